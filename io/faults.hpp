// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace corpuscle::io {

/// A line of the deck. Files are numbered in the order in which they are opened, lines from 1.
struct Place {
    std::uint32_t file = 0;
    std::uint32_t line = 0;

    auto operator<=>(const Place&) const = default;
};

/// Gathers what is wrong with a deck, and what its user should know, in any order.
class Faults {
public:
    /// Number of the new file.
    std::uint32_t add_file(std::string name);
    /// "driver.k:41"
    [[nodiscard]] std::string where(Place at) const;

    void fault(Place at, const std::string& text);
    void warn(Place at, const std::string& text);

    /// Faults between begin_block() and end_block() belong to one keyword: a table with a thousand
    /// bad rows shows the first few and says how many more there are.
    void begin_block() { in_block_ = 0; }
    [[nodiscard]] bool block_is_good() const { return in_block_ == 0; }
    void end_block(Place keyword_at, const std::string& keyword);

    [[nodiscard]] bool any() const { return !faults_.empty(); }
    /// In deck order.
    [[nodiscard]] std::vector<std::string> faults() const { return sorted(faults_); }
    [[nodiscard]] std::vector<std::string> warnings() const { return sorted(warnings_); }

private:
    using Message = std::pair<Place, std::string>;
    [[nodiscard]] static std::vector<std::string> sorted(std::vector<Message> messages);

    std::vector<std::string> files_;
    std::vector<Message> faults_, warnings_;
    std::size_t in_block_ = 0;
};

}  // namespace corpuscle::io
