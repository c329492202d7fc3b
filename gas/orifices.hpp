// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "gas/bag.hpp"
#include "gas/facet_lists.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Where gas enters: points that move with a node, or with the shell that they lie on.
///
/// An orifice that is part of the bag's own fabric lies a thousandth of a facet's size inside it,
/// so that what enters is on the right side. Any other must never be passed by fabric.
class Orifices {
public:
    /// @param outward  the bag's triangles, normals outward
    /// @param given    the same triangles as the deck orients them: VD = -1 blows along that normal
    /// @param shell    a row a triangle
    Orifices(const std::vector<OrificeCard>& cards, const std::vector<Triangle>& outward,
             const std::vector<Triangle>& given, const std::vector<Index>& shell);

    [[nodiscard]] std::size_t size() const { return cards_.size(); }
    [[nodiscard]] Vec3 place(std::size_t orifice, std::span<const Vec3> x) const;

    /// Direction of each jet; zero: into every direction.
    void axes(std::span<const Vec3> x, std::vector<Vec3>& out) const;

    /// First orifice that fabric passes while it moves from x_0 to x_1, or -1.
    [[nodiscard]] int passed_by_fabric(const FacetLists& lists, std::span<const Vec3> x_0,
                                       std::span<const Vec3> x_1) const;

private:
    struct Facet {
        Triangle outward, given;
    };
    std::vector<OrificeCard> cards_;
    std::vector<std::vector<Facet>> on_;  ///< facets that an orifice lies on; empty: on none
};

}  // namespace corpuscle::gas
