// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// The sides of a bag's walls that gas can touch, each as its own surface.
///
/// A facet that closes the bag has one wetted side, its back (its normal leads out of the gas); an
/// internal one has two. Round an edge, the sides of neighbouring facets that face the same wedge
/// of space belong together. Sides joined in that way are the wall of one room: gas of two rooms
/// can never meet but through a gate. A corner of a side is a *wall point*; corners that are joined
/// along edges are one point, so a node on the rim of a membrane is one point in each of the rooms.
///
/// Where two facets meet, and where a membrane meets the closing surface, connectivity alone says
/// which sides face each other; where more meet, the order of their angles round the edge at `x`
/// does.
class WettedSurface {
public:
    /// @param triangles  the first `closing` ones close the bag, normals outward; then the internal
    WettedSurface(std::span<const Triangle> triangles, std::size_t closing,
                  std::span<const Vec3> x);

    [[nodiscard]] std::size_t sides() const { return facet_.size(); }
    /// Row of a facet's side. Gas on the back pushes along the normal, gas on the front against it.
    [[nodiscard]] std::size_t side(std::size_t facet, bool is_front) const {
        return facet < closing_ ? facet : closing_ + 2 * (facet - closing_) + (is_front ? 1 : 0);
    }
    [[nodiscard]] bool is_front(std::size_t side) const {
        return side >= closing_ && (side - closing_) % 2 == 1;
    }
    [[nodiscard]] bool closes(std::size_t facet) const { return facet < closing_; }
    [[nodiscard]] Index facet(std::size_t side) const { return facet_[side]; }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    /// Wall points of a side's corners, in the order of the facet's nodes.
    [[nodiscard]] const std::array<Index, 3>& points(std::size_t side) const {
        return points_[side];
    }
    /// +1 where the facet's normal leads out of the gas on this side, -1 on the front.
    [[nodiscard]] double sign(std::size_t side) const { return is_front(side) ? -1.0 : 1.0; }

    [[nodiscard]] std::size_t points() const { return node_.size(); }
    [[nodiscard]] Index node(std::size_t point) const { return node_[point]; }  ///< row of x
    [[nodiscard]] Index room_of_point(std::size_t point) const { return room_of_point_[point]; }
    /// Sides at a point.
    [[nodiscard]] std::span<const Index> around(std::size_t point) const {
        return {around_.data() + start_[point],
                static_cast<std::size_t>(start_[point + 1] - start_[point])};
    }
    /// Points that share an edge of a side with a point, and for each its row in edges().
    struct Neighbour {
        Index point, edge;
    };
    [[nodiscard]] std::span<const Neighbour> neighbours(std::size_t point) const {
        return {neighbour_.data() + next_[point],
                static_cast<std::size_t>(next_[point + 1] - next_[point])};
    }
    [[nodiscard]] const std::vector<std::array<Index, 2>>& edges() const { return edges_; }

    [[nodiscard]] std::size_t rooms() const { return rooms_; }
    [[nodiscard]] Index room(std::size_t side) const { return room_[side]; }
    /// Facets of a room's wall, turned so that normals lead out of the gas.
    [[nodiscard]] std::vector<Triangle> wall(std::size_t room) const;

    /// Volume of each room.                                                     rooms [m^3]
    void volumes(std::span<const Vec3> x, std::vector<double>& volume) const;
    /// Way of each room's wall from x_0 to x_1, the mean over its area at x_0.
    ///                                                                         rooms × 3 [m]
    [[nodiscard]] std::vector<Vec3> mean_way(std::span<const Vec3> x_0,
                                             std::span<const Vec3> x_1) const;
    /// Room that each point lies in; the first where rounding leaves none.
    [[nodiscard]] std::vector<Index> rooms_of(std::span<const Vec3> points,
                                              std::span<const Vec3> x) const;
    /// area[p]: the vector area that a point carries, out of the gas.          points × 3 [m^2]
    void point_areas(std::span<const Vec3> x, std::span<Vec3> area) const;
    /// Its parts: the vector area of a facet, then that of a point, from all facets'.      [m^2]
    [[nodiscard]] Vec3 facet_area(std::size_t facet, std::span<const Vec3> x) const {
        const Triangle& c = triangles_[facet];
        return vector_area(x[c[0]], x[c[1]], x[c[2]]);
    }
    [[nodiscard]] Vec3 point_area(std::size_t point, std::span<const Vec3> of_facet) const {
        Vec3 sum = Vec3::Zero();
        for (const Index s : around(point))
            sum += sign(static_cast<std::size_t>(s)) * of_facet[facet_[s]];
        return sum / 3.0;
    }

private:
    void join_sides(std::span<const Vec3> x);
    void number_points(std::vector<Index>& corner);
    void number_rooms(std::vector<Index>& piece, std::span<const Vec3> x);
    void find_homes(const std::vector<Index>& number, const std::vector<double>& volume,
                    std::span<const Vec3> x, std::vector<Index>& room);
    void connect_points();
    [[nodiscard]] Triangle turned(std::size_t side) const;

    std::size_t closing_;
    std::vector<Triangle> triangles_;
    std::vector<Index> facet_;                  ///< of each side
    std::vector<std::array<Index, 3>> points_;  ///< of each side
    std::vector<Index> node_;                   ///< of each point
    std::vector<Index> room_, room_of_point_;   ///< of each side, of each point
    std::size_t rooms_ = 0;
    std::vector<Index> start_, around_;  ///< sides at points, compressed rows
    std::vector<Index> next_;
    std::vector<Neighbour> neighbour_;  ///< points at points, compressed rows
    std::vector<std::array<Index, 2>> edges_;
};

}  // namespace corpuscle::gas
