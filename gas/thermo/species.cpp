// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/thermo/species.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "solver/base/error.hpp"

namespace corpuscle::gas {

namespace {

constexpr double GAMMA_ROUNDING = 1.002;  ///< decks write 20.78 or 20.79 for 5/2 R

/// Where E rises no more: the end of the fit's use towards high temperatures.
double summit(const EnergyPolynomial& E) {
    if (E.c == 0.0) return E.b < 0.0 ? -E.a / (2.0 * E.b) : INF;
    const double disc = E.b * E.b - 3.0 * E.a * E.c;
    if (E.c > 0.0 || disc < 0.0) return INF;
    return (-E.b - std::sqrt(disc)) / (3.0 * E.c);  // c < 0: the larger root of E' = 0
}

}  // namespace

double EnergyPolynomial::temperature(double energy, double guess) const {
    const EnergyPolynomial& E = *this;
    if (energy == 0.0 && a > 0.0) return 0.0;

    // Bracket the last rise: E(low) <= energy < E(high).
    double low = 0.0, high = summit(E);
    if (high == INF) {
        high = std::max(guess, 1.0);
        while (E(high) < energy) {
            low = high;
            if (!((high *= 2.0) < 1e12)) return NaN;
        }
    }
    if (!(energy > 0.0) || !(high > 0.0) || !(E(high) >= energy)) return NaN;

    double T = std::clamp(guess, low, high);
    for (int i = 0; i < 200; ++i) {
        const double excess = E(T) - energy;
        (excess > 0.0 ? high : low) = T;
        double next = T - excess / E.slope(T);
        if (!(next > low && next < high)) {
            if (std::abs(next - T) <= 4e-16 * T) return T;
            next = 0.5 * (low + high);
        }
        if (std::abs(next - T) <= 2e-16 * T) return next;
        T = next;
    }
    return T;  // Newton hops between two neighbouring doubles
}

Species::Species(const SpeciesCard& card, double gas_constant, std::string name)
    : R_(gas_constant),
      M_(card.molar_mass),
      A_(card.A),
      B_(card.B),
      C_(card.C),
      name_(std::move(name)) {
    std::vector<std::string> faults;
    if (!(M_ > 0.0) || std::isinf(M_))
        faults.push_back(fmt::format("{}: molar mass = {:g}, expected > 0 [kg/mol]", name_, M_));
    if (!(R_ > 0.0) || std::isinf(R_))
        faults.push_back(fmt::format("{}: gas constant R = {:g}, expected > 0", name_, R_));
    if (!std::isfinite(A_) || !std::isfinite(B_) || !std::isfinite(C_))
        faults.push_back(fmt::format(
            "{}: heat capacity A, B, C = {:g}, {:g}, {:g}, expected numbers", name_, A_, B_, C_));
    if (!faults.empty()) throw InputError(std::move(faults));
}

double Species::temperature_of(double specific_energy) const {
    return molar_energy().temperature(specific_energy * M_);
}

std::string Species::fault_between(double low, double high) const {
    // Cp - Cv = R, so both bounds are bounds on the least Cv; Cv is a parabola.
    std::array<double, 3> at = {low, high, low};
    if (C_ != 0.0) at[2] = std::clamp(-B_ / (2.0 * C_), low, high);
    const double T = *std::min_element(at.begin(), at.end(),
                                       [this](double p, double q) { return cv(p) < cv(q); });

    const double Cv = cv(T) * M_;
    if (!(Cv > 0.0))
        return fmt::format(
            "{}: Cv = A + B T + C T^2 - R = {:.6g} J/(mol K) at {:.6g} K, expected > 0 "
            "from {:.6g} to {:.6g} K",
            name_, Cv, T, low, high);
    for (const double where : {T, at[0], at[1], at[2]})
        if (!(gamma(where) > 1.0 && gamma(where) <= 5.0 / 3.0 * GAMMA_ROUNDING))
            return fmt::format(
                "{}: Cp/Cv = {:.6g} at {:.6g} K, expected above 1, up to 5/3, from {:.6g} to "
                "{:.6g} K "
                "(check R's unit system against A, B, C)",
                name_, gamma(where), where, low, high);
    return {};
}

Mixture::Mixture(std::vector<Species> species, double moles_each)
    : species_(std::move(species)), moles_each_(moles_each) {
    for (const Species& s : species_) {
        const auto first = std::find_if(species_.begin(), species_.end(),
                                        [&](const Species& o) { return o.is_like(s); });
        kind_.push_back(static_cast<std::int32_t>(first - species_.begin()));
        half_heat_ = 0.5 * s.gas_constant() * moles_each;
        mass_.push_back(moles_each * s.molar_mass());
        internal_.push_back(moles_each * s.molar_internal());
    }
}

double Mixture::particle_temperature(std::int32_t s, double internal, double speed_squared) const {
    const double T = internal > 0.0 ? internal_[s].temperature(internal) : NaN;
    if (std::isfinite(T) && internal > 0.05 * half_heat_ * T) return T;
    return mass_[s] * speed_squared / (6.0 * half_heat_);
}

double mixture_temperature(std::span<const Species> species, std::span<const double> moles,
                           double energy) {
    assert(species.size() == moles.size());
    EnergyPolynomial total;
    for (std::size_t s = 0; s < species.size(); ++s) total += moles[s] * species[s].molar_energy();
    return total.temperature(energy);
}

}  // namespace corpuscle::gas
