// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/simulation.hpp"

#include "solver/base/fingerprint.hpp"
#include "solver/stops.hpp"

namespace corpuscle {

void Simulation::close(const Observer& observe) {
    Stopwatch lap(timings_);
    const double dt = scene_.clock.dt_last;
    load_and_kick(dt, dt, lap);
    observe(*this);
}

bool Simulation::is_finite() const {
    return corpuscle::is_finite(scene_);
}

std::uint64_t Simulation::fingerprint() const {
    StateWriter scene;
    Model model = scene_.model;  // archives take what they may change
    std::uint64_t seed = scene_.seed;
    scene(model.node_id, model.x, model.shells, model.velocity);
    for (Curve& curve : model.curves) scene(curve.id, curve.x, curve.y);
    for (Part& part : model.parts) scene(part.id, part.thickness, part.material);
    for (TiedNode& tie : model.tied_nodes) scene(tie.node, tie.ends, tie.share);
    for (gas::BagCard& bag : model.bags) scene(bag.id, bag.particles);
    scene(seed, model.step_factor, model.step_mass_scaled, model.fingerprint);
    return corpuscle::fingerprint(scene.bytes());
}

}  // namespace corpuscle
