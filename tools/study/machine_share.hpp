// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "tools/study/study.hpp"

namespace corpuscle::study {

/// What a machine has.
struct Machine {
    int cores;             ///< a core's hardware threads count once
    int hardware_threads;  ///< at least as many
};

/// Threads beyond which a run hardly gains: sixteen are worth eight to ten
/// (tests/benchmark/scaling_benchmark.cpp).
inline constexpr int MOST_THREADS = 16;

/// Sets the workers and threads that a study does not say, for so many runs. As many runs at a time
/// as there are hardware threads, each of one thread, for a second run gains more from a core than
/// a second thread does; fewer runs than cores share the cores out among their threads.
void share_machine(Study& study, std::size_t runs, const Machine& machine);

}  // namespace corpuscle::study
