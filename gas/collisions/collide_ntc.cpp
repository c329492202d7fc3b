// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <vector>

#include "gas/collisions/collide.hpp"
#include "gas/collisions/each_group.hpp"
#include "gas/collisions/relax.hpp"

/// NTC: Bird's no-time-counter collisions [Bird 1994, 11.1]. In a cell of volume V
///
///     N (N-1)/2 sigma g_max dt / V
///
/// pairs are candidates, and one with relative speed g collides with chance g / g_max. That is the
/// rate at which molecules of cross section sigma collide at the cell's density, without their
/// volume. Partners are the nearest that have not met last, which keeps the distance over which
/// momentum jumps below the cell's size. Internal energy is shared out by group.
namespace corpuscle::gas {

namespace {

constexpr std::size_t NOBODY = static_cast<std::size_t>(-1);

/// The nearest to particle p but `last`; in a pair there is but one.
std::size_t nearest(const CellSample& sample, std::size_t p, std::size_t last) {
    std::size_t best = p == 0 ? 1 : 0;
    double least = INF;
    for (std::size_t q = 0; q < sample.size(); ++q) {
        if (q == p || (q == last && sample.size() > 2)) continue;
        const double distance = (sample.dx[q] - sample.dx[p]).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best = q;
    }
    return best;
}

/// A bound g_max of relative speeds: two of the lightest particles cannot have more than all of the
/// group's energy, E = m g²/4, and more than 8 c_T, c_T² = 2 E / (3 N m), has one pair in 10^7,
/// which then counts as one at 8 c_T. Collisions do not change it. [m/s]
double most_relative_speed(const CellSample& sample) {
    const double g2 = 2.0 * sample.translational() / sample.least_mass();
    return std::sqrt(g2 * std::min(2.0, 64.0 / (3.0 * static_cast<double>(sample.size()))));
}

/// Who meets whom does not depend on velocities, not even by what was accepted before: else
/// collisions would favour the fast, and unlike gases end 2 % apart in temperature.
void collide_candidates(const CollisionStep& step, CellSample& sample, Random& draw) {
    thread_local std::vector<std::size_t> last;
    last.assign(sample.size(), NOBODY);
    const auto n = static_cast<double>(sample.size());
    const double g_max = most_relative_speed(sample);
    const double pairs = 0.5 * n * (n - 1.0) * step.cross_section * g_max * step.dt / step.volume;
    const auto candidates = static_cast<std::size_t>(pairs + draw.uniform());
    for (std::size_t k = 0; k < candidates; ++k) {
        const std::size_t p = draw.below(static_cast<std::uint32_t>(sample.size()));
        const std::size_t q = nearest(sample, p, last[p]);
        last[p] = q;
        last[q] = p;
        if (draw.uniform() * g_max < (sample.c[p] - sample.c[q]).norm())
            sample.collide_pair(p, q, draw);
    }
}

}  // namespace

CollisionReport collide_ntc(const CollisionStep& step, Particles& particles) {
    return for_each_group(step, particles, [&](CellSample& sample, Random& draw, auto rows) {
        const bool is_relaxed = relax(step.mixture, sample, draw);
        if (is_relaxed && sample.size() > 1 && !is_rigid(sample, sample.translational())) {
            sample.gather_places(rows, particles);
            collide_candidates(step, sample, draw);
        }
        return is_relaxed;
    });
}

}  // namespace corpuscle::gas
