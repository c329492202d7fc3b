// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

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
    FORCE,
    PRESSURE,
    ENERGY,
    DENSITY,
};

/// The unit of a quantity in a deck's unit system, as text: "GPa" for a pressure in kg-mm-ms-K.
///
/// @param unit_system  "SI", "kg-mm-ms-K" or "ton-mm-s-K"; any other name is an unknown consistent
///                     system, for which the answer is "deck [pressure]"
[[nodiscard]] std::string unit_of(Quantity quantity, std::string_view unit_system);

}  // namespace corpuscle::io
