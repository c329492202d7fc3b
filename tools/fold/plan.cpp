// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "tools/fold/imprint.hpp"
#include "tools/fold/improve.hpp"

namespace corpuscle::fold {
namespace {

constexpr double CLEAR_OF_FOLDS = 0.5;  ///< of an element: a tether's edge nearer to a fold's line
                                        ///< takes that line
constexpr double WANTED = 0.28;         ///< of an element: reach of a cell that improving aims at
constexpr double TOO_SMALL = 0.17;      ///< that of cells that lose an edge
constexpr int ROUNDS = 8;
constexpr double NEAR = 2.5;  ///< elements round a hole's circle that change for it
constexpr int TRIES = 8;      ///< radii of a hole, of the rim
constexpr double HOLE_ERROR = 0.02, RIM_ERROR = 1e-3;  ///< of an area that is good enough
constexpr double SNAP = 0.45, GIVES_WAY = 0.4;         ///< of an edge, for circles

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

struct Circle {
    Vec3 middle;
    double radius;
};

void settle(const Circle& c, Vec3& X) {
    X = c.middle + c.radius / (X - c.middle).norm() * (X - c.middle);
}

std::vector<int> imprint_circle(Sheet& sheet, const Circle& c, int name) {
    Imprint line{name, {}, SNAP, GIVES_WAY, [&](Vec3& X) { settle(c, X); }};
    for (const Vec3& X : sheet.X) line.level.push_back((X - c.middle).norm() - c.radius);
    return imprint(sheet, line);
}

void improve(Sheet& sheet, double size, const Freedom& freedom) {
    for (int k = 0; k < 3; ++k) {
        collapse({TOO_SMALL * size}, freedom, sheet);
        smooth(sheet, WANTED * size, ROUNDS, freedom);
    }
}

double area_of(const Sheet& sheet, int region) {
    double sum = 0.0;
    for (std::size_t e = 0; e < sheet.cells.size(); ++e)
        if (sheet.part[e] == region) sum += area(sheet.cells[e], sheet.X);
    return sum;
}

double area_of(const Circle& c) {
    return std::numbers::pi * c.radius * c.radius;
}

void keep_inside(Sheet& sheet, const std::vector<int>& side) {
    std::size_t kept = 0;
    for (std::size_t e = 0; e < side.size(); ++e)
        if (side[e] < 0) {
            sheet.cells[kept] = sheet.cells[e];
            sheet.part[kept++] = sheet.part[e];
        }
    sheet.cells.resize(kept);
    sheet.part.resize(kept);
    drop_loose_nodes(sheet);
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

/// A circle that is the border of a region.
struct Cut {
    Circle circle;
    int region;
};

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

Sheet cut_once(const std::vector<Cut>& cuts, double size, Sheet sheet) {
    Freedom near;
    int name = -2;
    for (const Cut& cut : cuts) {
        const std::vector<int> side = imprint_circle(sheet, cut.circle, name);
        for (std::size_t e = 0; e < side.size(); ++e)
            if (side[e] < 0) sheet.part[e] = cut.region;
        near.curves[name--] = [circle = cut.circle](Vec3& X) { settle(circle, X); };
    }
    near.is_free = [&](const Vec3& X) {
        return std::any_of(cuts.begin(), cuts.end(), [&](const Cut& c) {
            return std::abs((X - c.circle.middle).norm() - c.circle.radius) < NEAR * size;
        });
    };
    improve(sheet, size, near);
    return sheet;
}

/// A few elements' polygon is not a circle, and lines give way. So other radii are tried; of those
/// meshes whose areas are the drawing's the one with the best cells is kept.
class Choice {
public:
    explicit Choice(double allowed) : allowed_(allowed) {}

    /// @param error  of an area [-]
    void offer(double error, Sheet sheet) {
        const double over = std::max(0.0, error - allowed_);
        double least = INF;
        for (const Cell& c : sheet.cells) least = std::min(least, reach(c, sheet.X));
        if (over > over_ || (over == over_ && least <= least_)) return;
        over_ = over;
        least_ = least;
        sheet_ = std::move(sheet);
    }
    Sheet best() { return std::move(sheet_); }

private:
    double allowed_, over_ = INF, least_ = -INF;
    Sheet sheet_;
};

Sheet cut_holes(const std::vector<Cut>& cuts, double size, const Sheet& whole) {
    std::vector<Cut> tried = cuts;
    Choice choice(HOLE_ERROR);
    for (int k = 0; k < TRIES; ++k) {
        Sheet sheet = cut_once(tried, size, whole);
        double worst = 0.0;
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            double found = area_of(sheet, cuts[i].region);
            if (cuts[i].region == RING) found += area_of(sheet, HOLE);
            const double wanted = area_of(cuts[i].circle);
            worst = std::max(worst, std::abs(found / wanted - 1.0));
            if (found > 0.0) tried[i].circle.radius *= std::sqrt(wanted / found);
        }
        choice.offer(worst, std::move(sheet));
    }
    return choice.best();
}

Sheet cut_rim(double radius, double size, const Sheet& whole) {
    constexpr int RIM = -1;
    Circle rim{Vec3::Zero(), radius};
    const double wanted = area_of(rim);
    Choice choice(RIM_ERROR);
    for (int k = 0; k < TRIES; ++k) {
        Sheet sheet = whole;
        keep_inside(sheet, imprint_circle(sheet, rim, RIM));
        improve(sheet, size, {{{RIM, [&](Vec3& X) { settle(rim, X); }}}, {}});
        drop_loose_nodes(sheet);
        const double found = area_of(sheet, CLOTH);
        rim.radius *= std::sqrt(wanted / found);
        choice.offer(std::abs(found / wanted - 1.0), std::move(sheet));
    }
    return choice.best();
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
