// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::support {

enum PartId { WALL = 1, VENT = 2, POROUS = 3, FAR_WALL = 4, MEMBRANE = 5, HOLE = 6 };
/// Of a folded bag, whose back is a WALL and whose front is POROUS.
enum FoldedPartId { COVER = 14, RING = 15, TETHER = 16 };

/// What the cards of a scene have to agree on.
struct Plan {
    bool is_rigid, has_chambers, has_hole, has_vent, is_porous, has_heat, switches;
    int air;                                ///< IAIR
    int particles;                          ///< NP, or more where a gas needs them
    Vec3 side;                              ///< [m]
    std::array<int, 3> cells;               ///< along each axis
    double end;                             ///< [s]
    double inflow_end;                      ///< of most inflows [s]
    std::array<std::vector<int>, 2> floor;  ///< shells at z = 0, by chamber
    bool is_free = false;                   ///< nothing holds the bag
    bool is_chamber = false;                ///< the bag as a whole is one of *DEFINE_CPM_CHAMBER
    int closing_set = 1, inner_set = 0;     ///< part sets: what closes the bag, and lies inside
    double start = NaN;                     ///< volume at the start; NaN: that of `side` [m^3]
    std::optional<Vec3> inflator;           ///< where a nozzle may be, beside `floor` [m]
    int next_curve = 1;
    std::string curves;

    [[nodiscard]] double volume() const { return side.prod(); }
    [[nodiscard]] double start_volume() const { return std::isnan(start) ? volume() : start; }
    /// A curve of points (x, y), its id.
    int curve(const std::vector<std::array<double, 2>>& points) {
        curves += fmt::format("*DEFINE_CURVE\n{}\n", next_curve);
        for (const auto& [x, y] : points) curves += fmt::format("{:.6g}, {:.6g}\n", x, y);
        return next_curve++;
    }
};

/// Nodes, shells and supports: the box from the origin to `side`, normals inward.
std::string mesh_of(Plan& plan, bool has_triangles);

}  // namespace corpuscle::support
