// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// Impulses that each of some things has got since the start, at the half steps around t: a hit of
/// one step is in it, whenever the results are sampled.
class ImpulseBook {
public:
    ImpulseBook() = default;
    /// @param count  of the things, each without an impulse at first
    explicit ImpulseBook(std::size_t count)
        : before_(count, Vec3::Zero()), after_(count, Vec3::Zero()) {}

    /// Things.
    [[nodiscard]] std::size_t size() const { return after_.size(); }

    /// The next kick begins where the last ended.
    void commit() { before_ = after_; }
    /// In the kick at t.                                                                  [N s]
    void give(std::size_t i, const Vec3& impulse) { after_[i] += impulse; }

    /// Up to t, between the half steps as velocities are: m v(t) changes by just that.
    /// @param weight  of the half step after t, Clock::weight()                            [-]
    [[nodiscard]] Vec3 given(std::size_t i, double weight) const {
        return before_[i] + weight * (after_[i] - before_[i]);
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(before_, after_);
    }

private:
    Points before_, after_;  ///< half steps t - dt_last/2, t + dt/2                      [N s]
};

}  // namespace corpuscle
