// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "io/deck/field_log.hpp"

namespace corpuscle::io {

/// A line of the deck. Files are numbered in the order in which they are opened, lines from 1.
struct Place {
    std::uint32_t file = 0;
    std::uint32_t line = 0;

    auto operator<=>(const Place&) const = default;
};

/// Three kinds of answer to a deck, gathered in any order:
///
///     error    would change the answer and cannot be had
///     warning  what was done instead, and how much it can matter
///     note     harmless
///
/// Messages of one cause are one line with a count. Cause: what messages have in common, such as
/// keyword, field, value and what was expected, without the card's number; empty: the whole text.
class Faults {
public:
    /// Number of the new file.
    std::uint32_t add_file(std::string name);
    /// "driver.k:41"
    [[nodiscard]] std::string where(Place at) const;

    void fault(Place at, const std::string& text, const std::string& cause = {});
    void warn(Place at, const std::string& text, const std::string& cause = {}) {
        warnings_.add(at, text, cause);
    }
    void note(Place at, const std::string& text, const std::string& cause = {}) {
        notes_.add(at, text, cause);
    }

    /// Faults between begin_block() and end_block() belong to one keyword: a table with a thousand
    /// bad rows shows the first few and says how many more there are.
    void begin_block() { in_block_ = hidden_ = 0; }
    [[nodiscard]] bool block_is_good() const { return in_block_ == 0; }
    void end_block(Place keyword_at, const std::string& keyword);

    /// Receiver of the treatment of each field; nullptr: none.
    void keep_log(FieldLog* log) { log_ = log; }
    [[nodiscard]] FieldLog* log() const { return log_; }

    [[nodiscard]] bool any() const { return !faults_.empty(); }
    /// In deck order.
    [[nodiscard]] std::vector<std::string> faults() const { return told(faults_); }
    [[nodiscard]] std::vector<std::string> warnings() const { return told(warnings_); }
    [[nodiscard]] std::vector<std::string> notes() const { return told(notes_); }

private:
    struct Message {
        Place at;
        std::string text;
        Place last;             ///< of the latest one of its cause
        std::size_t count = 1;  ///< of that cause
    };
    /// Messages of one kind, one for each cause.
    class List {
    public:
        /// Counts another one of a cause that is there. False: there is none.
        bool repeats(Place at, const std::string& cause);
        void add(Place at, const std::string& text, const std::string& cause);
        [[nodiscard]] bool empty() const { return messages_.empty(); }
        [[nodiscard]] const std::vector<Message>& messages() const { return messages_; }

    private:
        std::vector<Message> messages_;
        std::map<std::string, std::size_t> by_cause_;  ///< place in messages_
    };
    [[nodiscard]] std::vector<std::string> told(const List& list) const;

    FieldLog* log_ = nullptr;
    std::vector<std::string> files_;
    List faults_, warnings_, notes_;
    std::size_t in_block_ = 0, hidden_ = 0;
};

}  // namespace corpuscle::io
