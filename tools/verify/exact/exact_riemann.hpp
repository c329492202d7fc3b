// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/verify/exact/euler_1d.hpp"

namespace corpuscle::oracle {

/// Exact solution of the Riemann problem of an ideal gas, no vacuum            [Toro, ch. 4].
///
/// @param speed  x / t, where the jump lies at x = 0 at t = 0                           [m/s]
Gas1D exact_riemann(double gamma, const Gas1D& left, const Gas1D& right, double speed);

}  // namespace corpuscle::oracle
