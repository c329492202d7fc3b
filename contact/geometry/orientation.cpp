// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/geometry/orientation.hpp"

#include <cmath>

namespace corpuscle::contact {
namespace {

/// Adds sign·|a b c| of the coordinates as they stand.
template <int CAPACITY>
void add_determinant(exact::Expansion<CAPACITY>& sum, double sign, const Vec3& a, const Vec3& b,
                     const Vec3& c) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        sum.add_product(b[j], c[k], sign * a[i]);
        sum.add_product(-b[k], c[j], sign * a[i]);
    }
}

int exact_orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    exact::Expansion<96> sum;  // 4 determinants of 6 products of 4 parts
    add_determinant(sum, 1.0, b, c, d);
    add_determinant(sum, -1.0, a, c, d);
    add_determinant(sum, 1.0, a, b, d);
    add_determinant(sum, -1.0, a, b, c);
    return sum.sign();
}

bool pierces(const Triangle& edges_of, const Triangle& face, std::span<const Vec3> x) {
    for (std::size_t k = 0; k < 3; ++k)
        if (segment_crosses(x[edges_of[k]], x[edges_of[(k + 1) % 3]], x[face[0]], x[face[1]],
                            x[face[2]]))
            return true;
    return false;
}

}  // namespace

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = c - a, w = d - a;
    const double yz = v.y() * w.z(), zy = v.z() * w.y();
    const double zx = v.z() * w.x(), xz = v.x() * w.z();
    const double xy = v.x() * w.y(), yx = v.y() * w.x();
    const double value = u.x() * (yz - zy) + u.y() * (zx - xz) + u.z() * (xy - yx);
    const double size = std::abs(u.x()) * (std::abs(yz) + std::abs(zy)) +
                        std::abs(u.y()) * (std::abs(zx) + std::abs(xz)) +
                        std::abs(u.z()) * (std::abs(xy) + std::abs(yx));
    constexpr double ROUNDING =
        8.9e-16;  // above (7 + 56 eps) eps, eps = 2^-53 [Shewchuk 1997, orient3d]
    if (std::abs(value) > ROUNDING * size) return value > 0.0 ? 1 : -1;
    return exact_orientation(a, b, c, d);
}

bool segment_crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const int p_side = orientation(a, b, c, p);
    if (p_side == 0 || p_side != -orientation(a, b, c, q)) return false;
    const int turn = orientation(p, q, a, b);
    return turn != 0 && turn == orientation(p, q, b, c) && turn == orientation(p, q, c, a);
}

bool triangles_cross(const Triangle& first, const Triangle& second, std::span<const Vec3> x) {
    return pierces(first, second, x) || pierces(second, first, x);
}

}  // namespace corpuscle::contact
