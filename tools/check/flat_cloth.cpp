// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/check/flat_cloth.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::tools {
namespace {

/// Lengths and angle of two edges of a triangle.
Eigen::Matrix2d metric(const Vec3& a, const Vec3& b) {
    Eigen::Matrix2d g;
    g << a.dot(a), a.dot(b), a.dot(b), b.dot(b);
    return g;
}

/// Of a triangle; without an area 0.
double stretch(const Eigen::Matrix2d& now, const Eigen::Matrix2d& flat) {
    if (!(flat.determinant() > 0.0)) return 0.0;
    const Eigen::Matrix2d squared = flat.inverse() * now;  // its eigenvalues are stretches squared
    const double half = 0.5 * squared.trace();
    return std::sqrt(half + std::sqrt(std::max(0.0, half * half - squared.determinant())));
}

}  // namespace

double area(const Corners& at) {
    return 0.5 * (at[2] - at[0]).cross(at[3] - at[1]).norm();
}

Corners corners(const Shell& shell, const Points& x) {
    const auto& n = shell.nodes;
    return {x[n[0]], x[n[1]], x[n[2]], x[n[3]]};
}

bool has_references(const Model& model) {
    return !model.references.empty() || !model.shell_references.empty();
}

double closing_area(const gas::BagWalls& walls, const std::vector<Corners>& flat) {
    std::vector<Index> shells(walls.shell.begin(),
                              walls.shell.begin() + static_cast<std::ptrdiff_t>(walls.closing));
    std::sort(shells.begin(), shells.end());
    shells.erase(std::unique(shells.begin(), shells.end()), shells.end());
    double all = 0.0;
    for (const Index shell : shells) all += area(flat[shell]);
    return all;
}

double greatest_stretch(const Corners& now, const Corners& flat) {
    double most = 0.0;
    for (const std::size_t k : {1U, 2U})
        most = std::max(most, stretch(metric(now[k] - now[0], now[k + 1] - now[0]),
                                      metric(flat[k] - flat[0], flat[k + 1] - flat[0])));
    return most;
}

}  // namespace corpuscle::tools
