// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/responses/criteria.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace corpuscle::io {
namespace {

/// Time that the broken line spends at or above the level: in all, or in its longest stretch.
double time_above(std::span<const double> a, double dt, double level, Clip how) {
    double now = 0.0, most = 0.0;
    for (std::size_t k = 1; k < a.size(); ++k) {
        const double p = a[k - 1] - level, q = a[k] - level;
        if (p >= 0.0 && q >= 0.0) {
            now += dt;
        } else if (p < 0.0 && q < 0.0) {
            if (how == Clip::CONTIGUOUS) now = 0.0;
        } else {
            const double share = std::max(p, q) / std::abs(p - q);
            if (how == Clip::CONTIGUOUS && p < 0.0) now = 0.0;
            now += share * dt;
            most = std::max(most, now);
            if (how == Clip::CONTIGUOUS && q < 0.0) now = 0.0;
        }
        most = std::max(most, now);
    }
    return most;
}

}  // namespace

HeadInjury head_injury(std::span<const double> a, double dt, double longest) {
    HeadInjury worst;
    if (a.size() < 2) return worst;
    std::vector<double> sum(a.size(), 0.0);  // ∫ a dt                          [g s]
    for (std::size_t k = 1; k < a.size(); ++k) sum[k] = sum[k - 1] + 0.5 * dt * (a[k - 1] + a[k]);
    const auto reach = static_cast<std::size_t>(longest / dt + 1e-6);
    for (std::size_t i = 0; i + 1 < a.size(); ++i)
        for (std::size_t j = i + 1; j < std::min(a.size(), i + reach + 1); ++j) {
            const double span = static_cast<double>(j - i) * dt;
            const double mean = (sum[j] - sum[i]) / span;
            const double value = span * mean * mean * std::sqrt(mean);
            if (value > worst.value)
                worst = {value, static_cast<double>(i) * dt, static_cast<double>(j) * dt};
        }
    return worst;
}

double clip(std::span<const double> a, double dt, double duration, Clip how) {
    if (a.size() < 2 || static_cast<double>(a.size() - 1) * dt < duration * (1.0 - 1e-12))
        return 0.0;
    double low = 0.0, high = *std::max_element(a.begin(), a.end());
    for (int bisection = 0; bisection < 60; ++bisection) {
        const double level = 0.5 * (low + high);
        const bool lasts = time_above(a, dt, level, how) >= duration * (1.0 - 1e-12);
        (lasts ? low : high) = level;
    }
    return low;
}

}  // namespace corpuscle::io
