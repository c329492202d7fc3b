// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// The regions of contact/geometry/distance.cpp without branches; its source holds here too.
#include "contact/geometry/nearest_four.hpp"

#include <bit>

namespace corpuscle::contact {
namespace {

using FourCorners = std::array<FourPoints, 4>;

/// As in contact/geometry/distance.cpp: angles and areas below which only that will do.
constexpr double PARALLEL = 1e-12, SLIVER = 1e-12;

/// @returns lanes for which that does not do
FourBits of_edges(const FourCorners& x, NearestFour& out) {
    const FourPoints d = x[1] - x[0], e = x[3] - x[2], r = x[0] - x[2];
    const Four dd = dot(d, d), ee = dot(e, e), de = dot(d, e), dr = dot(d, r), er = dot(e, r);
    const Four cross = dd * ee - de * de;
    const Four inner = (de * er - dr * ee) / cross;
    const Four first = share_of(inner), second = (de * first + er) / ee;
    const FourBits is_within = (second >= 0.0) & (second <= 1.0);
    const Four t = share_of(second);
    const Four s = is_within ? first : share_of((de * t - dr) / dd);
    out.weight = {1.0 - s, s, t - 1.0, -t};
    out.apart = r + s * d - t * e;
    const FourBits is_inside = (inner > 0.0) & (inner < 1.0) & (second > 0.0) & (second < 1.0);
    out.is_inside = bits_of(is_inside);
    return ~(cross > PARALLEL * dd * ee);
}

FourBits of_node_and_triangle(const FourCorners& x, NearestFour& out) {
    const auto& [p, a, b, c] = x;
    const FourPoints ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const Four d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp);
    const Four d5 = dot(ab, cp), d6 = dot(ac, cp);
    const Four va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    const Four zero{}, one = zero + 1.0;

    // within; then what else may hold, what counts most last
    const Four per_sum = one / (va + vb + vc);
    Four v = vb * per_sum, w = vc * per_sum;
    const auto take = [&](const FourBits& is, const Four& at_b, const Four& at_c) {
        v = is ? at_b : v;
        w = is ? at_c : w;
    };
    const Four bc = share_of((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    take((va <= 0.0) & (d4 - d3 >= 0.0) & (d5 - d6 >= 0.0), one - bc, bc);
    take((vb <= 0.0) & (d2 >= 0.0) & (d6 <= 0.0), zero, share_of(d2 / (d2 - d6)));
    take((d6 >= 0.0) & (d5 <= d6), zero, one);
    take((vc <= 0.0) & (d1 >= 0.0) & (d3 <= 0.0), share_of(d1 / (d1 - d3)), zero);
    take((d3 >= 0.0) & (d4 <= d3), one, zero);
    take((d1 <= 0.0) & (d2 <= 0.0), zero, zero);

    const Four u = one - v - w;
    out.weight = {one, -u, -v, -w};
    out.apart = p - u * a - v * b - w * c;
    out.is_inside = ~0U;
    const FourPoints normal = {ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
                               ab[0] * ac[1] - ab[1] * ac[0]};
    return ~(dot(normal, normal) > SLIVER * dot(ab, ab) * dot(ac, ac));
}

void put(NearestFour& out, std::size_t l, const Nearest& one) {
    for (std::size_t k = 0; k < 4; ++k) out.weight[k][l] = one.weight[k];
    for (int k = 0; k < 3; ++k) out.apart[k][l] = one.apart[k];
    out.is_inside = (out.is_inside & ~(1U << l)) | (one.is_inside ? 1U << l : 0U);
}

}  // namespace

NearestFour nearest(const std::array<const Pair*, FOUR>& pairs, const Points& x) {
    FourCorners corners;
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 &a = x[pairs[0]->node[k]], &b = x[pairs[1]->node[k]];
        const Vec3 &c = x[pairs[2]->node[k]], &d = x[pairs[3]->node[k]];
        for (int i = 0; i < 3; ++i) corners[k][i] = Four{a[i], b[i], c[i], d[i]};
    }
    NearestFour out;
    const FourBits is_degenerate =
        pairs[0]->is_edges ? of_edges(corners, out) : of_node_and_triangle(corners, out);
    for (unsigned bits = bits_of(is_degenerate); bits != 0; bits &= bits - 1) {
        const auto l = static_cast<std::size_t>(std::countr_zero(bits));
        put(out, l, nearest(*pairs[l], x));
    }
    out.gap = roots_of(dot(out.apart, out.apart));
    return out;
}

}  // namespace corpuscle::contact
