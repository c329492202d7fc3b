// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// How long the next step may be, and who says so.
struct StepLimit {
    enum class Who { NOTHING, SHELL, GAS, START, END };

    double dt = INF;  ///< [s]
    Who who = Who::NOTHING;
    int id = 0;  ///< shell or bag id

    /// Keeps the shorter of the two.
    void tighten(double other, Who whose, int whose_id) {
        if (other < dt) *this = {other, whose, whose_id};
    }
    [[nodiscard]] std::string text() const;
};

}  // namespace corpuscle
