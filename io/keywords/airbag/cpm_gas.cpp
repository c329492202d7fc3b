// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// *DEFINE_CPM_GAS_PROPERTIES: a gas that rows of *AIRBAG_PARTICLE name.

#include <fmt/format.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

#include "io/keywords/airbag/airbag_gas.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

constexpr double MOST_OFF = 0.05;  ///< of Cp, of a parabola in the place of a fourth order

double heat_capacity(const CpmGas& gas, double T) {
    double cp = 0.0;
    for (auto k = gas.cp.rbegin(); k != gas.cp.rend(); ++k) cp = cp * T + *k;
    return cp;
}

/// A + B T + C T^2 by least squares.
Eigen::Vector3d parabola(const CpmGas& gas, double low, double high) {
    constexpr Eigen::Index POINTS = 101;
    Eigen::Matrix<double, POINTS, 3> terms;
    Eigen::Matrix<double, POINTS, 1> cp;
    for (Eigen::Index i = 0; i < POINTS; ++i) {
        const double T = low + (high - low) * static_cast<double>(i) / (POINTS - 1);
        const double s = T / high;
        terms.row(i) << 1.0, s, s * s;
        cp(i) = heat_capacity(gas, T);
    }
    const Eigen::Vector3d of_s = terms.householderQr().solve(cp);
    return {of_s(0), of_s(1) / high, of_s(2) / (high * high)};
}

/// The greatest difference from the fourth order, over it.
double worst(const CpmGas& gas, const Eigen::Vector3d& fit, double low, double high) {
    double most = 0.0;
    for (int i = 0; i <= 1000; ++i) {
        const double T = low + (high - low) * i / 1000, cp = heat_capacity(gas, T);
        const double off = std::abs(fit(0) + fit(1) * T + fit(2) * T * T - cp);
        most = cp > 0.0 ? std::max(most, off / cp) : INF;
    }
    return most;
}

}  // namespace

void define_cpm_gas(Cards& cards, Draft& draft) {
    constexpr const char* REFUSED = "this is not acted on: a gas that refers to it is refused";
    if (cards.has("TITLE")) cards.title();
    CpmGas gas;
    const auto refuse = [&](Card& c, const char* names) {
        c.noted(names, REFUSED);
        for (const std::string_view name : c.set_fields())
            gas.refused.append(gas.refused.empty() ? "" : ", ").append(name);
    };
    {
        Card c = cards.next("ID XMM CP0 CP1 CP2 CP3 CP4");
        c.new_id("ID", draft.cpm_gases, draft.cpm_gas.size());
        gas.molar_mass = c.real("XMM", POSITIVE);
        constexpr const char* NAMES[] = {"CP0", "CP1", "CP2", "CP3", "CP4"};
        for (std::size_t k = 0; k < gas.cp.size(); ++k) gas.cp[k] = c.real(NAMES[k]);
    }
    if (cards.more()) {
        Card c = cards.next("MUT0 MUT1 MUT2 MUT3 MUT4 CHM_ID VINI LCMCF");
        refuse(c, "MUT0 MUT1 MUT2 MUT3 MUT4 CHM_ID VINI LCMCF");
    }
    if (cards.more()) {
        Card c = cards.next("PID PCUT=1e20 MCUT=-1e20 TTIME");
        refuse(c, "PID PCUT MCUT TTIME");
    }
    draft.cpm_gas.push_back(std::move(gas));
}

gas::SpeciesCard defined_gas(Card& c, const char* mass, double id, const Draft& draft, double low,
                             double high) {
    gas::SpeciesCard species;
    const Registry::Entry* entry = c.named(mass, id, draft.cpm_gases);
    if (entry == nullptr) {
        c.fault(mass, "> 0, or minus the id of a *DEFINE_CPM_GAS_PROPERTIES of the deck");
        return species;
    }
    const CpmGas& gas = draft.cpm_gas[static_cast<std::size_t>(entry->row)];
    if (!gas.refused.empty())
        c.fault(mass, fmt::format("a *DEFINE_CPM_GAS_PROPERTIES without {}, on which nothing acts",
                                  gas.refused));
    species = {gas.molar_mass, gas.cp[0], gas.cp[1], gas.cp[2]};
    if (gas.cp[3] == 0.0 && gas.cp[4] == 0.0) return species;
    const Eigen::Vector3d fit = parabola(gas, low, high);
    const double off = worst(gas, fit, low, high);
    if (!(off < MOST_OFF)) {
        c.fault(mass, fmt::format("a Cp of fourth order that A + B T + C T^2 meets within {:g} % "
                                  "from {:g} to {:g} K, but it is {:.3g} % off",
                                  100.0 * MOST_OFF, low, high, 100.0 * off));
        return species;
    }
    c.warn(mass, fmt::format("its Cp of fourth order is taken as {:.5g} {:+.5g} T {:+.5g} T^2, "
                             "within {:.2g} % from {:g} to {:g} K",
                             fit(0), fit(1), fit(2), 100.0 * off, low, high));
    return {gas.molar_mass, fit(0), fit(1), fit(2)};
}

}  // namespace corpuscle::io::keywords
