// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "gas/collisions/collide.hpp"

/// Cases whose answer is known, each computed once by one collision model.
namespace corpuscle::benchmark {

/// How a model does best: cells of Sod's tube at 10^5 particles (smaller as n^(-1/3)), particles a
/// cell elsewhere, cfl (c_T dt / edge between collision steps).
struct Setting {
    gas::CollisionModel model;
    double cells;
    double particles_a_cell;
    double cfl;
};

/// Root-mean-square error of the pressure on a piston against the 1-D Euler equations, over that
/// before it moves.
/// The notes' fast piston that draws back at 400 m/s, in bins of 0.1 ms from its start to 4 ms
/// after.
double fast_piston_error(const Setting& setting, std::size_t n);
/// Air of 300 K and 1 bar in a tube 0.2 x 0.1 x 0.1 m that a piston compresses to half at
/// 200 m/s and then stops, in bins of 0.05 ms until 1 ms.
double compression_error(const Setting& setting, std::size_t n);

/// Helium at 400 K and nitrogen at 280 K that share a box, particle by particle.
struct Mixing {
    double error;      ///< RMS of both temperatures of motion from the one they end with   [-]
    double step_to_1;  ///< collision steps until both lie within 1 % of it, for good
};
/// The error is that of the mean over collision steps 100 to 200.
Mixing mixing_error(const Setting& setting, std::size_t n);

}  // namespace corpuscle::benchmark
