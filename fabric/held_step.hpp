// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// A stable step that falls at once and rises only after HELD steps, to the least stable step of
/// these.
///
/// Near the limit leapfrog conserves v²/2 + ω²x²/2·(1 - (ω dt/2)²) of a mode: a step that follows
/// each oscillation of the stretch adds energy. The energy of a crumpled film with compressive
/// stiffness grows a thousandfold in 10 000 steps at 0.9 of a step that follows, by less than half
/// at 0.9 of a held one.
class HeldStep {
public:
    static constexpr int HELD = 1000;  ///< 200 to 3000 are equally good on crumpled films

    HeldStep() = default;
    /// @param dt     the step held at first                                                   [s]
    /// @param shell  row of the shell that it is of, -1: of none
    HeldStep(double dt, Index shell) : dt_(dt), shell_(shell) {}

    /// Takes the stable step of the present state, and the shell that sets it.
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

    /// State for a checkpoint.
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
