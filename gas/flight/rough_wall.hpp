// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// What a bounce off rough fabric does to the velocity along it (FRIC, IDFRIC).
struct WallFriction {
    /// 0 to 1: share of the velocity along the fabric that a bounce takes. Below 0, above -1: share
    /// of what lacks to a right angle by which the path after it leans towards the fabric. [-]
    double factor = 0.0;
    bool pushes_along =
        true;  ///< IDFRIC = 0: the fabric feels it; 1: it feels only the normal part
    std::span<const double> of_side{};  ///< instead of `factor`, as WettedSurface::side() [-]
    Index closing = 0;                  ///< with it, how many facets have one side alone

    /// Whether any fabric is rough, as far as that can be told at once.
    [[nodiscard]] bool any() const { return factor != 0.0 || !of_side.empty(); }
    /// Whether a facet's two sides may differ.
    [[nodiscard]] bool has_sides(Index facet) const { return !of_side.empty() && facet >= closing; }
    /// Factor on a facet, where it has sides on that one.                                  [-]
    [[nodiscard]] double on(Index facet, bool is_front = false) const {
        if (of_side.empty()) return factor;
        return of_side[facet < closing ? facet : 2 * facet - closing + (is_front ? 1 : 0)];
    }
};

/// What a bounce does to a particle.
struct Bounce {
    Vec3 away;                    ///< velocity after it                                     [m/s]
    Vec3 impulse = Vec3::Zero();  ///< to the facet                                          [N s]
    double heat = 0.0;            ///< to the particle, from friction                        [J]
};

/// A bounce with friction f != 0; u is the velocity relative to the wall after a specular one,
/// theta its angle from the normal.
///
///     f > 0:  u_t' = (1 - f) u_t,  heat = m u_t² (1 - (1 - f)²) / 2
///     f < 0:  |u'| = |u|,  theta' = theta - f (pi/2 - theta)
///
/// @param v, mirrored  before, and after a specular bounce                               [m/s]
inline Bounce bounce_off_rough(double f, bool pushes_along, double mass, const Vec3& v,
                               const Vec3& mirrored, const Vec3& wall) {
    const Vec3 normal = (mirrored - v).normalized();
    const Vec3 u = mirrored - wall;
    const double u_n = u.dot(normal);
    const Vec3 along = u - u_n * normal;
    Bounce out{mirrored};
    if (f > 0.0) {
        out.away -= f * along;
        out.heat = 0.5 * mass * along.squaredNorm() * f * (2.0 - f);
    } else if (along.squaredNorm() > 0.0) {
        const double theta = std::atan2(along.norm(), u_n);
        const double leaning = theta - f * (0.5 * std::numbers::pi - theta);
        out.away =
            wall + u.norm() * (std::cos(leaning) * normal + std::sin(leaning) * along.normalized());
    }
    out.impulse = mass * (v - out.away);
    if (pushes_along) return out;
    const Vec3 beside = out.impulse - out.impulse.dot(normal) * normal;
    out.impulse -= beside;
    out.heat += beside.dot(wall);  // work that no one does
    return out;
}

}  // namespace corpuscle::gas
