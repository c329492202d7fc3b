// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/impulses.hpp"

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
    : cloth_(cloth), books_(cloth.rules.cards().size()), changed_(cloth.inverse_mass.size(), 0) {
    for (Column& column : columns_) {
        column.books.reserve(books_.size() + 2);
        column.books = books_;
    }
}

void Impulses::apply(double span, double dt, ContactList& contacts, Columns& columns,
                     Candidates& pairs, Movement& motion) {
    for (ImpulseBooks& book : books_) book.given.setZero();
    book_kick(span, contacts, pairs, motion);
    if (contacts.chunks() == 0) return;
    share_debt(contacts, columns);
    on_body_.clear();
    columns.for_each(contacts, [&](Contact& c) {
        if (c.force <= 0.0) return;
        note_given(c, c.impulse * c.normal);
        settle(span, c, pairs.memory_at(c.memory).account, motion);
        if (c.on_body) on_body_.push_back(&c);
    });
    for (int sweep = 0; sweep < BODY_SWEEPS; ++sweep)
        for (Contact* const c : on_body_) rub(*c, motion);
    take_up(dt, contacts, columns, pairs, motion);
    columns.sort(contacts);
    limit_approach(dt, contacts, columns, motion);
    close_columns();
}

/// Makes contacts of pairs whose nodes are so fast that they may come too near. Of those that
/// impulses make so only later, the guard knows.
void Impulses::take_up(double dt, ContactList& contacts, const Columns& columns,
                       const Candidates& pairs, const Movement& motion) {
    contacts.for_each_chunk([&](std::size_t chunk) {
        for (const NearPair& near : contacts.near(chunk)) {
            const Pair& pair = near.nodes;
            Corners v;
            for (int k = 0; k < 4; ++k) v[k] = motion.velocity(pair.node[k]);
            if (greatest_approach(pair, v) <= -approach_limit(dt, near.gap, near.rest)) continue;
            const Contact found = contact_at(cloth_, motion.bodies(), motion.x(), pair,
                                             nearest(pair, motion.x()), near.gap);
            Contact& c = contacts.add(chunk, columns.of(found, motion.x()), found);
            c.pair = near.pair;
            c.card = pairs.card(near.pair);
            c.side = pairs.side(near.pair);
            c.rest = near.rest;
        }
    });
}

/// What repulsion has done, and what is left of pairs that do not push any more.
void Impulses::book_kick(double span, ContactList& contacts, Candidates& pairs,
                         const Movement& motion) {
    pool_ += pairs.take_parted_accounts();
    for (std::size_t chunk = 0; chunk < contacts.chunks(); ++chunk)
        for (const NearPair& near : contacts.near(chunk))
            if (near.has_account) pool_ += std::exchange(pairs.make_memory(near.pair).account, 0.0);
    unsettled_.resize(std::max(unsettled_.size(), contacts.chunks()));
    const auto work = [](const Contact& c) {
        return c.impulse * (c.rest_rate - 0.5 * (c.rate_before + c.rate_kicked));
    };
    contacts.for_each_chunk([&](std::size_t chunk) {
        unsettled_[chunk].clear();
        for (Contact& c : contacts.chunk(chunk)) {
            c.impulse = span * c.force;
            c.rate_kicked = motion.rate(c);
            if (c.force <= 0.0) continue;
            if (c.memory < 0 || (pairs.memory_at(c.memory).account += work(c)) < 0.0)
                unsettled_[chunk].push_back(&c);
        }
    });
    for (std::size_t chunk = 0; chunk < contacts.chunks(); ++chunk)
        for (Contact* const c : unsettled_[chunk]) {
            if (c->memory < 0) {
                pairs.make_memory(c->pair).account = work(*c);
                c->memory = pairs.memory_row(c->pair);
            }
            draw(pairs.memory_at(c->memory).account);
        }
}

/// What parted pairs took beyond what they gave pays the debts of others.
void Impulses::draw(double& account) {
    if (account >= 0.0 || pool_ <= 0.0) return;
    const double drawn = std::min(pool_, -account);
    account += drawn;
    pool_ -= drawn;
}

