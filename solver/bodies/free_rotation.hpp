// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <optional>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// Principal moments of inertia, of a body or of what is a straight line: masses that are off it by
/// less than some 3e-5 of its length have no moment about it, 0 here. Nothing turns a line about
/// itself, and none of its places knows.                                                [kg m^2]
[[nodiscard]] Vec3 principal_moments(const Vec3& eigenvalues);

/// Spin by an angular momentum in the axes of the moments; none about a line.            [rad/s]
/// @param moments   principal_moments()                                                 [kg m^2]
/// @param momentum  [kg m^2/s]
[[nodiscard]] inline Vec3 spin_by(const Vec3& moments, const Vec3& momentum) {
    Vec3 spin;
    for (int k = 0; k < 3; ++k) spin[k] = moments[k] > 0.0 ? momentum[k] / moments[k] : 0.0;
    return spin;
}

/// Turn of a body that nothing acts on, in its axes of before, by the implicit midpoint rule
/// [Simo & Wong 1991]
///
///     W = I⁻¹ (L + Cᵀ L) / 2,   C = cay(dt W)
///
/// W by fixed-point sweeps, each of which gains a factor of some dt |W| √(I_max / I_min) / 2; in as
/// many equal parts of dt, a power of two, as sweeps need to converge.
/// @param moments   principal_moments()                                                 [kg m^2]
/// @param momentum  L in the body's axes of before                                    [kg m^2/s]
/// @param dt        [s]
/// @return nothing where a thousand parts are not enough
[[nodiscard]] std::optional<Eigen::Quaterniond> free_turn(const Vec3& moments, const Vec3& momentum,
                                                          double dt);

}  // namespace corpuscle
