// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

/// Sod's shock tube (tests/support/gas/sod.hpp) as decks that the program runs: the same box, gas,
/// slabs and measure, scaled to c_T = sqrt(R T / M) of air at 300 K and 1 m; the two gases come to
/// rest behind a membrane that opens as a valve.
namespace corpuscle::test {

/// L1 distances of the mean of an ensemble from the exact solution, over density and pressure of
/// the left; what chance adds where the mean is right: the halves' means' own distance, halved.
struct SodDeckError {
    double density = 0.0, pressure = 0.0;
    double density_noise = 0.0, pressure_noise = 0.0;
};

/// @param runs  in the ensemble, even; seeds 1, 2, ...
SodDeckError sod_deck_error(int particles, int runs);

}  // namespace corpuscle::test
