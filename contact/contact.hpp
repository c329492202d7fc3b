// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "contact/candidates.hpp"

namespace corpuscle::contact {

/// Two places of the cloth that are near each other: gap = normal · sum of weight x, rate = normal
/// · sum of weight v. The weights add up to zero, so forces along them keep momentum.
struct Contact {
    std::array<Index, 4> node;
    std::array<double, 4> weight;
    Vec3 normal;       ///< from the second place to the first
    double gap;        ///< negative: passed through, as the pair's memory knows              [m]
    double rest;       ///< gap below which it pushes                                         [m]
    double rest_rate;  ///< growth of `rest`                                                  [m/s]
    double mass;       ///< 1 / sum of weight² / m                                            [kg]
    double stiffness;  ///< [N/m]
    double force;      ///< repulsion, >= 0                                                   [N]
    double impulse;    ///< repulsion's and those of the filter, normal, >= 0                 [N s]
    double rate_before;  ///< before the kick [m/s]
    std::size_t pair;    ///< candidate row

    [[nodiscard]] Vec3 relative(const Points& v) const {
        return weight[0] * v[node[0]] + weight[1] * v[node[1]] + weight[2] * v[node[2]] +
               weight[3] * v[node[3]];
    }
    [[nodiscard]] double rate(const Points& v) const { return normal.dot(relative(v)); }
};

/// Looks at a pair at x and t.
///
/// @param range     gap below which it is a contact, and its memory is kept                    [m]
/// @param growth_time  in which a gap that starts below the contact thickness grows to it (to 1/e)
/// [s]
/// @param thickness contact thickness now                                                      [m]
/// @param nearest   receives the distance                                                      [m]
/// @returns whether `contact` has been filled (all but mass and what forces make of it)
/// Departs from a plain distance: a node that was on one side of a triangle, or an edge of an edge,
/// remains there until it has gone round it; when it is found on the other side, the gap is
/// negative.
bool look_at(Candidate& pair, const Points& x, double t, double growth_time, double range,
             double thickness, double& nearest, Contact& contact);

}  // namespace corpuscle::contact
