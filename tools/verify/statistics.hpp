// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "tools/study/estimate.hpp"

namespace corpuscle::verify {

using study::Estimate;
using study::mean_of;
using study::student_95;

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
