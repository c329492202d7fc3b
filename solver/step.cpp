// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// One time step. Leapfrog (central differences): positions x live at t, velocities v at t - dt/2.

#include <algorithm>

#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "solver/stops.hpp"

// Laps stand in a column of their own
// clang-format off
namespace corpuscle {

/// Advances fabric, gas, rigid bodies and their contacts from t to t + dt.
///
/// What the gas gives to the fabric during [t, t + dt] loads it from the following step on, so each
/// phase reads only finished data.
StepReport Simulation::step(const Observer& observe) {
    Stopwatch lap(timings_);
    scene_.activate_references();                                               lap("references");
    const StepLimit limit = scene_.stable_step();                               lap("stable step");
    const double t = scene_.clock.t, dt = limit.dt;
    fabric::Nodes& nodes = scene_.nodes;

    // 1., 2. Forces at t; v(t - dt/2) -> v(t + dt/2); between the two, at t, the energies balance
    const double span = scene_.clock.kick_span(dt);  // half the last step, half this one
    load_and_kick(dt, span, lap);
    observe(*this);                                                             lap("output");

    // 3. x(t) -> x(t + dt)
    nodes.drift(dt);                                                            lap("motion");

    // 4. Gas, t -> t + dt, against the fabric that moves from x to x_1
    touching_.tell_bags(scene_, span);                                          lap("contact");
    for (gas::BagGas& bag : scene_.airbags.particle) {
        if (bag.switches(t)) bag.become_uniform(dt, nodes.x, nodes.x_1);
        bag.prepare(dt, nodes.x, nodes.x_1);                                    lap("facet lists");
        bag.collide(dt, nodes.x);                                               lap("collisions");
        bag.inject(t, dt, nodes.x, nodes.x_1);                                  lap("inflators");
        bag.fly(t, dt, nodes.x, nodes.x_1);                                     lap("flight");
    }
    for (gas::UniformBag& bag : scene_.airbags.uniform) bag.flow(t, dt);
    for (const gas::Exchange& hole : scene_.airbags.exchanges)
        hole.flow(t, dt, nodes.x, scene_.airbags.uniform);
    if (!scene_.airbags.uniform.empty())                                        lap("uniform bags");

    // 5. Energy balance and clock
    check_given(scene_);
    scene_.ledger.commit();
    nodes.x.swap(nodes.x_1);
    scene_.clock.advance(dt);
    scene_.cloth.strained_start.advance();
    if (limit.who == StepLimit::Who::END) scene_.clock.t = scene_.model.end_time;
    return {t, dt, limit};
}

/// Brings velocities over t, and stops where what comes out is not physics.
void Simulation::load_and_kick(double dt, double span, Stopwatch& lap) {
    scene_.bodies.arrive();
    find_forces(span, lap);
    scene_.find_contacts(dt);                                                   lap("contact search");

    scene_.kick(dt, span);
    check_finite(scene_);                                                       lap("motion");
    scene_.stop_at_obstacles(dt);                                               lap("contact");
    check_finite(scene_);

    audit_.book(scene_, span);
    check_accounts(scene_);
    check_growth(scene_, span);                                                 lap("energy balance");
}

/// Forces of everything that acts on nodes at t.
void Simulation::find_forces(double span, Stopwatch& lap) {
    const double t = scene_.clock.t;
    fabric::Nodes& nodes = scene_.nodes;
    SceneForces& forces = scene_.forces;
    parallel::for_each(nodes.size(), [&](std::size_t n) { nodes.f[n].setZero(); });
    if (scene_.cloth.membranes) {
        scene_.cloth.membranes->restore_strains(t);
        const Index broken = scene_.cloth.membranes->add_force(nodes.x, nodes.v, nodes.f);
        if (broken >= 0) stop_for_strain(scene_, broken);
        parallel::copy(nodes.f, forces.fabric.f);                               lap("membranes");
    }
    for (gas::BagGas& bag : scene_.airbags.particle) {
        bag.add_load(nodes.x, nodes.v, nodes.mass, span, nodes.f);              lap("gas load");
    }
    for (gas::UniformBag& bag : scene_.airbags.uniform) {
        bag.add_load(t, nodes.x, nodes.f);                                      lap("gas load");
    }
    scene_.loads.find_force(t, nodes.x, nodes.mass, forces.loads.f);
    nodes.add(forces.loads.f);
    scene_.find_damping();
    nodes.add(forces.damping.f);                                                lap("loads");
}

}  // namespace corpuscle
