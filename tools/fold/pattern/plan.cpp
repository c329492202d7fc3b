// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/pattern/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "tools/fold/pattern/circles.hpp"

namespace corpuscle::fold {
namespace {

constexpr double CLEAR_OF_FOLDS = 0.5;  ///< of an element: a tether's edge nearer to a fold's line
                                        ///< takes that line
/// Lines of the grid along one axis; names of those that must stay.
struct GridLines {
    std::vector<double> at;
    std::vector<int> name;  ///< -1: free
};

struct Extent {
    double x, y;  ///< half of the grid's size [m]
};

Extent extent(const Pattern& p) {
    if (p.kind == PatternKind::RECTANGLE) return {0.5 * p.length, 0.5 * p.width};
    return {0.5 * p.diameter + p.element, 0.5 * p.diameter + p.element};
}

GridLines grid_lines(std::vector<double> hard, const std::vector<double>& soft, double half,
                     double size, int first_name) {
    std::erase_if(hard, [&](double v) { return std::abs(v) > half - 1e-3 * size; });
    for (const double v : soft)
        if (std::all_of(hard.begin(), hard.end(),
                        [&](double h) { return std::abs(h - v) > CLEAR_OF_FOLDS * size; }))
            hard.push_back(v);
    std::sort(hard.begin(), hard.end());
    GridLines lines{{-half}, {first_name}};
    hard.push_back(half);
    for (std::size_t i = 0; i < hard.size(); ++i) {
        const double from = lines.at.back(), length = hard[i] - from;
        const int n = std::max(1, static_cast<int>(std::lround(length / size)));
        for (int k = 1; k < n; ++k) {
            lines.at.push_back(from + length * k / n);
            lines.name.push_back(-1);
        }
        lines.at.push_back(hard[i]);
        lines.name.push_back(first_name + 1 + static_cast<int>(i));
    }
    return lines;
}

Sheet grid(const GridLines& along_x, const GridLines& along_y) {
    Sheet sheet;
    const auto columns = static_cast<Index>(along_x.at.size());
    const auto rows = static_cast<Index>(along_y.at.size());
    for (Index j = 0; j < rows; ++j)
        for (Index i = 0; i < columns; ++i) {
            sheet.X.emplace_back(along_x.at[i], along_y.at[j], 0.0);
            auto& on = sheet.on.emplace_back();
            for (const int name : {along_x.name[i], along_y.name[j]})
                if (name >= 0) on.push_back(name);
        }
    for (Index j = 0; j + 1 < rows; ++j)
        for (Index i = 0; i + 1 < columns; ++i) {
            const Index n = j * columns + i;
            sheet.cells.push_back({n, n + 1, n + columns + 1, n + columns});
        }
    sheet.x = sheet.X;
    sheet.part.assign(sheet.cells.size(), CLOTH);
    return sheet;
}

bool is_inside(const Pattern& p, double x, double y, double margin) {
    if (p.kind == PatternKind::DISC) return std::hypot(x, y) + margin < 0.5 * p.diameter;
    return std::abs(x) + margin < 0.5 * p.length && std::abs(y) + margin < 0.5 * p.width;
}

void check_inside(const Recipe& r) {
    std::vector<std::string> faults;
    const auto check = [&](bool is_good, const std::string& what) {
        if (!is_good)
            faults.push_back(fmt::format("{}: {}, expected within the pattern", r.file, what));
    };
    if (r.hole)
        check(is_inside(r.pattern, 0, 0, 0.5 * std::max(r.hole->diameter, r.hole->reinforcement)),
              fmt::format("[hole] diameter = {}", r.hole->diameter));
    for (const VentHole& v : r.vents)
        check(is_inside(r.pattern, v.x, v.y, 0.5 * v.diameter),
              fmt::format("[[vent]] at = [{}, {}]", v.x, v.y));
    for (const Tether& t : r.tethers) {
        const TetherStrip s(t);
        for (const double x : {s.low.x(), s.high.x()})
            for (const double y : {s.low.y(), s.high.y()})
                check(is_inside(r.pattern, x, y, r.pattern.element),
                      fmt::format("[[tether]] of line {} reaches ({}, {})", t.line, x, y));
    }
    if (!faults.empty()) throw InputError(faults);
}

/// Those of the front, or of the back; the outer before the inner.
std::vector<Cut> cuts(const Recipe& r, bool is_front) {
    std::vector<Cut> all;
    if (r.hole && !is_front) {
        if (r.hole->reinforcement > 0.0)
            all.push_back({{Vec3::Zero(), 0.5 * r.hole->reinforcement}, RING});
        all.push_back({{Vec3::Zero(), 0.5 * r.hole->diameter}, HOLE});
    }
    for (std::size_t i = 0; i < r.vents.size(); ++i)
        if (const VentHole& v = r.vents[i]; v.is_front == is_front)
            all.push_back({{Vec3(v.x, v.y, 0.0), 0.5 * v.diameter}, VENT + static_cast<int>(i)});
    return all;
}

Sheet outline(const Recipe& r, const PlanLines& lines) {
    std::vector<double> soft_x, soft_y;
    for (const Tether& t : r.tethers) {
        const TetherStrip s(t);
        soft_x.insert(soft_x.end(), {s.low.x(), s.high.x()});
        soft_y.insert(soft_y.end(), {s.low.y(), s.high.y()});
    }
    const Extent half = extent(r.pattern);
    const double size = r.pattern.element;
    constexpr int Y_NAMES = 1000000;
    const Sheet sheet = grid(grid_lines(lines.x, soft_x, half.x, size, 0),
                             grid_lines(lines.y, soft_y, half.y, size, Y_NAMES));
    if (r.pattern.kind == PatternKind::RECTANGLE) return sheet;
    return cut_rim(0.5 * r.pattern.diameter, size, sheet);
}

/// A hole that the mesh has lost, or most of it, is a fault.
void check_regions(const Recipe& r, const Plan& plan) {
    std::vector<std::string> faults;
    const auto check = [&](int region, double diameter, double inner, const std::string& what) {
        const bool is_front = region >= VENT && r.vents[region - VENT].is_front;
        const double found = area_of(is_front ? plan.front : plan.back, region);
        const double wanted = 0.25 * std::numbers::pi * (diameter * diameter - inner * inner);
        if (found < 0.6 * wanted)
            faults.push_back(
                fmt::format("{}: {} diameter = {}: the mesh has {:.3g} of its area {:.4g}; smaller "
                            "elements than {} are wanted, or another place",
                            r.file, what, diameter, found, wanted, r.pattern.element));
    };
    if (r.hole) check(HOLE, r.hole->diameter, 0.0, "[hole]");
    for (std::size_t i = 0; i < r.vents.size(); ++i)
        check(VENT + static_cast<int>(i), r.vents[i].diameter, 0.0,
              fmt::format("[[vent]] at = [{}, {}],", r.vents[i].x, r.vents[i].y));
    if (!faults.empty()) throw InputError(faults);
}

}  // namespace

TetherStrip::TetherStrip(const Tether& t) {
    const bool is_along_x = t.direction % 180 == 0;
    const double way = t.direction < 180 ? t.length : -t.length;
    const Vec3 from(t.x, t.y, 0.0), to = from + way * (is_along_x ? Vec3::UnitX() : Vec3::UnitY());
    const Vec3 aside = 0.5 * t.width * (is_along_x ? Vec3::UnitY() : Vec3::UnitX());
    low = from.cwiseMin(to) - aside;
    high = from.cwiseMax(to) + aside;
}

Plan make_plan(const Recipe& r, const PlanLines& lines, bool is_alike) {
    check_inside(r);
    const Sheet rim = outline(r, lines);
    if (rim.cells.empty())
        throw InputError(fmt::format(
            "{}: [pattern] element = {}: no cell of that size lies within the disc of diameter {}, "
            "expected smaller elements",
            r.file, r.pattern.element, r.pattern.diameter));
    std::vector<Cut> front = cuts(r, true), back = cuts(r, false);
    const double size = r.pattern.element;
    Plan plan{rim, rim, rim};
    if (is_alike) {
        back.insert(back.end(), front.begin(), front.end());
        if (!back.empty()) plan.front = plan.back = plan.between = cut_holes(back, size, rim);
    } else {
        if (!front.empty()) plan.front = cut_holes(front, size, rim);
        if (!back.empty()) plan.back = cut_holes(back, size, rim);
    }
    check_regions(r, plan);
    return plan;
}

}  // namespace corpuscle::fold
