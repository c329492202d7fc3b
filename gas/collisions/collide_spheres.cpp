// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include "gas/collisions/collide.hpp"
#include "gas/collisions/each_group.hpp"
#include "gas/collisions/relax.hpp"

/// Hard spheres as in the notes: the plain reference, simple and slow. Two spheres of diameter d
/// whose straight ways of the coming step bring them together bounce along the line of centres that
/// they will then have,
///
///     |r + g t| = d,  0 <= t <= dt,  g·(r + g t) < 0        r = x_q - x_p, g = v_q - v_p
///
/// the earliest contacts first, each sphere once a step. Places are left alone: a sphere that was
/// set back onto its new way could land behind fabric. Pairs are those of one group, so spheres in
/// two cells do not meet, and the mean free path comes out longer than asked for where a step's way
/// is not short against a cell.
namespace corpuscle::gas {

namespace {

struct Contact {
    double t;
    std::size_t p, q;
    bool operator<(const Contact& o) const { return std::tie(t, p, q) < std::tie(o.t, o.p, o.q); }
};

/// When spheres p and q meet; INF when they do not, or are apart from each other.
double time_of_contact(const Swarm& swarm, std::size_t p, std::size_t q, double d) {
    const Vec3 r = swarm.dx[q] - swarm.dx[p], g = swarm.c[q] - swarm.c[p];
    const double closing = -g.dot(r), g2 = g.squaredNorm();
    if (!(closing > 0.0)) return INF;
    const double gap = r.squaredNorm() - d * d;
    if (gap <= 0.0) return 0.0;
    const double inside = closing * closing - g2 * gap;
    return inside > 0.0 ? gap / (closing + std::sqrt(inside)) : INF;
}

void bounce_all(double dt, double d, Swarm& swarm) {
    thread_local std::vector<Contact> contacts;
    thread_local std::vector<std::uint8_t> has_met;
    contacts.clear();
    has_met.assign(swarm.size(), 0);
    for (std::size_t p = 0; p < swarm.size(); ++p)
        for (std::size_t q = p + 1; q < swarm.size(); ++q)
            if (const double t = time_of_contact(swarm, p, q, d); t <= dt)
                contacts.push_back({t, p, q});
    std::sort(contacts.begin(), contacts.end());
    for (const auto& [t, p, q] : contacts) {
        if (has_met[p] || has_met[q]) continue;
        has_met[p] = has_met[q] = 1;
        const Vec3 r = swarm.dx[q] - swarm.dx[p] + t * (swarm.c[q] - swarm.c[p]);
        swarm.bounce(p, q, r.normalized());
    }
}

}  // namespace

CollisionReport collide_spheres(const CollisionStep& step, Particles& particles) {
    const double diameter = std::sqrt(step.cross_section / std::numbers::pi);
    return for_each_group(step, particles, [&](Swarm& swarm, Random& draw, auto rows) {
        swarm.gather_places(rows, particles);
        bounce_all(step.dt, diameter, swarm);
        return relax(step.mixture, swarm, draw);
    });
}

}  // namespace corpuscle::gas
