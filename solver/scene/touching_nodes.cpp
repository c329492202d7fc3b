// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/touching_nodes.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle {

void TouchingNodes::tell_bags(SceneState& scene, double span) {
    std::vector<gas::BagGas>& bags = scene.airbags.particle;
    const auto asks = [](const gas::BagGas& bag) { return bag.asks_for_contact(); };
    if (std::none_of(bags.begin(), bags.end(), asks)) return;
    touching_.assign(scene.nodes.size(), 0);
    if (scene.obstacles.contact) scene.obstacles.contact->mark_touching(touching_);
    for (const contact::RigidWall& wall : scene.obstacles.walls)
        for (const Index node : wall.touching()) touching_[node] = 1;
    const auto weighs = [](const gas::BagGas& bag) { return bag.card().block.by_pressure; };
    if (std::any_of(bags.begin(), bags.end(), weighs)) find_push(scene, span);
    for (gas::BagGas& bag : bags)
        if (bag.asks_for_contact()) bag.set_touching(touching_, push_);
}

/// What contact does to each free node: the impulse that it gave, over its time.
void TouchingNodes::find_push(const SceneState& scene, double span) {
    if (held_.empty()) held_ = scene.held_nodes();
    const fabric::Nodes& nodes = scene.nodes;
    push_.resize(nodes.size());
    parallel::for_each(nodes.size(), [&](std::size_t n) {
        push_[n] = held_[n] == 0
                       ? Vec3(nodes.mass[n] / span * (nodes.v[n] - scene.v.before[n]) - nodes.f[n])
                       : Vec3(Vec3::Zero());
    });
}

}  // namespace corpuscle
