// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/inflator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {

namespace {

constexpr double COLDEST = 50.0;  ///< gas that expands from anything warmer may get this cold   [K]
constexpr double HOTTER = 1.2;    ///< head room over the hottest gas that comes in: a shock heats

using Faults = std::vector<Fault>;

/// Least and greatest value of a curve from `begins` to `ends`.
std::pair<double, double> range(const Curve& curve, double begins, double ends) {
    double low = std::min(curve(begins), curve(ends)), high = std::max(curve(begins), curve(ends));
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
        if (curve.x[i] < begins || curve.x[i] > ends) continue;
        low = std::min(low, curve.y[i]);
        high = std::max(high, curve.y[i]);
    }
    return {low, high};
}

const Curve* find(std::span<const Curve> curves, Index row, const std::string& use,
                  Faults& faults) {
    if (row >= 0 && static_cast<std::size_t>(row) < curves.size() && !curves[row].empty())
        return &curves[row];
    faults.push_back({.of = use, .why = "no curve is given"});
    return nullptr;
}

/// Areas of an inflator's orifices as shares of 1; other inflators' orifices get 0.
std::vector<double> shares(const BagCard& card, int inflator, const std::string& name,
                           Faults& faults) {
    const std::vector<OrificeCard>& orifices = card.orifices;
    std::vector<double> share(orifices.size(), 0.0);
    bool has_orifice = false;
    for (std::size_t o = 0; o < orifices.size(); ++o) {
        if (orifices[o].inflator != inflator) continue;
        has_orifice = true;
        share[o] = orifices[o].weight;
        if (!(share[o] >= 0.0))
            faults.push_back({.of = card.name(),
                              .property = Property::ORIFICE_AREA,
                              .which = "orifice " + std::to_string(o + 1),
                              .value = share[o],
                              .why = "expected >= 0"});
    }
    const double sum = std::accumulate(share.begin(), share.end(), 0.0);
    if (!has_orifice)
        faults.push_back(
            {.of = name,
             .why = fmt::format("inflator {} has no orifice to enter through", inflator)});
    else if (!(sum > 0.0))
        faults.push_back(
            {.of = name, .why = fmt::format("the orifices of inflator {} have no area", inflator)});
    for (double& s : share) s /= sum;
    return share;
}

/// NP, and NPAIR beside it; a bag that nothing flows into has NPAIR alone.
std::size_t particles_of(const BagCard& card) {
    const std::size_t air = card.air && card.air->is_particles ? card.air->particles : 0;
    return air > 0 && card.inflow.empty() ? air : card.particles + air;
}

/// Air that is no particles goes through the same temperatures as the gases that heat it.
void check_uniform_air(const BagCard& card, double low, double high, Faults& faults) {
    const InitialAirCard& air = *card.air;
    try {
        const Species species(air.species, card.gas_constant,
                              fmt::format("initial air of bag {}", card.id));
        std::string fault = species.fault_between(std::min(low, air.temperature),
                                                  std::max(high, HOTTER * air.temperature));
        if (!fault.empty()) faults.push_back({.of = {}, .why = std::move(fault)});
    } catch (const InputError& e) {
        faults.insert(faults.end(), e.typed.begin(), e.typed.end());
    }
}

}  // namespace

Inflators::Inflators(const BagCard& card, std::span<const Curve> curves, std::uint64_t seed,
                     double volume)
    : seed_(seed),
      gas_constant_(card.gas_constant),
      low_(COLDEST),
      high_(COLDEST),
      given_(card.inflow.size() * card.orifices.size(), 0) {
    Faults faults;
    for (std::size_t o = 0; o < card.orifices.size(); ++o) {
        const OrificeCard& orifice = card.orifices[o];
        const bool is_jet = orifice.direction.has_value() || orifice.shell >= 0;
        if (is_jet && !(orifice.cone >= 0.0 && orifice.cone <= std::numbers::pi))
            faults.push_back({.of = card.name(),
                              .property = Property::CONE_ANGLE,
                              .which = "orifice " + std::to_string(o + 1),
                              .value = orifice.cone,
                              .why = "expected 0 to pi"});
        cone_.push_back(orifice.cone);
    }
    for (std::size_t g = 0; g < card.inflow.size(); ++g)
        add_gas(card, card.inflow[g], fmt::format("gas {} of bag {}", g + 1, card.id), curves,
                faults);
    const bool has_air = card.air && card.air->is_particles;
    if (has_air) add_air(card, volume, faults);
    if (card.air && !has_air) check_uniform_air(card, low_, high_, faults);

    // A gas is met at any temperature that any of them has, once they are mixed.
    for (const Species& s : species_)
        if (std::string fault = s.fault_between(low_, high_); !fault.empty())
            faults.push_back({.of = {}, .why = std::move(fault)});
    if (faults.empty() && !species_.empty()) share_particles(card, faults);
    if (!faults.empty()) throw InputError(std::move(faults));
}

