// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/stable_step.hpp"

namespace corpuscle {
class Simulation;
}

namespace corpuscle::tools {

/// What a run will take, by what the scene holds at the start.
struct Cost {
    StepLimit first;       ///< the first step, and who sets it; DTINIT apart                  [s]
    double steps = 0.0;    ///< to the end time
    double seconds = 0.0;  ///< on all threads
};

/// Sum over the run's time of steps, each with its cost:
///
///     dt(t)   = min(cloth, gas beside it);   cloth: the first step / 1.2, for stretched cloth wants less
///     gas     = first gas step (N / n)^(1/3) (V / V_0)^(1/3) c_0 / c: cells of as many particles
///     seconds = sum of counts times costs: particles that are in, facets of bags, elements, nodes,
///               shells in contact, and pairs that were near at the start, which come apart as gas
///               comes in
///
/// n: particles that are in by then, less what vents and fabric let out above the pressure outside; V:
/// volume that their gas wants at that pressure, up to that of the full bag, where cloth can move; c:
/// thermal speed of what is in. Costs per count are those of one core
/// (tests/benchmark/estimate_benchmark.cpp compares them with runs of all models).
Cost cost_of(const Simulation& simulation);

}  // namespace corpuscle::tools
