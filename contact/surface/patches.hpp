// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "contact/geometry/box.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::contact {

/// Triangles grouped into patches of cloth: patch p holds triangle[start[p]] .. triangle[start[p +
/// 1] - 1].
struct Patches {
    std::vector<Index> triangle;  ///< triangle rows, patch by patch
    std::vector<Index> start;     ///< compressed rows, one more than there are patches

    /// Patches.
    [[nodiscard]] std::size_t size() const { return start.empty() ? 0 : start.size() - 1; }
    /// Triangle rows of patch p.
    [[nodiscard]] std::span<const Index> operator[](std::size_t p) const {
        return {triangle.data() + start[p], static_cast<std::size_t>(start[p + 1] - start[p])};
    }
};

/// Patches of `size` to 2·size triangles (fewer only where a piece of cloth is smaller), each
/// compact *along the cloth*, so that they stay compact however it is folded or inflated.
///
/// Recursive bisection: separate pieces are told apart first, then a connected piece is cut midway
/// between two ends of it, distance being measured along the cloth. Two panels that lie on each
/// other, seamed at their rim, are thus told apart though their centroids coincide.
///
/// @param reference_x  node positions, flat or folded (the same along the cloth), N × 3   [m]
[[nodiscard]] Patches make_patches(std::span<const Vec3> reference_x,
                                   std::span<const Triangle> triangles, std::size_t size = 32);

/// Box of a triangle that moves from x_0 to x_1, `margin` wider on each side. [m]
[[nodiscard]] Box triangle_box(const Triangle& triangle, std::span<const Vec3> x_0,
                               std::span<const Vec3> x_1, double margin);

}  // namespace corpuscle::contact
