// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/mesh/imprint.hpp"

#include <algorithm>
#include <map>

namespace corpuscle::fold {
namespace {

constexpr double ON_THE_LINE = 1e-7;  ///< share of the mean edge below which a node is on it [-]

using Edge = std::pair<Index, Index>;

class Cutter {
public:
    Cutter(Sheet& sheet, Imprint& line) : sheet_(sheet), line_(line), level_(line.level) {}

    std::vector<int> run() {
        find_nodes_on_it();
        snap();
        give_way();
        split_edges();
        return cut_cells();
    }

private:
    [[nodiscard]] bool is_crossed(const Edge& e) const {
        return level_[e.first] * level_[e.second] < 0.0;
    }

    /// Each once, rows ascending, sorted.
    [[nodiscard]] std::vector<Edge> crossed_edges() const {
        std::vector<Edge> all;
        for (const Cell& c : sheet_.cells)
            for (int k = 0, n = corner_count(c); k < n; ++k)
                if (const Edge e = std::minmax(c[k], c[(k + 1) % n]); is_crossed(e))
                    all.push_back(e);
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    void put_on_line(Index n) {
        level_[n] = 0.0;
        auto& on = sheet_.on[n];
        on.insert(std::upper_bound(on.begin(), on.end(), line_.name), line_.name);
    }

    void find_nodes_on_it() {
        double length = 0.0;
        for (const Cell& c : sheet_.cells) length += (sheet_.X[c[0]] - sheet_.X[c[1]]).norm();
        const double near = ON_THE_LINE * length / static_cast<double>(sheet_.cells.size());
        for (std::size_t n = 0; n < level_.size(); ++n)
            if (std::abs(level_[n]) < near) put_on_line(static_cast<Index>(n));
    }

    /// The nearest ends first, as long as their edge is still crossed.
    void snap() {
        struct Move {
            double share;  ///< of the edge
            Index node, other;
            bool operator<(const Move& o) const {
                return std::tie(share, node, other) < std::tie(o.share, o.node, o.other);
            }
        };
        std::vector<Move> moves;
        for (const Edge& e : crossed_edges()) {
            const double share = level_[e.first] / (level_[e.first] - level_[e.second]);
            const auto offer = [&](double s, Index node, Index other) {
                if (s < line_.snap && is_within(sheet_.on[node], sheet_.on[other]))
                    moves.push_back({s, node, other});
            };
            offer(share, e.first, e.second);
            offer(1.0 - share, e.second, e.first);
        }
        std::sort(moves.begin(), moves.end());
        for (const Move& m : moves) {
            if (!is_crossed({m.node, m.other})) continue;
            sheet_.X[m.node] += m.share * (sheet_.X[m.other] - sheet_.X[m.node]);
            sheet_.x[m.node] += m.share * (sheet_.x[m.other] - sheet_.x[m.node]);
            if (line_.settle && sheet_.on[m.node].empty()) line_.settle(sheet_.X[m.node]);
            put_on_line(m.node);
        }
    }

    void give_way() {
        for (const Edge& e : crossed_edges()) {
            if (!is_crossed(e)) continue;
            const double share = level_[e.first] / (level_[e.first] - level_[e.second]);
            if (share < line_.gives_way) put_on_line(e.first);
            if (1.0 - share < line_.gives_way) put_on_line(e.second);
        }
    }

    void split_edges() {
        for (const Edge& e : crossed_edges()) {
            const Index a = e.first, b = e.second;
            const double share = level_[a] / (level_[a] - level_[b]);
            const auto between = [&](const Points& of) {
                return Vec3(of[a] + share * (of[b] - of[a]));
            };
            std::vector<int> on;
            std::set_intersection(sheet_.on[a].begin(), sheet_.on[a].end(), sheet_.on[b].begin(),
                                  sheet_.on[b].end(), std::back_inserter(on));
            middle_[e] = static_cast<Index>(sheet_.X.size());
            sheet_.X.push_back(between(sheet_.X));
            sheet_.x.push_back(between(sheet_.x));
            if (line_.settle && on.empty()) line_.settle(sheet_.X.back());
            sheet_.on.push_back(on);
            level_.push_back(0.0);
            put_on_line(middle_[e]);
        }
    }

    [[nodiscard]] std::vector<Index> polygon(const Cell& c) const {
        std::vector<Index> all;
        for (int k = 0, n = corner_count(c); k < n; ++k) {
            all.push_back(c[k]);
            const auto found = middle_.find(std::minmax(c[k], c[(k + 1) % n]));
            if (found != middle_.end()) all.push_back(found->second);
        }
        return all;
    }

    /// Corners of a polygon that are not on the other side.
    [[nodiscard]] std::vector<Index> corners_at(int side, const std::vector<Index>& all) const {
        std::vector<Index> some;
        for (const Index n : all)
            if (side * level_[n] >= 0.0) some.push_back(n);
        return some;
    }

    std::vector<int> cut_cells() {
        std::vector<Cell> cells;
        std::vector<int> part, sides;
        const auto add = [&](const Cell& cell, std::size_t from, int side) {
            cells.push_back(cell);
            part.push_back(sheet_.part[from]);
            sides.push_back(side);
        };
        for (std::size_t e = 0; e < sheet_.cells.size(); ++e) {
            const std::vector<Index> all = polygon(sheet_.cells[e]);
            double least = 0.0, most = 0.0;
            for (const Index n : all) {
                least = std::min(least, level_[n]);
                most = std::max(most, level_[n]);
            }
            if (least < 0.0 && most > 0.0) {
                for (const int side : {-1, 1})
                    for (const Cell& cell : best_cells(corners_at(side, all), sheet_.X))
                        add(cell, e, side);
            } else if (corner_count(sheet_.cells[e]) == 4 &&
                       quality(sheet_.cells[e], sheet_.X) < 0.5) {
                for (const Cell& cell : best_cells(all, sheet_.X))
                    add(cell, e, most > 0.0 ? 1 : -1);
            } else {
                add(sheet_.cells[e], e, most > 0.0 ? 1 : -1);
            }
        }
        sheet_.cells = std::move(cells);
        sheet_.part = std::move(part);
        return sides;
    }

    Sheet& sheet_;
    Imprint& line_;
    std::vector<double>& level_;
    std::map<Edge, Index> middle_;  ///< new node by the edge that it splits
};

}  // namespace

std::vector<int> imprint(Sheet& sheet, Imprint line) {
    return Cutter(sheet, line).run();
}

}  // namespace corpuscle::fold
