// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/pattern/bag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "solver/base/error.hpp"
#include "tools/fold/pattern/circles.hpp"
#include "tools/fold/pattern/deck_pattern.hpp"

namespace corpuscle::fold {
namespace {

/// Whether p is within the strip, wider by `margin`.
bool is_in(const TetherStrip& s, const Vec3& p, double margin) {
    return p.x() > s.low.x() - margin && p.x() < s.high.x() + margin &&
           p.y() > s.low.y() - margin && p.y() < s.high.y() + margin;
}

double distance_outside(const TetherStrip& s, const Vec3& p) {
    return std::max(
        {s.low.x() - p.x(), p.x() - s.high.x(), s.low.y() - p.y(), p.y() - s.high.y(), 0.0});
}

double distance_to_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - share * (b - a)).norm();
}

/// Rows of Bag::parts.
enum Piece { FRONT, BACK, MODULE, REINFORCEMENT, FRONT_VENT, BACK_VENT, TETHER };

class Sewing {
public:
    Sewing(const Recipe& recipe, Plan plan) : r_(recipe), plan_(std::move(plan)) {}

    Bag run() {
        check_tethers();
        add_nodes();
        add_panels();
        for (std::size_t i = 0; i < r_.tethers.size(); ++i) add_tether(r_.tethers[i]);
        finish();
        return std::move(bag_);
    }

private:
    void check_tethers() const {
        for (std::size_t i = 0; i < r_.tethers.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const TetherStrip a(r_.tethers[i]), b(r_.tethers[j]);
                const double apart = (a.low - b.high).cwiseMax(b.low - a.high).head<2>().maxCoeff();
                if (apart < r_.pattern.element)
                    throw InputError(fmt::format(
                        "{}:{}: [[tether]] is {:.4g} away from that of line {}, expected more than "
                        "an element: {}",
                        r_.file, r_.tethers[i].line, std::max(apart, 0.0), r_.tethers[j].line,
                        r_.pattern.element));
            }
    }

    /// Distance of the panels from z = 0.
    [[nodiscard]] double half_gap(const Vec3& X) const {
        double edge = INF, strip = INF;
        for (const auto& [a, b] : rim_)
            edge = std::min(edge, distance_to_edge(X, plan_.back.X[a], plan_.back.X[b]));
        for (const Tether& t : r_.tethers)
            strip = std::min(strip, distance_outside(TetherStrip(t), X));
        const double open = std::min(1.0, edge / r_.pattern.closing);
        const double wide = std::max(0.0, 1.0 - strip / r_.pattern.closing);
        return 0.5 * r_.pattern.gap * open * (1.0 + wide);
    }

    Index add_node(const Sheet& plan, std::size_t n, double z) {
        Sheet& s = bag_.sheet;
        s.X.push_back(plan.X[n]);
        s.x.emplace_back(plan.X[n].x(), plan.X[n].y(), z);
        s.on.push_back(plan.on[n]);
        return static_cast<Index>(s.X.size()) - 1;
    }

    void add_seam_node(std::size_t n) {
        front_[n] = back_[n] = add_node(plan_.back, n, 0.0);
        bag_.seam.push_back(front_[n]);
        auto& on = bag_.sheet.on[front_[n]];
        if (on.empty() || on.front() >= 0) on.insert(on.begin(), SEAM);
    }

    void add_nodes() {
        rim_ = rim_edges(plan_.back.cells);
        std::set<Index> seam;
        for (const auto& [a, b] : rim_) seam.insert({a, b});
        front_.resize(plan_.front.X.size());
        back_.resize(plan_.back.X.size());
        for (std::size_t n = 0; n < std::max(front_.size(), back_.size()); ++n) {
            if (seam.contains(static_cast<Index>(n))) {
                add_seam_node(n);
                continue;
            }
            if (n < front_.size()) front_[n] = add_node(plan_.front, n, half_gap(plan_.front.X[n]));
            if (n < back_.size()) back_[n] = add_node(plan_.back, n, -half_gap(plan_.back.X[n]));
        }
    }

    void add(const Cell& cell, const std::vector<Index>& rows, Piece piece) {
        bag_.sheet.cells.push_back({rows[cell[0]], rows[cell[1]], rows[cell[2]], rows[cell[3]]});
        bag_.sheet.part.push_back(piece);
    }

    [[nodiscard]] bool is_vent_of(int region, bool is_front) const {
        return region >= VENT && r_.vents[region - VENT].is_front == is_front;
    }

    void add_panels() {
        const auto add_front = [&](std::size_t e) {
            add(plan_.front.cells[e], front_,
                is_vent_of(plan_.front.part[e], true) ? FRONT_VENT : FRONT);
        };
        std::set<Index> module;
        const auto add_back = [&](std::size_t e) {
            const int region = plan_.back.part[e];
            Piece piece = BACK;
            if (is_vent_of(region, false)) piece = BACK_VENT;
            if (region == RING) piece = REINFORCEMENT;
            if (region == HOLE) piece = MODULE;
            if (region == HOLE || region == RING)
                for (const Index n : plan_.back.cells[e]) module.insert(back_[n]);
            if (region != HOLE || !r_.hole->is_open) add(plan_.back.cells[e], back_, piece);
        };
        const std::size_t fronts = plan_.front.cells.size(), backs = plan_.back.cells.size();
        for (std::size_t e = 0; e < std::max(fronts, backs); ++e) {
            if (e < fronts) add_front(e);
            if (e < backs) add_back(e);
        }
        bag_.module.assign(module.begin(), module.end());
    }

