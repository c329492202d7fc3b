// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What stops a run: fabric whose step is too long, and what is not finite.

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/simulation.hpp"

namespace corpuscle {

/// Stops when the step has become too long for the fabric.
void Simulation::watch_growth(double span) {
    if (fabric_.empty()) return;
    if (const Index node = growth_.zigzag(fabric_force_.f, nodes_.mass, span); node >= 0)
        throw PhysicsError(clock_.t, growing_shell(node) +
                                         " swings further in every step: the step is too "
                                         "long for it, the fabric became unstable");
    const GrowthMonitor::Instant now{
        fabric_.front().strain_energy() + fabric_.front().lost_energy(),
        fabric_force_.work(v_mid_, span), fabric_force_.work(v_before_, span)};
    if (!growth_.gains(now, nodes_.mass, v_before_, nodes_.v)) return;
    if (!(growth_.spurious() > negligible_energy(span))) return;  // nor where the gas has a NaN
    throw PhysicsError(
        clock_.t, fmt::format("the fabric has {:.4g} of energy from nowhere, {:.3g} times what it "
                              "was given; worst is {}: the step is too long for it, the fabric "
                              "became unstable",
                              growth_.spurious(), growth_.spurious() / growth_.scale(),
                              growing_shell(growth_.most_kicked(nodes_.mass))));
}

/// What fabric may gain from nowhere before anyone calls it unstable: rounding of places, which at
/// rest is all the energy there is, and a hundredth of the 1 % that books of a run may be off. [J]
double Simulation::negligible_energy(double span) const {
    constexpr double ROUNDING = 1e-12, SHARE = 1e-4;
    double size = 0.0, mass = 0.0, all = ledger_.after.kinetic;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        size = std::max(size, nodes_.x[n].norm());
        mass += nodes_.mass[n];
    }
    for (const fabric::Membranes& fabric : fabric_) all += fabric.strain_energy();
    for (const gas::BagGas& bag : bags_) all += bag.energy();
    for (const gas::UniformBag& bag : uniform_bags_) all += bag.energy();
    const double speed = ROUNDING * size / span;
    return mass * speed * speed + SHARE * all;
}

/// Of the strained shells at a node, the one whose nodes' kicks hold most energy.
std::string Simulation::growing_shell(Index node) const {
    double most = -1.0;
    std::size_t who = 0;
    for (std::size_t s = 0; s < model_.shells.size(); ++s) {
        const auto& nodes = model_.shells[s].nodes;
        if (!active_[s] || std::find(nodes.begin(), nodes.end(), node) == nodes.end()) continue;
        double energy = 0.0;
        for (const Index n : nodes) energy += nodes_.mass[n] * growth_.kick(n).squaredNorm();
        if (energy > most || most < 0.0) {  // whatever it is, NaN too, there is one
            most = energy;
            who = s;
        }
    }
    const Vec3& at = nodes_.x[node];
    if (most < 0.0)
        return fmt::format("node {} near ({:.6g}, {:.6g}, {:.6g})", model_.node_id[node], at[0],
                           at[1], at[2]);
    const Shell& shell = model_.shells[who];
    return fmt::format("shell {} of part {} near ({:.6g}, {:.6g}, {:.6g})", shell.id,
                       model_.parts[shell.part].id, at[0], at[1], at[2]);
}

void Simulation::stop_for(Index broken_shell) const {
    const Shell& shell = model_.shells[broken_shell];
    const Vec3& at = nodes_.x[shell.nodes[0]];
    throw PhysicsError(
        clock_.t, fmt::format("shell {} of part {} near ({:.6g}, {:.6g}, {:.6g}) has no finite "
                              "strain: the fabric became unstable",
                              shell.id, model_.parts[shell.part].id, at[0], at[1], at[2]));
}

namespace {

/// Largest component; infinite where one is no number.
double size_of(const Vec3& v) {
    return v.allFinite() ? v.cwiseAbs().maxCoeff() : INF;
}

}  // namespace

/// Stops when the kinetic energy after the kick is not finite, with the first of the kick's forces,
/// in the order of the step, that is not finite at some node: a membrane whose own force is not was
/// found before (stop_for). Nothing is looked for while the energy is finite.
void Simulation::check_finite() const {
    if (std::isfinite(ledger_.after.kinetic)) return;
    std::size_t fastest = 0;
    double most = -1.0;
    for (std::size_t n = 0; n < nodes_.size() && most < INF; ++n) {
        const double speed = size_of(nodes_.v[n]);
        if (speed <= most) continue;
        most = speed;
        fastest = n;
    }
    const auto node = static_cast<Index>(fastest);
    const auto part_of = [&](const ForceShare& share) {
        return share.f.empty() ? Vec3(Vec3::Zero()) : share.f[fastest];
    };
    std::vector<std::pair<std::string, Vec3>> forces{{"the membranes", part_of(fabric_force_)}};
    for (const gas::BagGas& bag : bags_)
        forces.emplace_back(fmt::format("the gas of *AIRBAG_PARTICLE {}", bag.card().id),
                            bag.force(node));
    for (const gas::UniformBag& bag : uniform_bags_)
        forces.emplace_back(fmt::format("the gas of airbag {}", bag.card().id), bag.force(node));
    forces.emplace_back("loads", part_of(load_force_));
    forces.emplace_back("damping", part_of(damping_force_));
    const auto largest = std::max_element(
        forces.begin(), forces.end(),
        [](const auto& a, const auto& b) { return size_of(a.second) < size_of(b.second); });
    const Vec3& at = nodes_.x[fastest];
    const std::string where = fmt::format("node {} near ({:.6g}, {:.6g}, {:.6g})",
                                          model_.node_id[fastest], at[0], at[1], at[2]);
    if (size_of(largest->second) == INF)
        throw PhysicsError(
            clock_.t, fmt::format("the force of {} on {} is not finite", largest->first, where));
    if (most == INF)
        throw PhysicsError(clock_.t, where +
                                         " has no finite velocity after walls, contact, "
                                         "supports or a rigid body held it: every force on "
                                         "it is finite");
    throw PhysicsError(clock_.t,
                       fmt::format("{}: the kinetic energy overflows at {}; most of the force "
                                   "there is that of {}",
                                   growing_shell(node), where, largest->first));
}

}  // namespace corpuscle
