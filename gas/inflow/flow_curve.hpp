// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/base/curve.hpp"

namespace corpuscle::gas {

/// A flow that is piecewise linear in time, summed up from t = 0, and the way back: when has how
/// much come in. Nothing flows before the curve's first abscissa nor after its last.
class FlowCurve {
public:
    /// @param rate  flow over time, nowhere negative                                [kg/s]
    /// @param end   nothing counts after this time                                  [s]
    FlowCurve(const Curve& rate, double end);

    [[nodiscard]] double total() const { return sum_.back(); }  ///< all that comes in  [kg]
    [[nodiscard]] double begins() const { return t_.front(); }  ///< when flow may begin, >= 0  [s]
    [[nodiscard]] double ends() const { return t_.back(); }     ///< when it has ended  [s]

    /// Exact integral of the flow from 0 to t.                                      [kg]
    [[nodiscard]] double sum_until(double t) const;

    /// First instant at which `amount` has come in, 0 < amount <= total().          [s]
    [[nodiscard]] double time_of(double amount) const;

private:
    std::vector<double> t_, rate_;  ///< corners within 0..end
    std::vector<double> sum_;       ///< integral up to each corner
};

}  // namespace corpuscle::gas
