// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// How forces and obstacles change the velocities of nodes and rigid bodies in a step.

#include <utility>

#include "solver/simulation.hpp"

namespace corpuscle {

/// d of *DAMPING_GLOBAL at t.                                                            [1/s]
double Simulation::mass_damping() const {
    return model_.mass_damping_curve >= 0 ? model_.curves[model_.mass_damping_curve](clock_.t)
                                          : model_.mass_damping;
}

/// f = -d m v.
void Simulation::add_mass_damping() {
    if (damping_force_.f.empty()) return;
    const double d = mass_damping();
    for (std::size_t n = 0; n < nodes_.size(); ++n)
        damping_force_.f[n] = -d * nodes_.mass[n] * nodes_.v[n];
}

/// v += span f / m; rigid bodies move as one; held directions do as they are told.
void Simulation::kick(double dt, double span) {
    ledger_.weight = clock_.weight(dt);
    v_before_ = nodes_.v;
    nodes_.add(load_force_.f);
    nodes_.add(damping_force_.f);
    ties_.share_force(nodes_.f);
    nodes_.kick(span);
    move_bodies(dt, span);
    supports_.hold(clock_.t, dt, span, nodes_);
    ties_.hold(nodes_.v);
    ledger_.after.kinetic = kinetic_energy();
}

void Simulation::move_bodies(double dt, double span) {
    if (bodies_.empty()) return;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        const RigidBody::Field field{loads_.acceleration(clock_.t, bodies_[b].part()),
                                     mass_damping()};
        bodies_[b].advance(clock_.t, dt, span, field, nodes_);
        movers_[b] = bodies_[b].mover();
    }
    for (RigidJoints& joints : joints_)
        joints.hold(clock_.t, dt, span, RigidJoints::After::KICK, bodies_, movers_, nodes_);
}

void Simulation::drift(double dt) {
    nodes_.drift(dt);
}

/// Walls and touching surfaces take away the velocity that would carry a place through them.
///
/// Their impulses m (v - v_k) act with the forces of the kick, v_before -> v_k; what they take is
/// m (v_k - v) · (v_before + v) / 2, nothing where a node rests against its load.
void Simulation::stop_at_obstacles(double dt) {
    bool has_stopped = !walls_.empty();
    if (!ties_.empty()) v_free_ = nodes_.v;
    v_kicked_.clear();
    if (has_stopped) v_kicked_ = nodes_.v;
    double by_walls = 0.0;
    for (contact::RigidWall& wall : walls_) {
        by_walls -= wall.driving_work() + wall.held_work();
        wall.hold(nodes_.x, met_mass(), clock_.t, dt, nodes_.v, {body_of_node_, movers_});
    }
    contact::SurfaceContact::Hold hold_by_walls;
    double by_joints = 0.0;
    if (!walls_.empty() || !joints_.empty())
        hold_by_walls = [&](bool is_last) {
            for (RigidJoints& joints : joints_) by_joints += joints.pass_on(movers_);
            for (contact::RigidWall& wall : walls_)
                wall.hold_again(is_last, nodes_.x, met_mass(), clock_.t, dt, nodes_.v,
                                {body_of_node_, movers_});
        };
    for (contact::SurfaceContact& contact : contacts_) {
        const double by_held = contact.held_work();
        has_stopped |= contact.respond(nodes_.x, dt, nodes_.v, movers_,
                                       has_stopped ? nullptr : &v_kicked_, hold_by_walls);
        ledger_.after.external += contact.held_work() - by_held;
        ledger_.after.contact += contact.held_work() - by_held;
    }
    for (const contact::RigidWall& wall : walls_)
        by_walls += wall.driving_work() + wall.held_work();
    ledger_.after.external += by_walls + by_joints;
    ledger_.after.contact += by_walls + by_joints;
    if (!ties_.empty() && has_stopped)
        ties_.settle(v_free_, nodes_.mass, met_mass_, nodes_.x, body_of_node_, movers_, nodes_.v);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        bodies_[b].take(movers_[b], dt, clock_.kick_span(dt), nodes_);
    if (has_stopped) {
        for (RigidJoints& joints : joints_)
            joints.hold(clock_.t, dt, clock_.kick_span(dt), RigidJoints::After::CONTACT, bodies_,
                        movers_, nodes_);
        if (!ties_.empty()) ties_.hold(nodes_.v);  // bodies have moved ends
        const double kicked = std::exchange(ledger_.after.kinetic, kinetic_energy());
        ledger_.after.contact +=
            kicked - ledger_.after.kinetic - parallel::sum(nodes_.size(), 0.0, [&](std::size_t n) {
                return 0.5 * nodes_.mass[n] *
                       (v_kicked_[n] - nodes_.v[n]).dot(v_kicked_[n] - v_before_[n]);
            });
    }
    check_finite();
}

}  // namespace corpuscle
