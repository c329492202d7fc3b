// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/repulsion.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {

Repulsion::Repulsion(const Cloth& cloth) : cloth_(cloth), shared_by_(cloth.inverse_mass.size()) {}

void Repulsion::find(double dt, ContactList& contacts) {
    std::fill(shared_by_.begin(), shared_by_.end(), 0.0);
    contacts.for_each([&](const Contact& c) {
        if (c.gap >= c.rest) return;
        for (int i = 0; i < 4; ++i) shared_by_[c.node[i]] += 2.0 * std::abs(c.weight[i]);
    });
    contacts.for_each_apart([&](Contact& c) {
        c.stiffness = c.force = 0.0;
        if (c.gap >= c.rest) return;
        double softest = INF;
        for (int i = 0; i < 4; ++i) {
            const double inverse = cloth_.inverse_mass[c.node[i]];
            if (c.weight[i] == 0.0 || inverse == 0.0) continue;
            softest = std::min(softest, 1.0 / (inverse * shared_by_[c.node[i]]));
        }
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

double stored_energy(const ContactList& contacts) {
    double energy = 0.0;
    contacts.for_each([&](const Contact& c) {
        if (c.force > 0.0) energy += 0.5 * c.force * (c.rest - c.gap);
    });
    return energy;
}

}  // namespace corpuscle::contact
