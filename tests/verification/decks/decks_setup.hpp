// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include "gas/thermo/orifice_flow.hpp"
#include "tests/support/decks/stepped_deck.hpp"

namespace decks_setup {

using namespace corpuscle;

inline constexpr double VOLUME = 1e-3, AREA = 0.06;  // of the cube
inline constexpr double CP = 1004.5, CV = 717.5, R = CP - CV;
inline constexpr double PE = 101325.0, RO = 1.2, POVER = 20000.0;

/// What has left after the first step at a rate that holds for all of it.                [kg]
inline double first_loss(double rate, double mass, double dt) {
    return -std::expm1(-rate * dt / mass) * mass;
}

}  // namespace decks_setup
