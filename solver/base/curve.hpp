// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace corpuscle {

/// Piecewise linear curve y(x) of *DEFINE_CURVE, offset and scaled already.
///
/// Abscissae never decrease; two equal ones are a jump, where the value is that after it, at the
/// first abscissa too. Outside its range a curve keeps its end value.
struct Curve {
    int id = 0;             ///< the deck's LCID
    std::vector<double> x;  ///< abscissa, ascending
    std::vector<double> y;  ///< ordinate, as many as x; units of both as the user of it says

    /// Without points: of such a curve nothing else may be asked.
    [[nodiscard]] bool empty() const { return x.empty(); }

    /// y at `at`; on a jump, after it.                          cost: one binary search, 1 div
    [[nodiscard]] double operator()(double at) const {
        if (at <= x.front()) return at < x.front() ? y.front() : after(0);
        if (at >= x.back()) return y.back();
        const auto right = std::upper_bound(x.begin(), x.end(), at);
        const auto i = static_cast<std::size_t>(right - x.begin());
        const double span = x[i] - x[i - 1];
        return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / span;
    }

    /// Mean of y over [from, to], exact; from < to.
    [[nodiscard]] double mean(double from, double to) const {
        double sum = 0.0, at = from, y_at = (*this)(from);
        for (auto next = std::upper_bound(x.begin(), x.end(), from); at < to; ++next) {
            const double end = next == x.end() ? to : std::min(to, *next);
            const bool at_knot = next != x.end() && end == *next;
            const double y_end =
                at_knot ? y[static_cast<std::size_t>(next - x.begin())] : (*this)(end);
            sum += 0.5 * (y_at + y_end) * (end - at);
            at = end;
            y_at = at_knot ? after(static_cast<std::size_t>(next - x.begin())) : y_end;
            if (next == x.end()) break;
        }
        return sum / (to - from);
    }

    /// Exact integral of y from the first abscissa to `to`, y = 0 outside the range. [units of x y]
    [[nodiscard]] double integral_to(double to) const {
        double sum = 0.0;
        for (std::size_t i = 1; i < x.size() && x[i - 1] < to; ++i) {
            const double end = std::min(to, x[i]);
            sum += 0.5 * (y[i - 1] + (x[i] > end ? (*this)(end) : y[i])) * (end - x[i - 1]);
        }
        return sum;
    }

    /// The same up to `end`; one that ends there goes on beyond it along its last segment.
    ///
    /// For motions that a curve gives up to the end of a run: the step beyond it, which only the
    /// last sample looks into, goes on as the one before. A curve that ends sooner stays.
    [[nodiscard]] Curve continued_beyond(double end) const {
        constexpr double ROUNDING = 1e-9;  // of times in decks
        Curve on = *this;
        const std::size_t n = x.size();
        if (n < 2 || !(x[n - 1] > x[n - 2])) return on;
        if (!(end > 0.0) || x[n - 1] < end * (1.0 - ROUNDING)) return on;
        const double slope = (y[n - 1] - y[n - 2]) / (x[n - 1] - x[n - 2]);
        on.x.push_back(x[n - 1] + end);  // further than any step
        on.y.push_back(y[n - 1] + slope * end);
        return on;
    }

private:
    /// Ordinate just after knot i: of the last knot at the same abscissa.
    [[nodiscard]] double after(std::size_t i) const {
        while (i + 1 < x.size() && x[i + 1] == x[i]) ++i;
        return y[i];
    }
};

}  // namespace corpuscle
