// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/vec.hpp"

namespace corpuscle::verify {

Estimate jackknife(std::size_t n, const std::function<double(std::size_t)>& of) {
    const double all = of(n);
    if (n < 2) return {all, NaN};
    std::vector<double> without;
    for (std::size_t k = 0; k < n; ++k) without.push_back(of(k));
    const auto count = static_cast<double>(n);
    double mean = 0.0, squares = 0.0;
    for (const double x : without) mean += x / count;
    for (const double x : without) squares += (x - mean) * (x - mean);
    return {all, student_95(n - 1) * std::sqrt((count - 1.0) / count * squares)};
}

double fitted_order(std::span<const double> sizes, std::span<const double> errors) {
    const auto n = static_cast<double>(sizes.size());
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double a = std::log(sizes[i]), b = std::log(std::abs(errors[i]));
        if (!std::isfinite(a) || !std::isfinite(b)) return NaN;
        x += a / n;
        y += b / n;
        xx += a * a / n;
        xy += a * b / n;
    }
    const double spread = xx - x * x;
    return spread > 1e-12 ? -(xy - x * y) / spread : NaN;
}

double kolmogorov_smirnov(std::vector<double> samples, const std::function<double(double)>& below) {
    std::sort(samples.begin(), samples.end());
    const auto n = static_cast<double>(samples.size());
    double gap = 0.0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto rank = static_cast<double>(i);
        const double expected = below(samples[i]);
        gap = std::max({gap, expected - rank / n, (rank + 1.0) / n - expected});
    }
    return std::sqrt(n) * gap;
}

double maxwell_below(double speed, double a) {
    const double s = speed / a, pi = std::acos(-1.0);
    return std::erf(s / std::sqrt(2.0)) - std::sqrt(2.0 / pi) * s * std::exp(-0.5 * s * s);
}

}  // namespace corpuscle::verify
