// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "contact/geometry/eight.hpp"

namespace corpuscle::contact {

/// Two orthonormal directions.                                                              [-]
using Frame = std::array<std::array<float, 3>, 2>;

/// Two edges of eight triangles, from a common corner on.                                   [m]
using EightEdges = std::array<EightPoints, 2>;

/// How a chart lies in the reference shape, and where it is laid now.
struct Spread {
    EightPoints along, across;  ///< of its plane
    EightPoints first, second;  ///< Q
    Eight least;                ///< value of mu that counts (charts.hpp)                     [-]

    Spread(const Frame& plane, const Frame& now, float least_mu)
        : along(all_eight(plane[0])),
          across(all_eight(plane[1])),
          first(all_eight(now[0])),
          second(all_eight(now[1])),
          least(all_eight(least_mu)) {}

    /// How far the corners of eight triangles may move against each other until mu could be the
    /// least that counts: (mu - least) h / 2, h their least height in the chart. Of which no number
    /// comes out, not at all.
    ///
    /// With P = Q^T [e f], U = [u v] of the same edges in the chart and d = det U, mu |d| is the
    /// least eigenvalue of the symmetric part of P adj U sign d, and h = |d| / longest edge.  [m]
    [[nodiscard]] Eight allowed(const EightEdges& reference, const EightEdges& now) const {
        const auto& [u, v] = reference;
        const auto& [e, f] = now;
        const Eight u0 = dot(along, u), u1 = dot(across, u);
        const Eight v0 = dot(along, v), v1 = dot(across, v);
        const Eight det = u0 * v1 - v0 * u1, size = greatest_of(det, -det);
        const Eight e0 = dot(first, e), e1 = dot(second, e);
        const Eight f0 = dot(first, f), f1 = dot(second, f);
        const Eight m00 = e0 * v1 - f0 * u1, m01 = f0 * u0 - e0 * v0;
        const Eight m10 = e1 * v1 - f1 * u1, m11 = f1 * u0 - e1 * v0;
        const Eight half = all_eight(0.5F);
        const Eight mean = half * (m00 + m11), apart = half * (m00 - m11), off = half * (m01 + m10);
        const Eight mu = (det > 0.0F ? mean : -mean) - roots_of(apart * apart + off * off);
        const Eight w0 = v0 - u0, w1 = v1 - u1;
        const Eight square =
            greatest_of(greatest_of(u0 * u0 + u1 * u1, v0 * v0 + v1 * v1), w0 * w0 + w1 * w1);
        return half * (mu - least * size) / roots_of(square);
    }
};

}  // namespace corpuscle::contact
