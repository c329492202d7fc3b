// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/inspect/inspect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>
#include <numbers>

namespace corpuscle::fold {
namespace {

/// Greatest principal strain of a triangle, with its edges as columns of D (flat) and d (now):
///
///     E = ½ (D⁻ᵀ dᵀ d D⁻¹ - 1)  [Green]
double green_strain(const Triangle& t, const Sheet& s) {
    const Vec3 a = s.X[t[1]] - s.X[t[0]], b = s.X[t[2]] - s.X[t[0]];
    const Vec3 along = a.normalized(), across = a.cross(b).cross(a).normalized();
    Eigen::Matrix2d D;
    D << along.dot(a), along.dot(b), across.dot(a), across.dot(b);
    Eigen::Matrix<double, 3, 2> d;
    d << s.x[t[1]] - s.x[t[0]], s.x[t[2]] - s.x[t[0]];
    const Eigen::Matrix<double, 3, 2> F = d * D.inverse();
    const Eigen::Matrix2d E = 0.5 * (F.transpose() * F - Eigen::Matrix2d::Identity());
    return 0.5 * E.trace() + std::hypot(0.5 * (E(0, 0) - E(1, 1)), E(0, 1));
}

void stretches(const Sheet& s, Inspection& found) {
    for (std::size_t e = 0; e < s.cells.size(); ++e)
        for (const Triangle& t : triangles({s.cells[e]}))
            if (const double strain = green_strain(t, s);
                found.stretched_at < 0 || strain > found.greatest_stretch) {
                found.greatest_stretch = strain;
                found.stretched_at = static_cast<Index>(e);
            }
}

/// Which of an edge's cells comes first, for messages.
void strains(const Sheet& s, Inspection& found) {
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t e = 0; e < s.cells.size(); ++e) {
        const Cell& c = s.cells[e];
        for (int k = 0, n = corner_count(c); k < n; ++k) {
            const Index a = c[k], b = c[(k + 1) % n];
            const double strain = (s.x[a] - s.x[b]).norm() / (s.X[a] - s.X[b]).norm() - 1.0;
            sum += strain * strain;
            ++count;
            if (strain < found.least_strain) {
                found.least_strain = strain;
                found.shortest_at = static_cast<Index>(e);
            }
            if (strain > found.greatest_strain) {
                found.greatest_strain = strain;
                found.longest_at = static_cast<Index>(e);
            }
        }
    }
    found.rms_strain = std::sqrt(sum / static_cast<double>(count));
}

void flat_quality(const Sheet& s, Inspection& found) {
    found.least_angle = std::numbers::pi;
    for (std::size_t e = 0; e < s.cells.size(); ++e) {
        const Cell& c = s.cells[e];
        const int n = corner_count(c);
        ++(n == 3 ? found.triangles : found.quads);
        found.flat_area += area(c, s.X);
        double longest = 0.0, shortest = INF;
        for (int k = 0; k < n; ++k) {
            const Vec3 a = s.X[c[(k + 1) % n]] - s.X[c[k]], b = s.X[c[(k + n - 1) % n]] - s.X[c[k]];
            longest = std::max(longest, a.norm());
            shortest = std::min(shortest, a.norm());
            const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
            if (angle < found.least_angle) {
                found.least_angle = angle;
                found.least_angle_at = static_cast<Index>(e);
            }
        }
        found.greatest_aspect = std::max(found.greatest_aspect, longest / shortest);
    }
}

bool is_above(const Triangle& t, const Points& x, double px, double py) {
    const auto side = [&](int i, int j) {
        const Vec3 &a = x[t[i]], &b = x[t[j]];
        return (b.x() - a.x()) * (py - a.y()) - (b.y() - a.y()) * (px - a.x());
    };
    const double s0 = side(0, 1), s1 = side(1, 2), s2 = side(2, 0);
    return (s0 > 0 && s1 > 0 && s2 > 0) || (s0 < 0 && s1 < 0 && s2 < 0);
}

/// Counts triangles over the points of a raster that no line of the mesh goes through.
int count_layers(const Sheet& s, const Inspection& found) {
    constexpr int POINTS = 61;
    constexpr double OFF = 0.4142135623730951;
    const Vec3 step = (found.high - found.low) / POINTS;
    std::vector<int> layers(POINTS * POINTS, 0);
    for (const Triangle& t : triangles(s.cells)) {
        const Vec3 low = s.x[t[0]].cwiseMin(s.x[t[1]]).cwiseMin(s.x[t[2]]) - found.low;
        const Vec3 high = s.x[t[0]].cwiseMax(s.x[t[1]]).cwiseMax(s.x[t[2]]) - found.low;
        const auto first = [&](int k) {
            return std::max(0, static_cast<int>(low[k] / step[k] - OFF));
        };
        const auto last = [&](int k) {
            return std::min(POINTS - 1, static_cast<int>(high[k] / step[k] - OFF) + 1);
        };
        for (int i = first(0); i <= last(0); ++i)
            for (int j = first(1); j <= last(1); ++j)
                if (is_above(t, s.x, found.low.x() + (i + OFF) * step.x(),
                             found.low.y() + (j + OFF) * step.y()))
                    ++layers[i * POINTS + j];
    }
    return *std::max_element(layers.begin(), layers.end());
}

}  // namespace

