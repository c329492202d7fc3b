// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/deck/expression.hpp"
#include "io/deck/faults.hpp"

namespace corpuscle::io {

/// One *PARAMETER: R real, I integer, C characters.
struct Parameter {
    char type = 'R';
    Value value;
    std::string text;  ///< of type C
    Place place;
};

/// Names that -D may give a value in any deck.
inline constexpr std::array<std::string_view, 5> OWN_NAMES = {"DIALECT", "COLLISION",
                                                              "MEAN_FREE_PATH", "CLOSE", "UNITS"};

/// What *PARAMETER and -D define. Names have no case. A _LOCAL one is seen in its file and what
/// that includes; the others everywhere.
class Parameters {
public:
    explicit Parameters(std::vector<std::pair<std::string, std::string>> overrides);

    /// The file that includes `file`; the deck itself has no parent.
    void add_file(std::uint32_t file, std::optional<std::uint32_t> parent);

    /// -D value for `name`, if there is one; it counts as used.
    std::optional<std::string> take_override(std::string_view name);
    /// @returns the earlier definition that stays, or nullptr when this one is taken
    const Parameter* define(std::string_view name, Parameter parameter, bool local);

    /// DFLAG of *PARAMETER_DUPLICATION, 1 to 5: what becomes of a second definition.
    void set_duplication(int flag) { duplication_ = flag; }
    /// Likewise, 1 at first.
    [[nodiscard]] int duplication() const { return duplication_; }

    [[nodiscard]] const Parameter* find(std::string_view name, std::uint32_t from_file) const;
    /// Number of an expression's name.
    [[nodiscard]] std::optional<Value> value(std::string_view name, std::uint32_t from_file) const;
    /// Of all parameters, in alphabetical order.
    [[nodiscard]] std::vector<std::string> names() const;
    /// The name that was probably meant, or "".
    [[nodiscard]] std::string nearest_name(std::string_view name) const;

    /// One complaint for each -D that no *PARAMETER of the deck asked for.
    [[nodiscard]] std::vector<std::string> unused_overrides() const;

private:
    struct Override {
        std::string name, value;
        bool used = false;
    };
    struct File {
        std::optional<std::uint32_t> parent;
        std::map<std::string, Parameter> local;
    };
    std::vector<Override> overrides_;
    std::vector<File> files_;
    std::map<std::string, Parameter> global_;
    int duplication_ = 1;
};

}  // namespace corpuscle::io
