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
/// whose straight paths in the coming step meet bounce along the line of centres that
/// they will then have,
///
///     |r + g t| = d,  0 <= t <= dt,  g·(r + g t) < 0        r = x_q - x_p, g = v_q - v_p
///
/// the earliest contacts first, each sphere once a step. Places are left alone: a sphere that was
/// set back onto its new path could land behind fabric. Pairs are those of one group, so spheres in
/// two cells do not meet, and the mean free path comes out longer than asked for where a step's path
/// is not short against a cell.
namespace corpuscle::gas {

namespace {

struct Contact {
    double t;
    std::size_t p, q;
    bool operator<(const Contact& o) const { return std::tie(t, p, q) < std::tie(o.t, o.p, o.q); }
};

/// When spheres p and q meet; INF when they do not, or are apart from each other.
double time_of_contact(const CellSample& sample, std::size_t p, std::size_t q, double d) {
    const Vec3 r = sample.dx[q] - sample.dx[p], g = sample.c[q] - sample.c[p];
    const double closing = -g.dot(r), g2 = g.squaredNorm();
    if (!(closing > 0.0)) return INF;
    const double gap = r.squaredNorm() - d * d;
    if (gap <= 0.0) return 0.0;
    const double inside = closing * closing - g2 * gap;
    return inside > 0.0 ? gap / (closing + std::sqrt(inside)) : INF;
}

void bounce_all(double dt, double d, CellSample& sample) {
    thread_local std::vector<Contact> contacts;
    thread_local std::vector<std::uint8_t> has_met;
    contacts.clear();
    has_met.assign(sample.size(), 0);
    for (std::size_t p = 0; p < sample.size(); ++p)
        for (std::size_t q = p + 1; q < sample.size(); ++q)
            if (const double t = time_of_contact(sample, p, q, d); t <= dt)
                contacts.push_back({t, p, q});
    std::sort(contacts.begin(), contacts.end());
    for (const auto& [t, p, q] : contacts) {
        if (has_met[p] || has_met[q]) continue;
        has_met[p] = has_met[q] = 1;
        const Vec3 r = sample.dx[q] - sample.dx[p] + t * (sample.c[q] - sample.c[p]);
        sample.bounce(p, q, r.normalized());
    }
}

}  // namespace

CollisionReport collide_spheres(const CollisionStep& step, Particles& particles) {
    const double diameter = std::sqrt(step.cross_section / std::numbers::pi);
    return for_each_group(step, particles, [&](CellSample& sample, Random& draw, auto rows) {
        const bool is_relaxed = relax(step.mixture, sample, draw);
        if (is_relaxed) {
            sample.gather_places(rows, particles);
            bounce_all(step.dt, diameter, sample);
        }
        return is_relaxed;
    });
}

}  // namespace corpuscle::gas
