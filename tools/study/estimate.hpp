// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>

namespace corpuscle::study {

/// A value that chance has a part in, with half the width of its 95 % interval; NaN: unknown.
struct Estimate {
    double value, half_width;
};

/// Student's t that |t| stays below in 95 of 100 cases.
///
/// Tables to 10 degrees of freedom, beyond by Cornish and Fisher's expansion [Abramowitz and
/// Stegun, 26.7.5], exact to 1e-4 there.
[[nodiscard]] double student_95(std::size_t degrees_of_freedom);

/// Mean of independent samples, and t s / sqrt(n); the width of one sample is not known.
[[nodiscard]] Estimate mean_of(std::span<const double> samples);

}  // namespace corpuscle::study
