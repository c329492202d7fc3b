// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/pattern/circles.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/fold/mesh/imprint.hpp"
#include "tools/fold/mesh/improve.hpp"

namespace corpuscle::fold {
namespace {

constexpr double WANTED = 0.28;          ///< of an element: reach of a cell that improving aims at
constexpr double SMALLEST_REACH = 0.17;  ///< that of cells that lose an edge
constexpr int ROUNDS = 8;
constexpr double NEAR = 2.5;  ///< elements round a hole's circle that change for it
constexpr int RADII = 8;      ///< radii of a hole, of the rim
constexpr double HOLE_ERROR = 0.02, RIM_ERROR = 1e-3;  ///< of an area that is good enough
constexpr double SNAP = 0.45, BENDS = 0.4;             ///< of an edge, for circles

void settle(const Circle& c, Vec3& X) {
    X = c.middle + c.radius / (X - c.middle).norm() * (X - c.middle);
}

std::vector<int> imprint_circle(Sheet& sheet, const Circle& c, int name) {
    Imprint line{name, {}, SNAP, BENDS, [&](Vec3& X) { settle(c, X); }};
    for (const Vec3& X : sheet.X) line.level.push_back((X - c.middle).norm() - c.radius);
    return imprint(sheet, line);
}

void improve(Sheet& sheet, double size, const Freedom& freedom) {
    for (int k = 0; k < 3; ++k) {
        collapse({SMALLEST_REACH * size}, freedom, sheet);
        smooth(sheet, WANTED * size, ROUNDS, freedom);
    }
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
        for (const Cell& c : sheet.cells) least = std::min(least, fold::reach(c, sheet.X));
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

}  // namespace

double area_of(const Sheet& sheet, int region) {
    double sum = 0.0;
    for (std::size_t e = 0; e < sheet.cells.size(); ++e)
        if (sheet.part[e] == region) sum += area(sheet.cells[e], sheet.X);
    return sum;
}

Sheet cut_holes(const std::vector<Cut>& cuts, double size, const Sheet& whole) {
    std::vector<Cut> tried = cuts;
    Choice choice(HOLE_ERROR);
    for (int k = 0; k < RADII; ++k) {
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
    for (int k = 0; k < RADII; ++k) {
        Sheet sheet = whole;
        keep_inside(sheet, imprint_circle(sheet, rim, RIM));
        improve(sheet, size, {{{RIM, [&](Vec3& X) { settle(rim, X); }}}, {}});
        drop_loose_nodes(sheet);
        const double found = area_of(sheet, CLOTH);
        if (found > 0.0) rim.radius *= std::sqrt(wanted / found);
        choice.offer(std::abs(found / wanted - 1.0), std::move(sheet));
    }
    return choice.best();
}

}  // namespace corpuscle::fold