/// The debt of parted pairs is for those to repay that part now: each column's share is by how many
/// it has.
void Impulses::share_debt(ContactList& contacts, const Columns& columns) {
    if (pool_ >= 0.0) return;
    const auto is_parting = [](const Contact& c) { return c.force > 0.0 && c.rate_kicked > 0.0; };
    columns.for_each(contacts, [&](const Contact& c) {
        if (is_parting(c)) columns_[c.column].debt -= 1.0;
    });
    double all = 0.0;
    for (const Column& column : columns_) all -= column.debt;
    if (all == 0.0) return;
    for (Column& column : columns_) column.debt *= -pool_ / all;
    pool_ = 0.0;
}

/// Adds up what the columns hold, in their order.
void Impulses::close_columns() {
    for (Column& column : columns_) {
        pool_ += std::exchange(column.debt, 0.0);
        for (std::size_t c = 0; c < books_.size(); ++c) {
            books_[c] += column.books[c];
            column.books[c] = {};
        }
    }
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
    book(c).normal += taken;
    rub(c, motion);
}

/// Impulse, <= 0, that takes back from a parting pair what repulsion has given beyond what it took,
/// here or where pairs have parted.
double Impulses::repay_debt(double rate, const Contact& c, double& account) {
    double& debt = columns_[c.column].debt;
    const double owed = -std::min(account, 0.0) - std::min(debt, 0.0);
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
    debt += taken;
    return impulse;
}

double Impulses::approach_limit(double dt, double gap, double rest) {
    const double spare = gap - QUARTER * rest;
    return spare > 0.0 ? -HALF * spare / dt : 0.0;
}

/// In sweeps: what is too fast is found first, then slowed down. From the second sweep on only what
/// has to do with nodes that the last one has changed is looked at.
void Impulses::limit_approach(double dt, ContactList& contacts, const Columns& columns,
                              Movement& motion) {
    too_fast_.resize(std::max(too_fast_.size(), contacts.chunks()));
    for (int sweep = 0; sweep < SWEEPS; ++sweep) {
        contacts.for_each_chunk([&](std::size_t chunk) {
            too_fast_[chunk].clear();
            std::vector<Contact>& all = contacts.chunk(chunk);
            for (std::size_t row = 0; row < all.size(); ++row) {
                const auto& [node, column] = contacts.briefs(chunk)[row];
                if (sweep > 0 && column != Contact::ALONE && !has_changed(node)) continue;
                Contact& c = all[row];
                if (c.mass < INF && motion.rate(c) < approach_limit(dt, c.gap, c.rest))
                    too_fast_[chunk].push_back(&c);
            }
        });
        bool is_any = false;
        for (Column& column : columns_) column.too_fast.clear();
        for (std::size_t chunk = 0; chunk < contacts.chunks(); ++chunk)
            for (Contact* const c : too_fast_[chunk]) {
                columns_[c->column].too_fast.push_back(c);
                is_any = true;
            }
        if (!is_any) break;
        ++sweep_;
        columns.for_each([&](std::size_t column) {
            for (Contact* const c : columns_[column].too_fast) {
                const double limit = approach_limit(dt, c->gap, c->rest);
                if (motion.rate(*c) >= limit) continue;  // by now
                raise_rate(limit, *c, motion);
                for (const Index n : c->node) changed_[n] = sweep_;
            }
        });
    }
}

bool Impulses::has_changed(const std::array<Index, 4>& nodes) const {
    return std::any_of(nodes.begin(), nodes.end(), [&](Index n) { return changed_[n] == sweep_; });
}

void Impulses::raise_rate(double rate, Contact& c, Movement& motion) {
    const double impulse = c.mass * (rate - motion.rate(c));
    c.impulse += impulse;
    book(c).normal += push(impulse, c.normal, c.mass, c, motion);
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
    book(c).friction += push(size, along, motion.mass(c, along), c, motion);
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
        if (c.weight[i] != 0.0) book(c).held_work += motion.push(c.node[i], c.weight[i] * whole);
    note_given(c, whole);
    return -impulse * (rate + 0.5 * impulse / mass);
}

void Impulses::note_given(const Contact& c, const Vec3& impulse) {
    if (c.side != 0) {
        book(c).given += c.side * impulse;
        return;
    }
    for (int i = 0; i < 4; ++i)
        if (cloth_.inverse_mass[c.node[i]] > 0.0) book(c).given += c.weight[i] * impulse;
}

}  // namespace corpuscle::contact
