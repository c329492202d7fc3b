// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/fold/pattern/plan.hpp"

namespace corpuscle::fold {
namespace {

/// 0 or 1 for folds along x or y, and the sign of s along it; -1 for all others.
struct Axis {
    int index = -1;
    double sign = 1.0;
};

template <class Fold>
Axis axis(const Fold& f) {
    const double quarters = f.angle / (0.5 * std::numbers::pi);
    const double whole = std::round(quarters);
    if (std::abs(quarters - whole) > 1e-12) return {};
    const int turn = ((static_cast<int>(whole) % 4) + 4) % 4;
    const double side = f.is_left ? -1.0 : 1.0;
    return {turn % 2, turn < 2 ? side : -side};
}

Axis axis_of(const Move& move) {
    return std::visit([](const auto& f) { return borders(f, 1).empty() ? Axis{} : axis(f); }, move);
}

void sort_unique(std::vector<double>& lines) {
    std::sort(lines.begin(), lines.end());
    double size = 1.0;
    for (const double v : lines) size = std::max(size, std::abs(v));
    const auto same = [&](double a, double b) { return b - a < 1e-9 * size; };
    lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
}

}  // namespace

PlanLines plan_lines(const std::vector<Move>& folds, double gap, int parts) {
    PlanLines all;
    for (std::size_t j = 0; j < folds.size(); ++j) {
        const Axis mine = axis_of(folds[j]);
        if (mine.index < 0) continue;
        std::vector<double> places;  // x or y, as they are before fold j
        for (const double s :
             std::visit([&](const auto& f) { return borders(f, parts); }, folds[j]))
            places.push_back(mine.sign * s);
        for (std::size_t i = j; i-- > 0;) {
            const Axis other = axis_of(folds[i]);
            if (other.index != mine.index) continue;
            std::vector<double> earlier;
            for (const double v : places)
                for (const double s : std::visit(
                         [&](const auto& f) { return before(f, gap, other.sign * v); }, folds[i]))
                    earlier.push_back(other.sign * s);
            places = std::move(earlier);
        }
        auto& lines = mine.index == 0 ? all.x : all.y;
        lines.insert(lines.end(), places.begin(), places.end());
    }
    sort_unique(all.x);
    sort_unique(all.y);
    return all;
}

}  // namespace corpuscle::fold
