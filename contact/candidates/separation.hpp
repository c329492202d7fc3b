// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/simd.hpp"

namespace corpuscle::contact {

/// Eight nodes (CORNERS 1), edges (2) or triangles (3), now and late.                        [m]
template <int CORNERS>
struct EightMoving {
    std::array<EightPoints, CORNERS> now, late;
};

/// How far eight pairs are apart along a direction each, now and late. Any direction gives a lower
/// bound of the distance; these are close to that between the nearest places, where it is the
/// distance itself. Both are to be divided by the root of `square`, the direction's length.
struct EightSeparations {
    Eight now, late;  ///< times the direction's length  [m²]
    Eight square;     ///< [m²]
};

/// Of edges p from edges q.
///
/// cost: 3 div
/// Source: nearest places of two segments, clamped one after the other [Ericson 2005, 5.1.9].
inline EightSeparations separations(const EightMoving<2>& p, const EightMoving<2>& q) {
    const EightPoints d = p.now[1] - p.now[0], e = q.now[1] - q.now[0], r = p.now[0] - q.now[0];
    const Eight dd = dot(d, d), ee = dot(e, e), de = dot(d, e), dr = dot(d, r), er = dot(e, r);
    const Eight first = share_of((de * er - dr * ee) / (dd * ee - de * de));
    const Eight t = share_of((de * first + er) / ee);
    const Eight s = share_of((de * t - dr) / dd);
    const EightPoints apart = r + s * d - t * e;
    const auto along = [&](const std::array<EightPoints, 2>& a,
                           const std::array<EightPoints, 2>& b) {
        return least_of(dot(apart, a[0]), dot(apart, a[1])) -
               greatest_of(dot(apart, b[0]), dot(apart, b[1]));
    };
    return {along(p.now, q.now), along(p.late, q.late), dot(apart, apart)};
}

/// Of nodes from triangles.
///
/// cost: 5 div
/// Source: the foot within the triangle, else the nearest of those on its edges.
inline EightSeparations separations(const EightMoving<1>& node, const EightMoving<3>& triangle) {
    const auto& [a, b, c] = triangle.now;
    const EightPoints& p = node.now[0];
    const EightPoints ab = b - a, ac = c - a, bc = c - b, ap = p - a, bp = p - b;
    const Eight uu = dot(ab, ab), vv = dot(ac, ac), uv = dot(ab, ac);
    const Eight pu = dot(ab, ap), pv = dot(ac, ap);

    EightPoints apart = ap - share_of(pu / uu) * ab;
    Eight least = dot(apart, apart);
    const auto take_nearer = [&](const EightPoints& other, const EightBits& allowed) {
        const Eight square = dot(other, other);
        const EightBits is_nearer = (square < least) & allowed;
        for (int k = 0; k < 3; ++k) apart[k] = is_nearer ? other[k] : apart[k];
        least = is_nearer ? square : least;
    };
    const EightBits always = least == least;
    take_nearer(ap - share_of(pv / vv) * ac, always);
    take_nearer(bp - share_of(dot(bc, bp) / dot(bc, bc)) * bc, always);
    const Eight area = uu * vv - uv * uv;
    const Eight v = (vv * pu - uv * pv) / area, w = (uu * pv - uv * pu) / area;
    take_nearer(ap - v * ab - w * ac, (v >= 0.0F) & (w >= 0.0F) & (v + w <= 1.0F));

    const auto along = [&](const EightPoints& from, const std::array<EightPoints, 3>& to) {
        return dot(apart, from) -
               greatest_of(dot(apart, to[0]), greatest_of(dot(apart, to[1]), dot(apart, to[2])));
    };
    return {along(p, triangle.now), along(node.late[0], triangle.late), dot(apart, apart)};
}
inline EightSeparations separations(const EightMoving<3>& triangle, const EightMoving<1>& node) {
    return separations(node, triangle);
}

}  // namespace corpuscle::contact
