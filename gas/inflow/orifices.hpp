// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/flight/facet_lists.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Where, and at which share of a step, a particle enters.
struct Birth {
    Vec3 at;       ///< [m]
    double share;  ///< 0 at t, 1 at t + dt  [-]
};

/// Where gas enters: points that move with a node, or with the shell that they lie on.
///
/// An orifice that is part of the bag's own fabric lies a thousandth of a facet's size inside it,
/// so that what enters is on the right side: of facets that do not close the bag that to which the
/// jet leads at the start. Any other must never be passed by fabric.
class Orifices {
public:
    /// @param outward  the bag's triangles, normals outward
    /// @param given    the same triangles as the deck orients them: VD = -1 blows along that normal
    /// @param closing  how many of them close the bag, the first ones
    /// @param shell    a row a triangle
    /// @param frame    three node rows that directions turn with, or -1
    /// @param x        where nodes are when the directions are those of the cards
    Orifices(const std::vector<OrificeCard>& cards, const std::vector<Triangle>& outward,
             const std::vector<Triangle>& given, std::size_t closing,
             const std::vector<Index>& shell, const std::array<Index, 3>& frame,
             std::span<const Vec3> x);

    [[nodiscard]] std::size_t size() const { return cards_.size(); }
    [[nodiscard]] Vec3 place(std::size_t orifice, std::span<const Vec3> x) const;

    /// Entry of what is due at a share of a step in which nodes move from x_0 to x_1: then, where
    /// the orifice is; at the step's beginning where it lies on facets whose nodes move against one
    /// another. What such facets sweep is made of flat pieces (crossing.hpp), which stray from them
    /// by share (1 - share) of that motion: more than the orifice lies inside of them.
    [[nodiscard]] Birth birth(std::size_t orifice, double share, std::span<const Vec3> x_0,
                              std::span<const Vec3> x_1) const;

    /// Direction of each jet; zero: into every direction.
    void axes(std::span<const Vec3> x, std::vector<Vec3>& out) const;

    /// Nodes that feel an orifice's jet (IMOM = 1), in equal shares; none: nothing does.
    [[nodiscard]] std::span<const Index> pushed(std::size_t orifice) const {
        return pushed_[orifice];
    }

    /// First orifice that fabric passes while it moves from x_0 to x_1, or -1.
    [[nodiscard]] int passed_by_fabric(const FacetLists& lists, std::span<const Vec3> x_0,
                                       std::span<const Vec3> x_1) const;

private:
    struct Facet {
        Triangle outward, given;
        double side;  ///< +1: `outward` leads away from where gas enters, -1: to it

        /// Away from where gas enters.                                                 [m^2]
        [[nodiscard]] Vec3 out(std::span<const Vec3> x) const {
            return side * vector_area(x[outward[0]], x[outward[1]], x[outward[2]]);
        }
    };
    [[nodiscard]] double side_of_jet(std::size_t orifice, const Triangle& outward,
                                     const Triangle& given, std::span<const Vec3> x) const;
    std::vector<OrificeCard> cards_;
    [[nodiscard]] Mat3 axes_of_frame(std::span<const Vec3> x) const;
    [[nodiscard]] Vec3 normal(std::size_t orifice, std::span<const Vec3> x) const;
    [[nodiscard]] Vec3 inward(std::size_t orifice, std::span<const Vec3> x) const;
    [[nodiscard]] double depth(std::size_t orifice, const Vec3& at, const Vec3& inward,
                               std::span<const Vec3> x) const;

    std::vector<std::vector<Facet>> on_;      ///< facets that an orifice lies on; empty: on none
    std::vector<std::vector<Index>> pushed_;  ///< node rows an orifice
    std::array<Index, 3> frame_;
    Mat3 frame_0_ = Mat3::Identity();  ///< columns: axes of the frame at the start
};

}  // namespace corpuscle::gas
