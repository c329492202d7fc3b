// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/keywords/airbag/airbag_gas.hpp"

namespace corpuscle::io::keywords {
namespace {

/// Pieces that a stretch between knots is cut into: the mass flow of one gas is no polynomial in
/// time where fractions change. The sum over all gases is exact with any number.
constexpr int PIECES = 32;

constexpr double ROUNDED = 2e-3;  ///< sums of fractions are 1 up to what a deck rounds

/// All knots of the curves, and points between; inner knots twice, for curves may jump there.
std::vector<double> times_of(const std::vector<const Curve*>& curves, double from, double to) {
    std::vector<double> knots;
    for (const Curve* curve : curves)
        for (const double t : curve->x)
            if (t >= from && t <= to) knots.push_back(t);
    std::sort(knots.begin(), knots.end());
    knots.erase(std::unique(knots.begin(), knots.end()), knots.end());
    std::vector<double> times;
    for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
        for (int piece = 0; piece < PIECES; ++piece)
            times.push_back(knots[k] + (knots[k + 1] - knots[k]) * piece / PIECES);
        times.push_back(knots[k + 1]);
    }
    return times;
}

/// Value just before (the first of two equal times) or just after it: curves may jump.
double value(const Curve& curve, double t, bool before) {
    const auto at = std::lower_bound(curve.x.begin(), curve.x.end(), t);
    const bool is_knot = at != curve.x.end() && *at == t;
    return is_knot && before ? curve.y[static_cast<std::size_t>(at - curve.x.begin())] : curve(t);
}

}  // namespace

void share_by_moles(Cards& cards, Draft& draft, Index mass, std::vector<gas::InflowCard>& gases) {
    std::vector<Curve>& curves = draft.model.curves;
    const Curve total = curves[mass];
    std::vector<Curve> fraction, flow(gases.size());
    std::vector<const Curve*> all{&total};
    for (const gas::InflowCard& gas : gases) fraction.push_back(curves[gas.mass_rate]);
    for (const Curve& curve : fraction) all.push_back(&curve);

    const std::vector<double> times = times_of(all, total.x.front(), total.x.back());
    for (std::size_t k = 0; k < times.size(); ++k) {
        const double t = times[k];
        const bool before = k + 1 < times.size() && times[k + 1] == t;
        const double rate = value(total, t, before);
        double sum = 0.0, weight = 0.0;
        for (std::size_t g = 0; g < gases.size(); ++g) {
            const double x = value(fraction[g], t, before);
            if (x < 0.0)
                return cards.fault(
                    fmt::format("has mole fraction {:g} < 0 of gas {} at time {:g} (curve {})", x,
                                g + 1, t, fraction[g].id));
            sum += x;
            weight += x * gases[g].species.molar_mass;
        }
        if (rate != 0.0 && std::abs(sum - 1.0) > ROUNDED)
            return cards.fault(fmt::format(
                "has mole fractions that add up to {:.6g} at time {:g}, expected 1", sum, t));
        for (std::size_t g = 0; g < gases.size(); ++g) {
            const double x = value(fraction[g], t, before);
            const double share = weight > 0.0 ? x * gases[g].species.molar_mass / weight : 0.0;
            flow[g].x.push_back(t);
            flow[g].y.push_back(rate * share);
        }
    }
    for (std::size_t g = 0; g < gases.size(); ++g) {
        flow[g].id = fraction[g].id;
        gases[g].mass_rate = static_cast<Index>(curves.size());
        curves.push_back(std::move(flow[g]));
    }
}

}  // namespace corpuscle::io::keywords
