// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/included/file_place.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <cmath>

namespace corpuscle::io {

namespace {

constexpr double EXACT = 1e-12;      ///< rounding of products of rotations
constexpr double ALONG_AXIS = 1e-9;  ///< of the square of a cosine

}  // namespace

FilePlace::FilePlace(const Mat3& linear, const Vec3& shift) : linear_(linear), shift_(shift) {
    moves_ = linear != Mat3::Identity() || !shift.isZero(0.0);
    stretches_ = !(linear.transpose() * linear).isApprox(Mat3::Identity(), EXACT);
    turn_ = linear;
    if (stretches_) {
        const Eigen::JacobiSVD<Mat3> svd(linear, Eigen::ComputeFullU | Eigen::ComputeFullV);
        turn_ = svd.matrixU() * svd.matrixV().transpose();
        if (turn_.isApprox(Mat3::Identity(), EXACT)) turn_.setIdentity();
    }
    turns_ = turn_ != Mat3::Identity();
    mirrors_ = turn_.determinant() < 0.0;
}

Vec3 FilePlace::written(const Vec3& x) const {
    return moves_ ? Vec3(linear_.inverse() * (x - shift_)) : x;
}

/// Of the space that the turned axes span: the diagonal of its projector, sum of R e_i (R e_i)ᵀ, is
/// 1 for axes in it and 0 for those across.
std::optional<unsigned> FilePlace::held_three(unsigned axes) const {
    unsigned turned = 0;
    for (int j = 0; j < 3; ++j) {
        double share = 0.0;
        for (int i = 0; i < 3; ++i)
            if ((axes >> i & 1U) != 0) share += turn_(j, i) * turn_(j, i);
        if (std::abs(share - 1.0) <= ALONG_AXIS)
            turned |= 1U << j;
        else if (share > ALONG_AXIS)
            return {};
    }
    return turned;
}

std::optional<unsigned> FilePlace::held(unsigned axes) const {
    if (!turns_) return axes;
    const auto moves = held_three(axes & 7U), turns = held_three(axes >> 3U);
    if (!moves || !turns) return {};
    return *moves | *turns << 3U;
}

}  // namespace corpuscle::io
