// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "tools/fold/mesh/neighbours.hpp"

namespace corpuscle::fold {
namespace {

constexpr double LEAST_OF_QUAD = 0.3;  ///< quality below which it is cut [-]

class Collapser {
public:
    Collapser(const ShortEdges& edges, const Freedom& freedom, Sheet& sheet)
        : sheet_(sheet), edges_(edges), freedom_(freedom), near_(sheet), rim_(sheet.X.size(), 0) {
        for (const auto& [a, b] : rim_edges(sheet.cells)) rim_[a] = rim_[b] = 1;
        is_seam_ = edges.is_seam.empty() ? rim_ : edges.is_seam;
    }

    int run() {
        std::vector<std::tuple<double, Index, Index>> all;  // the shortest first
        for (const auto& [a, b] : edges(sheet_.cells)) {
            const double length = (sheet_.X[a] - sheet_.X[b]).norm();
            all.emplace_back(length, a, b);
        }
        std::sort(all.begin(), all.end());
        int count = 0;
        for (const auto& [length, a, b] : all)
            if (touched_.empty() || (!touched_[a] && !touched_[b]))
                count += draw(a, b) || draw(b, a) ? 1 : 0;
        return count;
    }

private:
    /// Cells of a as they are when a is drawn to b; false if the mesh would not be one any more.
    bool cells_after(Index a, Index b, std::vector<std::pair<Index, Cell>>& after) const {
        int shared = 0;
        std::vector<int> parts;
        for (const Index e : near_.cells[a]) {
            const Cell& c = sheet_.cells[e];
            const int n = corner_count(c);
            std::vector<Index> corners;
            bool has_edge = false, has_b = false;
            for (int k = 0; k < n; ++k) {
                has_b |= c[k] == b;
                has_edge |= std::minmax(c[k], c[(k + 1) % n]) == std::minmax(a, b);
                if (c[k] != a || !std::count(c.begin(), c.end(), b))
                    corners.push_back(c[k] == a ? b : c[k]);
            }
            if (has_b && !has_edge) return false;  // they are the ends of its diagonal
            if (has_edge) {
                ++shared;
                parts.push_back(sheet_.part[e]);
            }
            if (corners.size() < 3) {
                after.emplace_back(e, Cell{-1, -1, -1, -1});
                continue;
            }
            const Cell whole{corners[0], corners[1], corners[2], corners.back()};
            if (quality(whole, sheet_.X) > LEAST_OF_QUAD || corners.size() == 3)
                after.emplace_back(e, whole);
            else
                for (const Cell& part : best_cells(corners, sheet_.X)) after.emplace_back(e, part);
        }
        const bool is_border = !sheet_.on[a].empty() && sheet_.on[a].front() < 0;
        // along a rim or the border of a region, never across what lies between two of them
        if (is_border && !(shared == 1 || (shared == 2 && parts[0] != parts[1]))) return false;
        if (rim_[a] && shared != 1) return false;
        return is_border || is_of_one_part(a);
    }

    [[nodiscard]] bool is_of_one_part(Index n) const {
        const auto part = [&](Index e) { return sheet_.part[e]; };
        return std::all_of(near_.cells[n].begin(), near_.cells[n].end(),
                           [&](Index e) { return part(e) == part(near_.cells[n].front()); });
    }

    /// Whether a may go to b.
    [[nodiscard]] bool may_go(Index a, Index b) const {
        if ((is_seam_[a] && !is_seam_[b]) || !may_move(sheet_.X[a], freedom_)) return false;
        const auto &of_a = sheet_.on[a], &of_b = sheet_.on[b];
        return is_within(of_a, of_b) ||
               (of_a.size() <= of_b.size() && (sheet_.X[a] - sheet_.X[b]).norm() < edges_.slack);
    }

    bool draw(Index a, Index b) {
        if (!may_go(a, b)) return false;
        const double before = least_reach(near_.cells[a], sheet_);
        if (before >= edges_.too_small) return false;
        std::vector<std::pair<Index, Cell>> after;
        if (!cells_after(a, b, after)) return false;
        double least = INF;
        for (const auto& [e, cell] : after) {
            if (cell[0] < 0) continue;
            if (lies_on_seam(cell)) return false;
            least = std::min(least, reach(cell, sheet_.X));
        }
        if (least <= before) return false;
        apply(a, b, after);
        return true;
    }

    /// All its corners, or a diagonal, on the seam: it would lie on the other panel's.
    [[nodiscard]] bool lies_on_seam(const Cell& c) const {
        int inner = 0;
        for (int k = 0; k < corner_count(c); ++k) inner += is_seam_[c[k]] ? 0 : 1;
        return inner == 0 || (corner_count(c) == 4 && inner < 2);
    }

    void apply(Index a, Index b, const std::vector<std::pair<Index, Cell>>& after) {
        touched_.resize(sheet_.X.size(), 0);
        Index last = -1;
        for (const auto& [e, cell] : after) {
            for (const Index n : sheet_.cells[e])
                if (n >= 0) touched_[n] = 1;
            if (e != last) {
                sheet_.cells[e] = cell;
            } else {  // the second half of a quad
                sheet_.cells.push_back(cell);
                sheet_.part.push_back(sheet_.part[e]);
            }
            last = e;
        }
        touched_[a] = touched_[b] = 1;
    }

    Sheet& sheet_;
    const ShortEdges& edges_;
    const Freedom& freedom_;
    Neighbours near_;
    std::vector<char> rim_, is_seam_, touched_;
};

}  // namespace

int collapse(const ShortEdges& edges, const Freedom& freedom, Sheet& sheet) {
    int count = 0;
    while (const int more = Collapser(edges, freedom, sheet).run()) {
        count += more;
        std::size_t kept = 0;
        for (std::size_t e = 0; e < sheet.cells.size(); ++e)
            if (sheet.cells[e][0] >= 0) {
                sheet.cells[kept] = sheet.cells[e];
                sheet.part[kept++] = sheet.part[e];
            }
        sheet.cells.resize(kept);
        sheet.part.resize(kept);
    }
    return count;
}

}  // namespace corpuscle::fold
