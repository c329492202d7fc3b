// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "gas/collisions/collide.hpp"

/// Sod's shock tube in three dimensions: a box 1 x 0.1 x 0.1 of diatomic gas, c_T = sqrt(R T / M) =
/// 1 on the left, where density and pressure are 1; on the right of the middle they are 0.125 and
/// 0.1. Looked at when t = 0.2, in 100 slabs.
namespace corpuscle::oracle {

/// How a tube is computed.
struct SodRun {
    gas::CollisionModel model;
    std::size_t particles;
    double edge;  ///< of a cell; fits into 0.1                                             [-]
    double cfl;   ///< c_T dt / edge between collision steps
    double mean_free_path = NaN;
};

/// L1 distances (mean of absolute differences) of the mean of an ensemble from the exact solution,
/// and what chance adds where the mean is right: the same distance between the halves' means,
/// halved.
struct SodError {
    double density, pressure;
    double density_noise, pressure_noise;
    std::size_t steps;   ///< collision steps of a run
    double cpu_seconds;  ///< of a run, flight, sort and collisions
};

/// @param runs  in the ensemble, even; they differ in their seeds, that of collisions included
SodError sod_error(const SodRun& run, int runs);

}  // namespace corpuscle::oracle
