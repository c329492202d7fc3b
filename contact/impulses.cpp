// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/impulses.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace corpuscle::contact {
namespace {

constexpr int BODY_SWEEPS = 4;  ///< of friction on bodies, which rest on many places
constexpr int SWEEPS = 8;  ///< of the approach limit; more let less momentum pass through piles
constexpr double QUARTER = 0.25;  ///< of the rest gap that approach may not use up
constexpr double HALF = 0.5;      ///< of the remaining gap that one step may use up

}  // namespace

Impulses::Impulses(const Cloth& cloth)
    : cloth_(cloth), books_(cloth.rules.cards().size()), changed_(cloth.inverse_mass.size(), 0) {}

void Impulses::apply(double span, double dt, ContactList& contacts, Candidates& pairs,
                     Movement& motion) {
    for (ImpulseBooks& book : books_) book.given.setZero();
    book_kick(span, contacts, pairs, motion);
    on_body_.clear();
    contacts.for_each([&](Contact& c) {
        if (c.force <= 0.0) return;
        note_given(c, c.impulse * c.normal);
        PairMemory& memory = c.memory < 0 ? pairs.make_memory(c.pair) : pairs.memory_at(c.memory);
        double& account = memory.account;
        account += c.impulse * (c.rest_rate - 0.5 * (c.rate_before + c.rate_kicked));
        settle(span, c, account, motion);
        if (c.on_body) on_body_.push_back(&c);
    });
    for (int sweep = 0; sweep < BODY_SWEEPS; ++sweep)
        for (Contact* const c : on_body_) rub(*c, motion);
    limit_approach(dt, contacts, pairs, motion);
}

/// What repulsion has done, and what is left of pairs that do not push any more.
void Impulses::book_kick(double span, ContactList& contacts, Candidates& pairs,
                         const Movement& motion) {
    pool_ += pairs.take_parted_accounts();
    for (std::size_t chunk = 0; chunk < contacts.chunks(); ++chunk)
        for (const NearPair& near : contacts.near(chunk))
            if (near.has_account) pool_ += std::exchange(pairs.make_memory(near.pair).account, 0.0);
    contacts.for_each_apart([&](Contact& c) {
        c.impulse = span * c.force;
        c.rate_kicked = motion.rate(c);
    });
}

/// Repayment, damping and friction of a contact that pushes.
void Impulses::settle(double span, Contact& c, double& account, Movement& motion) {
    const double rate = motion.rate(c);
    const double repay = repay_debt(rate, c, account);
    const double repaid = -repay * (rate + 0.5 * repay / c.mass);
    // c dt / m of a dashpot c = 2 zeta k / omega, with the omega that the stiffness was found for
    const double zeta = 0.01 * card(c).damping;
    const double strength = 2.0 * zeta * c.stiffness * span / (std::sqrt(c.share) * c.mass);
    const double damp = -c.mass * (rate + repay / c.mass) * strength / (1.0 + strength);
    const double impulse = std::max(repay + damp, -c.impulse);  // contacts do not pull
    c.impulse += impulse;
    const double taken = push(impulse, c.normal, c.mass, c, motion);
    account += taken - repaid;
    books_[c.card].normal += taken;
    rub(c, motion);
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

double Impulses::approach_limit(double dt, double gap, double rest) {
    const double spare = gap - QUARTER * rest;
    return spare > 0.0 ? -HALF * spare / dt : 0.0;
}

/// In sweeps: what is too fast is found first, then slowed down, one after the other. From the
/// second sweep on only what has to do with nodes that the last one has changed is looked at.
void Impulses::limit_approach(double dt, ContactList& contacts, const Candidates& pairs,
                              Movement& motion) {
    too_fast_.resize(std::max(too_fast_.size(), contacts.chunks()));
    bool is_any = true;
    for (int sweep = 0; sweep < SWEEPS && is_any; ++sweep) {
        is_first_ = sweep == 0;
        contacts.for_each_chunk([&](std::size_t chunk) {
            too_fast_[chunk].clear();
            find_too_fast(dt, chunk, contacts, pairs, motion);
        });
        is_any = false;
        ++sweep_;
        for (std::size_t chunk = 0; chunk < contacts.chunks(); ++chunk)
            for (const Index row : too_fast_[chunk]) {
                Contact& c = contacts.chunk(chunk)[row];
                const double limit = approach_limit(dt, c.gap, c.rest);
                if (motion.rate(c) >= limit) continue;  // by now
                raise_rate(limit, c, motion);
                for (const Index n : c.node) changed_[n] = sweep_;
                is_any = true;
            }
    }
}

void Impulses::find_too_fast(double dt, std::size_t chunk, ContactList& contacts,
                             const Candidates& pairs, const Movement& motion) {
    if (is_first_) take_up(dt, chunk, contacts, pairs, motion);
    const std::vector<Contact>& all = contacts.chunk(chunk);
    for (std::size_t row = 0; row < all.size(); ++row) {
        const Contact& c = all[row];
        if (c.mass == INF || !(is_first_ || c.on_body || has_changed(c.node))) continue;
        if (motion.rate(c) < approach_limit(dt, c.gap, c.rest))
            too_fast_[chunk].push_back(static_cast<Index>(row));
    }
}

/// Makes contacts of pairs whose nodes are so fast that they may come too near. Of those that
/// impulses make so only later, the guard knows.
void Impulses::take_up(double dt, std::size_t chunk, ContactList& contacts, const Candidates& pairs,
                       const Movement& motion) {
    for (const NearPair& near : contacts.near(chunk)) {
        const Pair& pair = near.nodes;
        Corners v;
        for (int k = 0; k < 4; ++k) v[k] = motion.velocity(pair.node[k]);
        if (greatest_approach(pair, v) <= -approach_limit(dt, near.gap, near.rest)) continue;
        Contact& c = contacts.chunk(chunk).emplace_back(contact_at(
            cloth_, motion.bodies(), motion.x(), pair, nearest(pair, motion.x()), near.gap));
        c.pair = near.pair;
        c.card = pairs.card(near.pair);
        c.side = pairs.side(near.pair);
        c.rest = near.rest;
    }
}

bool Impulses::has_changed(const std::array<Index, 4>& nodes) const {
    return std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return changed_[n] == sweep_; });
}

