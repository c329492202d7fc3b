// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/crossing.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <utility>

#include "solver/base/predicates.hpp"
#include "solver/base/simd.hpp"

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

/// Lane by lane, a bit each: is a greater than b?
unsigned greater(const Four& a, const Four& b) {
    const FourBits is_greater = a > b;
#ifdef __AVX__
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(is_greater)));
#else
    unsigned bits = 0;
    for (int l = 0; l < FOUR; ++l) bits |= static_cast<unsigned>(is_greater[l] != 0) << l;
    return bits;
#endif
}

/// Some corners of the swept triangle as the particle sees them: 0-2 at t, 3-5 at t + dt.
struct Corners {
    std::array<Four, 3> along;
    [[nodiscard]] Corners pick(const FourBits& from) const {
        Corners out;
        for (int a = 0; a < 3; ++a) out.along[a] = shuffled(along[a], from);
        return out;
    }
    [[nodiscard]] Vec3 operator[](int lane) const {
        return {along[0][lane], along[1][lane], along[2][lane]};
    }
    /// Largest coordinates, by absolute value.
    [[nodiscard]] Four size() const {
        Four most{};
        for (const Four& a : along) {
            const Four size = magnitude_of(a);
            most = size > most ? size : most;
        }
        return most;
    }
};
Four inner_product(const Corners& a, const Corners& b) {
    return a.along[0] * b.along[0] + a.along[1] * b.along[1] + a.along[2] * b.along[2];
}
Corners cross_product(const Corners& a, const Corners& b) {
    const auto& [ax, ay, az] = a.along;
    const auto& [bx, by, bz] = b.along;
    return {{ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx}};
}

/// All six, as faces_of() needs them.
struct Prism {
    Corners a, b;  ///< 0 4 2 0 and 1 5 5 3
    double size;   ///< largest coordinate, by absolute value                            [m]

    [[nodiscard]] Vec3 operator[](int corner) const {
        constexpr std::array<int, 6> LANE = {0, 4, 2, 7, 1, 5};
        return LANE[corner] < 4 ? a[LANE[corner]] : b[LANE[corner] - 4];
    }
    static Prism seen_by(const Path& path, const Triangle& nodes, const Vec3* x_0,
                         const Vec3* x_1) {
        const auto& [i, j, k] = nodes;
        Prism out;
        for (int c = 0; c < 3; ++c) {
            const double p = path.at_0[c], q = path.at_1[c];
            out.a.along[c] = Four{x_0[i][c], x_1[j][c], x_0[k][c], x_0[i][c]} - Four{p, q, p, p};
            out.b.along[c] = Four{x_0[j][c], x_1[k][c], x_1[k][c], x_1[i][c]} - Four{p, q, q, q};
        }
        const Four a = out.a.size(), b = out.b.size(), most = a > b ? a : b;
        out.size = std::max(std::max(most[0], most[1]), std::max(most[2], most[3]));
        return out;
    }
};

