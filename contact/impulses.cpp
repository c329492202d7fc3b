// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/impulses.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/repulsion.hpp"

namespace corpuscle::contact {
namespace {

constexpr int SWEEPS =
    4;  ///< of the approach limit; more of them let less momentum pass through piles
constexpr double QUARTER = 0.25;  ///< of the rest gap that approach may not use up
constexpr double HALF = 0.5;      ///< of the remaining gap that one step may use up

}  // namespace

Impulses::Impulses(const Cloth& cloth, const ContactCard& card) : cloth_(cloth), card_(card) {}

void Impulses::apply(double span, double dt, ContactList& contacts, Candidates& pairs, Points& v) {
    pool_ += pairs.take_parted_accounts();
    contacts.for_each([&](Contact& c) {
        c.impulse = span * c.force;
        if (c.force > 0.0)
            pairs.make_memory(c.pair).account +=
                c.impulse * (c.rest_rate - 0.5 * (c.rate_before + c.rate(v)));
        else if (PairMemory* const parted = pairs.memory(c.pair);
                 parted != nullptr && c.gap >= c.rest)
            pool_ += std::exchange(parted->account, 0.0);
    });
    contacts.for_each([&](Contact& c) {
        if (c.force > 0.0) settle(span, c, pairs.make_memory(c.pair).account, v);
    });
    bool is_stopped = true;
    for (int sweep = 0; sweep < SWEEPS && is_stopped; ++sweep) {
        is_stopped = false;
        contacts.for_each([&](Contact& c) { is_stopped |= limit_approach(dt, c, v); });
    }
}

/// Repayment, damping and friction of a contact that pushes.
void Impulses::settle(double span, Contact& c, double& account, Points& v) {
    const double rate = c.rate(v);
    const double repay = repay_debt(rate, c, account);
    const double repaid = -repay * (rate + 0.5 * repay / c.mass);
    // c dt / m of a dashpot c = 2 zeta k / omega, with the omega dt that the stiffness was found
    // for
    const double zeta = 0.01 * card_.damping;
    const double strength =
        2.0 * zeta * c.stiffness * span * span / (std::sqrt(STIFFNESS) * c.mass);
    const double damp = -c.mass * (rate + repay / c.mass) * strength / (1.0 + strength);
    const double impulse = std::max(repay + damp, -c.impulse);  // contacts do not pull
    c.impulse += impulse;
    const double taken = push(impulse, c.normal, c, v);
    account += taken - repaid;
    books_.normal += taken;
    rub(c.impulse, c, v);
}

/// Impulse, <= 0, that takes back from a parting pair what repulsion has given beyond what it took,
/// here or where pairs have parted; none while pairs that have parted took more than they gave.
double Impulses::repay_debt(double rate, const Contact& c, double& account) {
    if (account < 0.0 && pool_ > 0.0) {
        const double drawn = std::min(pool_, -account);
        account += drawn;
        pool_ -= drawn;
    }
    const double owed = -std::min(account, 0.0) - std::min(pool_, 0.0);
    if (owed == 0.0 || rate <= 0.0) return 0.0;
    const double left = rate * rate - 2.0 * owed / c.mass;
    const double impulse =
        std::max(c.mass * ((left > 0.0 ? std::sqrt(left) : 0.0) - rate), -c.impulse);
    double taken = -impulse * (rate + 0.5 * impulse / c.mass);
    if (account < 0.0) {
        const double here = std::min(taken, -account);
        account += here;
        taken -= here;
    }
    pool_ += taken;
    return impulse;
}

bool Impulses::limit_approach(double dt, Contact& c, Points& v) {
    const double spare = c.gap - QUARTER * c.rest;
    const double limit = spare > 0.0 ? -HALF * spare / dt : 0.0;
    if (c.rate(v) >= limit || c.mass == INF) return false;
    raise_rate(limit, c, v);
    return true;
}

void Impulses::raise_rate(double rate, Contact& c, Points& v) {
    const double impulse = c.mass * (rate - c.rate(v));
    c.impulse += impulse;
    books_.normal += push(impulse, c.normal, c, v);
    rub(impulse, c, v);
}

void Impulses::clump(std::span<const Index> nodes, std::span<const double> mass, Points& v) {
    Vec3 momentum = Vec3::Zero(), held_velocity = Vec3::Zero();
    double total = 0.0, kinetic = 0.0;
    int held = 0;
    for (const Index n : nodes) {
        if (cloth_.inverse_mass[n] == 0.0) {
            held_velocity += v[n];
            ++held;
            continue;
        }
        momentum += mass[n] * v[n];
        kinetic += 0.5 * mass[n] * v[n].squaredNorm();
        total += mass[n];
    }
    const Vec3 common = held > 0 ? Vec3(held_velocity / held) : Vec3(momentum / total);
    for (const Index n : nodes)
        if (cloth_.inverse_mass[n] > 0.0) v[n] = common;
    const double work = held > 0 ? (total * common - momentum).dot(common) : 0.0;
    books_.held_work += work;
    books_.normal += kinetic + work - 0.5 * total * common.squaredNorm();
}

void Impulses::rub(double normal_impulse, const Contact& c, Points& v) {
    const double most = std::max(card_.friction_static, card_.friction_dynamic);
    if (most == 0.0 || c.mass == INF) return;
    const Vec3 relative = c.relative(v);
    const Vec3 sliding = relative - c.normal.dot(relative) * c.normal;
    const double speed = sliding.norm();
    if (speed == 0.0) return;
    const double mu = card_.friction_dynamic + (card_.friction_static - card_.friction_dynamic) *
                                                   std::exp(-card_.friction_decay * speed);
    const double impulse = std::min(mu * normal_impulse, c.mass * speed);
    books_.friction += push(-impulse, sliding / speed, c, v);
}

/// Gives an impulse along a unit direction to the contact's two places.
/// @returns energy taken: -J (rate before + rate after) / 2                                    [J]
double Impulses::push(double impulse, const Vec3& direction, const Contact& c, Points& v) {
    const double rate = direction.dot(c.relative(v));
    for (int i = 0; i < 4; ++i) {
        const double inverse = cloth_.inverse_mass[c.node[i]];
        const Vec3 share = impulse * c.weight[i] * direction;
        if (inverse == 0.0)
            books_.held_work -= share.dot(v[c.node[i]]);
        else
            v[c.node[i]] += inverse * share;
    }
    return -impulse * (rate + 0.5 * impulse / c.mass);
}

}  // namespace corpuscle::contact
