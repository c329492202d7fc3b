// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/body_tracker.hpp"

namespace corpuscle::tools {

BodyTracker::BodyTracker(const Simulation& simulation, io::ResultsFile& results)
    : results_(results) {
    const Model& model = simulation.model();
    std::vector<io::RigidTrack> tracks;
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        const RigidBody& body = simulation.bodies()[b];
        if (!body.can_move()) continue;
        bodies_.push_back(b);
        tracks.push_back(
            {model.parts[body.part()].id, body.mass(), body.position(), body.velocity()});
    }
    states_.resize(bodies_.size());
    results.follow(io::rigid_interval(model.unit_system, model.end_time), tracks);
}

void BodyTracker::observe(const Simulation& simulation, bool at_end) {
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
        const RigidBody& body = simulation.bodies()[bodies_[k]];
        states_[k] = {body.position(), body.velocity(), simulation.force_on(body)};
    }
    results_.observe(simulation.time(), states_, at_end);
}

}  // namespace corpuscle::tools
