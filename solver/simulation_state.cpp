// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// A scene's state as bytes.

#include "solver/base/fingerprint.hpp"
#include "solver/simulation.hpp"

namespace corpuscle {

/// Between two steps: forces, and what a step works out on its way, are not part of it.
template <class Archive>
void Simulation::visit_all(Archive& archive) {
    archive(clock_, nodes_.x, nodes_.v, ledger_, rubbed_, last_sample_, last_frame_);
    const double next_birth = next_birth_;
    archive(next_birth_);
    if (next_birth_ != next_birth)  // read: reference geometries that count by now
        for (fabric::Membranes& fabric : fabric_) fabric = membranes_at(clock_.t);
    archive(fabric_, restored_, growth_, supports_, bodies_, bags_, uniform_bags_, contacts_,
            walls_, wall_impulses_, contact_impulses_, joint_impulses_, joint_turnings_);
}

void Simulation::visit_state(StateWriter& archive) {
    visit_all(archive);
}
void Simulation::visit_state(StateReader& archive) {
    visit_all(archive);
}

std::uint64_t Simulation::fingerprint() const {
    StateWriter scene;
    Model model = model_;  // archives take what they may change
    scene(model.node_id, model.x, model.shells, model.velocity);
    for (Curve& curve : model.curves) scene(curve.id, curve.x, curve.y);
    for (Part& part : model.parts) scene(part.id, part.thickness, part.material);
    for (TiedNode& tie : model.tied_nodes) scene(tie.node, tie.ends, tie.share);
    for (gas::BagCard& bag : model.bags) scene(bag.id, bag.particles);
    scene(seed_, model.step_factor, model.step_mass_scaled);
    return corpuscle::fingerprint(scene.bytes());
}

}  // namespace corpuscle
