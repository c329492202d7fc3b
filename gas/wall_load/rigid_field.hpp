// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>

#include "gas/wall_load/wrench.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// What points can bear, by their weights.
struct Lever {
    double weight = 0.0;
    Vec3 first = Vec3::Zero();   ///< moment of the weights, from an origin                   [m]
    Mat3 second = Mat3::Zero();  ///< likewise                                              [m^2]
    void add(double own, const Vec3& from_origin) {
        weight += own;
        first += own * from_origin;
        second += own * from_origin * from_origin.transpose();
    }
    Lever& operator+=(const Lever& o) {
        weight += o.weight;
        first += o.first;
        second += o.second;
        return *this;
    }
    Lever& operator*=(double factor) {
        weight *= factor;
        first *= factor;
        second *= factor;
        return *this;
    }
};

/// Impulses w_p (a + b × (x_p - c)) of points of weights w_p, c their centre: the least ones, by
/// sum |.|² / w_p, whose sum and moment about the origin are what is wanted,
///
///     a = J / sum w,   b = I^-1 (L - c × J),   I = sum w (|d|² 1 - d dᵀ),   d = x - c.
///
/// Points on a line have no moment about it: then b = 0, and what is missing is not in whole().
class RigidField {
public:
    /// Determinant of I over the cube of its trace, below which points lie on a line. More: stronger
    /// forces where they nearly do.                                                         [-]
    static constexpr double FLAT = 1e-3;

    /// @param origin  that the lever's moments are taken from                              [m]
    /// @param wanted  J [N s] and L [N m s]
    /// @param flat    where b is 0
    RigidField(const Lever& lever, const Vec3& origin, const Wrench& wanted, double flat = FLAT)
        : weight_(lever.weight) {
        const Vec3 from_origin = lever.first / lever.weight;
        centre_ = origin + from_origin;
        const Mat3 second = lever.second - lever.weight * from_origin * from_origin.transpose();
        inertia_ = second.trace() * Mat3::Identity() - second;
        const double size = inertia_.trace();
        const Mat3 shape = inertia_ / size;
        a_ = wanted.linear / lever.weight;
        if (size > 0.0 && shape.determinant() > flat)
            b_ = shape.inverse() * (wanted.angular - centre_.cross(wanted.linear)) / size;
    }
    /// Impulse by weight of a point at x.
    [[nodiscard]] Vec3 at(const Vec3& x) const { return a_ + b_.cross(x - centre_); }
    /// What all points get together.
    [[nodiscard]] Wrench whole() const {
        Wrench sum;
        sum.linear = weight_ * a_;
        sum.angular = centre_.cross(sum.linear) + inertia_ * b_;
        return sum;
    }

private:
    double weight_;
    Vec3 centre_, a_, b_ = Vec3::Zero();
    Mat3 inertia_;
};

}  // namespace corpuscle::gas
