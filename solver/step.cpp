// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// One time step. Leapfrog (central differences): positions x live at t, velocities v at t - dt/2.

#include <algorithm>

#include "solver/simulation.hpp"

// Laps stand in a column of their own
// clang-format off
namespace corpuscle {

/// Advances fabric, gas, rigid bodies and their contacts from t to t + dt.
///
/// What the gas gives to the fabric during [t, t + dt] loads it from the following step on, so each
/// phase reads only finished data.
StepReport Simulation::step(const Observer& observe) {
    Stopwatch lap(timings_);
    bear_references();
    const StepLimit limit = stable_step();
    const double t = clock_.t, dt = limit.dt;
    const double span = clock_.kick_span(dt);  // half the last step, half this one

    // 1. Forces at t
    find_forces(dt, span, lap);

    // 2. v(t - dt/2) -> v(t + dt/2); between the two, at t, the books balance
    kick(dt, span);                                                             lap("motion");
    stop_at_obstacles(dt);                                                      lap("contact");
    book_forces(span);                                                          lap("motion");
    observe(*this);                                                             lap("output");

    // 3. x(t) -> x(t + dt)
    drift(dt);                                                                  lap("motion");

    // 4. Gas, t -> t + dt, against the fabric that moves from x to x_1
    find_touching(span);
    for (gas::BagGas& bag : bags_) {
        if (bag.switches(t)) bag.become_uniform(nodes_.x);
        bag.prepare(dt, nodes_.x, nodes_.x_1);                                  lap("facet lists");
        bag.collide(dt, nodes_.x);                                              lap("collisions");
        bag.inject(t, dt, nodes_.x, nodes_.x_1);                                lap("inflators");
        bag.fly(t, dt, nodes_.x, nodes_.x_1);                                   lap("flight");
    }
    for (gas::UniformBag& bag : uniform_bags_) bag.flow(t, dt);
    for (const gas::Exchange& hole : exchanges_) hole.flow(t, dt, nodes_.x, uniform_bags_);

    // 5. Page and clock
    ledger_.turn_page();
    nodes_.x.swap(nodes_.x_1);
    clock_.advance(dt);
    if (limit.who == StepLimit::Who::END) clock_.t = model_.end_time;
    return {t, dt, limit};
}

/// Forces of everything that acts on nodes at t.
void Simulation::find_forces(double dt, double span, Stopwatch& lap) {
    std::fill(nodes_.f.begin(), nodes_.f.end(), Vec3::Zero());
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        bodies_[b].arrive();
        movers_[b] = bodies_[b].mover();
    }
    for (fabric::Membranes& fabric : fabric_) {
        fabric.restore_strains(clock_.t);
        const Index broken = fabric.add_force(nodes_.x, nodes_.v, nodes_.f);    lap("membranes");
        if (broken >= 0) stop_for(broken);
        fabric_force_.f = nodes_.f;
    }
    for (gas::BagGas& bag : bags_) {
        bag.add_load(nodes_.x, nodes_.v, nodes_.mass, span, nodes_.f);          lap("gas load");
    }
    for (gas::UniformBag& bag : uniform_bags_) {
        bag.add_load(clock_.t, nodes_.x, nodes_.f);                             lap("gas load");
    }
    for (contact::SurfaceContact& contact : contacts_) {
        contact.find(nodes_.x, nodes_.v, clock_.t, dt, movers_);                lap("contact search");
    }
    loads_.find_force(clock_.t, nodes_.x, nodes_.mass, load_force_.f);
    add_mass_damping();                                                         lap("loads");
}

}  // namespace corpuscle
