// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// The longest step with which repulsion still holds what is pressed.
///
/// Repulsion is as stiff as the step leaves room for, k ~ 1/dt², so what presses gets the deeper
/// the longer the step is. Where it gets through, the guard has to stop pairs at the last moment:
/// that is safe, but their motion is chance. So the step follows what the guard does,
///
///     d ln dt_most = GROWTH · (1 − stopped / (ALLOWED · touching))   a step,  −FASTEST at least
///
/// falls under a few hundred steps' worth of pressure and comes back after it. Without stopped
/// pairs there is no limit; the caller sets a floor.
class StepControl {
public:
    /// After a step of dt, in which `stopped` pairs or tangles were stopped last of `touching`
    /// contacts, one by `card`.
    void follow(double dt, std::size_t stopped, std::size_t touching, int card) {
        if (stopped > 0) {
            longest_ = std::min(longest_, dt);
            card_ = card;
        }
        if (longest_ == INF) return;
        const double allowed = ALLOWED * static_cast<double>(std::max(touching, FEW));
        const double change = GROWTH * (1.0 - static_cast<double>(stopped) / allowed);
        longest_ *= std::exp(std::max(change, -FASTEST));
        if (longest_ > FORGOTTEN * dt) longest_ = INF;
    }

    [[nodiscard]] double longest() const { return longest_; }  ///< INF: no limit              [s]
    [[nodiscard]] int card() const { return card_; }           ///< of a pair stopped last

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(longest_, card_);
    }

private:
    /// Part of the contacts that touch which may be stopped in a step.
    static constexpr double ALLOWED = 1.5e-4;
    /// Contacts below which they count as so many.
    static constexpr std::size_t FEW = 20'000;
    /// Change of the step in a step, at most: up, down.
    static constexpr double GROWTH = 0.002, FASTEST = 0.05;
    /// Over the step taken: where a limit no longer says anything.
    static constexpr double FORGOTTEN = 4.0;

    double longest_ = INF;
    int card_ = -1;
};

}  // namespace corpuscle::contact
