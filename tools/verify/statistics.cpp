// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/vec.hpp"

namespace corpuscle::verify {

double student_95(std::size_t degrees_of_freedom) {
    constexpr std::array<double, 10> TABLE{12.7062, 4.3027, 3.1824, 2.7764, 2.5706,
                                           2.4469,  2.3646, 2.3060, 2.2622, 2.2281};
    if (degrees_of_freedom == 0) return NaN;
    if (degrees_of_freedom <= TABLE.size()) return TABLE[degrees_of_freedom - 1];
    constexpr double Z = 1.959963985, Z3 = Z * Z * Z, Z5 = Z3 * Z * Z, Z7 = Z5 * Z * Z;
    const auto n = static_cast<double>(degrees_of_freedom);
    return Z + (Z3 + Z) / (4.0 * n) + (5.0 * Z5 + 16.0 * Z3 + 3.0 * Z) / (96.0 * n * n) +
           (3.0 * Z7 + 19.0 * Z5 + 17.0 * Z3 - 15.0 * Z) / (384.0 * n * n * n);
}

Estimate mean_of(std::span<const double> samples) {
    const auto n = static_cast<double>(samples.size());
    if (samples.empty()) return {NaN, NaN};
    double mean = 0.0, squares = 0.0;
    for (const double x : samples) mean += x / n;
    for (const double x : samples) squares += (x - mean) * (x - mean);
    const double deviation = std::sqrt(squares / (n - 1.0));
    return {mean, student_95(samples.size() - 1) * deviation / std::sqrt(n)};
}

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
