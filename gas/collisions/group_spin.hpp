// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Eigenvalues>

#include <cmath>

#include "gas/collisions/cell_sample.hpp"

namespace corpuscle::gas {

/// Rotation of a group that is too small, or too flat, for a whole velocity gradient: taken out of
/// c before a collision and after it, so that angular momentum is kept to rounding.
///
///     omega = I⁻¹ sum m dx × c,   I = sum m (dx² - dx dxᵀ)
///
/// On a line I has no inverse along it, at one point none at all: nothing turns there.
class GroupSpin {
public:
    explicit GroupSpin(const CellSample& sample) {
        const Mat3 S = sample.moment(sample.dx, sample.dx);
        const Eigen::SelfAdjointEigenSolver<Mat3> I(S.trace() * Mat3::Identity() - S);
        axes_ = I.eigenvectors();
        for (int k = 0; k < 3; ++k) {
            const bool turns = I.eigenvalues()[k] > FLATTEST * S.trace();
            per_inertia_[k] = turns ? 1.0 / I.eigenvalues()[k] : 0.0;
            freedom_ += turns ? 1.0 : 0.0;
        }
    }
    /// Directions about which the group can turn, 0 to 3.
    [[nodiscard]] double freedom() const { return freedom_; }

    /// Takes the rotation out of c and returns it as a velocity gradient.                   [1/s]
    Mat3 take_out(CellSample& sample) const {
        const Mat3 Q = sample.moment(sample.c, sample.dx);
        const Vec3 J(Q(2, 1) - Q(1, 2), Q(0, 2) - Q(2, 0), Q(1, 0) - Q(0, 1));
        const Mat3 G = gradient(axes_ * per_inertia_.cwiseProduct(axes_.transpose() * J));
        sample.add_gradient(-G);
        return G;
    }
    /// A rotation as thermal agitation makes it at kT: omega is normal with covariance kT I⁻¹.
    [[nodiscard]] Mat3 thermal(double kT, Random& draw) const {
        Vec3 omega;
        for (int k = 0; k < 3; ++k) omega[k] = std::sqrt(kT * per_inertia_[k]) * draw.normal();
        return gradient(axes_ * omega);
    }

private:
    static constexpr double FLATTEST = 1e-9;  ///< of the trace: smaller is rounding

    /// dx -> omega × dx
    static Mat3 gradient(const Vec3& omega) {
        Mat3 G;
        G << 0.0, -omega[2], omega[1], omega[2], 0.0, -omega[0], -omega[1], omega[0], 0.0;
        return G;
    }

    Mat3 axes_;
    Vec3 per_inertia_ = Vec3::Zero();
    double freedom_ = 0.0;
};

}  // namespace corpuscle::gas
