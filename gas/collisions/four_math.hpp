// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <numbers>

#include "solver/base/simd.hpp"

/// Four groups of particles at once: functions and 3 × 3 matrices, one a lane.
namespace corpuscle::gas {

/// Cube root of positive numbers, to 4e-16: a third of the exponent, then three steps of Halley.
/// Cost: 3 div.
inline Four cbrt(const Four& a) {
    Four y;
    for (int l = 0; l < FOUR; ++l) {
        std::uint64_t bits;
        const double from = a[l];
        std::memcpy(&bits, &from, sizeof(bits));
        bits = bits / 3 + 0x2A9F'7893'0000'0000ULL;
        double to;
        std::memcpy(&to, &bits, sizeof(to));
        y[l] = to;
    }
    for (int i = 0; i < 3; ++i) {
        const Four cube = y * y * y;
        y *= (cube + 2.0 * a) / (2.0 * cube + a);
    }
    return y;
}

/// Sine and cosine of 2 pi u, 0 <= u <= 1, to 3e-16: Taylor's series within an eighth of a turn.
struct SineCosine {
    Four sine, cosine;
};
inline SineCosine turn(const Four& u) {
    const Four quarters = 4.0 * u + 0.5;
    using FourInts = std::int32_t __attribute__((vector_size(16)));
    const auto nearest = __builtin_convertvector(quarters, FourInts);
    const auto quarter = __builtin_convertvector(nearest, FourBits);
    const Four r = (0.5 * std::numbers::pi) * (4.0 * u - __builtin_convertvector(nearest, Four));
    const Four square = r * r;
    const auto series = [&](const std::array<double, 8>& factor) {
        Four sum = all_four(1.0);
        for (const double f : factor) sum = 1.0 - sum * square * f;
        return sum;
    };
    constexpr auto per = [](int i) { return 1.0 / (i * (i + 1.0)); };
    const Four s = r * series({per(16), per(14), per(12), per(10), per(8), per(6), per(4), per(2)});
    const Four c = series({per(15), per(13), per(11), per(9), per(7), per(5), per(3), per(1)});
    const FourBits is_odd = (quarter & 1) == 1, is_left = ((quarter + 1) & 2) == 2,
                   is_low = (quarter & 2) == 2;
    const Four sine = is_odd ? c : s, cosine = is_odd ? s : c;
    return {is_low ? -sine : sine, is_left ? -cosine : cosine};
}

/// A 3 × 3 matrix a lane.
struct Four33 {
    std::array<std::array<Four, 3>, 3> at{};
    Four& operator()(int i, int j) { return at[i][j]; }
    const Four& operator()(int i, int j) const { return at[i][j]; }
};

inline Four33 product(const Four33& a, const Four33& b) {
    Four33 c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            c(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
    return c;
}

/// a bᵀ
inline Four33 product_transposed(const Four33& a, const Four33& b) {
    Four33 c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            c(i, j) = a(i, 0) * b(j, 0) + a(i, 1) * b(j, 1) + a(i, 2) * b(j, 2);
    return c;
}

inline Four trace(const Four33& a) {
    return a(0, 0) + a(1, 1) + a(2, 2);
}

/// Lower triangle L with L Lᵀ = P, from P's lower triangle. `is_good`: where all pivots are above
/// `least`; elsewhere L means nothing. Cost: 3 sqrt, 3 div.
struct Factor {
    Four33 L;
    FourBits is_good;
};
inline Factor lower_factor(const Four33& P, const Four& least) {
    Factor out{{}, FourBits{-1, -1, -1, -1}};
    Four33& L = out.L;
    for (int j = 0; j < 3; ++j) {
        Four pivot = P(j, j);
        for (int k = 0; k < j; ++k) pivot -= L(j, k) * L(j, k);
        out.is_good &= pivot > least;
        L(j, j) = roots_of(pivot);
        const Four per_pivot = 1.0 / L(j, j);
        for (int i = j + 1; i < 3; ++i) {
            Four sum = P(i, j);
            for (int k = 0; k < j; ++k) sum -= L(i, k) * L(j, k);
            L(i, j) = sum * per_pivot;
        }
    }
    return out;
}

/// Inverse of a lower triangle. Cost: 3 div.
inline Four33 inverse_of(const Four33& L) {
    Four33 out;
    for (int i = 0; i < 3; ++i) out(i, i) = 1.0 / L(i, i);
    out(1, 0) = -L(1, 0) * out(0, 0) * out(1, 1);
    out(2, 1) = -L(2, 1) * out(1, 1) * out(2, 2);
    out(2, 0) = -(L(2, 0) * out(0, 0) + L(2, 1) * out(1, 0)) * out(2, 2);
    return out;
}

}  // namespace corpuscle::gas
