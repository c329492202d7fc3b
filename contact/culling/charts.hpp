// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/culling/spread.hpp"
#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// Patches of cloth with what surrounds them, laid out in a plane: chart c is the reference shape
/// seen along the mean normal of patch c, u(n) [m]. What does not change.
///
/// Where cloth lies open, a chart tells that nothing of it can touch. Let x(u) be where the cloth
/// is, G = dx/du on a triangle, Q any 3 × 2 matrix of orthonormal columns, and
///     mu = least eigenvalue of (Q^T G + G^T Q) / 2,                                        (1)
/// the least on all triangles that the straight way between two places u and w of the chart
/// crosses. Then
///     |x(u) - x(w)| >= (u - w)^T Q^T (x(u) - x(w)) / |u - w| >= mu |u - w|,                 (2)
/// and pieces without a common node are at least the least height of those triangles apart in the
/// chart. So they are never nearer than mu times that height.
///
/// Source: a map of a convex region whose gradient has a positive definite symmetric part is one to
/// one (Noshiro 1934, Warschawski 1935, in the plane); (2) is the integral of (1) along the way.
class Charts {
public:
    static constexpr std::size_t MOST_BLOCKS = 8;  ///< of a patch in a chart
    /// Eight triangles of a patch; the last fills up what is missing.
    struct Block {
        std::array<std::array<Index, EIGHT>, 3> corner;  ///< nodes
        EightEdges edge;  ///< in the reference shape, from the first corner on [m]
    };
    /// A patch in a chart, and which of its triangles ways cross: bit 8 b + l for lane l of block
    /// b.
    struct Sheet {
        Index patch;
        Index row = 0;  ///< of all charts' sheets
        std::uint64_t crossed = 0;
    };
    struct Chart {
        std::vector<Sheet> sheets;
        Frame axis{};        ///< of the plane: u_i = axis_i · X
        double least = 0.0;  ///< value of mu from which on nothing of them can be within reach  [-]
    };
    /// The chart that two patches have in common, or -1, and the sheets of it that ways between
    /// them cross.
    struct Link {
        Index chart = -1;
        std::uint64_t cover = 0;  ///< bit s: sheet s
    };
    /// Where a patch is a sheet.
    struct Place {
        Index chart, sheet;
        Index row;              ///< of all charts' sheets, a patch's in a row
        std::uint64_t crossed;  ///< as in Sheet
    };

    /// @param margin  by triangle: its part of the gap that matters                        [m]
    Charts(const Cloth& cloth, std::span<const double> margin);

    [[nodiscard]] std::size_t size() const { return charts_.size(); }
    [[nodiscard]] std::size_t sheets() const { return sheets_; }  ///< of all charts
    [[nodiscard]] const Chart& operator[](Index p) const { return charts_[p]; }
    [[nodiscard]] std::span<const Place> places(Index patch) const { return places_[patch]; }
    /// Of two patches p <= q.
    [[nodiscard]] Link link(Index p, Index q) const;

    [[nodiscard]] std::span<const Block> blocks(Index patch) const { return blocks_[patch]; }

private:
    using Pair = std::pair<Index, Index>;
    struct Drawing;
    struct Linked {
        Pair pair;
        Link link;
    };
    std::vector<Linked> draw(Index c, std::span<const Pair> pairs, const Drawing& from);
    void number_sheets();
    void set_blocks(const Cloth& cloth);

    std::vector<Chart> charts_;
    std::size_t sheets_ = 0;
    std::vector<double> height_, reach_;      ///< by chart: least of triangles; greatest      [m]
    std::vector<std::vector<Block>> blocks_;  ///< by patch
    std::vector<std::vector<Place>> places_;  ///< likewise
    std::vector<std::vector<std::pair<Index, Link>>> links_;  ///< likewise, to those after it
};

}  // namespace corpuscle::contact
