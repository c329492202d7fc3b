// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/implicit_response.hpp"

#include <algorithm>
#include <cmath>

#include "contact/response/exposure.hpp"

namespace corpuscle::contact {
namespace {

constexpr int LEAST_SWEEPS = 4, MOST_SWEEPS = 32;
constexpr int WHOLE = 4;            ///< every so many sweeps go over all rows
constexpr double CONVERGED = 4e-3;  ///< change by a sweep over all impulses

}  // namespace

ImplicitResponse::ImplicitResponse(const Cloth& cloth) : cloth_(cloth) {
    for (Share& share : share_) {
        share.books.reserve(cloth.rules.cards().size() + 2);  // no two in one cache line
        share.books.resize(cloth.rules.cards().size());
    }
}

void ImplicitResponse::apply(double span, double dt, ContactList& contacts,
                             ColumnColouring& columns, Candidates& pairs, VelocityState& motion,
                             std::vector<ImpulseBooks>& books,
                             const std::function<void(bool is_last)>& hold) {
    for (ImpulseBooks& book : books) book.given.setZero();
    ++step_;
    take_up(dt, contacts, columns, pairs, motion);
    columns.sort(contacts);
    if (columns.size() == 0) return;
    motion.begin();
    set_rows(span, dt, contacts, columns, pairs, motion);
    const double residual = solve_all(columns, motion, hold);
    if (hold) hold(true);
    ++convergence_.steps;
    convergence_.sum += residual;
    convergence_.worst = std::max(convergence_.worst, residual);
    close(span, columns, pairs, motion, books);
}

/// Makes contacts of pairs that are near and come within rest as their nodes move now; of pairs
/// without exposure, which do not push, if they come nearer than a step may bring them; of pairs
/// that a hit has left beyond rest and that have not paid. Seen along the line between their nearest
/// places no node of the one is nearer to the other than `left`.
void ImplicitResponse::take_up(double dt, ContactList& contacts, const ColumnColouring& columns,
                               Candidates& pairs, const VelocityState& motion) {
    contacts.for_each_chunk([&](std::size_t chunk) {
        for (const NearPair& near : contacts.near(chunk)) {
            const Pair& pair = near.nodes;
            Corners v;
            for (int k = 0; k < 4; ++k) v[k] = motion.velocity(pair.node[k]);
            const bool owes = near.gap >= near.rest && owes_still(near, pairs);
            if (!owes && dt * greatest_approach(pair, v) <= near.gap - near.rest) continue;
            Corners late;
            for (int k = 0; k < 4; ++k) late[k] = motion.x()[pair.node[k]] + dt * v[k];
            const double left = separation(pair, near.places.apart / near.gap, late);
            if (!owes && left >= near.rest) continue;
            const double exposed = near.gap < near.rest
                                       ? 0.0
                                       : exposure(cloth_, pairs.parts(near.pair), motion.x(), pair,
                                                  near.places, near.gap);
            if (exposed == 0.0 && left >= least_gap(near.gap, near.rest, opening(dt, near.rest)))
                continue;
            const Contact found =
                contact_at(cloth_, motion.bodies(), motion.x(), pair, near.places, near.gap);
            contacts.add(chunk, columns.of(found, motion.x()), found, near).exposure = exposed;
        }
    });
}

double ImplicitResponse::solve_all(const ColumnColouring& columns, VelocityState& motion,
                                   const std::function<void(bool is_last)>& hold) {
    active_.resize(rows_.size());
    bool is_whole = true;
    for (int k = 1;; ++k) {
        const double residual = sweep(is_whole, columns, motion);
        if (hold) hold(false);
        ++convergence_.sweeps;
        const bool is_done = residual <= CONVERGED && k >= LEAST_SWEEPS;
        if (is_whole && (is_done || k >= MOST_SWEEPS)) return residual;
        is_whole = is_done || k % WHOLE == 0 || k + 1 >= MOST_SWEEPS;
    }
}

double ImplicitResponse::sweep(bool is_whole, const ColumnColouring& columns,
                               VelocityState& motion) {
    columns.for_each_column([&](std::size_t column) {
        double changed = 0.0, all = 0.0;
        const bool is_alone = column == ColumnColouring::COUNT;
        std::uint32_t* const active = active_.data() + columns.begin(column);
        const auto bring = [&](std::size_t i) {
            Row& row = rows_[i];
            if (row.mass == INF) return false;
            const bool on_body = is_alone && row.contact->on_body;
            const double change = on_body ? solve_on_body(row, motion) : solve(row, motion);
            changed += std::abs(change);
            all += row.impulse;
            return change != 0.0 || row.impulse > 0.0;
        };
        Share& share = share_[column];
        if (is_whole) {
            std::size_t count = 0;
            for (std::size_t i = columns.begin(column); i < columns.begin(column + 1); ++i)
                if (bring(i)) active[count++] = static_cast<std::uint32_t>(i);
            share.active = count;
        } else {
            for (std::size_t k = 0; k < share.active; ++k) bring(active[k]);
        }
        share.changed = changed;
        share.all = all;
    });
    double changed = 0.0, all = 0.0;
    columns.for_each_in_turn([&](std::size_t column) {
        changed += share_[column].changed;
        all += share_[column].all;
    });
    return all > 0.0 ? changed / all : 0.0;
}

/// Brings a row between free or held nodes to its law, all else as it is; returns the change of J.
double ImplicitResponse::solve(Row& row, VelocityState& motion) {
    const Points& v = motion.v();
    Vec3 relative = row.weight[0] * v[row.node[0]] + row.weight[1] * v[row.node[1]] +
                    row.weight[2] * v[row.node[2]] + row.weight[3] * v[row.node[3]];
    const double rate = row.normal.dot(relative);
    const double change = row.change(rate);
    const bool rubs = row.card->greatest_mu() > 0.0 && (row.impulse > 0.0 || change > 0.0);
    if (change == 0.0 && !rubs) return 0.0;
    row.impulse += change;
    Vec3 whole = change * row.normal;
    if (rubs) {
        const Vec3 sliding = relative - rate * row.normal;
        Vec3 wanted = row.rubbed - row.rub_mass * sliding;
        const double speed = sliding.norm(), strength = wanted.norm();
        const double most = row.impulse * row.card->mu(speed);
        if (strength > most) wanted *= most / strength;
        whole += wanted - row.rubbed;
        row.rubbed = wanted;
    }
    give(whole, row, motion);
    return change;
}

/// Likewise where a body takes part that may move, whose mass is another in each direction.
double ImplicitResponse::solve_on_body(Row& row, VelocityState& motion) {
    Contact& c = *row.contact;
    const double rate = motion.rate(c);
    const double change = row.change(rate);
    row.impulse += change;
    for (int i = 0; i < 4; ++i)
        if (row.weight[i] != 0.0) motion.push(row.node[i], row.weight[i] * change * row.normal);
    if (row.card->greatest_mu() == 0.0) return change;
    const Vec3 relative = motion.relative(c);
    const Vec3 sliding = relative - row.normal.dot(relative) * row.normal;
    const double speed = sliding.norm();
    double mass = 0.0;
    if (speed > 0.0) mass = motion.mass(c, sliding / speed);
    if (mass == INF) return change;
    Vec3 wanted = row.rubbed - mass * sliding;
    const double strength = wanted.norm();
    const double most = row.impulse * row.card->mu(speed);
    if (strength > most) wanted *= most / strength;
    const Vec3 rub = wanted - row.rubbed;
    row.rubbed = wanted;
    for (int i = 0; i < 4; ++i)
        if (row.weight[i] != 0.0) motion.push(row.node[i], row.weight[i] * rub);
    return change;
}

/// Bodies that do not move take the impulse of a row when all is done.
void ImplicitResponse::add_to_bodies(const Vec3& impulse, const Row& row,
                                     const VelocityState& motion,
                                     std::vector<BodyImpulse>& taken) const {
    for (int i = 0; i < 4; ++i) {
        const Index body = cloth_.body[row.node[i]];
        if (body < 0 || row.weight[i] == 0.0) continue;
        const Vec3 own = row.weight[i] * impulse;
        const Vec3 arm = motion.x()[row.node[i]] - motion.bodies()[body].centre;
        taken[body].linear += own;
        taken[body].turning += arm.cross(own);
    }
}

/// Books what the impulses have taken, of all together exactly J · (velocity before + after) / 2,
/// and remembers them.
void ImplicitResponse::close(double span, const ColumnColouring& columns, Candidates& pairs,
                             VelocityState& motion, std::vector<ImpulseBooks>& books) {
    columns.for_each_column_apart([&](std::size_t column) {
        Share& share = share_[column];
        for (ImpulseBooks& book : share.books) book = {};
        share.on_bodies.assign(motion.bodies().size(), {});
        for (std::size_t i = columns.begin(column); i < columns.begin(column + 1); ++i) {
            const Row& row = rows_[i];
            Contact& c = *row.contact;
            c.impulse = row.impulse;
            c.force = row.impulse / span;
            c.rubbed = row.rubbed;
            PairMemory& memory = pairs.memory_at(c.memory);
            memory.force = c.force;
            memory.friction = row.rubbed / span;
            memory.area = c.area;
            memory.own_area = c.own_area;
            memory.area_until = c.area_until;
            memory.step = step_;
            const Vec3 relative = motion.relative(c);
            const double after = row.normal.dot(relative);
            memory.owed = owed_after(after, row);
            const Vec3 whole = row.impulse * row.normal + row.rubbed;
            if (whole.isZero(0.0)) continue;
            if (!c.on_body) add_to_bodies(whole, row, motion, share.on_bodies);
            ImpulseBooks& book = share.books[static_cast<std::size_t>(c.card)];
            const Vec3 mean = 0.5 * (row.before + relative);
            book.normal -= row.impulse * row.normal.dot(mean);
            book.friction -= row.rubbed.dot(mean);
            for (int k = 0; k < 4; ++k)
                book.held_work += motion.held_work(row.node[k], row.weight[k] * whole);
            book.give(whole, c, cloth_);
        }
    });
    columns.for_each_in_turn([&](std::size_t column) {
        const Share& share = share_[column];
        for (std::size_t c = 0; c < books.size(); ++c) books[c] += share.books[c];
        for (std::size_t b = 0; b < share.on_bodies.size(); ++b)
            motion.push_body(b, share.on_bodies[b]);
    });
}

}  // namespace corpuscle::contact
