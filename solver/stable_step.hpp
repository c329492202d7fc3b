// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// Longest next step, and its limiter.
struct StepLimit {
    /// What sets the step.
    enum class Who {
        NOTHING,  ///< no fabric and no gas: a share of the run
        SHELL,    ///< fabric, `id` is a shell's
        STRAIN,   ///< release of the fabric's initial strain
        GAS,      ///< gas, `id` is a bag's
        JOINT,    ///< springs and dampers of a joint, `id` is its JSID
        START,    ///< DTINIT, in the first step
        END       ///< the end of the run
    };

    double dt = INF;         ///< of the next step, INF: no limit  [s]
    Who who = Who::NOTHING;  ///< the limiter
    int id = 0;              ///< of shell, bag or joint stiffness

    /// Keeps the shorter of the two.
    void tighten(double other, Who whose, int whose_id) {
        if (other < dt) *this = {other, whose, whose_id};
    }
    /// For people: "shell 17", "gas of bag 1", "end time", ...
    [[nodiscard]] std::string text() const;
};

/// Step of a gas with the step g of its collisions, beside cloth with the stable step f: a cloth's
/// step slightly above g is used, a much longer one is reduced towards g,
///
///     f                      f <= q g,      q = 3/2
///     max(g, (q g)² / f)     else                                                                 [s]
///
/// so from g to q g, continuous in both. Particles cross 3/16 of a cell in q g: errors of Sod's tube
/// are 7 % above those at an eighth.
/// @param gas    [s]; INF: none
/// @param cloth  [s]; INF: none
[[nodiscard]] inline double step_beside(double gas, double cloth) {
    const double most = 1.5 * gas;
    return cloth <= most ? cloth : std::max(gas, most / cloth * most);
}

}  // namespace corpuscle
