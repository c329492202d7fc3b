// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>

#include "solver/base/simd.hpp"

/// Several elements at once: kernels are written for a number type `Real`, which is `double` for
/// one element (tests, set-up) and `Lanes` for as many as the processor takes in one instruction.
namespace corpuscle::fabric {

/// Numbers in a Real, and one of them.
template <class Real>
inline constexpr int WIDTH = 1;
template <>
inline constexpr int WIDTH<Lanes> = LANES;
inline double get_lane(double a, int /*lane*/) {
    return a;
}
inline double get_lane(const Lanes& a, int lane) {
    return a[lane];
}
inline void set_lane(double& a, int /*lane*/, double value) {
    a = value;
}
inline void set_lane(Lanes& a, int lane, double value) {
    a[lane] = value;
}

inline Lanes load_lanes(const double* from) {
    Lanes out;
    std::memcpy(&out, from, sizeof(out));
    return out;
}
inline void store(double* to, const Lanes& a) {
    std::memcpy(to, &a, sizeof(a));
}

inline double square_root(double a) {
    return std::sqrt(a);
}
inline Lanes square_root(const Lanes& a) {
    Lanes out;
    for (int l = 0; l < LANES; ++l) out[l] = std::sqrt(a[l]);
    return out;
}

/// yes where `when` holds, no elsewhere; a comparison with NaN does not hold.
inline double select(bool when, double yes, double no) {
    return when ? yes : no;
}
inline Lanes select(const LaneMask& when, const Lanes& yes, const Lanes& no) {
    return when ? yes : no;
}

inline bool any(bool a) {
    return a;
}
inline bool any(const LaneMask& a) {
    bool out = false;
    for (int l = 0; l < LANES; ++l) out |= a[l] != 0;
    return out;
}

template <class Real>
Real greater(const Real& a, const Real& b) {
    return select(a > b, a, b);
}
template <class Real>
Real magnitude(const Real& a) {
    return select(a < Real{}, -a, a);
}

inline double sum_of(double a) {
    return a;
}
inline double sum_of(const Lanes& a) {
    double out = 0.0;
    for (int l = 0; l < LANES; ++l) out += a[l];
    return out;
}

/// A vector in space.
template <class Real>
struct Vector {
    Real x{}, y{}, z{};

    friend Vector operator+(const Vector& a, const Vector& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    friend Vector operator-(const Vector& a, const Vector& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    friend Vector operator*(const Real& s, const Vector& a) { return {s * a.x, s * a.y, s * a.z}; }
    Vector& operator+=(const Vector& b) { return *this = *this + b; }
};
template <class Real>
Real dot(const Vector<Real>& a, const Vector<Real>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace corpuscle::fabric
