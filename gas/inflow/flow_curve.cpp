// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/flow_curve.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace corpuscle::gas {

FlowCurve::FlowCurve(const Curve& rate, double end) {
    assert(!rate.empty());
    const double from = std::max(0.0, rate.x.front());
    const double to = std::max(from, std::min(end, rate.x.back()));
    const auto corner = [this](double t, double y) {
        const double sum =
            t_.empty() ? 0.0 : sum_.back() + 0.5 * (rate_.back() + y) * (t - t_.back());
        t_.push_back(t);
        rate_.push_back(y);
        sum_.push_back(sum);
    };
    corner(from, rate(from));
    for (std::size_t i = 0; i < rate.x.size(); ++i)
        if (rate.x[i] >= from && rate.x[i] <= to) corner(rate.x[i], rate.y[i]);
    if (t_.back() < to) corner(to, rate(to));
}

double FlowCurve::sum_until(double t) const {
    if (t <= t_.front()) return 0.0;
    if (t >= t_.back()) return sum_.back();
    const auto i = static_cast<std::size_t>(std::upper_bound(t_.begin(), t_.end(), t) - t_.begin());
    const double dt = t - t_[i - 1];
    const double slope = (rate_[i] - rate_[i - 1]) / (t_[i] - t_[i - 1]);
    return sum_[i - 1] + dt * (rate_[i - 1] + 0.5 * slope * dt);
}

double FlowCurve::time_of(double amount) const {
    assert(amount > 0.0 && amount <= sum_.back());
    const auto i =
        static_cast<std::size_t>(std::lower_bound(sum_.begin(), sum_.end(), amount) - sum_.begin());
    const double wanted = amount - sum_[i - 1];
    const double span = t_[i] - t_[i - 1];
    const double slope = (rate_[i] - rate_[i - 1]) / span;
    // rate dt + slope dt²/2 = wanted, in the form that a vanishing slope leaves well conditioned.
    // The square is that of the rate at the end: rounding must not make it negative where that is
    // 0.
    const double rate_1 =
        std::sqrt(std::max(0.0, rate_[i - 1] * rate_[i - 1] + 2.0 * slope * wanted));
    return t_[i - 1] + std::min(span, 2.0 * wanted / (rate_[i - 1] + rate_1));
}

}  // namespace corpuscle::gas
