// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace corpuscle::contact {

/// Four numbers that one instruction takes at once, where the processor can.
using Four = double __attribute__((vector_size(32)));
using FourBits = std::int64_t __attribute__((vector_size(32)));  ///< of a comparison: all or none

inline constexpr std::size_t FOUR = 4;

/// Bit l: comparison l holds.
inline unsigned bits_of(const FourBits& is) {
#ifdef __AVX__
    return static_cast<unsigned>(_mm256_movemask_pd(reinterpret_cast<__m256d>(is)));
#else
    unsigned bits = 0;
    for (std::size_t l = 0; l < FOUR; ++l) bits |= is[l] != 0 ? 1U << l : 0U;
    return bits;
#endif
}

inline Four roots_of(const Four& a) {
#ifdef __AVX__
    return _mm256_sqrt_pd(a);
#else
    return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

/// A number between 0 and 1; NaN becomes 0.
inline Four share_of(const Four& a) {
    const Four zero{}, one = zero + 1.0;
    const Four positive = a > zero ? a : zero;
    return positive < one ? positive : one;
}

/// Four points or vectors.
using FourPoints = std::array<Four, 3>;

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

}  // namespace corpuscle::contact
