// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "contact/broad_phase/bounds.hpp"
#include "gas/flight/facet_lists.hpp"
#include "gas/flight/near_facets.hpp"

namespace corpuscle::gas {

/// a b + c, rounded once where the processor can: only for bounds, which have room for either.
inline Eight fused(const Eight& a, const Eight& b, const Eight& c) {
#ifdef __FMA__
    return _mm256_fmadd_ps(a, b, c);
#else
    return a * b + c;
#endif
}

/// A piece of a path, from one instant of the step to another, in single precision: what
/// FacetBounds compare.
struct SmallPath {
    contact::Bounds box;            ///< [m]
    std::array<float, 3> from, to;  ///< from the bounds' origin                            [m]
    double after, length;           ///< share of the step at its start, and that it takes  [-]
    bool is_far;                    ///< too far from the origin for single precision
};

/// An affine function of place, eight times over: gradient · x - offset.
struct EightHeights {
    EightPoints gradient{};
    Eight offset{};

    [[nodiscard]] Eight at(const EightPoints& x) const {
        return fused(gradient[0], x[0], fused(gradient[1], x[1], gradient[2] * x[2] - offset));
    }
};

/// What eight facets sweep in one step: each lies within a prism, all six corners that it has at t
/// and at t + dt,
///
///     0 <= n·x - low <= thick,    0 <= b·x - b_0,    0 <= c·x - c_0,    (b + c)·x - b_0 - c_0 <= d
///
/// n its unit normal at t, b and c the gradients of two of its barycentric coordinates: what the
/// exact test (crossing.hpp) takes for the facet's in between lies within, too. Any gradients are
/// right, if only the bounds are those that the corners keep.
struct EightPrisms {
    EightHeights normal, b, c;
    Eight thick, d;

    /// At which share of the way from one point to another each prism is entered: at least; more
    /// than 1 where it is missed. Cost: 50 instructions.
    [[nodiscard]] Eight entered(const EightPoints& from, const EightPoints& to) const;
};

/// Boxes of eight eights, and two parallel planes that all corners of each lie between.
struct EightsBounds {
    contact::EightBounds box;
    EightHeights normal;
    Eight thick{};

    /// A bit for each that the way from one point to another, with this box, may meet.
    [[nodiscard]] unsigned near(const contact::Bounds& path, const EightPoints& from,
                                const EightPoints& to) const {
        const Eight h_0 = normal.at(from), h_1 = normal.at(to);
        const auto is_crossed = (greatest_of(h_0, h_1) >= Eight{}) & (least_of(h_0, h_1) <= thick);
        return box.overlapping(path) & bits_of(is_crossed);
    }
};

/// Bounds of all facets in one step. Single precision, rounded outward: half the memory.
class FacetBounds {
public:
    /// Facets of the lists move from x_0 to x_1.
    void update(const FacetLists& lists, std::span<const Vec3> x_0, std::span<const Vec3> x_1);

    /// meet(near) with a cell's facets that the path may meet, some at a time.
    template <class Meet>
    void for_some_near(const FacetLists& lists, const Slab& cell, const SmallPath& path,
                       NearFacets& near, Meet&& meet) const;

    /// Between the shares `enters` and `leaves` of the way from `from`, where the particle is at
    /// the share `now` of the step, to `to` at its end.
    [[nodiscard]] SmallPath small(const Vec3& from, const Vec3& to, double now, double enters,
                                  double leaves) const {
        SmallPath out;
        float most = 0.0F;
        for (int a = 0; a < 3; ++a) {
            const double displacement = to[a] - from[a];
            const auto p = static_cast<float>(from[a] + enters * displacement - origin_[a]),
                       q = static_cast<float>(from[a] + leaves * displacement - origin_[a]);
            out.from[a] = p;
            out.to[a] = q;
            out.box.low[a] = std::min(p, q);
            out.box.high[a] = std::max(p, q);
            most = std::max({most, -out.box.low[a], out.box.high[a]});
        }
        out.after = now + enters * (1.0 - now);
        out.length = (leaves - enters) * (1.0 - now);
        out.is_far = !(most <= size_);
        return out;
    }

private:
    void set_prisms(const FacetLists& lists, std::size_t eight);
    [[nodiscard]] EightsBounds bounds_of(const FacetLists::EightEights& eights) const;

    Vec3 origin_ = Vec3::Zero();  ///< near the facets: small numbers are rounded less        [m]
    float size_ = 0.0F;           ///< no coordinate that is compared is larger               [m]
    float slack_ = 0.0F;          ///< more than rounding can be wrong                        [m]
    std::vector<std::array<std::array<float, 3>, 2>> node_;  ///< by row: at t and at t + dt  [m]
    std::vector<EightPrisms> prisms_;
    struct Bound {
        contact::Bounds box;
        std::array<float, 3> normal;
        float low, thick;
        void set_planes(const std::array<EightPoints, 6>& corners, const EightPoints& n,
                        float slack);
    };
    std::vector<Bound> bound_;      ///< by eight
    std::vector<EightsBounds> in_;  ///< as FacetLists::eights_in()
};

inline Eight EightPrisms::entered(const EightPoints& from, const EightPoints& to) const {
    const Eight zero{}, one = all_eight(1.0F), tiny = all_eight(1e-30F);
    const Eight h_0 = normal.at(from), rise = normal.at(to) - h_0;
    const Eight slope = ((rise > tiny) | (rise < -tiny)) ? rise : tiny;
    const Eight low = -h_0 / slope, high = (thick - h_0) / slope;
    const Eight enters = greatest_of(least_of(low, high), zero),
                leaves = least_of(greatest_of(low, high), one);
    const Eight b_0 = b.at(from), b_rise = b.at(to) - b_0, c_0 = c.at(from),
                c_rise = c.at(to) - c_0;
    const Eight b_in = fused(enters, b_rise, b_0), b_out = fused(leaves, b_rise, b_0),
                c_in = fused(enters, c_rise, c_0), c_out = fused(leaves, c_rise, c_0);
    const Eight d_in = b_in + c_in, d_out = b_out + c_out;
    const auto is_missed = (enters > leaves) | (greatest_of(b_in, b_out) < zero) |
                           (greatest_of(c_in, c_out) < zero) | (least_of(d_in, d_out) > d);
    return is_missed ? all_eight(2.0F) : enters;
}

template <class Meet>
void FacetBounds::for_some_near(const FacetLists& lists, const Slab& cell, const SmallPath& path,
                                NearFacets& near, Meet&& meet) const {
    constexpr int AT_ONCE = NearFacets::EIGHTS_AT_ONCE / EIGHT;
    std::array<Index, NearFacets::EIGHTS_AT_ONCE + EIGHT> eights;
    const EightPoints from = all_eight(path.from), to = all_eight(path.to);
    for (Index first = cell.begin; first < cell.end; first += AT_ONCE) {
        int count = 0;
        const Index last = std::min(first + AT_ONCE, cell.end);
        for (Index k = first; k < last; ++k) {
            const unsigned close =
                path.is_far ? those(lists.eights_in()[k]) : in_[k].near(path.box, from, to);
            write_lanes(close, lists.eights_in()[k].data(), eights.data() + count);
            count += std::popcount(close);
        }
        for (int i = 0; i < count; ++i) {
            const std::array<Index, EIGHT>& facets = lists.eights().facet[eights[i]];
            if (path.is_far)
                near.add(facets, those(facets), Eight{});
            else
                near.add(facets, prisms_[eights[i]].entered(from, to));
        }
        if (!near.is_empty()) meet(near);
    }
}

}  // namespace corpuscle::gas
