// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/pattern/bag.hpp"

namespace corpuscle::fold {

/// What can be said of a folded bag. Rows are of cells.
struct Inspection {
    std::vector<std::pair<Index, Index>> crossings;  ///< cells that cross, exactly, sorted
    double least_gap = INF;  ///< between cells without a common node             [m]
    std::array<Index, 2> least_gap_at{-1, -1};
    double least_strain = 0.0, greatest_strain = 0.0, rms_strain = 0.0;  ///< of edges          [-]
    Index shortest_at = -1, longest_at = -1;
    double greatest_stretch = 0.0;  ///< greatest principal Green strain of a shell          [-]
    Index stretched_at = -1;
    Vec3 low, high;            ///< corners of the pack, middle of the cloth        [m]
    int layers = 0;            ///< most cells above each other
    double least_angle = 0.0;  ///< of the flat mesh, at a corner                 [rad]
    Index least_angle_at = -1;
    double greatest_aspect = 0.0;  ///< longest over shortest edge, flat                [-]
    double flat_area = 0.0;        ///< of all cells                                  [m^2]
    std::size_t triangles = 0, quads = 0;
};

/// Distances are looked for below `reach`; without any the least gap is infinite.
[[nodiscard]] Inspection inspect(const Bag& bag, double reach);

/// Cells that cross, by exact signs, whatever is near them.
[[nodiscard]] std::vector<std::pair<Index, Index>> crossing_cells(const Sheet& sheet);

/// Sets least_gap and where it is.
void find_least_gap(const Sheet& sheet, double reach, Inspection& found);

/// Whether the pack fits, or by how much not; in a sentence.
[[nodiscard]] std::string fit(const Inspection& found, const Package& package);

/// The whole inspection in lines.
[[nodiscard]] std::string text(const Inspection& found);

}  // namespace corpuscle::fold
