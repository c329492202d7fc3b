// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/responses/channel_filter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// One pass over the samples in place, settled on the first.
void pass(double dt, double cfc, auto begin, auto end) {
    constexpr double CORNER = 2.0775;  // of the one-way filter over CFC           [SAE J211-1]
    const double w = std::tan(std::numbers::pi * cfc * CORNER * dt);
    const double scale = 1.0 / (1.0 + std::numbers::sqrt2 * w + w * w);
    const double a0 = w * w * scale, a1 = 2.0 * a0, a2 = a0;
    const double b1 = -2.0 * (w * w - 1.0) * scale;
    const double b2 = (-1.0 + std::numbers::sqrt2 * w - w * w) * scale;
    double x1 = *begin, x2 = x1, y1 = x1, y2 = x1;
    for (auto at = begin; at != end; ++at) {
        const double x = *at;
        const double y = a0 * x + a1 * x1 + a2 * x2 + b1 * y1 + b2 * y2;
        x2 = x1;
        x1 = x;
        y2 = y1;
        y1 = y;
        *at = y;
    }
}

}  // namespace

std::vector<double> filtered(std::span<const double> samples, double dt, double cfc) {
    if (dt * cfc * SAMPLES_PER_CLASS > 1.0 + 1e-9)
        throw InputError(fmt::format(
            "CFC {:g} wants {:g} samples a second or more, there are {:g}: it would be aliased",
            cfc, SAMPLES_PER_CLASS * cfc, 1.0 / dt));
    if (samples.size() < 2) return {samples.begin(), samples.end()};

    // what a filter still remembers after 5/CFC seconds is below 1e-12
    const auto pad = std::min(samples.size() - 1, static_cast<std::size_t>(5.0 / (cfc * dt)));
    const double first = samples.front(), last = samples.back();
    std::vector<double> y;
    y.reserve(samples.size() + 2 * pad);
    for (std::size_t k = pad; k > 0; --k) y.push_back(2.0 * first - samples[k]);
    y.insert(y.end(), samples.begin(), samples.end());
    for (std::size_t k = 1; k <= pad; ++k)
        y.push_back(2.0 * last - samples[samples.size() - 1 - k]);
    pass(dt, cfc, y.begin(), y.end());
    pass(dt, cfc, y.rbegin(), y.rend());
    const auto begin = y.begin() + static_cast<std::ptrdiff_t>(pad);
    return {begin, begin + static_cast<std::ptrdiff_t>(samples.size())};
}

}  // namespace corpuscle::io