void Inflators::add_gas(const BagCard& card, const InflowCard& inflow, const std::string& name,
                        std::span<const Curve> curves, Faults& faults) {
    const std::size_t known = faults.size();
    const Curve* rate = find(curves, inflow.mass_rate, name + ", mass flow", faults);
    const Curve* T = find(curves, inflow.temperature, name + ", temperature", faults);
    std::vector<double> share = shares(card, inflow.inflator, name, faults);
    try {
        species_.emplace_back(inflow.species, card.gas_constant, name);
    } catch (const InputError& e) {
        faults.insert(faults.end(), e.typed.begin(), e.typed.end());
    }
    if (faults.size() > known) return;

    FlowCurve flow(*rate, card.all_in);
    const auto [rate_low, rate_high] = range(*rate, flow.begins(), flow.ends());
    const auto [T_low, T_high] = range(*T, flow.begins(), flow.ends());
    if (!(rate_low >= 0.0))
        faults.push_back({.of = name,
                          .why = fmt::format("mass-flow curve {} falls to {:g}, expected >= 0",
                                             rate->id, rate_low)});
    else if (!(flow.total() > 0.0))
        faults.push_back({.of = name,
                          .why = fmt::format("mass-flow curve {} brings nothing in until {:g}",
                                             rate->id, card.all_in)});
    if (!(T_low > 0.0)) {
        faults.push_back({.of = name,
                          .why = fmt::format("temperature curve {} falls to {:g}, expected > 0 K",
                                             T->id, T_low)});
        return;
    }
    const double T_stag = species_.back().stagnation_temperature(T_high);
    if (!(T_stag > 0.0))
        faults.push_back(
            {.of = name,
             .why = fmt::format(
                 "no temperature holds the enthalpy at {:g} K; Cv turns negative above", T_high)});
    else
        high_ = std::max(high_, HOTTER * T_stag);
    low_ = std::min(low_, T_low);
    gases_.push_back({std::move(flow), *T, std::move(share), 0});
}

/// The initial air as one more gas of particles: n = p V / (R T).
void Inflators::add_air(const BagCard& card, double volume, Faults& faults) {
    const InitialAirCard& air = *card.air;
    try {
        species_.emplace_back(air.species, card.gas_constant,
                              fmt::format("initial air of bag {}", card.id));
    } catch (const InputError& e) {
        faults.insert(faults.end(), e.typed.begin(), e.typed.end());
        return;
    }
    resident_moles_ = air.pressure * volume / (card.gas_constant * air.temperature);
    low_ = std::min(low_, air.temperature);
    high_ = std::max(high_, HOTTER * air.temperature);
}

/// Particles of each gas in proportion to its moles, by largest remainder, so that all sum up to
/// NP.
void Inflators::share_particles(const BagCard& card, Faults& faults) {
    const std::size_t particles = particles_of(card);
    const auto refuse = [&](std::string why) {
        faults.push_back({.of = card.name(),
                          .property = Property::PARTICLE_NUMBER,
                          .value = static_cast<double>(particles),
                          .why = std::move(why)});
    };
    std::vector<double> moles;
    for (std::size_t g = 0; g < gases_.size(); ++g)
        moles.push_back(gases_[g].flow.total() / species_[g].molar_mass());
    if (species_.size() > gases_.size()) moles.push_back(resident_moles_);
    if (particles == 0) {
        refuse("expected > 0");
        return;
    }
    moles_each_ = std::accumulate(moles.begin(), moles.end(), 0.0) / static_cast<double>(particles);

    std::vector<double> remainder(moles.size());
    std::vector<std::size_t> count(moles.size());
    std::size_t left = particles;
    for (std::size_t g = 0; g < moles.size(); ++g) {
        const double exact = moles[g] / moles_each_;
        count[g] = std::min(left, static_cast<std::size_t>(exact));
        remainder[g] = exact - static_cast<double>(count[g]);
        left -= count[g];
    }
    for (; left > 0; --left) {
        const auto most = std::max_element(remainder.begin(), remainder.end()) - remainder.begin();
        ++count[most];
        remainder[most] -= 1.0;
    }
    for (std::size_t g = 0; g < moles.size(); ++g)
        if (count[g] == 0) refuse("too few to hold any of " + species_[g].name());
    for (std::size_t g = 0; g < gases_.size(); ++g) gases_[g].particles = count[g];
    if (moles.size() > gases_.size()) resident_ = count.back();
}

std::size_t Inflators::particles() const {
    std::size_t sum = 0;
    for (const Gas& gas : gases_) sum += gas.particles;
    return sum;
}

double Inflators::ends() const {
    double last = 0.0;
    for (const Gas& gas : gases_) last = std::max(last, gas.flow.ends());
    return last;
}

}  // namespace corpuscle::gas
