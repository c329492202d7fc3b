// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// First steps of cloth with initial strain: short, each longer than the last.
///
/// A stable step still has an energy error. From x_0 to x_1 the forces f = -dW/dx do the work
/// (f_0 + f_1)·(x_1 - x_0)/2, but the strain energy changes by W_1 - W_0:
///
///     e = W_1 - W_0 + (f_0 + f_1)·(x_1 - x_0)/2 = -W''' (x_1 - x_0)³/12 + ...
///
/// Zero for linear elements; alternating in cloth that oscillates about its rest. Folds compressed
/// to half of their length release their energy within some ten stable steps and lose part of it:
/// 2 % in steps of 0.7 of the stable one. Steps that start at FIRST and grow by RISE release it at
/// less strain a step. They grow once and never shrink with strain again: steps that follow the
/// oscillation of cloth add energy to it.
class StrainedStart {
public:
    /// Strain of an edge up to which cloth begins unstrained: the first step's error is at most
    /// LITTLE/2 of what so little strain holds.                                              [-]
    static constexpr double LITTLE = 0.01;
    /// First step, of the stable one.                                                         [-]
    static constexpr double FIRST = 0.125;
    /// Each next step: 43 from FIRST to a whole one, in the time of 18 whole ones.            [-]
    static constexpr double RISE = 1.05;

    /// The longest step that may come; infinite for cloth that began unstrained.              [s]
    [[nodiscard]] double longest() const { return longest_; }

    /// Cloth is strained, and has not yet moved.
    /// @param stable  the longest step that is stable                                        [s]
    void begin(double stable) { longest_ = std::min(longest_, FIRST * stable); }
    /// A step was made.
    void advance() { longest_ *= RISE; }

    /// All of it, for a checkpoint.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(longest_);
    }

private:
    double longest_ = INF;  ///< [s]
};

}  // namespace corpuscle
