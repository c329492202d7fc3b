// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/uniform_bag.hpp"

namespace corpuscle::gas {

/// A hole between two bags of uniform pressure (*AIRBAG_INTERACTION). Gas of the higher pressure
/// flows to the lower with its enthalpy, by orifice_flow() or a curve of the pressure difference.
/// A step never goes past equal pressures:
///
///     m = m_e (1 - exp(-m' dt / m_e)),   m_e = (p_1 - p_2) / (gamma R T (1/V_1 + 1/V_2)).
class Exchange {
public:
    /// @param curves  that the card's rows mean, copied
    Exchange(const ExchangeCard& card, std::span<const Curve> curves)
        : card_(card), curves_(curves.begin(), curves.end()) {}

    /// t -> t + dt, from the states at t; after the bags' own UniformBag::flow().
    /// @param bags  all bags of uniform pressure
    /// @param x     N × 3, nodes at t                                                       [m]
    void flow(double t, double dt, const Points& x, std::span<UniformBag> bags) const;

private:
    [[nodiscard]] double value(const CurveOr& of, double at) const {
        return of.curve >= 0 ? curves_[of.curve](at) : of.value;
    }
    [[nodiscard]] double rate(double t, const Points& x, const UniformBag& from,
                              const UniformBag& to) const;

    ExchangeCard card_;
    std::vector<Curve> curves_;
};

/// Area of facets, node rows, with nodes at x; a triangle repeats its third node.         [m^2]
[[nodiscard]] double area_of(std::span<const std::array<Index, 4>> facets, const Points& x);

}  // namespace corpuscle::gas
