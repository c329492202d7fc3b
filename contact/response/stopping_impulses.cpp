// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/stopping_impulses.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {
namespace {

constexpr int BODY_SWEEPS = 4;  ///< over the nodes of an impact zone that a rigid body is part of

}  // namespace

void StoppingImpulses::raise_rate(double rate, Contact& c, VelocityState& motion) {
    const double impulse = c.mass * (rate - motion.rate(c));
    c.impulse += impulse;
    book(c).normal += push(impulse, c.normal, c.mass, c, motion);
    rub(c, motion);
}

void StoppingImpulses::join_zone(std::span<const Index> nodes, std::span<const double> mass,
                                 VelocityState& motion) {
    const auto on_body =
        std::find_if(nodes.begin(), nodes.end(), [&](Index n) { return cloth_.body[n] >= 0; });
    if (on_body != nodes.end()) return join_to_body(cloth_.body[*on_body], nodes, motion);
    Vec3 momentum = Vec3::Zero(), held_velocity = Vec3::Zero();
    double total = 0.0, kinetic = 0.0;
    int held = 0;
    for (const Index n : nodes) {
        const Vec3 v = motion.velocity(n);
        if (cloth_.inverse_mass[n] == 0.0) {
            held_velocity += v;
            ++held;
            continue;
        }
        momentum += mass[n] * v;
        kinetic += 0.5 * mass[n] * v.squaredNorm();
        total += mass[n];
    }
    const Vec3 common = held > 0 ? Vec3(held_velocity / held) : Vec3(momentum / total);
    for (const Index n : nodes)
        if (cloth_.inverse_mass[n] > 0.0) motion.set(n, common);
    const double work = held > 0 ? (total * common - momentum).dot(common) : 0.0;
    books_[0].held_work += work;
    books_[0].normal += kinetic + work - 0.5 * total * common.squaredNorm();
}

/// Joins nodes to a rigid body one after the other [Gauss-Seidel]: they are light beside it, so a
/// few sweeps leave next to nothing between them.
void StoppingImpulses::join_to_body(Index body, std::span<const Index> nodes,
                                    VelocityState& motion) {
    for (int sweep = 0; sweep < BODY_SWEEPS; ++sweep)
        for (const Index n : nodes) {
            const auto [taken, work] = motion.join(n, body);
            books_[0].normal += taken;
            books_[0].held_work += work;
        }
}

/// Brings the friction of a contact to what stops its sliding, as far as its normal impulse allows:
///     |sum of friction impulses| <= mu · sum of normal impulses
void StoppingImpulses::rub(Contact& c, VelocityState& motion) {
    const ContactCard& by = cloth_.rules.card(c.card);
    if (by.greatest_mu() == 0.0 || c.mass == INF) return;
    const Vec3 relative = motion.relative(c);
    const Vec3 sliding = relative - c.normal.dot(relative) * c.normal;
    const double speed = sliding.norm();
    if (speed == 0.0) return;
    const double mass = motion.mass(c, sliding / speed);
    if (mass == INF) return;
    Vec3 wanted = c.rubbed - mass * sliding;
    const double strength = wanted.norm(), limit = std::max(0.0, by.mu(speed) * c.impulse);
    if (strength > limit) wanted *= limit / strength;
    const Vec3 change = wanted - c.rubbed;
    const double size = change.norm();
    if (size == 0.0) return;
    const Vec3 along = change / size;
    book(c).friction += push(size, along, motion.mass(c, along), c, motion);
    c.rubbed = wanted;
}

/// Gives an impulse along a unit direction to the contact's two places.
/// @param mass  of the contact along that direction                                       [kg]
/// @returns energy taken: -J (rate before + rate after) / 2                                    [J]
double StoppingImpulses::push(double impulse, const Vec3& direction, double mass, const Contact& c,
                              VelocityState& motion) {
    const double rate = direction.dot(motion.relative(c));
    const Vec3 whole = impulse * direction;
    for (int i = 0; i < 4; ++i)
        if (c.weight[i] != 0.0) book(c).held_work += motion.push(c.node[i], c.weight[i] * whole);
    book(c).give(whole, c, cloth_);
    return -impulse * (rate + 0.5 * impulse / mass);
}

}  // namespace corpuscle::contact
