// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/pattern/deck_pattern.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "io/deck_mesh.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::fold {
namespace {

constexpr double FLAT = 0.98;        ///< of a shell's area, that the pattern shows at least
constexpr double SAME_PLACE = 1e-3;  ///< of an element, for nodes that are sewn to each other
constexpr int SEAM = -1000000, BORDER = -2;  ///< lines that count as curved: their nodes stay

enum PanelRow { UPPER, LOWER };

class DeckSewing {
public:
    explicit DeckSewing(const Recipe& recipe)
        : r_(recipe), file_(r_.pattern.deck.string()), mesh_(io::read_deck_mesh(r_.pattern.deck)) {}

    Bag run() {
        tell_panels_apart();
        check_shells();
        stop_at_faults();
        sew();
        stop_at_faults();
        lay_out();
        stop_at_faults();
        name_parts();
        drop_loose_nodes(bag_.sheet, {&bag_.seam, &bag_.module});
        return std::move(bag_);
    }

private:
    void stop_at_faults() {
        if (!faults_.empty()) throw InputError(std::move(faults_));
    }
    template <class... Values>
    void fault(fmt::format_string<Values...> text, Values&&... values) {
        faults_.push_back(file_ + ": " + fmt::format(text, std::forward<Values>(values)...));
    }

    [[nodiscard]] double mean_height(const Cell& c) const {
        double sum = 0.0;
        for (int k = 0; k < corner_count(c); ++k) sum += mesh_.x[c[k]].z();
        return sum / corner_count(c);
    }

    /// By the recipe's part numbers, or else by height.
    void tell_panels_apart() {
        const auto& front = r_.pattern.front;
        const auto& back = r_.pattern.back;
        const auto holds = [](const std::vector<int>& list, int id) {
            return std::find(list.begin(), list.end(), id) != list.end();
        };
        double low = INF, high = -INF;
        for (const Cell& c : mesh_.shells) {
            low = std::min(low, mean_height(c));
            high = std::max(high, mean_height(c));
        }
        if (front.empty() && !(high > low))
            fault(
                "both panels lie at the same height, expected their parts as front and back in "
                "[pattern]");
        std::set<int> strangers, doubles;
        for (std::size_t e = 0; e < mesh_.shells.size(); ++e) {
            const int id = mesh_.part_id[e];
            if (!front.empty() && !holds(front, id) && !holds(back, id)) strangers.insert(id);
            if (holds(front, id) && holds(back, id)) doubles.insert(id);
            const bool is_front = front.empty() ? mean_height(mesh_.shells[e]) > 0.5 * (low + high)
                                                : holds(front, id);
            panel_.push_back(is_front ? UPPER : LOWER);
        }
        for (const int id : strangers)
            fault("part {} is in neither front nor back of [pattern]", id);
        for (const int id : doubles) fault("part {} is in both front and back of [pattern]", id);
    }

    /// Cells counter-clockwise seen from +z, none that is not flat.
    void check_shells() {
        for (std::size_t e = 0; e < mesh_.shells.size(); ++e) {
            Cell c = mesh_.shells[e];
            const double whole = area(c, mesh_.x);
            Vec3 seen = Vec3::Zero();
            for (const Triangle& t : triangles({c}))
                seen += vector_area(mesh_.x[t[0]], mesh_.x[t[1]], mesh_.x[t[2]]);
            if (!(std::abs(seen.z()) >= FLAT * whole) || !(whole > 0.0))
                fault(
                    "shell {} shows {:.4g} of its area of {:.4g} in the plane x, y, expected a "
                    "flat pattern there",
                    mesh_.shell_id[e], std::abs(seen.z()), whole);
            if (seen.z() < 0.0 && corner_count(c) == 4) std::swap(c[1], c[3]);
            if (seen.z() < 0.0 && corner_count(c) == 3) c = {c[1], c[0], c[2], c[2]};
            cells_[panel_[e]].push_back(c);
            row_[panel_[e]].push_back(e);
        }
        for (const PanelRow p : {UPPER, LOWER})
            if (cells_[p].empty())
                fault("the {} panel has no shells", p == UPPER ? "front" : "back");
    }

    /// Nodes of the back that are sewn to the front become those of the front.
    void sew() {
        std::array<std::set<Index>, 2> rim, all;
        for (const PanelRow p : {UPPER, LOWER}) {
            for (const auto& [a, b] : rim_edges(cells_[p])) rim[p].insert({a, b});
            for (const Cell& c : cells_[p]) all[p].insert(c.begin(), c.end());
        }
        for (const Index n : all[UPPER])
            if (all[LOWER].contains(n) && !(rim[UPPER].contains(n) && rim[LOWER].contains(n)))
                fault("node {} is in both panels, expected at their rims only", mesh_.node_id[n]);
        const double reach = SAME_PLACE * r_.pattern.element;
        std::map<Index, Index> partner;
        for (const Index n : rim[LOWER]) {
            if (rim[UPPER].contains(n)) {
                seam_.insert(n);
                continue;
            }
            for (const Index m : rim[UPPER])
                if ((mesh_.x[m] - mesh_.x[n]).head<2>().norm() < reach) partner[n] = m;
            if (partner.contains(n)) seam_.insert(partner[n]);
        }
        for (Cell& c : cells_[LOWER])
            for (Index& n : c)
                if (const auto found = partner.find(n); found != partner.end()) n = found->second;
        check_rims();
    }

