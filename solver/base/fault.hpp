// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <string_view>

namespace corpuscle {

/// What of a scene is at fault, in the words of physics. io knows the deck's word for each
/// (io/deck/deck_words.hpp).
enum class Property : std::uint8_t {
    NONE,  ///< `why` tells the whole fault
    // a material's
    DENSITY,
    WARP_MODULUS,
    WEFT_MODULUS,
    SHEAR_MODULUS,
    CROSS_MODULUS,
    MODULUS,
    POISSON_RATIO,
    CROSS_POISSON_RATIO,
    DAMPING,
    LINER_MODULUS,
    LINER_RATIO,
    LINER_POISSON_RATIO,
    COAT_MODULUS,
    COAT_THICKNESS,
    THICKNESS,
    STRESS_CURVE,
    UNLOADING_CURVE,
    REFERENCE_RESTORATION,
    // a bag's
    CLOSING_WALL,
    VENT_WALL,
    VENT_COEFFICIENT,
    VENT_LAW,
    ORIFICE_PLACE,
    ORIFICE_AREA,
    CONE_ANGLE,
    PARTICLE_NUMBER,
    HOLE_SHARE,
    POROSITY,
    INITIAL_AIR,
    START_VOLUME,
    START_STATE,
    // the run's
    MASS_SCALED_STEP,
    COUNT
};

/// Its name in physics, English, lower case; empty for NONE.
[[nodiscard]] inline std::string_view name_of(Property property) {
    constexpr std::array<std::string_view, static_cast<std::size_t>(Property::COUNT)> NAMES{
        "",
        "density",
        "modulus along the warp",
        "modulus along the weft",
        "shear modulus",
        "cross modulus",
        "modulus",
        "Poisson's ratio",
        "Poisson's ratio of weft and warp",
        "damping",
        "the liner's modulus",
        "the liner's share",
        "the liner's Poisson's ratio",
        "the coat's modulus",
        "the coat's thickness",
        "thickness",
        "curve of stress",
        "curve of unloading",
        "return to the reference shape",
        "closing wall",
        "wall",
        "discharge coefficient",
        "law",
        "place",
        "area",
        "half angle of the cone [rad]",
        "number of particles",
        "share of the bag's area",
        "porosity",
        "initial air",
        "volume at the start",
        "state at the start",
        "time step with scaled mass"};
    return NAMES[static_cast<std::size_t>(property)];
}

/// One fault of a scene: of what, which of its numbers, and why.
struct Fault {
    std::string of;                      ///< "bag 1", "material 17"; empty where `why` says it all
    Property property = Property::NONE;  ///< whose value, table or place is wrong
    std::string which{};                 ///< "vent 2", "orifice 1"; empty: there is one
    double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: `why` is no matter of one
    std::string why{};  ///< "expected > 0", "no shell of it is in the bag"

    /// "material 17: shear modulus = 0, expected > 0", "bag 1, wall of vent 2: no shell of it is in
    /// the bag", "bag 1: area of orifice 2 = -1, expected >= 0"; with the property by another name,
    /// if `word` is one.
    [[nodiscard]] std::string text(std::string_view word = {}) const {
        if (of.empty()) return why;
        std::string what(word.empty() ? name_of(property) : word), line = of;
        if (what.empty()) return line.append(": ").append(why);
        if (!which.empty()) what.append(" of ").append(which);
        if (value != value) return line.append(", ").append(what).append(": ").append(why);
        std::array<char, 32> digits{};
        std::snprintf(digits.data(), digits.size(), "%g", value);
        line.append(": ").append(what).append(" = ").append(digits.data());
        return line.append(", ").append(why);
    }
};

}  // namespace corpuscle
