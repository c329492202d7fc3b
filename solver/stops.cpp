// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/stops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "gas/particles.hpp"
#include "solver/base/error.hpp"

namespace corpuscle {
namespace {

/// What fabric may gain from nowhere before anyone calls it unstable: rounding of places, which at
/// rest is all the energy there is, and a hundredth of the 1 % that books of a run may be off. [J]
double negligible_energy(const SceneState& scene, double span) {
    constexpr double ROUNDING = 1e-12, SHARE = 1e-4;
    double size = 0.0, mass = 0.0, all = scene.ledger.after.kinetic;
    for (std::size_t n = 0; n < scene.nodes.size(); ++n) {
        size = std::max(size, scene.nodes.x[n].norm());
        mass += scene.nodes.mass[n];
    }
    if (scene.cloth.membranes) all += scene.cloth.membranes->strain_energy();
    for (const gas::BagGas& bag : scene.airbags.particle) all += bag.energy();
    for (const gas::UniformBag& bag : scene.airbags.uniform) all += bag.energy();
    const double speed = ROUNDING * size / span;
    return mass * speed * speed + SHARE * all;
}

/// Of the strained shells at a node, the one whose nodes' kicks hold most energy.
std::string growing_shell(const SceneState& scene, Index node) {
    double most = -1.0;
    std::size_t who = 0;
    for (std::size_t s = 0; s < scene.model.shells.size(); ++s) {
        const auto& nodes = scene.model.shells[s].nodes;
        if (!scene.cloth.active[s] || std::find(nodes.begin(), nodes.end(), node) == nodes.end())
            continue;
        double energy = 0.0;
        for (const Index n : nodes)
            energy += scene.nodes.mass[n] * scene.cloth.growth.kick(n).squaredNorm();
        if (energy > most || most < 0.0) {  // whatever it is, NaN too, there is one
            most = energy;
            who = s;
        }
    }
    const Vec3& at = scene.nodes.x[node];
    if (most < 0.0)
        return fmt::format("node {} near ({:.6g}, {:.6g}, {:.6g})", scene.model.node_id[node],
                           at[0], at[1], at[2]);
    const Shell& shell = scene.model.shells[who];
    return fmt::format("shell {} of part {} near ({:.6g}, {:.6g}, {:.6g})", shell.id,
                       scene.model.parts[shell.part].id, at[0], at[1], at[2]);
}

/// Largest component; infinite where one is no number.
double size_of(const Vec3& v) {
    return v.allFinite() ? v.cwiseAbs().maxCoeff() : INF;
}

}  // namespace

void check_growth(SceneState& scene, double span) {
    if (!scene.cloth.membranes) return;
    if (const Index node = scene.cloth.growth.zigzag(scene.forces.fabric.f, scene.nodes.mass, span);
        node >= 0)
        throw PhysicsError(scene.clock.t, growing_shell(scene, node) +
                                              " swings further in every step: the step is too "
                                              "long for it, the fabric became unstable");
    const auto [inner_work, inner_early] =
        scene.forces.fabric.works(scene.v.mid, scene.v.before, span);
    const GrowthMonitor::Instant now{
        scene.cloth.membranes->strain_energy() + scene.cloth.membranes->lost_energy(), inner_work,
        inner_early};
    if (!scene.cloth.growth.gains(now, scene.nodes.mass, scene.v.before, scene.nodes.v)) return;
    if (!(scene.cloth.growth.spurious() > negligible_energy(scene, span)))
        return;  // nor where the gas has a NaN
    throw PhysicsError(
        scene.clock.t,
        fmt::format("the fabric has {:.4g} of energy from nowhere, {:.3g} times what it "
                    "was given; worst is {}: the step is too long for it, the fabric "
                    "became unstable",
                    scene.cloth.growth.spurious(),
                    scene.cloth.growth.spurious() / scene.cloth.growth.scale(),
                    growing_shell(scene, scene.cloth.growth.most_kicked(scene.nodes.mass))));
}

void stop_for_strain(const SceneState& scene, Index broken_shell) {
    const Shell& shell = scene.model.shells[broken_shell];
    const Vec3& at = scene.nodes.x[shell.nodes[0]];
    throw PhysicsError(
        scene.clock.t,
        fmt::format("shell {} of part {} near ({:.6g}, {:.6g}, {:.6g}) has no finite "
                    "strain: the fabric became unstable",
                    shell.id, scene.model.parts[shell.part].id, at[0], at[1], at[2]));
}

/// Stops when the kinetic energy after the kick is not finite, with the first of the kick's forces,
/// in the order of the step, that is not finite at some node: a membrane whose own force is not was
/// found before (stop_for_strain). Nothing is looked for while the energy is finite.
void check_finite(const SceneState& scene) {
    if (std::isfinite(scene.ledger.after.kinetic)) return;
    std::size_t fastest = 0;
    double most = -1.0;
    for (std::size_t n = 0; n < scene.nodes.size() && most < INF; ++n) {
        const double speed = size_of(scene.nodes.v[n]);
        if (speed <= most) continue;
        most = speed;
        fastest = n;
    }
    const auto node = static_cast<Index>(fastest);
    const auto part_of = [&](const ForceShare& share) {
        return share.f.empty() ? Vec3(Vec3::Zero()) : share.f[fastest];
    };
    std::vector<std::pair<std::string, Vec3>> forces{
        {"the membranes", part_of(scene.forces.fabric)}};
    for (const gas::BagGas& bag : scene.airbags.particle)
        forces.emplace_back("the gas of " + bag.card().name(), bag.force(node));
    for (const gas::UniformBag& bag : scene.airbags.uniform)
        forces.emplace_back(fmt::format("the gas of airbag {}", bag.card().id), bag.force(node));
    forces.emplace_back("loads", part_of(scene.forces.loads));
    forces.emplace_back("damping", part_of(scene.forces.damping));
    const auto largest = std::max_element(
        forces.begin(), forces.end(),
        [](const auto& a, const auto& b) { return size_of(a.second) < size_of(b.second); });
    const Vec3& at = scene.nodes.x[fastest];
    const std::string where = fmt::format("node {} near ({:.6g}, {:.6g}, {:.6g})",
                                          scene.model.node_id[fastest], at[0], at[1], at[2]);
    if (size_of(largest->second) == INF)
        throw PhysicsError(scene.clock.t, fmt::format("the force of {} on {} is not finite",
                                                      largest->first, where));
    if (most == INF)
        throw PhysicsError(scene.clock.t, where +
                                              " has no finite velocity after walls, contact, "
                                              "supports or a rigid body held it: every force on "
                                              "it is finite");
    throw PhysicsError(scene.clock.t,
                       fmt::format("{}: the kinetic energy overflows at {}; most of the force "
                                   "there is that of {}",
                                   growing_shell(scene, node), where, largest->first));
}

bool is_finite(const SceneState& scene) {
    const auto all_finite = [](const Points& vectors) {
        return std::all_of(vectors.begin(), vectors.end(),
                           [](const Vec3& v) { return v.allFinite(); });
    };
    bool is =
        std::isfinite(scene.clock.t) && all_finite(scene.nodes.x) && all_finite(scene.nodes.v);
    for (const RigidBody& body : scene.bodies.all)
        is &= body.position().allFinite() && body.velocity().allFinite();
    for (const gas::BagGas& bag : scene.airbags.particle) {
        const gas::Particles& gas = bag.particles();
        is &= all_finite(gas.x) && all_finite(gas.v) &&
              std::all_of(gas.e.begin(), gas.e.end(), [](double e) { return std::isfinite(e); });
    }
    return is;
}

void check_accounts(const SceneState& scene) {
    const Moved& moved = scene.ledger.after;
    const std::pair<const char*, double> accounts[] = {
        {"external work", moved.external}, {"contact", moved.contact},
        {"friction", moved.friction},      {"damping", moved.damping},
        {"the atmosphere", moved.ambient}, {"gas in transit to the fabric", moved.smoothing}};
    for (const auto& [name, energy] : accounts)
        if (!std::isfinite(energy))
            throw PhysicsError(scene.clock.t,
                               fmt::format("the energy account of {} is not finite after "
                                           "the forces of this step were booked",
                                           name));
}

// The load follows its hits by some steps: sheets that pass through each other in between, with gas
// between them, are lent what nobody has.
void check_given(const SceneState& scene) {
    for (const gas::BagGas& bag : scene.airbags.particle)
        if (const double had = bag.energy_had(); bag.smoothing_given() > had)
            throw PhysicsError(
                scene.clock.t,
                fmt::format("{}: its gas has given the fabric {:.4g} of energy, and had {:.4g} in "
                            "all: sheets without contact pass through each other with gas between "
                            "them, or a room without gas is inside out",
                            bag.card().name(), bag.smoothing_given(), had));
}

}  // namespace corpuscle
