// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/mesh/improve.hpp"

#include <algorithm>
#include <cmath>

#include "tools/fold/mesh/neighbours.hpp"

namespace corpuscle::fold {

double reach(const Cell& c, const Points& X) {
    const int n = corner_count(c);
    double least = INF;
    for (int k = 0; k < (n == 3 ? 1 : 4); ++k) {
        const Vec3 a = X[c[(k + 1) % n]] - X[c[k]], b = X[c[(k + n - 1) % n]] - X[c[k]];
        const double edges = a.squaredNorm() + b.squaredNorm() + (a - b).squaredNorm();
        if (const double twice = a.cross(b).z(); twice > 0.0)
            least = std::min(least, twice / std::sqrt(3.0 * edges));
        else
            return -1.0;
    }
    return n == 3 ? least : std::sqrt(1.5) * least;
}

Neighbours::Neighbours(const Sheet& sheet) : nodes(sheet.X.size()), cells(sheet.X.size()) {
    for (const auto& [a, b] : edges(sheet.cells)) {
        nodes[a].push_back(b);
        nodes[b].push_back(a);
    }
    for (std::size_t e = 0; e < sheet.cells.size(); ++e)
        for (int k = 0; k < corner_count(sheet.cells[e]); ++k)
            cells[sheet.cells[e][k]].push_back(static_cast<Index>(e));
}

double least_reach(const std::vector<Index>& cells, const Sheet& sheet) {
    double least = INF;
    for (const Index e : cells) least = std::min(least, reach(sheet.cells[e], sheet.X));
    return least;
}

}  // namespace corpuscle::fold