Inspection inspect(const Bag& bag, double reach) {
    const Sheet& s = bag.sheet;
    Inspection found;
    found.crossings = crossing_cells(s);
    find_least_gap(s, reach, found);
    strains(s, found);
    stretches(s, found);
    flat_quality(s, found);
    found.low = found.high = s.x.front();
    for (const Vec3& x : s.x) {
        found.low = found.low.cwiseMin(x);
        found.high = found.high.cwiseMax(x);
    }
    found.layers = count_layers(s, found);
    return found;
}

std::string fit(const Inspection& found, const Package& package) {
    const Vec3 size = found.high - found.low;
    const Vec3 room(package.length, package.width, package.height);
    std::string over;
    for (int k = 0; k < 3; ++k)
        if (size[k] > room[k])
            over += fmt::format("{}{} by {:.4g}", over.empty() ? "" : ", ",
                                std::array{"length", "width", "height"}[k], size[k] - room[k]);
    const std::string asked =
        fmt::format("the package of {:.6g} x {:.6g} x {:.6g}", room.x(), room.y(), room.z());
    return over.empty() ? "fits into " + asked
                        : "does not fit into " + asked + ": too great in " + over;
}

std::string text(const Inspection& f) {
    const Vec3 size = f.high - f.low;
    const auto shell = [](Index row) { return row + 1; };
    std::string all = fmt::format("{} quads, {} triangles, flat area {:.6g}\n", f.quads,
                                  f.triangles, f.flat_area);
    all += fmt::format("pack of {:.4g} x {:.4g} x {:.4g}, up to {} layers\n", size.x(), size.y(),
                       size.z(), f.layers);
    all += fmt::format("crossings: {}\n", f.crossings.size());
    if (f.least_gap_at[0] >= 0)
        all +=
            fmt::format("least gap between shells that share no node: {:.4g} (shells {} and {})\n",
                        f.least_gap, shell(f.least_gap_at[0]), shell(f.least_gap_at[1]));
    all += fmt::format(
        "edge strain that the fold puts in: {:.3g} (shell {}) to {:.3g} (shell {}), RMS {:.3g}\n",
        f.least_strain, shell(f.shortest_at), f.greatest_strain, shell(f.longest_at), f.rms_strain);
    all += fmt::format("greatest principal Green strain of a shell: {:.3g} (shell {})\n",
                       f.greatest_stretch, shell(f.stretched_at));
    all += fmt::format(
        "flat mesh: least angle {:.3g} degrees (shell {}), longest over shortest edge {:.3g}",
        f.least_angle * 180.0 / std::numbers::pi, shell(f.least_angle_at), f.greatest_aspect);
    return all;
}

}  // namespace corpuscle::fold
