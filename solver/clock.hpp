// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace corpuscle {

/// Time of the leapfrog: positions live at t, velocities at t - dt_last / 2.
struct Clock {
    double t = 0.0;        ///< where positions live  [s]
    double dt_last = 0.0;  ///< step that led to t; 0 at the start, where velocities live at t   [s]
    std::int64_t step = 0;  ///< steps made so far

    /// The span that a force at t acts for: half the last step and half the next.
    [[nodiscard]] double kick_span(double dt) const { return 0.5 * (dt_last + dt); }

    /// Weight of v(t + dt/2) in v(t), interpolated between the half steps; the start takes v(t -
    /// 0).
    [[nodiscard]] double weight(double dt) const { return dt_last / (dt_last + dt); }

    /// Ends the step from t to t + dt.
    void advance(double dt) {
        t += dt;
        dt_last = dt;
        ++step;
    }
};

}  // namespace corpuscle
