// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/crossing.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "solver/base/predicates.hpp"

namespace corpuscle::gas {
namespace {

/// Corners of a triangle in ascending node row.
std::array<int, 3> ascending(const Triangle& nodes) {
    std::array<int, 3> order{0, 1, 2};
    if (nodes[order[0]] > nodes[order[1]]) std::swap(order[0], order[1]);
    if (nodes[order[1]] > nodes[order[2]]) std::swap(order[1], order[2]);
    if (nodes[order[0]] > nodes[order[1]]) std::swap(order[0], order[1]);
    return order;
}

/// The six corners of the swept triangle as the particle sees them: 0-2 at t, 3-5 at t + dt.
using Corners = std::array<Vec3, 6>;

/// Are all corners on one side of the plane through the origin that is parallel to the triangle at
/// t, and farther from it than rounding can be wrong? Cost: one cross product, four dot products.
bool all_on_one_side(const Corners& r) {
    constexpr double ROUNDING = 1e-13;  // of the products below, generously
    const Vec3 normal = (r[1] - r[0]).cross(r[2] - r[0]);
    double low = INF, high = -INF, size = 0.0;
    for (const Vec3& corner : r) {
        const double height = normal.dot(corner);
        low = std::min(low, height);
        high = std::max(high, height);
        size = std::max(size, normal.cwiseAbs().dot(corner.cwiseAbs()));
    }
    return low > ROUNDING * size || high < -ROUNDING * size;
}

/// Faces of the three tetrahedra; vertices in ascending order, so that neighbours compute the same
/// number.
enum Face { F012, F015, F025, F125, F014, F045, F145, F034, F035, F345, FACES };
constexpr std::array<std::array<int, 3>, FACES> FACE_CORNERS = {{{0, 1, 2},
                                                                 {0, 1, 5},
                                                                 {0, 2, 5},
                                                                 {1, 2, 5},
                                                                 {0, 1, 4},
                                                                 {0, 4, 5},
                                                                 {1, 4, 5},
                                                                 {0, 3, 4},
                                                                 {0, 3, 5},
                                                                 {3, 4, 5}}};

struct Piece {
    std::array<int, 4> corner;  ///< vertices
    std::array<Face, 4> face;   ///< face[i] is opposite corner[i]
};
constexpr std::array<Piece, 3> PIECES = {{
    {{0, 1, 2, 5}, {F125, F025, F015, F012}},
    {{0, 1, 4, 5}, {F145, F045, F015, F014}},
    {{0, 3, 4, 5}, {F345, F045, F035, F034}},
}};

}  // namespace

std::optional<Crossing> cross(const Path& path, const Triangle& triangle, const Vec3* x_0,
                              const Vec3* x_1, double after, int ignored) {
    const auto order = ascending(triangle);
    Corners r;
    for (int i = 0; i < 3; ++i) {
        const Index node = triangle[order[i]];
        r[i] = x_0[node] - path.at_0;
        r[i + 3] = x_1[node] - path.at_1;
    }
    if (all_on_one_side(r)) return std::nullopt;

    std::array<double, FACES> value;
    std::array<std::int8_t, FACES> sign{};  // 0: not yet asked for
    // An exact zero counts as positive, on both sides of the face.
    const auto is_positive = [&](Face f) {
        if (sign[f] == 0) {
            const auto& c = FACE_CORNERS[f];
            const Determinant d = determinant(r[c[0]], r[c[1]], r[c[2]]);
            value[f] = d.value;
            sign[f] = d.sign >= 0 ? 1 : -1;
        }
        return sign[f] > 0;
    };
    std::optional<Crossing> first;
    for (int p = 0; p < 3; ++p) {
        if (p == ignored) continue;
        const auto& [corner, face] = PIECES[p];
        // Barycentric weights of the origin are ± the face determinants, with alternating signs.
        const bool inside = is_positive(face[0]) == !is_positive(face[1]) &&
                            is_positive(face[1]) == !is_positive(face[2]) &&
                            is_positive(face[2]) == !is_positive(face[3]);
        if (!inside) continue;
        std::array<double, 4> weight;
        double total = 0.0;
        for (int i = 0; i < 4; ++i) total += weight[i] = std::abs(value[face[i]]);
        if (total == 0.0) continue;  // a piece without volume: nothing moves here
        Crossing hit{0.0, {0.0, 0.0, 0.0}, p};
        for (int i = 0; i < 4; ++i) {
            const double share = weight[i] / total;
            hit.at[order[corner[i] % 3]] += share;
            if (corner[i] >= 3) hit.tau += share;
        }
        if (hit.tau > after && (!first || hit.tau < first->tau)) first = hit;
    }
    return first;
}

MovingPlane plane_of(int piece, const Triangle& triangle, const Vec3* x_0, const Vec3* x_1) {
    const auto order = ascending(triangle);
    const Index i = triangle[order[0]], j = triangle[order[1]], k = triangle[order[2]];
    MovingPlane plane;
    switch (piece) {
        case 0:  // i and j at t, k all along
            plane.normal = (x_0[j] - x_0[i]).cross(x_0[k] - x_0[i]);
            plane.speed = plane.normal.dot(x_1[k] - x_0[k]);
            break;
        case 1:  // i at t, k at t + dt, j all along
            plane.normal = (x_0[j] - x_0[i]).cross(x_1[k] - x_1[j]);
            plane.speed = plane.normal.dot(x_1[j] - x_0[j]);
            break;
        default:  // j and k at t + dt, i all along
            plane.normal = (x_1[j] - x_1[i]).cross(x_1[k] - x_1[i]);
            plane.speed = plane.normal.dot(x_1[i] - x_0[i]);
    }
    return plane;
}

}  // namespace corpuscle::gas
