// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// The rows of the implicit law: what a contact offers, and what it starts with.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/response/implicit_response.hpp"
#include "contact/response/overlap_area.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t NEW_ROWS_A_CHUNK = 64;   ///< rows
constexpr std::size_t NEW_CONTACT_CHUNKS = 1;  ///< chunks of contacts at once

/// A pair hits that closes in a step by more than this share of its rest gap, so that the step does
/// not resolve its oscillation, and so fast that it would be pressed by as much.
constexpr double HIT = 0.25;

constexpr double ALIKE = 8.0;  ///< taken for (w dt)² of all that act alike, over k span dt / m
constexpr double LEAST_THETA = 0.2;

/// A pair that closes faster than at this share of the speed that what it owes could give it does
/// not pay yet.
constexpr double CLOSING = 0.5;

constexpr double SLID = 0.01;     ///< of an edge: how far an area is good
constexpr double LONGEST = 16.0;  ///< steps for which it is

/// Share of its energy that a hit leaves a pair with a dashpot: what a linear oscillator keeps over a
/// whole oscillation, since the law stiffens.
double kept_by_hit(double zeta) {
    if (zeta == 0.0) return 1.0;
    return zeta < 1.0 ? std::exp(-4.0 * std::numbers::pi * zeta / std::sqrt(1.0 - zeta * zeta))
                      : 0.0;
}

}  // namespace

/// Whether a pair hit in the step before and has not paid.
bool ImplicitResponse::owes_still(const NearPair& near, Candidates& pairs) const {
    if (near.memory < 0) return false;
    const PairMemory& memory = pairs.memory_at(near.memory);
    return memory.owed > 0.0 && memory.step + 1 == step_;
}

/// Finds the area of a contact, for as many steps as it is about the same.
void ImplicitResponse::measure(double dt, const VelocityState& motion, Contact& c) const {
    const ContactArea found = overlap_area(cloth_, motion.x(), c);
    c.area = found.area;
    c.own_area = found.own;
    const Vec3 relative = motion.relative(c);
    const double way = dt * (relative - c.normal.dot(relative) * c.normal).norm();
    const double steps = std::min(SLID * cloth_.mean_edge / std::max(way, 1e-300), LONGEST);
    c.area_until = step_ + 1 + static_cast<std::uint32_t>(steps);
}

/// Makes sure that each contact has a memory, an area, and the impulses of the step before.
void ImplicitResponse::recall(double span, double dt, ContactList& contacts, Candidates& pairs,
                              const VelocityState& motion) {
    fresh_.clear();
    found_fresh_.find(
        contacts.chunks(), fresh_,
        [&](std::size_t chunk, auto&& take) {
            for (const Contact& c : contacts.chunk(chunk)) pairs.prefetch_memory_at(c.memory);
            for (Contact& c : contacts.chunk(chunk)) {
                if (c.memory < 0) {
                    take(&c);
                    measure(dt, motion, c);
                    continue;
                }
                const PairMemory& memory = pairs.memory_at(c.memory);
                const bool is_of_last_step = memory.step + 1 == step_;
                if (is_of_last_step && step_ < memory.area_until) {
                    c.area = memory.area;
                    c.own_area = memory.own_area;
                    c.area_until = memory.area_until;
                } else {
                    measure(dt, motion, c);
                }
                if (!is_of_last_step) continue;
                c.owed = memory.owed;
                c.impulse = span * memory.force;
                c.rubbed = span * memory.friction;
            }
        },
        NEW_CONTACT_CHUNKS);
    const Index first = pairs.make_memories(fresh_.size(), [&](std::size_t k) {
        fresh_[k]->memory = static_cast<Index>(k);
        return fresh_[k]->pair;
    });
    for (Contact* const c : fresh_) c->memory += first;
}

void ImplicitResponse::set_rows(double span, double dt, ContactList& contacts,
                                const ColumnColouring& columns, Candidates& pairs,
                                VelocityState& motion) {
    recall(span, dt, contacts, pairs, motion);
    rows_.resize(columns.size());
    parallel::for_each(
        rows_.size(),
        [&](std::size_t i) {
            Contact& c = columns.at(i, contacts);
            rows_[i] = row_of(span, dt, c, motion);
            warm(c, rows_[i]);
        },
        NEW_ROWS_A_CHUNK);
    columns.for_each_column([&](std::size_t column) {
        for (std::size_t i = columns.begin(column); i < columns.begin(column + 1); ++i)
            begin(rows_[i], motion);
    });
}

