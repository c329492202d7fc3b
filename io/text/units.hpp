// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace corpuscle::io {

/// What a number measures.
enum class Quantity {
    NONE,  ///< ids, counts, ratios
    TIME,
    LENGTH,
    AREA,
    VOLUME,
    MASS,
    TEMPERATURE,
    VELOCITY,
    ACCELERATION,
    MOMENTUM,
    ANGULAR_MOMENTUM,
    FORCE,
    MOMENT,  ///< of a force about a place
    PRESSURE,
    ENERGY,
    DENSITY,
};

/// The unit of a quantity in a deck's unit system, as text: "GPa" for a pressure in kg-mm-ms-K.
///
/// @param unit_system  "SI", "kg-mm-ms-K", "ton-mm-s-K", "g-mm-ms-K" or "lbf-in-s-K" (mass: lbf
///                     s2/in, 386.1 pounds); any other name is an unknown consistent system, for
///                     which the answer is "deck [pressure]"
[[nodiscard]] std::string unit_of(Quantity quantity, std::string_view unit_system);

/// The unit in which people say a quantity, whatever the deck's are: kPa, l, g, ms, kN, J, m/s, mm,
/// K, ...; of an unknown consistent system the deck's own.
struct SpokenUnit {
    double factor = 1.0;  ///< on a number in the deck's unit
    std::string unit;     ///< "kPa", "ms", ...
};
/// @param unit_system  as of unit_of()
[[nodiscard]] SpokenUnit spoken(Quantity quantity, std::string_view unit_system);
/// The same, of a number in one of the system's units, as unit_of() names it.
[[nodiscard]] SpokenUnit spoken(std::string_view unit, std::string_view unit_system);

/// The base units of a unit system, in SI.
struct UnitScale {
    double second = 1.0,  ///< the unit of time                                                [s]
        metre = 1.0,      ///< the unit of length                                             [m]
        kilogram = 1.0;   ///< the unit of mass                                              [kg]

    /// Standard gravity, in the system's own acceleration.       [ISO 80000-3: 9.80665 m/s^2]
    [[nodiscard]] double gravity() const { return 9.80665 * second * second / metre; }
};

/// None for an unknown consistent system.
[[nodiscard]] std::optional<UnitScale> scale_of(std::string_view unit_system);

/// The system of a name as people write it, in either case, with or without the K: "kg-mm-ms-K" of
/// "kg-mm-ms", "SI" of "kg-m-s". Empty where there is none.
[[nodiscard]] std::string_view unit_system_named(std::string_view word);

/// Of all systems that are known, as unit_of() takes them.
[[nodiscard]] std::vector<std::string_view> unit_system_names();
/// All systems, for messages: "SI, kg-mm-ms-K, ... or lbf-in-s-K".
[[nodiscard]] std::string unit_systems();

}  // namespace corpuscle::io