    /// What stays open must be whole holes.
    void check_rims() {
        if (seam_.empty()) fault("the rims of the two panels have no place in common");
        std::vector<Cell> both = cells_[UPPER];
        both.insert(both.end(), cells_[LOWER].begin(), cells_[LOWER].end());
        std::set<Index> open;
        for (const auto& [a, b] : rim_edges(both))
            for (const Index n : {a, b})
                if (seam_.contains(n)) open.insert(n);
        for (const Index n : open)
            fault(
                "the seam opens at node {} ({:.6g}, {:.6g}), expected rims whose nodes lie on "
                "each other",
                mesh_.node_id[n], mesh_.x[n].x(), mesh_.x[n].y());
    }

    [[nodiscard]] double half_gap(const Vec3& X) const {
        double least = INF;
        for (const auto& [a, b] : seam_edges_) {
            const Vec3 &from = bag_.sheet.X[a], &to = bag_.sheet.X[b];
            const double share =
                std::clamp((X - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
            least = std::min(least, (X - from - share * (to - from)).norm());
        }
        return 0.5 * r_.pattern.gap * std::min(1.0, least / r_.pattern.closing);
    }

    void lay_out() {
        Sheet& s = bag_.sheet;
        for (const Vec3& x : mesh_.x) s.X.emplace_back(x.x(), x.y(), 0.0);
        s.x = s.X;
        s.on.resize(s.X.size());
        for (const auto& edge : rim_edges(cells_[UPPER]))
            if (seam_.contains(edge.first) && seam_.contains(edge.second))
                seam_edges_.push_back(edge);
        std::vector<std::set<int>> parts(s.X.size());
        for (const PanelRow p : {UPPER, LOWER}) {
            std::set<Index> nodes;
            for (std::size_t i = 0; i < cells_[p].size(); ++i) {
                const Cell& c = cells_[p][i];
                s.cells.push_back(c);
                part_of_.push_back({mesh_.part_id[row_[p][i]], p});
                for (const Index n : c) parts[n].insert(part_of_.back().first);
                nodes.insert(c.begin(), c.end());
                if (std::all_of(c.begin(), c.end(), [&](Index n) { return seam_.contains(n); }))
                    fault(
                        "shell {} has all its corners on the seam, expected one inside: it would "
                        "lie on the other panel",
                        mesh_.shell_id[row_[p][i]]);
            }
            for (const Index n : nodes)
                if (!seam_.contains(n)) s.x[n].z() = (p == UPPER ? 1.0 : -1.0) * half_gap(s.X[n]);
        }
        for (std::size_t n = 0; n < parts.size(); ++n) {
            if (seam_.contains(static_cast<Index>(n)))
                s.on[n] = {SEAM};
            else if (parts[n].size() > 1)
                s.on[n] = {BORDER};
        }
        bag_.seam.assign(seam_.begin(), seam_.end());
    }

    void name_parts() {
        std::map<std::pair<int, int>, int> row;
        std::set<Index> module;
        for (std::size_t e = 0; e < part_of_.size(); ++e) {
            const auto [id, panel] = part_of_[e];
            if (const auto [at, is_new] =
                    row.try_emplace({id, panel}, static_cast<int>(bag_.parts.size()));
                is_new)
                bag_.parts.push_back(
                    {id, fmt::format("part {} of {}", id, r_.pattern.deck.filename().string()),
                     panel == UPPER});
            bag_.sheet.part.push_back(row.at({id, panel}));
            bag_.has_vents |= id == r_.parts.vent;
            if (id == r_.parts.module || id == r_.parts.reinforcement)
                for (const Index n : bag_.sheet.cells[e]) module.insert(n);
        }
        bag_.module.assign(module.begin(), module.end());
    }

    const Recipe& r_;
    std::string file_;
    io::DeckMesh mesh_;
    std::vector<std::string> faults_;
    std::vector<PanelRow> panel_;                  ///< by shell
    std::array<std::vector<Cell>, 2> cells_;       ///< by panel
    std::array<std::vector<std::size_t>, 2> row_;  ///< their shells
    std::set<Index> seam_;
    std::vector<std::pair<Index, Index>> seam_edges_;
    std::vector<std::pair<int, int>> part_of_;  ///< id and panel, by cell of the bag
    Bag bag_;
};

}  // namespace

Bag make_deck_bag(const Recipe& recipe) {
    return DeckSewing(recipe).run();
}

}  // namespace corpuscle::fold