ImplicitResponse::Row ImplicitResponse::row_of(double span, double dt, Contact& c,
                                               const VelocityState& motion) const {
    const ContactCard& card = cloth_.rules.card(c.card);
    const double at = std::min(c.gap, c.rest);
    const double area = c.area * c.exposure;
    c.stiffness = c.modulus * area * c.rest / (at * at);
    const double zeta = 0.01 * card.damping;
    const double damping = c.mass < INF ? 2.0 * zeta * std::sqrt(c.stiffness * c.mass) : 0.0;
    double most = 0.0;
    for (int k = 0; k < 4; ++k)
        most += c.weight[k] * c.weight[k] * cloth_.mobility[c.node[k]].maxCoeff();
    Row row;
    row.node = c.node;
    row.weight = c.weight;
    row.normal = c.normal;
    row.gap = c.gap;
    row.rest = c.rest + dt * c.rest_rate;
    row.floor = least_gap(row.gap, row.rest, area > 0.0 ? 0.0 : opening(dt, row.rest));
    const double beat = ALIKE * c.modulus * c.own_area * c.rest / (at * at) * span * dt / c.mass;
    const double theta = std::max(LEAST_THETA, 0.5 - 1.0 / beat);
    row.stiff = c.modulus * area;
    row.push = theta * span * row.stiff;
    row.given = (1.0 - theta) * span * row.stiff * std::max(0.0, c.rest / c.gap - 1.0);
    row.dt = dt;
    row.impulse = 0.0;
    row.rubbed.setZero();
    row.mass = c.mass;
    row.heft = (row.mass + span * damping) / dt;
    row.rub_mass = most > 0.0 ? 1.0 / most : 0.0;
    row.card = &card;
    row.before = motion.relative(c);
    row.zeta = zeta;
    row.rate = motion.unkicked_rate(c);
    row.owed = 0.0;
    if (c.owed > 0.0 && row.rate > -CLOSING * std::sqrt(2.0 * c.owed / c.mass)) row.owed = c.owed;
    row.contact = &c;
    return row;
}

/// Starts a row with what it did in the step before, and no more than its law gives where it is.
void ImplicitResponse::warm(const Contact& before, Row& row) {
    const double offer = row.given + row.push * (row.rest / row.gap - 1.0);
    row.impulse = std::clamp(before.impulse, 0.0, std::max(0.0, offer));
    row.rubbed = before.rubbed;
    row.rubbed -= row.normal.dot(row.rubbed) * row.normal;
    const double most = row.card->greatest_mu() * row.impulse;
    const double strength = row.rubbed.norm();
    if (strength > most) row.rubbed *= most / strength;
}

double ImplicitResponse::owed_after(double after, const Row& row) {
    const Contact& c = *row.contact;
    if (row.mass == INF || c.rest_rate > 0.0) return 0.0;
    const double speed = std::sqrt(c.modulus * c.own_area * row.rest / row.mass);
    const bool is_fast = c.owed > 0.0 || -row.rate > HIT * speed;
    const bool is_hit = is_fast && -row.rate * row.dt > HIT * row.rest;
    if (!is_hit && row.owed == 0.0) return c.owed;
    const double mean = 0.5 * (row.rate + after);
    const double moved = row.gap + row.dt * after;
    const double end = moved > 0.0 ? moved : row.floor;   // sweeps may end before they converge
    const double damping = row.heft * row.dt - row.mass;  // span C
    const double by_dashpot = std::clamp(-damping * after, 0.0, row.impulse);
    const double taken =
        -(row.impulse - by_dashpot) * mean - (row.stored(end) - row.stored(row.gap));
    return c.owed + (is_hit && taken > 0.0 ? taken * kept_by_hit(row.zeta) : taken);
}

/// Gives what a row starts with.
void ImplicitResponse::begin(Row& row, VelocityState& motion) {
    if (row.mass == INF) {
        row.impulse = 0.0;
        row.rubbed.setZero();
        return;
    }
    const Vec3 whole = row.impulse * row.normal + row.rubbed;
    if (whole.isZero(0.0)) return;
    if (!row.contact->on_body) return give(whole, row, motion);
    for (int i = 0; i < 4; ++i) motion.push(row.node[i], row.weight[i] * whole);
}

double stored_energy(const ContactList& contacts) {
    return contacts.sum([&](const Contact& c) {
        if (c.gap >= c.rest) return 0.0;
        return c.modulus * c.area * c.exposure *
               (c.rest * std::log(c.rest / c.gap) - (c.rest - c.gap));
    });
}

}  // namespace corpuscle::contact