    /// Its own nodes but for the two ends: these are the panels'.
    void add_tether(const Tether& t) {
        const TetherStrip strip(t);
        const Sheet& plan = plan_.between;
        const double near = 0.45 * r_.pattern.element;  // lines of folds may have taken its edges
        const bool is_along_x = t.direction % 180 == 0;
        const int axis = is_along_x ? 0 : 1;
        const double way = t.direction < 180 ? 1.0 : -1.0;
        std::vector<std::size_t> cells;
        double first = INF, last = -INF;
        for (std::size_t e = 0; e < plan.cells.size(); ++e) {
            const Cell& c = plan.cells[e];
            const Vec3 middle = (plan.X[c[0]] + plan.X[c[1]] + plan.X[c[2]] +
                                 (corner_count(c) == 4 ? plan.X[c[3]] : plan.X[c[2]])) /
                                4.0;
            if (!is_in(strip, middle, 0.0)) continue;
            cells.push_back(e);
            for (const Index n : c) {
                first = std::min(first, way * plan.X[n][axis]);
                last = std::max(last, way * plan.X[n][axis]);
            }
        }
        if (cells.empty() || last - first < 2.0 * near)
            throw InputError(fmt::format("{}:{}: [[tether]] has no room for elements of {}",
                                         r_.file, t.line, r_.pattern.element));
        if (std::abs(last - first - t.length) > 1e-6 * t.length)
            bag_.remarks.push_back(fmt::format(
                "{}:{}: [[tether]] is {:.4g} long in place of {:.4g}: it ends where a fold does",
                r_.file, t.line, last - first, t.length));
        std::map<Index, Index> own;
        const double end = 1e-6 * r_.pattern.element;
        for (const std::size_t e : cells) {
            Cell c;
            for (int k = 0; k < 4; ++k) {
                const Index n = plan.cells[e][k];
                const double at = way * plan.X[n][axis];
                if (at < first + end)
                    c[k] = back_[n];
                else if (at > last - end)
                    c[k] = front_[n];
                else if (const auto [found, is_new] = own.try_emplace(n, 0); is_new)
                    c[k] = found->second = add_node(plan, n, 0.0);
                else
                    c[k] = found->second;
            }
            bag_.sheet.cells.push_back(c);
            bag_.sheet.part.push_back(TETHER);
        }
    }

    /// Vents of a few elements may be larger or smaller than drawn.
    void remark_on_vents() {
        constexpr double ALLOWED = 0.02;
        for (std::size_t i = 0; i < r_.vents.size(); ++i) {
            const VentHole& v = r_.vents[i];
            const double found =
                area_of(v.is_front ? plan_.front : plan_.back, VENT + static_cast<int>(i));
            const double wanted = 0.25 * std::numbers::pi * v.diameter * v.diameter;
            if (std::abs(found - wanted) > ALLOWED * wanted)
                bag_.remarks.push_back(fmt::format(
                    "{}: [[vent]] at = [{:g}, {:g}] has an area of {:.4g} in place of {:.4g}: "
                    "smaller elements are nearer",
                    r_.file, v.x, v.y, found, wanted));
        }
    }

    void finish() {
        remark_on_vents();
        bag_.parts = {{r_.parts.front, "front panel", true},
                      {r_.parts.back, "back panel", false},
                      {r_.parts.module, "module cover", false},
                      {r_.parts.reinforcement, "reinforcement", false},
                      {r_.parts.vent, "vents", true},
                      {r_.parts.vent, "vents", false},
                      {r_.parts.tether, "tethers", false}};
        bag_.has_vents = !r_.vents.empty();
        drop_loose_nodes(bag_.sheet, {&bag_.seam, &bag_.module});  // of an open hole
    }

    static constexpr int SEAM = -1000000;  ///< a line that counts as curved: its nodes stay

    const Recipe& r_;
    Plan plan_;
    Bag bag_;
    std::vector<std::pair<Index, Index>> rim_;
    std::vector<Index> front_, back_;  ///< rows of the bag by those of the plan
};

}  // namespace

void turn_front(Bag& bag) {
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        Cell& c = bag.sheet.cells[e];
        if (!bag.parts[bag.sheet.part[e]].is_front) continue;
        if (corner_count(c) == 4)
            std::swap(c[1], c[3]);
        else
            std::swap(c[0], c[1]);
    }
}

Bag make_bag(const Recipe& recipe, const PlanLines& lines, bool is_alike) {
    if (recipe.pattern.kind == PatternKind::DECK) return make_deck_bag(recipe);
    return Sewing(recipe, make_plan(recipe, lines, is_alike)).run();
}

}  // namespace corpuscle::fold
