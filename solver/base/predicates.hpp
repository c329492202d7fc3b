// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "solver/base/vec.hpp"

/// Signs that are right for every input, however nearly degenerate.
namespace corpuscle {

namespace exact {

/// Sum of doubles held without rounding: non-overlapping parts, smallest first [Shewchuk 1997, Fig.
/// 6].
template <int CAPACITY>
class Expansion {
public:
    /// Adds b, exactly.
    void add(double b) {
        double carry = b;
        int kept = 0;
        for (int i = 0; i < size_; ++i) {
            const double sum = carry + part_[i];
            const double virtual_part = sum - carry;
            const double rest = (carry - (sum - virtual_part)) + (part_[i] - virtual_part);
            if (rest != 0.0) part_[kept++] = rest;
            carry = sum;
        }
        if (carry != 0.0) part_[kept++] = carry;
        size_ = kept;
    }
    /// Adds a·b, exactly (barring underflow).
    void add_product(double a, double b) {
        const double high = a * b;
        add(std::fma(a, b, -high));
        add(high);
    }
    /// Adds a·b·c, exactly (barring underflow).
    void add_product(double a, double b, double c) {
        const double high = a * b;
        add_product(std::fma(a, b, -high), c);
        add_product(high, c);
    }
    [[nodiscard]] int sign() const { return size_ == 0 ? 0 : (part_[size_ - 1] > 0.0 ? 1 : -1); }

private:
    std::array<double, CAPACITY> part_{};
    int size_ = 0;
};

}  // namespace exact

/// Determinant |a b c| = a · (b × c), and its exact sign.
struct Determinant {
    double value;  ///< rounded
    int sign;      ///< of the exact determinant of the given doubles: -1, 0, +1
};

/// Floating point first; exact arithmetic only where rounding could have turned the sign.
inline Determinant determinant(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double yz = b.y() * c.z(), zy = b.z() * c.y();
    const double zx = b.z() * c.x(), xz = b.x() * c.z();
    const double xy = b.x() * c.y(), yx = b.y() * c.x();
    const double value = a.x() * (yz - zy) + a.y() * (zx - xz) + a.z() * (xy - yx);
    const double size = std::abs(a.x()) * (std::abs(yz) + std::abs(zy)) +
                        std::abs(a.y()) * (std::abs(zx) + std::abs(xz)) +
                        std::abs(a.z()) * (std::abs(xy) + std::abs(yx));
    constexpr double ROUNDING = 8.9e-16;  // (7 + 56 eps) eps, eps = 2^-53 [Shewchuk 1997, Eq. 13]
    if (value > ROUNDING * size) return {value, 1};
    if (-value > ROUNDING * size) return {value, -1};

    exact::Expansion<32> sum;
    sum.add_product(b.y(), c.z(), a.x());
    sum.add_product(-b.z(), c.y(), a.x());
    sum.add_product(b.z(), c.x(), a.y());
    sum.add_product(-b.x(), c.z(), a.y());
    sum.add_product(b.x(), c.y(), a.z());
    sum.add_product(-b.y(), c.x(), a.z());
    return {value, sum.sign()};
}

}  // namespace corpuscle
