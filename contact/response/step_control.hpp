// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// The longest step with which repulsion still holds what is pressed.
///
/// Repulsion is as stiff as the step leaves room for, k ~ 1/dt², so what presses gets the deeper
/// the longer the step is. Where it gets through, the guard has to stop pairs at the last moment:
/// that is safe, but their motion is chance. So each step in which pairs are stopped is followed by
/// shorter ones,
///
///     ln dt_most -= LOSS · stopped / touching,   MOST_LOST at most,
///
/// and after HOLD steps without such pairs they grow again, by GAIN a step. Not sooner: a pack
/// whose contacts become softer and stiffer again breathes, and hits what it lies against. A pair
/// that shorter steps have not freed after PATIENCE of them counts no longer: it lies at no
/// distance whatever the step, and the guard holds it. Without stopped pairs there is no limit; the
/// caller sets a floor.
class StepControl {
public:
    using Nodes = std::array<Index, 4>;  ///< of a pair

    /// After each step of dt.
    /// @param stopped   pairs that were stopped last, in any order, some more than once
    /// @param touching  contacts
    /// @param card      by which one of the stopped pairs touches
    void follow(double dt, std::vector<Nodes>& stopped, std::size_t touching, int card);

    [[nodiscard]] double longest() const { return longest_; }  ///< INF: no limit              [s]
    [[nodiscard]] std::int64_t card() const { return card_; }  ///< of a pair stopped last

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(held_, step_, lost_at_, longest_, card_);
    }

private:
    struct Held {
        Nodes nodes;
        std::uint64_t since, last;  ///< steps
    };
    std::size_t count_new(std::vector<Nodes>& stopped);

    std::vector<Held> held_;  ///< pairs stopped of late, by nodes
    std::uint64_t step_ = 0, lost_at_ = 0;
    double longest_ = INF;
    std::int64_t card_ = -1;
};

}  // namespace corpuscle::contact
