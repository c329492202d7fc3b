// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

#ifdef __AVX__
#include <immintrin.h>
#endif

/// Several numbers in one instruction, by the vectors that GCC and clang have of their own: + - * /
/// < ? : work lane by lane, on every processor, with the same bits whatever the other lanes hold.
/// The only place that knows about instructions. Not for headers that users include.
///
///     Four   4 doubles    points in space, groups of particles
///     Eight  8 floats     boxes and bounds, where single precision does
///     Lanes  as many doubles as the processor takes at once: elements of the fabric
namespace corpuscle {

using Four = double __attribute__((vector_size(32)));
using FourBits = std::int64_t __attribute__((vector_size(32)));  ///< of a comparison: all or none
using Eight = float __attribute__((vector_size(32)));
using EightBits = std::int32_t __attribute__((vector_size(32)));  ///< of a comparison: all or none

inline constexpr int FOUR = 4, EIGHT = 8;

#if defined(__AVX512F__)
inline constexpr int LANES = 8;
#elif defined(__AVX__)
inline constexpr int LANES = 4;
#else
inline constexpr int LANES = 2;
#endif
using Lanes = double __attribute__((vector_size(LANES * sizeof(double))));
using LaneMask = decltype(Lanes{} < Lanes{});

/// out[l] = a[from[l]]; clang has it only for constants.
template <class Vector, class Lanes>
[[nodiscard]] inline Vector shuffled(const Vector& a, const Lanes& from) {
#ifdef __clang__
    Vector out = a;
    for (unsigned l = 0; l < sizeof(Vector) / sizeof(a[0]); ++l) out[l] = a[from[l]];
    return out;
#else
    return __builtin_shuffle(a, from);
#endif
}

inline Four all_four(double a) {
    return Four{a, a, a, a};
}
inline Eight all_eight(float a) {
    return Eight{a, a, a, a, a, a, a, a};
}

inline Four load_four(const double* from) {
    Four out;
    std::memcpy(&out, from, sizeof(out));
    return out;
}

inline Eight load_eight(const float* from) {
    Eight out;
    std::memcpy(&out, from, sizeof(out));
    return out;
}

/// Bit l: comparison l holds.
inline unsigned bits_of(const FourBits& is) {
#ifdef __AVX__
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(is)));
#else
    unsigned bits = 0;
    for (int l = 0; l < FOUR; ++l) bits |= is[l] != 0 ? 1U << l : 0U;
    return bits;
#endif
}
inline unsigned bits_of(const EightBits& is) {
#ifdef __AVX__
    return static_cast<unsigned>(_mm256_movemask_ps(reinterpret_cast<__m256>(is)));
#else
    unsigned bits = 0;
    for (int l = 0; l < EIGHT; ++l) bits |= is[l] != 0 ? 1U << l : 0U;
    return bits;
#endif
}

/// Lanes whose bits are set.
inline EightBits lanes_of(unsigned bits) {
    const auto b = static_cast<std::int32_t>(bits);
    return (EightBits{b, b, b, b, b, b, b, b} & EightBits{1, 2, 4, 8, 16, 32, 64, 128}) != 0;
}

inline Four roots_of(const Four& a) {
#ifdef __AVX__
    return _mm256_sqrt_pd(a);
#else
    return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
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

inline Four magnitude_of(const Four& a) {
    constexpr std::int64_t REST = INT64_MAX;  // all bits but the sign
    return reinterpret_cast<Four>(reinterpret_cast<const FourBits&>(a) &
                                  FourBits{REST, REST, REST, REST});
}

/// Lane by lane; the second where the two do not compare.
inline Eight least_of(const Eight& a, const Eight& b) {
    return a < b ? a : b;
}
inline Eight greatest_of(const Eight& a, const Eight& b) {
    return a > b ? a : b;
}

/// The least of the eight.
inline float least_lane(const Eight& a) {
    const Eight four = least_of(a, shuffled(a, EightBits{4, 5, 6, 7, 0, 1, 2, 3}));
    const Eight two = least_of(four, shuffled(four, EightBits{2, 3, 0, 1, 6, 7, 4, 5}));
    return std::min(two[0], two[1]);
}

/// A number between 0 and 1; NaN becomes 0.
inline Four share_of(const Four& a) {
    const Four zero{}, one = zero + 1.0;
    const Four positive = a > zero ? a : zero;
    return positive < one ? positive : one;
}
inline Eight share_of(const Eight& a) {
    const Eight positive = a > 0.0F ? a : all_eight(0.0F);
    return positive < 1.0F ? positive : all_eight(1.0F);
}

/// Points or vectors, one a lane.
using FourPoints = std::array<Four, 3>;
using EightPoints = std::array<Eight, 3>;

/// One point eight times over.
inline EightPoints all_eight(const std::array<float, 3>& p) {
    return {all_eight(p[0]), all_eight(p[1]), all_eight(p[2])};
}

/// Four points x y z x, y z x y, z x y z as columns.
inline FourPoints columns(const Four& a, const Four& b, const Four& c) {
    constexpr FourBits ONE{0, -1, 0, 0}, TWO{0, 0, -1, 0}, OUTER{-1, 0, 0, -1};
    return {shuffled(TWO   ? b
                     : ONE ? c
                           : a,
                     FourBits{0, 3, 2, 1}),
            shuffled(ONE   ? a
                     : TWO ? c
                           : b,
                     FourBits{1, 0, 3, 2}),
            shuffled(OUTER ? c
                     : ONE ? b
                           : a,
                     FourBits{2, 1, 0, 3})};
}

inline FourPoints operator-(const FourPoints& a, const FourPoints& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline FourPoints operator+(const FourPoints& a, const FourPoints& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline FourPoints operator*(const Four& a, const FourPoints& b) {
    return {a * b[0], a * b[1], a * b[2]};
}
inline Four dot(const FourPoints& a, const FourPoints& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
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

}  // namespace corpuscle
