// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/reference_shape.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"

namespace corpuscle::fabric {

namespace {

/// Below these shares of (longest side)² a shape has no area, or a corner is straight to rounding.
constexpr double NO_AREA = 1e-10;
constexpr double STRAIGHT = 1e-9;
/// An axis this close to the normal (sine) has no direction in the plane.
constexpr double NO_DIRECTION = 1e-6;

Vec3 diagonal_product(const ReferenceShape& s, const std::array<Vec3, 4>& x) {
    const auto at = [&](int i) -> const Vec3& { return x[static_cast<std::size_t>(s.corner[i])]; };
    if (s.corners == 3) return (at(1) - at(0)).cross(at(2) - at(0));
    return (at(2) - at(0)).cross(at(3) - at(1));
}

/// Direction of the warp before BETA, not yet in the plane.
Vec3 warp_direction(const MaterialCard& card, const Vec3& side, const Vec3& normal) {
    const auto* fabric = std::get_if<FabricCard>(&card);
    if (fabric && fabric->axes == 2) return fabric->a.normalized();
    if (fabric && fabric->axes == 3) return fabric->v.normalized().cross(normal);
    return side.normalized();
}

double beta(const MaterialCard& card) {
    const auto* fabric = std::get_if<FabricCard>(&card);
    return fabric ? fabric->beta : 0.0;
}

double corner_area(const Eigen::Vector2d& before, const Eigen::Vector2d& at,
                   const Eigen::Vector2d& after) {
    const Eigen::Vector2d u = after - at, v = before - at;
    return u.x() * v.y() - u.y() * v.x();
}

bool points_inward(const ReferenceShape& s, double longest) {
    for (std::size_t i = 0; s.corners == 4 && i < 4; ++i)
        if (corner_area(s.x[(i + 3) % 4], s.x[i], s.x[(i + 1) % 4]) < -STRAIGHT * longest * longest)
            return true;
    return false;
}

}  // namespace

ReferenceShape distinct_corners(const Shell& shell) {
    ReferenceShape s;
    for (int i = 0; i < 4; ++i) {
        const auto n = [&](int k) { return shell.nodes[static_cast<std::size_t>(k)]; };
        if (i > 0 && n(i) == n(i - 1)) continue;
        if (i == 3 && n(3) == n(0)) continue;
        s.corner[static_cast<std::size_t>(s.corners++)] = i;
    }
    if (s.corners == 4 && (shell.nodes[0] == shell.nodes[2] || shell.nodes[1] == shell.nodes[3]))
        s.corners = 0;
    return s;
}

double reference_area(const Shell& shell, const std::array<Vec3, 4>& x) {
    const ReferenceShape s = distinct_corners(shell);
    return s.corners < 3 ? 0.0 : 0.5 * diagonal_product(s, x).norm();
}

ReferenceShape lay_flat(const Shell& shell, const std::array<Vec3, 4>& x, const MaterialCard& card,
                        std::string& fault) {
    ReferenceShape s = distinct_corners(shell);
    fault.clear();
    if (s.corners < 3) {
        fault = fmt::format("shell {} has fewer than three distinct corners", shell.id);
        return s;
    }
    const auto count = static_cast<std::size_t>(s.corners);
    const auto at = [&](std::size_t i) -> const Vec3& {
        return x[static_cast<std::size_t>(s.corner[i % count])];
    };
    double longest = 0.0;
    Vec3 middle = Vec3::Zero();
    for (std::size_t i = 0; i < count; ++i) {
        longest = std::max(longest, (at(i + 1) - at(i)).norm());
        middle += at(i) / static_cast<double>(count);
    }
    const Vec3 product = diagonal_product(s, x);
    s.area = 0.5 * product.norm();
    if (!(s.area > NO_AREA * longest * longest)) {
        fault = fmt::format("shell {} has a reference area of {:g}", shell.id, s.area);
        return s;
    }
    const Vec3 normal = product.normalized();
    // A side may have no length where two reference places coincide: take the first that has
    Vec3 side = at(1) - at(0);
    for (std::size_t i = 1; side.norm() < STRAIGHT * longest && i < count; ++i)
        side = at(i + 1) - at(i);
    Vec3 warp = warp_direction(card, side, normal);
    warp -= warp.dot(normal) * normal;
    if (!(warp.norm() > NO_DIRECTION)) {
        fault = fmt::format("shell {}: its material axis is normal to it", shell.id);
        return s;
    }
    warp.normalize();
    const double turn = beta(card);
    const Vec3 e_1 = std::cos(turn) * warp + std::sin(turn) * normal.cross(warp);
    const Vec3 e_2 = normal.cross(e_1);
    for (std::size_t i = 0; i < count; ++i)
        s.x[i] = {e_1.dot(at(i) - middle), e_2.dot(at(i) - middle)};
    s.warp = s.corners == 4 ? normal.dot(at(0) - middle) : 0.0;
    if (points_inward(s, longest))
        fault = fmt::format("shell {} is not convex in its reference shape", shell.id);
    return s;
}

}  // namespace corpuscle::fabric
