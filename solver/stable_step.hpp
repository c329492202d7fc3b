// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// How long the next step may be, and who says so.
struct StepLimit {
    /// What sets the step.
    enum class Who {
        NOTHING,  ///< no fabric and no gas: a share of the run
        SHELL,    ///< fabric, `id` is a shell's
        STRAIN,   ///< fabric that lets go of a great strain
        GAS,      ///< gas, `id` is a bag's
        START,    ///< DTINIT, in the first step
        END       ///< the end of the run
    };

    double dt = INF;         ///< of the next step, INF: no limit  [s]
    Who who = Who::NOTHING;  ///< the one that allows least
    int id = 0;              ///< shell or bag id

    /// Keeps the shorter of the two.
    void tighten(double other, Who whose, int whose_id) {
        if (other < dt) *this = {other, whose, whose_id};
    }
    /// For people: "shell 17", "gas of bag 1", "end time", ...
    [[nodiscard]] std::string text() const;
};

}  // namespace corpuscle
