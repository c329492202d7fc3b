// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/free_rotation.hpp"

namespace corpuscle {
namespace {

constexpr double LINE = 1e-9;  ///< of the greatest moment; coordinates of six digits leave 1e-12

std::optional<Eigen::Quaterniond> by_sweeps(const Vec3& moments, const Vec3& momentum, double dt) {
    constexpr int MOST_SWEEPS = 50;
    constexpr double CONVERGED = 1e-15, ROUNDING = 1e-12;
    Vec3 W = spin_by(moments, momentum);
    Eigen::Quaterniond step;
    double change = 0.0;
    for (int sweep = 0; sweep < MOST_SWEEPS; ++sweep) {
        const Vec3 half = 0.5 * dt * W;
        step = Eigen::Quaterniond(1.0, half[0], half[1], half[2]).normalized();
        const Vec3 then = step.conjugate() * momentum;
        const Vec3 better = spin_by(moments, 0.5 * (momentum + then));
        change = (better - W).norm();
        W = better;
        if (change <= CONVERGED * W.norm()) break;
    }
    if (change <= ROUNDING * W.norm()) return step;
    return {};
}

}  // namespace

Vec3 principal_moments(const Vec3& eigenvalues) {
    const double least = LINE * eigenvalues.maxCoeff();
    return (eigenvalues.array() > least).select(eigenvalues, 0.0);
}

std::optional<Eigen::Quaterniond> free_turn(const Vec3& moments, const Vec3& momentum, double dt) {
    constexpr int MOST_PARTS = 1024;
    for (int parts = 1; parts <= MOST_PARTS; parts *= 2) {
        std::optional<Eigen::Quaterniond> turn = Eigen::Quaterniond::Identity();
        for (int part = 0; part < parts && turn; ++part) {
            const auto step = by_sweeps(moments, turn->conjugate() * momentum, dt / parts);
            turn = step ? std::optional(parts == 1 ? *step : (*turn * *step).normalized())
                        : std::nullopt;
        }
        if (turn) return turn;
    }
    return {};
}

}  // namespace corpuscle