void Impulses::raise_rate(double rate, Contact& c, Movement& motion) {
    const double impulse = c.mass * (rate - motion.rate(c));
    c.impulse += impulse;
    books_[c.card].normal += push(impulse, c.normal, c.mass, c, motion);
    rub(c, motion);
}

void Impulses::clump(std::span<const Index> nodes, std::span<const double> mass, Movement& motion) {
    const auto on_body =
        std::find_if(nodes.begin(), nodes.end(), [&](Index n) { return cloth_.body[n] >= 0; });
    if (on_body != nodes.end()) return clump_round(cloth_.body[*on_body], nodes, motion);
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
void Impulses::clump_round(Index body, std::span<const Index> nodes, Movement& motion) {
    for (int sweep = 0; sweep < BODY_SWEEPS; ++sweep)
        for (const Index n : nodes) {
            const auto [taken, work] = motion.join(n, body);
            books_[0].normal += taken;
            books_[0].held_work += work;
        }
}

/// Brings the friction of a contact to what stops its sliding, as far as its normal impulse allows:
///     |sum of friction impulses| <= mu · sum of normal impulses
void Impulses::rub(Contact& c, Movement& motion) {
    const ContactCard& by = card(c);
    const double most = std::max(by.friction_static, by.friction_dynamic);
    if (most == 0.0 || c.mass == INF) return;
    const Vec3 relative = motion.relative(c);
    const Vec3 sliding = relative - c.normal.dot(relative) * c.normal;
    const double speed = sliding.norm();
    if (speed == 0.0) return;
    const double mass = motion.mass(c, sliding / speed);
    if (mass == INF) return;
    const double mu = by.friction_dynamic + (by.friction_static - by.friction_dynamic) *
                                                std::exp(-by.friction_decay * speed);
    Vec3 wanted = c.rubbed - mass * sliding;
    const double strength = wanted.norm(), limit = std::max(0.0, mu * c.impulse);
    if (strength > limit) wanted *= limit / strength;
    const Vec3 change = wanted - c.rubbed;
    const double size = change.norm();
    if (size == 0.0) return;
    const Vec3 along = change / size;
    books_[c.card].friction += push(size, along, motion.mass(c, along), c, motion);
    c.rubbed = wanted;
}

/// Gives an impulse along a unit direction to the contact's two places.
/// @param mass  of the contact along that direction                                       [kg]
/// @returns energy taken: -J (rate before + rate after) / 2                                    [J]
double Impulses::push(double impulse, const Vec3& direction, double mass, const Contact& c,
                      Movement& motion) {
    const double rate = direction.dot(motion.relative(c));
    const Vec3 whole = impulse * direction;
    for (int i = 0; i < 4; ++i)
        if (c.weight[i] != 0.0)
            books_[c.card].held_work += motion.push(c.node[i], c.weight[i] * whole);
    note_given(c, whole);
    return -impulse * (rate + 0.5 * impulse / mass);
}

void Impulses::note_given(const Contact& c, const Vec3& impulse) {
    if (c.side != 0) {
        books_[c.card].given += c.side * impulse;
        return;
    }
    for (int i = 0; i < 4; ++i)
        if (cloth_.inverse_mass[c.node[i]] > 0.0) books_[c.card].given += c.weight[i] * impulse;
}

}  // namespace corpuscle::contact
