// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/repulsion.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {
namespace {

/// In parts of 1 / dt²: what a step of 0.9 of the membrane's limit leaves free of 4, but for a
/// margin; that and what the membrane has taken; the most that one pair makes use of.
constexpr double LEAST = 0.5, ALL = 0.9 * 0.9 * 4.0 + LEAST, MOST = 2.0;

/// What a contact weighs when its nodes share out what they bear. With F = S d²/sum of d a force
/// changes with its own depth or another's by no more than the whole share S. Contacts with rigid
/// bodies share alike: what a stiffness that changes takes from the motion would be missing there.
double weight(const Contact& c) {
    return c.on_body ? 1.0 : (c.rest - c.gap) / c.rest;
}

}  // namespace

Repulsion::Repulsion(const Cloth& cloth)
    : cloth_(cloth),
      shared_by_(cloth.inverse_mass.size()),
      share_(cloth.inverse_mass.size()),
      body_shared_by_(cloth.body_start.size() - 1) {}

void Repulsion::count_sharers(const Columns& columns, const ContactList& contacts) {
    std::fill(shared_by_.begin(), shared_by_.end(), 0.0);
    std::fill(body_shared_by_.begin(), body_shared_by_.end(), 0.0);
    columns.for_each(contacts, [&](const Contact& c) {
        if (c.gap >= c.rest) return;
        for (int i = 0; i < 4; ++i)
            shared_by_[c.node[i]] += 2.0 * weight(c) * std::abs(c.weight[i]);
        if (c.on_body) for_bodies_of(cloth_, c, [&](Index b) { body_shared_by_[b] += 2.0; });
    });
}

/// What each node may give to its contacts.
void Repulsion::share_limits(double dt, const OwnRates& own) {
    body_share_ = LEAST / (dt * dt);
    if (own.rate.empty()) {
        std::fill(share_.begin(), share_.end(), body_share_);
        return;
    }
    const double all = ALL / (dt * dt), most = MOST / (dt * dt);
    for (std::size_t n = 0; n < share_.size(); ++n)
        share_[n] = std::clamp(all - own.stiffening * own.rate[n], body_share_, most);
}

/// Of the node or body that bears least; none where the places that touch are held.
void Repulsion::set_stiffness(const Points& x, std::span<const RigidMover> bodies,
                              Contact& c) const {
    double least = INF;
    const auto bears = [&](double share, double inverse_mass, double shared_by) {
        const double stiffness = weight(c) * share / (inverse_mass * shared_by);
        if (stiffness >= least) return;
        least = stiffness;
        c.share = share;
    };
    for (int i = 0; i < 4; ++i) {
        const double inverse = cloth_.inverse_mass[c.node[i]];
        if (c.weight[i] == 0.0 || inverse == 0.0) continue;
        bears(c.on_body ? body_share_ : share_[c.node[i]], inverse, shared_by_[c.node[i]]);
    }
    if (c.on_body)
        for_bodies_of(cloth_, c, [&](Index b) {
            const double inverse = inverse_mass(bodies[b], b, cloth_, x, c, c.normal);
            if (inverse > 0.0) bears(body_share_, inverse, body_shared_by_[b]);
        });
    if (least < INF) c.stiffness = least;
}

void Repulsion::find(double dt, const Points& x, std::span<const RigidMover> bodies,
                     const OwnRates& own, const Columns& columns, ContactList& contacts) {
    if (columns.size() == 0) return;
    count_sharers(columns, contacts);
    share_limits(dt, own);
    contacts.for_each_apart([&](Contact& c) {
        c.stiffness = c.force = 0.0;
        if (c.gap >= c.rest) return;
        set_stiffness(x, bodies, c);
        c.force = c.stiffness * (c.rest - c.gap);
    });
}

void Repulsion::add(const Columns& columns, const ContactList& contacts, Points& f) const {
    columns.for_each(contacts, [&](const Contact& c) {
        if (c.force == 0.0) return;
        const Vec3 force = c.force * c.normal;
        for (int i = 0; i < 4; ++i) f[c.node[i]] += c.weight[i] * force;
    });
}

double stored_energy(const ContactList& contacts, int card) {
    return contacts.sum([&](const Contact& c) {
        if (c.card != card || c.gap >= c.rest) return 0.0;
        if (c.area > 0.0)
            return c.modulus * c.area * (c.rest * std::log(c.rest / c.gap) - (c.rest - c.gap));
        const double missing = c.rest - c.gap;
        return 0.5 * c.stiffness * missing * missing;
    });
}

}  // namespace corpuscle::contact
