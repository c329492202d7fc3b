// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What forces have done, and what there is at t.

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/simulation.hpp"

namespace corpuscle {
namespace {

/// Contact gives no more than it took. What goes beyond that is work that its growing gaps and
/// areas bring into the scene: it parts surfaces that began nearer than their thickness.
void bring_in_parting(Moved& moved) {
    if (moved.contact >= 0.0) return;
    moved.external -= moved.contact;
    moved.contact = 0.0;
}

}  // namespace

/// Of nodes, rigid bodies and walls of mass, at the half step that velocities live at. [J]
double Simulation::kinetic_energy() const {
    double all = nodes_.kinetic_energy();
    for (const RigidBody& body : bodies_) all += body.kinetic_energy();
    for (const contact::RigidWall& wall : walls_) all += wall.kinetic_energy();
    return all;
}

double ForceShare::work(const Points& v_mid, double span) const {
    return span * parallel::sum(f.size(), 0.0, [&](std::size_t n) { return f[n].dot(v_mid[n]); });
}

/// Books the work of this kick's forces, sum of f · v_mid · span, v_mid = (v_before + v) / 2:
/// exactly the change of kinetic energy, so what held nodes gain beyond it, and beyond what
/// obstacles gave, came from their supports.
void Simulation::book_forces(double span) {
    parallel::for_each(nodes_.size(),
                       [&](std::size_t n) { v_mid_[n] = 0.5 * (v_before_[n] + nodes_.v[n]); });
    for (const RigidBody& body : bodies_)
        for (const Index n : body.nodes()) v_mid_[n] = body.mid_velocity_at(nodes_.x[n]);

    const auto gain = [&](Index n) {
        Vec3 given = span * nodes_.f[n];
        if (!v_kicked_.empty()) given += nodes_.mass[n] * (nodes_.v[n] - v_kicked_[n]);
        return 0.5 * nodes_.mass[n] * (nodes_.v[n].squaredNorm() - v_before_[n].squaredNorm()) -
               given.dot(v_mid_[n]);
    };
    Moved& moved = ledger_.after;
    for (const Index n : supports_.nodes()) moved.external += gain(n);
    for (const RigidBody& body : bodies_) {
        moved.external += body.held_work() + body.field_work();
        moved.damping += body.damped();
    }
    moved.external += load_force_.work(v_mid_, span);

    moved.damping -= damping_force_.work(v_mid_, span);
    for (fabric::Membranes& fabric : fabric_)
        moved.damping += fabric.damping_energy(v_before_, nodes_.v, span);

    for (const contact::SurfaceContact& contact : contacts_)
        rubbed_ += contact.friction_work(v_mid_);
    double friction = rubbed_;
    for (const contact::RigidWall& wall : walls_) friction += wall.friction_energy();
    moved.contact -= friction - moved.friction;
    moved.friction = friction;

    moved.ambient = moved.smoothing = 0.0;
    for (gas::BagGas& bag : bags_) {
        bag.book_load(v_mid_, span);
        moved.ambient += bag.ambient_work();
        moved.smoothing += bag.smoothing_given();
    }
    for (gas::UniformBag& bag : uniform_bags_) {
        const double scaled = bag.scaling_work();
        bag.book_load(v_mid_, span);
        moved.ambient += bag.ambient_work();
        moved.external += bag.scaling_work() - scaled;
    }
    for (fabric::Membranes& fabric : fabric_) {
        const double restored = fabric.restored_energy() - restored_;
        restored_ += restored;
        ledger_.before.external += restored;
        moved.external += restored;
        growth_.give(restored);
    }
    bring_in_parting(moved);
    book_impulses(span);
    check_books();
    if (clock_.step == 0) ledger_.open(books());
    watch_growth(span);
}

/// Stops when an account of the ledger is not finite.
void Simulation::check_books() const {
    const Moved& moved = ledger_.after;
    const std::pair<const char*, double> accounts[] = {
        {"external work", moved.external}, {"contact", moved.contact},
        {"friction", moved.friction},      {"damping", moved.damping},
        {"the atmosphere", moved.ambient}, {"gas in transit to the fabric", moved.smoothing}};
    for (const auto& [name, energy] : accounts)
        if (!std::isfinite(energy))
            throw PhysicsError(clock_.t, fmt::format("the energy account of {} is not finite after "
                                                     "the forces of this step were booked",
                                                     name));
}

/// What walls, contacts and joints have got in this kick.
void Simulation::book_impulses(double span) {
    wall_impulses_.turn_page();
    for (std::size_t w = 0; w < walls_.size(); ++w) wall_impulses_.give(w, walls_[w].impulse());
    contact_impulses_.turn_page();
    for (std::size_t c = 0; c < contact_impulses_.size(); ++c)
        contact_impulses_.give(c, span * contacts_[0].force(static_cast<int>(c)));
    joint_impulses_.turn_page();
    joint_turnings_.turn_page();
    for (RigidJoints& joints : joints_) {
        const std::vector<RigidJoints::Given> given = joints.take_given();
        for (std::size_t j = 0; j < given.size(); ++j) {
            joint_impulses_.give(j, given[j].impulse);
            joint_turnings_.give(j, given[j].turning);
        }
    }
}

EnergyBooks Simulation::books() const {
    EnergyBooks instant;
    for (const fabric::Membranes& fabric : fabric_) {
        instant.strain += fabric.strain_energy();
        instant.damping += fabric.lost_energy();
    }
    for (const gas::BagGas& bag : bags_) {
        instant.gas += bag.energy();
        instant.smoothing += bag.smoothing_taken();
        instant.inflow += bag.inflow_energy();
        instant.outflow += bag.lost_energy();
    }
    for (const gas::UniformBag& bag : uniform_bags_) {
        instant.gas += bag.energy();
        instant.inflow += bag.inflow_energy();
        instant.outflow += bag.outflow_energy();
    }
    return ledger_.balance(instant);
}

/// Tells bags whose holes contact closes which nodes touch fabric or walls.
void Simulation::find_touching(double span) {
    const auto asks = [](const gas::BagGas& bag) { return bag.asks_for_contact(); };
    if (std::none_of(bags_.begin(), bags_.end(), asks)) return;
    touching_.assign(nodes_.size(), 0);
    for (const contact::SurfaceContact& contact : contacts_) contact.mark_touching(touching_);
    for (const contact::RigidWall& wall : walls_)
        for (const Index node : wall.touching()) touching_[node] = 1;
    const auto weighs = [](const gas::BagGas& bag) { return bag.card().block.by_pressure; };
    if (std::any_of(bags_.begin(), bags_.end(), weighs)) find_contact_push(span);
    for (gas::BagGas& bag : bags_)
        if (bag.asks_for_contact()) bag.set_touching(touching_, contact_push_);
}

/// What contact does to each free node: the impulse that it gave, over its time.
void Simulation::find_contact_push(double span) {
    if (held_.empty()) held_ = held_nodes();
    contact_push_.assign(nodes_.size(), Vec3::Zero());
    for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (held_[n] == 0)
            contact_push_[n] = nodes_.mass[n] / span * (nodes_.v[n] - v_before_[n]) - nodes_.f[n];
}

Vec3 Simulation::gas_force(Index node) const {
    Vec3 force = Vec3::Zero();
    for (const gas::BagGas& bag : bags_) force += bag.force(node);
    for (const gas::UniformBag& bag : uniform_bags_) force += bag.force(node);
    return force;
}

Vec3 Simulation::velocity(Index node) const {
    return (1.0 - ledger_.weight) * v_before_[node] + ledger_.weight * nodes_.v[node];
}

}  // namespace corpuscle
