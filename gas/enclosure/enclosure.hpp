// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "solver/base/fault.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// The closed surface that holds a bag's gas: every edge belongs to two triangles, normals point
/// outward.
class Enclosure {
public:
    /// Mends the orientation where triangles disagree, by walking from neighbour to neighbour.
    /// @param x         N × 3, at the start                                                  [m]
    /// @param node_id   N: the deck's, for messages
    /// @param property  with `bag_name`, what the faults are of
    /// @throws InputError  when an edge is free or shared by more than two triangles, naming nodes
    Enclosure(std::vector<Triangle> triangles, std::span<const Vec3> x,
              std::span<const int> node_id, const std::string& bag_name,
              Property property = Property::NONE);

    /// Enclosed volume, V = sum x0·(x1 × x2) / 6. [m^3]
    [[nodiscard]] double volume(std::span<const Vec3> x) const;
    /// Sum of its triangles' areas.                                                           [m^2]
    [[nodiscard]] double area(std::span<const Vec3> x) const;

    /// area[n] = dV/dx_n: the vector area that a node carries, outward.                 N × 3 [m^2]
    /// Only rows in nodes() are written.
    void node_areas(std::span<const Vec3> x, std::span<Vec3> area) const;

    /// Is the point inside? By the winding number, sum of solid angles / 4 pi
    /// [van Oosterom & Strackee 1983, Eq. 8]. Cost: one atan2 a triangle.
    [[nodiscard]] bool contains(const Vec3& point, std::span<const Vec3> x) const;

    /// T × 3 node rows, normals outward.
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Rows of the nodes that triangles have, each once.
    [[nodiscard]] std::span<const Index> nodes() const { return nodes_; }
    /// Triangles whose normal was mended.
    [[nodiscard]] std::size_t turned() const { return turned_; }
    /// Connected piece that each triangle belongs to, numbered from 0.
    [[nodiscard]] const std::vector<Index>& piece() const { return piece_; }
    /// Turns the normals of a piece round: it is the wall of a cavity.
    void turn(Index piece);

private:
    std::vector<Triangle> triangles_;
    std::vector<Index> nodes_;
    std::vector<Index> start_;  ///< node (place in nodes_) -> its triangles, compressed rows
    std::vector<Index> around_;
    std::vector<Index> piece_;
    std::size_t turned_ = 0;
};

}  // namespace corpuscle::gas
