// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "io/results/results_file.hpp"
#include "solver/simulation.hpp"

namespace corpuscle::tools {

/// Hands the motion of every rigid body that can move to the results, step by step.
class BodyTracker {
public:
    /// Before the first step; after a restart visit_state() puts what was followed in place.
    BodyTracker(const Simulation& simulation, io::ResultsFile& results);

    /// Inside an observer; `at_end`: the last state of a run.
    void observe(const Simulation& simulation, bool at_end);

    template <class Archive>
    void visit_state(Archive& archive) {
        results_.visit_bodies(archive);
    }

private:
    io::ResultsFile& results_;
    std::vector<std::size_t> bodies_;  ///< rows in simulation.bodies()
    std::vector<io::RigidState> states_;
};

}  // namespace corpuscle::tools
