// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/repulsion.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {

Repulsion::Repulsion(const Cloth& cloth)
    : cloth_(cloth),
      shared_by_(cloth.inverse_mass.size()),
      body_shared_by_(cloth.body_start.size() - 1) {}

void Repulsion::count_sharers(const ContactList& contacts) {
    std::fill(shared_by_.begin(), shared_by_.end(), 0.0);
    std::fill(body_shared_by_.begin(), body_shared_by_.end(), 0.0);
    contacts.for_each([&](const Contact& c) {
        if (c.gap >= c.rest) return;
        for (int i = 0; i < 4; ++i) shared_by_[c.node[i]] += 2.0 * std::abs(c.weight[i]);
        if (c.on_body) for_bodies_of(cloth_, c, [&](Index b) { body_shared_by_[b] += 2.0; });
    });
}

/// Least m / N of the contact's free nodes; INF: none of them is free.                    [kg]
double Repulsion::softest_node(const Contact& c) const {
    double softest = INF;
    for (int i = 0; i < 4; ++i) {
        const double inverse = cloth_.inverse_mass[c.node[i]];
        if (c.weight[i] == 0.0 || inverse == 0.0) continue;
        softest = std::min(softest, 1.0 / (inverse * shared_by_[c.node[i]]));
    }
    return softest;
}

void Repulsion::find(double dt, const Points& x, std::span<const RigidMover> bodies,
                     ContactList& contacts) {
    count_sharers(contacts);
    contacts.for_each_apart([&](Contact& c) {
        c.stiffness = c.force = 0.0;
        if (c.gap >= c.rest) return;
        double softest = softest_node(c);
        if (c.on_body)
            for_bodies_of(cloth_, c, [&](Index b) {
                const double inverse = inverse_mass(bodies[b], b, cloth_, x, c, c.normal);
                if (inverse > 0.0)
                    softest = std::min(softest, 1.0 / (inverse * body_shared_by_[b]));
            });
        if (softest == INF) return;  // the places that touch are held
        c.stiffness = STIFFNESS / (dt * dt) * softest;
        c.force = c.stiffness * (c.rest - c.gap);
    });
}

void Repulsion::add(const ContactList& contacts, Points& f) const {
    contacts.for_each([&](const Contact& c) {
        if (c.force == 0.0) return;
        const Vec3 force = c.force * c.normal;
        for (int i = 0; i < 4; ++i) f[c.node[i]] += c.weight[i] * force;
    });
}

double stored_energy(const ContactList& contacts, int card) {
    double energy = 0.0;
    contacts.for_each([&](const Contact& c) {
        if (c.card == card && c.force > 0.0) energy += 0.5 * c.force * (c.rest - c.gap);
    });
    return energy;
}

}  // namespace corpuscle::contact
