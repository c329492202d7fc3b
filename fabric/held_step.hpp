// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// A stable step that stays as it is for a while: it falls at once when it must, and rises only
/// after HELD steps, to the least of what they allowed.
///
/// Of a mode near its limit, leapfrog keeps v²/2 + ω²x²/2·(1 - (ω dt/2)²): a step that follows
/// every breath of the stretch pumps energy into it. A crumpled film that takes compression grew a
/// thousandfold in 10 000 steps at 0.9 of a step that followed; at 0.9 of one that is held, by less
/// than half.
class HeldStep {
public:
    static constexpr int HELD = 1000;  ///< 200 do as well as 3000 on crumpled films

    HeldStep() = default;
    /// @param dt     the step held at first                                                   [s]
    /// @param shell  row of the shell that it is of, -1: of none
    HeldStep(double dt, Index shell) : dt_(dt), shell_(shell) {}

    /// Takes what the present state allows, and which shell says so.
    void take(double dt, Index shell) {
        if (dt < recent_) {
            recent_ = dt;
            recent_shell_ = shell;
        }
        const bool falls = dt < dt_;
        if (!falls && ++count_ < HELD) return;
        dt_ = recent_;
        shell_ = recent_shell_;
        recent_ = falls ? dt : INF;
        count_ = 0;
    }

    [[nodiscard]] double dt() const { return dt_; }       ///< the step held now  [s]
    [[nodiscard]] Index shell() const { return shell_; }  ///< -1: nothing limits it

    /// All of it, for a checkpoint.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(dt_);
        archive(shell_);
        archive(recent_);
        archive(recent_shell_);
        archive(count_);
    }

private:
    double dt_ = INF;
    Index shell_ = -1;
    double recent_ = INF;  ///< least since the step last changed
    Index recent_shell_ = -1;
    int count_ = 0;
};

}  // namespace corpuscle::fabric
