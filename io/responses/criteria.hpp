// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

namespace corpuscle::io {

struct HeadInjury {
    double value = 0.0;             ///< [g^2.5 s]
    double begin = 0.0, end = 0.0;  ///< of its window, since the first sample       [s]
};

/// Head injury criterion.
///
///     HIC = max (t2 - t1) (1 / (t2 - t1) ∫ a dt)^2.5 over t1 < t2 <= t1 + longest   [49 CFR
///     571.208 S6.2]
///
/// by the trapezoidal rule, windows from sample to sample. Cost: samples × samples a window.
///
/// @param a        resultant acceleration, not negative       [g]
/// @param dt       between samples                            [s]
/// @param longest  window: 0.015 or 0.036                     [s]
[[nodiscard]] HeadInjury head_injury(std::span<const double> a, double dt, double longest);

/// The highest level that `a`, a broken line through its samples, reaches or exceeds for
/// `duration`; 0 where the record is shorter.
///
/// @param a  not negative
/// CUMULATIVE adds up all stretches above the level [49 CFR 571.208 S6.3: "cumulative duration"],
/// CONTIGUOUS wants one stretch.
enum class Clip { CUMULATIVE, CONTIGUOUS };
[[nodiscard]] double clip(std::span<const double> a, double dt, double duration, Clip how);

}  // namespace corpuscle::io
