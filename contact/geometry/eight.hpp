// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "solver/base/shuffle.hpp"

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace corpuscle::contact {

/// Eight numbers in single precision that one instruction takes at once, where the processor can.
using Eight = float __attribute__((vector_size(32)));
using EightBits = std::int32_t __attribute__((vector_size(32)));  ///< of a comparison: all or none

inline constexpr int EIGHT = 8;

inline Eight all_eight(float a) {
    return Eight{a, a, a, a, a, a, a, a};
}

/// Bit l: comparison l holds.
inline unsigned bits_of(const EightBits& is) {
#ifdef __AVX__
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(is)));
#else
    unsigned bits = 0;
    for (int l = 0; l < EIGHT; ++l) bits |= is[l] != 0 ? 1U << l : 0U;
    return bits;
#endif
}

inline Eight least_of(const Eight& a, const Eight& b) {
    return a < b ? a : b;
}
inline Eight greatest_of(const Eight& a, const Eight& b) {
    return a > b ? a : b;
}

/// Lanes whose bits are set.
inline EightBits lanes_of(unsigned bits) {
    const auto b = static_cast<std::int32_t>(bits);
    return (EightBits{b, b, b, b, b, b, b, b} & EightBits{1, 2, 4, 8, 16, 32, 64, 128}) != 0;
}

/// The least of the eight.
inline float least_lane(const Eight& a) {
    const Eight four = least_of(a, shuffled(a, EightBits{4, 5, 6, 7, 0, 1, 2, 3}));
    const Eight two = least_of(four, shuffled(four, EightBits{2, 3, 0, 1, 6, 7, 4, 5}));
    return std::min(two[0], two[1]);
}

inline Eight roots_of(const Eight& a) {
#ifdef __AVX__
    return _mm256_sqrt_ps(a);
#else
    Eight out;
    for (int l = 0; l < EIGHT; ++l) out[l] = std::sqrt(a[l]);
    return out;
#endif
}

/// A number between 0 and 1; NaN becomes 0.
inline Eight share_of(const Eight& a) {
    const Eight positive = a > 0.0F ? a : all_eight(0.0F);
    return positive < 1.0F ? positive : all_eight(1.0F);
}

/// A point eight times over.
using EightPoints = std::array<Eight, 3>;

inline EightPoints operator-(const EightPoints& a, const EightPoints& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline EightPoints operator+(const EightPoints& a, const EightPoints& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline EightPoints operator*(const Eight& a, const EightPoints& b) {
    return {a * b[0], a * b[1], a * b[2]};
}
inline Eight dot(const EightPoints& a, const EightPoints& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// One point eight times over.
inline EightPoints all_eight(const std::array<float, 3>& p) {
    return {all_eight(p[0]), all_eight(p[1]), all_eight(p[2])};
}

}  // namespace corpuscle::contact
