// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// How forces and obstacles change the velocities of nodes and rigid bodies in a step.

#include <utility>

#include "solver/base/parallel.hpp"
#include "solver/bodies/rigid_parts.hpp"
#include "solver/scene/scene_state.hpp"

namespace corpuscle {

/// d of *DAMPING_GLOBAL at t.                                                            [1/s]
double SceneState::mass_damping() const {
    return model.mass_damping_curve >= 0 ? model.curves[model.mass_damping_curve](clock.t)
                                         : model.mass_damping;
}

namespace {

/// d that the dampings `own` of parts give to what has these shares of them.             [1/s]
double damping_of(const std::vector<double>& shares, const std::vector<double>& own) {
    double all = 0.0;
    for (std::size_t k = 0; k < own.size(); ++k) all += shares[k] * own[k];
    return all;
}

}  // namespace

std::vector<double> SceneState::part_dampings() const {
    std::vector<double> own;
    for (const PartDamping& damping : model.part_dampings)
        own.push_back(damping.scale * model.curves[damping.curve](clock.t));
    return own;
}

/// Cloth that rides on a body is damped for itself, and not as the body's rigid parts are, whose
/// damping is that of all the body (move_bodies).
void SceneState::find_damping() {
    if (forces.damping.f.empty()) return;
    const double d = mass_damping();
    const std::vector<double> own = part_dampings();
    parallel::for_each(nodes.size(), [&](std::size_t n) {
        Vec3& f = forces.damping.f[n];
        f = -d * nodes.mass[n] * nodes.v[n];
        if (!(nodes.mass[n] > 0.0)) return;  // of a rigid body, or tied
        for (std::size_t k = 0; k < own.size(); ++k)
            f -= own[k] * forces.damped_mass[k][n] * nodes.v[n];
    });
    if (own.empty()) return;
    for (const RidingNode& at : bodies.riding) {
        const RigidBody& body = bodies.all[at.body];
        double drag = -damping_of(bodies.damped[at.body], own) * at.by_shells;  // [kg/s]
        for (std::size_t k = 0; k < own.size(); ++k)
            drag += own[k] * forces.damped_mass[k][at.node];
        forces.damping.f[at.node] -=
            drag * (body.velocity() + body.spin().cross(nodes.x[at.node] - body.position()));
    }
}

/// Mass that the shells of each damped part of cloth give to nodes, and of tied nodes to those that
/// bear it; rigid parts are damped as one.
void SceneState::find_damped_mass() {
    for (const PartDamping& damping : model.part_dampings) {
        std::vector<std::uint8_t> is_meant(model.parts.size(), 0);
        is_meant[damping.part] = !is_rigid(model, damping.part);
        forces.damped_mass.push_back(mass_at_nodes(model, cloth.shell_mass, ties, is_meant));
    }
}

/// What cloth and bodies may touch until t + dt.
void SceneState::find_contacts(double dt) {
    for (std::size_t b = 0; b < bodies.all.size(); ++b) bodies.proxies[b] = bodies.all[b].proxy();
    if (obstacles.contact) obstacles.contact->find(nodes.x, nodes.v, clock.t, dt, bodies.proxies);
}

/// v += span f / m; rigid bodies move as one; held directions do as they are told.
void SceneState::kick(double dt, double span) {
    ledger.weight = clock.weight(dt);
    ties.share_force(nodes.f);
    nodes.kick(span, &v.before);
    move_bodies(dt, span);
    supports.hold(clock.t, dt, span, v.before, nodes);
    ties.hold(nodes.v);
    ledger.after.kinetic = kinetic_energy();
}

void SceneState::move_bodies(double dt, double span) {
    if (bodies.all.empty()) return;
    if (bodies.springs) bodies.springs->find(clock.t, bodies.all);
    const std::vector<double> own = part_dampings();
    for (std::size_t b = 0; b < bodies.all.size(); ++b) {
        const Index part = bodies.all[b].part();
        const auto [force, moment] = loads.push(clock.t, nodes.x, bodies.all[b].parts());
        RigidBody::Field field{loads.acceleration(clock.t, part), mass_damping(), force, moment};
        if (bodies.springs) field.springs = bodies.springs->moment(b);
        if (!own.empty()) field.damping += damping_of(bodies.damped[b], own);
        bodies.all[b].advance(clock.t, dt, span, field, nodes);
        bodies.proxies[b] = bodies.all[b].proxy();
    }
    if (bodies.joints)
        bodies.joints->hold(clock.t, dt, span, RigidJoints::After::KICK, bodies.all, bodies.proxies,
                            nodes);
}

/// Walls and touching surfaces take away the velocity that would carry a place through them.
///
/// Their impulses m (v - v_k) act with the forces of the kick, v_before -> v_k; what they take is
/// m (v_k - v) · (v_before + v) / 2, nothing where a node rests against its load.
void SceneState::stop_at_obstacles(double dt) {
    bool has_stopped = !obstacles.walls.empty();
    if (!ties.empty()) v.free = nodes.v;
    v.kicked.clear();
    if (has_stopped) parallel::copy(nodes.v, v.kicked);
    double by_walls = 0.0;
    for (contact::RigidWall& wall : obstacles.walls) {
        by_walls -= wall.driving_work() + wall.held_work();
        wall.hold(nodes.x, mass_met(), clock.t, dt, nodes.v, {bodies.of_node, bodies.proxies});
    }
    contact::SurfaceContact::Hold hold_by_walls;
    double by_joints = 0.0;
    if (!obstacles.walls.empty() || bodies.joints)
        hold_by_walls = [&](bool is_last) {
            if (bodies.joints) by_joints += bodies.joints->pass_on(bodies.proxies);
            for (contact::RigidWall& wall : obstacles.walls)
                wall.hold_again(is_last, nodes.x, mass_met(), clock.t, dt, nodes.v,
                                {bodies.of_node, bodies.proxies});
        };
    if (obstacles.contact) {
        const double by_held = obstacles.contact->held_work();
        has_stopped |=
            obstacles.contact->respond(nodes.x, dt, nodes.v, bodies.proxies,
                                       has_stopped ? nullptr : &v.kicked, hold_by_walls, &v.before);
        ledger.after.external += obstacles.contact->held_work() - by_held;
        ledger.after.contact += obstacles.contact->held_work() - by_held;
    }
    for (const contact::RigidWall& wall : obstacles.walls)
        by_walls += wall.driving_work() + wall.held_work();
    ledger.after.external += by_walls + by_joints;
    ledger.after.contact += by_walls + by_joints;
    if (!ties.empty() && has_stopped)
        ties.settle(v.free, nodes.mass, met_mass, nodes.x, bodies.of_node, bodies.proxies, nodes.v);
    for (std::size_t b = 0; b < bodies.all.size(); ++b) {
        const Vec3 by_joints = bodies.joints ? bodies.joints->passed_on(b) : Vec3(Vec3::Zero());
        bodies.all[b].take(bodies.proxies[b], by_joints, dt, clock.kick_span(dt), nodes);
    }
    if (has_stopped) {
        if (bodies.joints)
            bodies.joints->hold(clock.t, dt, clock.kick_span(dt), RigidJoints::After::CONTACT,
                                bodies.all, bodies.proxies, nodes);
        if (!ties.empty()) ties.hold(nodes.v);  // bodies have moved ends
        book_stops();
    }
}

/// Books what obstacles took from nodes, v.kicked -> v.
void SceneState::book_stops() {
    using Two = Eigen::Vector2d;  // kinetic energy; what obstacles took beside the kick
    const Two sums = parallel::sum(nodes.size(), Two(Two::Zero()), [&](std::size_t n) {
        const Vec3& now = nodes.v[n];
        return Two(0.5 * nodes.mass[n] * now.squaredNorm(),
                   0.5 * nodes.mass[n] * (v.kicked[n] - now).dot(v.kicked[n] - v.before[n]));
    });
    const double kicked = std::exchange(ledger.after.kinetic, with_obstacles(sums[0]));
    ledger.after.contact += kicked - ledger.after.kinetic - sums[1];
}

/// Of nodes, rigid bodies and walls of mass, at the half step that velocities live at. [J]
double SceneState::kinetic_energy() const {
    return with_obstacles(nodes.kinetic_energy());
}

double SceneState::with_obstacles(double all) const {
    for (const RigidBody& body : bodies.all) all += body.kinetic_energy();
    for (const contact::RigidWall& wall : obstacles.walls) all += wall.kinetic_energy();
    return all;
}

Vec3 SceneState::gas_force(Index node) const {
    Vec3 force = Vec3::Zero();
    for (const gas::BagGas& bag : airbags.particle) force += bag.force(node);
    for (const gas::UniformBag& bag : airbags.uniform) force += bag.force(node);
    return force;
}

Vec3 SceneState::velocity(Index node) const {
    if (!bodies.of_node.empty() && bodies.of_node[node] >= 0)
        return bodies.all[bodies.of_node[node]].velocity_at_t(nodes.x[node], ledger.weight);
    return (1.0 - ledger.weight) * v.before[node] + ledger.weight * nodes.v[node];
}

}  // namespace corpuscle
