// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace corpuscle::verify {

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

/// An estimate that takes all n samples at once, with its interval by the jackknife:
///     s² = (n - 1) / n · sum (of(k) - mean of(k))²,   of(k) without sample k   [Tukey 1958]
/// @param of  of(k) for k < n leaves sample k out, of(n) none
[[nodiscard]] Estimate jackknife(std::size_t n, const std::function<double(std::size_t)>& of);

/// k of |error| = C size^-k by least squares in logarithms; NaN for less than two sizes, or where
/// an error is 0 or not a number.
[[nodiscard]] double fitted_order(std::span<const double> sizes, std::span<const double> errors);

/// Kolmogorov and Smirnov's sqrt(n) D, where D is the largest gap between the samples'
/// distribution and `below(x)`, the share that ought to be below x. Where both agree it is above
/// 1.63 in one case of a hundred.
[[nodiscard]] double kolmogorov_smirnov(std::vector<double> samples,
                                        const std::function<double(double)>& below);

/// Share of Maxwell's speeds below `speed`, a = sqrt(R T / M):
///     erf(s / sqrt 2) - sqrt(2 / pi) s exp(-s^2 / 2),   s = speed / a
[[nodiscard]] double maxwell_below(double speed, double a);

}  // namespace corpuscle::verify
