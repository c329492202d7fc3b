// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/fold/plan.hpp"

namespace corpuscle::fold {
namespace {

/// 0 or 1 for folds along x or y, and the sign of s along it; -1 for all others.
struct Axis {
    int index = -1;
    double sign = 1.0;
};

Axis axis(const Accordion& f) {
    const double quarters = f.angle / (0.5 * std::numbers::pi);
    const double whole = std::round(quarters);
    if (std::abs(quarters - whole) > 1e-12) return {};
    const int turn = ((static_cast<int>(whole) % 4) + 4) % 4;
    const double side = f.is_left ? -1.0 : 1.0;
    return {turn % 2, turn < 2 ? side : -side};
}

/// Places s that the fold takes to `after`.
std::vector<double> before(const Accordion& f, double after) {
    std::vector<double> all;
    for (std::size_t i = 0; i <= f.lines.size(); ++i) {
        const double s = (i % 2 ? -1.0 : 1.0) * (after - mirrored(f, i, 0.0));
        const double tiny = 1e-9 * f.bands.front();
        if (i > 0 && s < f.lines[i - 1] + f.bands[i - 1] - tiny) continue;
        if (i < f.lines.size() && s > f.lines[i] - f.bands[i] + tiny) continue;
        all.push_back(s);
    }
    return all;
}

void sort_unique(std::vector<double>& lines) {
    std::sort(lines.begin(), lines.end());
    double size = 1.0;
    for (const double v : lines) size = std::max(size, std::abs(v));
    const auto same = [&](double a, double b) { return b - a < 1e-9 * size; };
    lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
}

}  // namespace

PlanLines plan_lines(const std::vector<Accordion>& folds, int parts) {
    PlanLines all;
    for (std::size_t j = 0; j < folds.size(); ++j) {
        const Axis mine = axis(folds[j]);
        if (mine.index < 0 || folds[j].lines.empty()) continue;
        std::vector<double> places;  // x or y, as they are before fold j
        for (const double s : borders(folds[j], parts)) places.push_back(mine.sign * s);
        for (std::size_t i = j; i-- > 0;) {
            const Axis other = axis(folds[i]);
            if (other.index != mine.index || folds[i].lines.empty()) continue;
            std::vector<double> earlier;
            for (const double v : places)
                for (const double s : before(folds[i], other.sign * v))
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
