// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/estimate.hpp"

#include <array>
#include <cmath>

#include "solver/base/vec.hpp"

namespace corpuscle::study {

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

}  // namespace corpuscle::study