/// Faces of the three tetrahedra; vertices in ascending order, so that neighbours compute the same
/// number.
enum Face { F012, F045, F025, F034, F015, F145, F125, F035, F014, F345, FACES };
constexpr std::array<std::array<int, 3>, FACES> FACE_CORNERS = {{{0, 1, 2},
                                                                 {0, 4, 5},
                                                                 {0, 2, 5},
                                                                 {0, 3, 4},
                                                                 {0, 1, 5},
                                                                 {1, 4, 5},
                                                                 {1, 2, 5},
                                                                 {0, 3, 5},
                                                                 {0, 1, 4},
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

/// In which pieces the origin lies, a bit each, by the signs of the faces: weights are ± the face
/// determinants, with alternating signs.
constexpr auto PIECES_AROUND = [] {
    std::array<std::uint8_t, 1U << FACES> out{};
    for (unsigned signs = 0; signs < out.size(); ++signs)
        for (unsigned p = 0; p < 3; ++p) {
            const auto& face = PIECES[p].face;
            const auto sign = [&](int i) { return signs >> face[i] & 1U; };
            if (sign(0) != sign(1) && sign(1) != sign(2) && sign(2) != sign(3))
                out[signs] |= static_cast<std::uint8_t>(1U << p);
        }
    return out;
}();

/// |i j k| of all faces, i · (j × k), and a bit each: is it positive? The sign is exact.
struct Faces {
    std::array<double, 3 * FOUR> value;
    unsigned is_positive;
    [[nodiscard]] unsigned pieces() const { return PIECES_AROUND[is_positive % (1U << FACES)]; }
};

/// Four cross products side by side, 0 × 1, 4 × 5, 2 × 5, 0 × 3, and three rows of dot products
/// with them.
Faces faces_of(const Prism& prism) {
    // Six products of three numbers no larger than size, and sums: rounded by some 40 units, twice.
    constexpr double ROUNDING = 1e-14;
    const auto& [a, b, size] = prism;
    const Corners normal = cross_product(a, b);
    Corners last;  // 4 3 3 3
    const FourBits is_3{0, -1, -1, -1};
    const Corners a_4 = a.pick(FourBits{1, 1, 1, 1}), b_3 = b.pick(FourBits{3, 3, 3, 3});
    for (int c = 0; c < 3; ++c) last.along[c] = is_3 ? b_3.along[c] : a_4.along[c];
    const std::array<Four, 3> row = {
        inner_product(normal, a.pick(FourBits{2, 0, 0, 1})),  // 2 0 0 4
        inner_product(normal, b.pick(FourBits{1, 0, 0, 1})),  // 5 1 1 5
        inner_product(normal, last)};
    const Four doubtful = all_four(ROUNDING * size * size * size);
    Faces out;
    std::memcpy(out.value.data(), row.data(), sizeof(row));
    out.is_positive = 0;
    unsigned is_sure = ~0U << FACES;
    for (int r = 0; r < 3; ++r) {
        const unsigned positive = greater(row[r], doubtful), negative = greater(-doubtful, row[r]);
        out.is_positive |= positive << (r * FOUR);
        is_sure |= (positive | negative) << (r * FOUR);
    }
    for (; is_sure != ~0U; is_sure |= is_sure + 1) {
        const int f = std::countr_one(is_sure);
        const auto& c = FACE_CORNERS[f];
        const Determinant d = determinant(prism[c[0]], prism[c[1]], prism[c[2]]);
        out.value[f] = d.value;
        // An exact zero counts as positive, on both sides of the face.
        out.is_positive |= static_cast<unsigned>(d.sign >= 0) << f;
    }
    return out;
}

}  // namespace

std::optional<Crossing> cross(const Path& path, const Triangle& triangle, const Vec3* x_0,
                              const Vec3* x_1, double after, int ignored) {
    const auto order = ascending(triangle);
    const Prism prism = Prism::seen_by(
        path, {triangle[order[0]], triangle[order[1]], triangle[order[2]]}, x_0, x_1);

    const Faces faces = faces_of(prism);
    std::optional<Crossing> first;
    for (unsigned around = faces.pieces(); around != 0; around &= around - 1) {
        const int p = std::countr_zero(around);
        if (p == ignored) continue;
        const auto& [corner, face] = PIECES[p];
        double total = 0.0, late = 0.0;
        for (int i = 0; i < 4; ++i) {
            const double weight = std::abs(faces.value[face[i]]);
            total += weight;
            if (corner[i] >= 3) late += weight;
        }
        if (total == 0.0) continue;  // a piece without volume: nothing moves here
        const double tau = late / total;
        if (!(tau > after) || (first && !(tau < first->tau))) continue;
        if (!first) first.emplace();
        first->tau = tau;
        first->piece = p;
        std::array<double, 3> at{};
        for (int i = 0; i < 4; ++i) at[corner[i] % 3] += std::abs(faces.value[face[i]]) / total;
        for (int c = 0; c < 3; ++c) first->at[order[c]] = at[c];
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
