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
    bool is_mutable = false;  ///< by _MUTABLE: another definition takes its place
    std::size_t order = 0;    ///< definitions of the deck before it
};

/// Where a name is read. Of several definitions the last before it counts, or the first.
struct Viewpoint {
    std::uint32_t file = 0;
    std::size_t defined = static_cast<std::size_t>(-1);  ///< definitions of the deck before it
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
    /// The last definition of the name so far, or nullptr.
    [[nodiscard]] const Parameter* last(std::string_view name, std::uint32_t file,
                                        bool local) const;
    /// Counts behind itself.
    void define(std::string_view name, Parameter parameter, bool local);
    /// How many there are so far.
    [[nodiscard]] std::size_t definitions() const { return definitions_; }

    /// DFLAG of *PARAMETER_DUPLICATION, 1 to 5: what becomes of a second definition.
    void set_duplication(int flag) { duplication_ = flag; }
    /// Likewise, 1 at first.
    [[nodiscard]] int duplication() const { return duplication_; }

    [[nodiscard]] const Parameter* find(std::string_view name, Viewpoint from) const;
    /// Number of an expression's name.
    [[nodiscard]] std::optional<Value> value(std::string_view name, Viewpoint from) const;
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
    using Table = std::map<std::string, std::vector<Parameter>>;  ///< definitions in turn
    struct File {
        std::optional<std::uint32_t> parent;
        Table local;
    };
    std::vector<Override> overrides_;
    std::vector<File> files_;
    Table global_;
    std::size_t definitions_ = 0;
    int duplication_ = 1;
};

}  // namespace corpuscle::io
