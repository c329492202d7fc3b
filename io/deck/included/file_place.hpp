// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// Where a file's scene lies in the deck's: x' = L x + t for places, and for directions the nearest
/// rotation or reflection R of L = R S, which neither stretches nor shears.
class FilePlace {
public:
    FilePlace() = default;  ///< as written
    FilePlace(const Mat3& linear, const Vec3& shift);

    [[nodiscard]] bool moves() const { return moves_; }  ///< is anything not where it is written?
    [[nodiscard]] bool turns() const { return turns_; }  ///< is R not 1?
    [[nodiscard]] bool mirrors() const { return mirrors_; }
    [[nodiscard]] bool stretches() const { return stretches_; }
    [[nodiscard]] const Mat3& linear() const { return linear_; }
    [[nodiscard]] const Mat3& turn() const { return turn_; }

    [[nodiscard]] Vec3 point(const Vec3& x) const {
        return moves_ ? Vec3(linear_ * x + shift_) : x;
    }
    [[nodiscard]] Vec3 written(const Vec3& x) const;  ///< the inverse of point()
    [[nodiscard]] Vec3 direction(const Vec3& v) const { return turns_ ? Vec3(turn_ * v) : v; }
    /// An angular velocity, or an axis that something turns about right-handed: det(R) R w.
    [[nodiscard]] Vec3 spin(const Vec3& w) const {
        return mirrors_ ? Vec3(-(turn_ * w)) : direction(w);
    }
    /// Corners of a facet, whose normal and first side are the images of the file's: a mirror
    /// exchanges 1 with 2 and 3 with 4. The diagonal 1-3 of a quad is then 2-4.
    [[nodiscard]] std::array<Index, 4> facet(std::array<Index, 4> corners) const {
        if (mirrors_) std::swap(corners[0], corners[1]), std::swap(corners[2], corners[3]);
        return corners;
    }
    /// Held axes, x y z and about x y z (bits 0 to 5), as the deck's; none: what is held lies along
    /// no axes of it.
    [[nodiscard]] std::optional<unsigned> held(unsigned axes) const;

private:
    [[nodiscard]] std::optional<unsigned> held_three(unsigned axes) const;

    Mat3 linear_ = Mat3::Identity(), turn_ = Mat3::Identity();
    Vec3 shift_ = Vec3::Zero();
    bool moves_ = false, turns_ = false, mirrors_ = false, stretches_ = false;
};

}  // namespace corpuscle::io
