// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

namespace corpuscle::io {

/// A filter needs this many samples in 1/CFC seconds: with fewer, the bilinear transform moves its
/// -3 dB point by more than 1 %.
inline constexpr double SAMPLES_PER_CLASS = 25.0;

/// Channel frequency class filter: two-pole Butterworth, run forward and then backward, so without
/// delay.
///
///     w = tan(2 pi · CFC · 2.0775 · dt / 2)                              [SAE J211-1, App. C]
///     y_k = a0 x_k + a1 x_(k-1) + a2 x_(k-2) + b1 y_(k-1) + b2 y_(k-2)
///
/// The gain is -3 dB at CFC/0.6. The ends are continued point-symmetrically and the filter starts
/// settled, so a constant or a straight line passes as it is.
///
/// @param dt   between samples, uniform                               [s]
/// @param cfc  channel frequency class: 60, 180, 600, 1000            [Hz]
/// @throws InputError for fewer than SAMPLES_PER_CLASS samples in 1/cfc: it would be aliased
[[nodiscard]] std::vector<double> filtered(std::span<const double> samples, double dt, double cfc);

}  // namespace corpuscle::io
