// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "contact/broad_phase/intersections.hpp"
#include "contact/broad_phase/triangle_pairs.hpp"
#include "contact/geometry/distance.hpp"
#include "tools/fold/inspect/inspect.hpp"

namespace corpuscle::fold {
namespace {

/// Cell of every triangle of triangles().
std::vector<Index> cell_of_triangles(const std::vector<Cell>& cells) {
    std::vector<Index> all;
    for (std::size_t e = 0; e < cells.size(); ++e)
        for (int k = 2; k < corner_count(cells[e]); ++k) all.push_back(static_cast<Index>(e));
    return all;
}

bool share_node(const Triangle& a, const Triangle& b) {
    return std::any_of(a.begin(), a.end(),
                       [&](Index n) { return std::find(b.begin(), b.end(), n) != b.end(); });
}

/// Distance of two triangles that do not cross: six nodes against triangles, nine pairs of edges.
double distance(const Triangle& a, const Triangle& b, const Points& x) {
    double least = INF;
    const auto look = [&](const contact::Pair& pair) {
        least = std::min(least, contact::nearest(pair, x).apart.squaredNorm());
    };
    for (int i = 0; i < 3; ++i) {
        look({{a[i], b[0], b[1], b[2]}, false});
        look({{b[i], a[0], a[1], a[2]}, false});
        for (int j = 0; j < 3; ++j) look({{a[i], a[(i + 1) % 3], b[j], b[(j + 1) % 3]}, true});
    }
    return std::sqrt(least);
}

}  // namespace

std::vector<std::pair<Index, Index>> crossing_cells(const Sheet& sheet) {
    const std::vector<Triangle> all = triangles(sheet.cells);
    const std::vector<Index> cell = cell_of_triangles(sheet.cells);
    std::vector<std::pair<Index, Index>> found;
    for (const auto& [a, b] : contact::crossings(all, contact::make_patches(sheet.X, all), sheet.x))
        found.push_back(std::minmax(cell[a], cell[b]));
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void find_least_gap(const Sheet& sheet, double reach, Inspection& found) {
    const std::vector<Triangle> all = triangles(sheet.cells);
    const std::vector<Index> cell = cell_of_triangles(sheet.cells);
    const contact::Patches patches = contact::make_patches(sheet.X, all);
    const contact::TrianglePairs near(patches, all, sheet.x, 0.5 * reach);
    for (const auto& pair : near.patch_pairs())
        near.for_each_in(pair, [&](Index a, Index b) {
            if (share_node(all[a], all[b])) return;
            const double gap = distance(all[a], all[b], sheet.x);
            if (gap >= std::min(found.least_gap, reach)) return;
            found.least_gap = gap;
            found.least_gap_at = {cell[a], cell[b]};
        });
}

}  // namespace corpuscle::fold
