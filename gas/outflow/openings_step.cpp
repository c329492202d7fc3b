// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What the openings of a bag let through in one step.

#include <algorithm>
#include <cmath>

#include "gas/outflow/beyond_chance.hpp"
#include "gas/outflow/leak_speed.hpp"
#include "gas/outflow/openings.hpp"
#include "gas/thermo/orifice_flow.hpp"

namespace corpuscle::gas {
namespace {

/// Arrivals at an opening over which their flow is averaged. More: steadier chances that answer
/// later to a change.
constexpr double ARRIVALS_KEPT = 50.0;

/// Least steps of the same.
constexpr double STEPS_KEPT = 6.0;

}  // namespace

void Openings::set_transmission(double t, double dt, std::span<const Vec3> x,
                                std::span<const Inside> inside, std::span<const Inside> rooms) {
    ++transmission_.step;
    for (std::size_t o = 0; o < openings_.size(); ++o) {
        set_chances(o, t, dt, x, inside[o]);
        if (openings_[o].is_internal && openings_[o].leak >= 0)
            set_between(static_cast<Index>(o), t, dt, rooms);
    }
}

void Openings::set_chances(std::size_t o, double t, double dt, std::span<const Vec3> x,
                           const Inside& inside) {
    const auto row = static_cast<Index>(o);
    Opening& opening = openings_[o];
    close(row);
    measure(opening, x);
    if (!inside.holds_gas()) return;
    compare(opening, inside);
    if (opening.leak >= 0) {
        if (opening.is_internal) return;  // set_between(), after TSW flow_between()
        const double area =
            opening.law == Opening::Law::ISENTROPIC ? leak_area(opening, inside) : 0.0;
        if (opening.law == Opening::Law::ISENTROPIC)
            set_isentropic(row, area, dt, inside);
        else
            set_seepage(row, t, dt, inside);
        set_intake(row, t, area, inside);
        return;
    }
    const double factor = vent_factor(opening, t, inside);
    set_intake(row, t, factor * opening.free * opening.area, inside);
    if (opening.law == Opening::Law::ISENTROPIC || inside.is_uniform)
        set_isentropic(row, factor * opening.free * opening.area, dt, inside);
    else
        set_plain(row, factor, x, inside);
}

void Openings::close(Index row) {
    Opening& opening = openings_[row];
    opening.flow = opening.air_flow = opening.intake = 0.0;
    Transmission::Chances& chances = transmission_.all[row];
    std::fill(chances.chance.begin(), chances.chance.end(), 0.0);
    std::fill(chances.collar_chance.begin(), chances.collar_chance.end(), 0.0);
    for (Opening::Seepage& side : opening.seepage) {
        side.share.assign(species_.size(), 0.0);
        side.flow.assign(species_.size(), 0.0);
        side.most.assign(species_.size(), 0.0);
    }
}

/// Area, and the share of it that is free.
void Openings::measure(Opening& opening, std::span<const Vec3> x) const {
    double free = 0.0;
    opening.area = 0.0;
    for (Opening::OfPart& own : opening.parts) own.area = 0.0;
    for (const Index f : opening.facets) {
        const auto& [a, b, c] = triangles_[f];
        const double area = vector_area(x[a], x[b], x[c]).norm();
        opening.area += area;
        free += transmission_.open[f] * area;
        std::find_if(opening.parts.begin(), opening.parts.end(), [&](const Opening::OfPart& own) {
            return own.part == part_[f];
        })->area += transmission_.open[f] * area;
    }
    opening.free = opening.area > 0.0 ? free / opening.area : 0.0;
}

/// With the pressure outside. Holes that pass a share of those that arrive let gas out against it.
void Openings::compare(const Opening& opening, const Inside& inside) {
    if (opening.is_internal) return;
    auto& [excess, lack] = imbalance_[opening.room];
    const double over = inside.pressure - p_atm_;
    if (opening.law != Opening::Law::PLAIN || inside.is_uniform)
        excess = std::max(
            excess, over * inside.molar_mass / (inside.gamma * gas_constant_ * inside.temperature));
    if (ambient_) lack = std::max(lack, -over / ((inside.gamma - 1.0) * ambient_->h(T_atm_)));
}

double Openings::curve_or(Index curve, double at, double otherwise) const {
    return curve >= 0 ? curves_[curve](at) : otherwise;
}

/// C23 with its curves; 0 until the gauge pressure has passed PPOP beyond chance.
double Openings::vent_factor(Opening& opening, double t, const Inside& inside) const {
    const VentCard& vent = vents_[opening.vent];
    opening.has_opened |=
        inside.pressure - 3.0 * inside.error - p_atm_ >= vent.opens_at || vent.opens_at == 0.0;
    if (!opening.has_opened) return 0.0;
    return vent.coefficient * (inside.is_uniform ? vent.uniform_factor : 1.0) *
           curve_or(vent.time_curve, t, 1.0) * curve_or(vent.pressure_curve, inside.pressure, 1.0);
}

/// A0 (X0 + X1 rs + X2 rp + X3 rs rp), rs = A / A0, rp = p_atm / p, as far as it is free.
double Openings::leak_area(const Opening& opening, const Inside& inside) const {
    const std::array<double, 4>& X = *leaks_[opening.leak].growth;
    const double rs = opening.area / opening.first_area, rp = p_atm_ / inside.pressure;
    const double area = opening.first_area * (X[0] + X[1] * rs + X[2] * rp + X[3] * rs * rp);
    return std::max(0.0, area) * opening.free;
}

/// `share` of all that arrive pass; a share above 1 opens the collar, too.
void Openings::set_plain(Index row, double share, std::span<const Vec3> x, const Inside& inside) {
    Opening& opening = openings_[row];
    Transmission::Chances& chances = transmission_.all[row];
    const double own = std::min(1.0, share);
    std::fill(chances.chance.begin(), chances.chance.end(), own);
    if (opening.is_internal) return;
    chances.push = std::min(1.0, p_atm_ / inside.pressure);
    if (share > 1.0 && !opening.collar.facets.empty())
        std::fill(chances.collar_chance.begin(), chances.collar_chance.end(),
                  std::min(1.0, (share - 1.0) * opening.free * opening.area /
                                    area_of(opening.collar.facets, x)));
    opening.air_flow = share * opening.free * opening.area * inside.air_density *
                       effusion_speed(inside.temperature, gas_constant_, inside.air_molar_mass);
    opening.air_heat = 0.5;  // effusing molecules carry u + R T / 2
}

/// Wang-Nefske flow of the state at the opening through `area`.
void Openings::set_isentropic(Index row, double area, double dt, const Inside& inside) {
    Opening& opening = openings_[row];
    Transmission::Chances& chances = transmission_.all[row];
    if (opening.is_internal) return;  // a hole after TSW: flow_between()
    const double flow =
        area * orifice_flow(beyond_chance(inside.pressure, p_atm_, inside.error), p_atm_,
                            inside.temperature, inside.gamma, gas_constant_ / inside.molar_mass);
    if (inside.is_uniform) {
        opening.air_flow = flow;
        opening.air_heat = 1.0;
        return;
    }
    if (opening.vent >= 0) chances.push = std::min(1.0, p_atm_ / inside.pressure);
    expect_arrivals(opening, dt, inside);
    if (flow <= 0.0) return;
    double density = inside.air_density;
    for (const double of_species : inside.density) density += of_species;
    opening.air_flow = flow * inside.air_density / density;
    opening.air_heat = 1.0;  // enthalpy
    opening.flow = flow - opening.air_flow;

    const double wanted = opening.flow + opening.due / opening.memory;
    if (wanted <= 0.0) return;
    const double chance = opening.arriving > 0.0 ? std::min(1.0, wanted / opening.arriving) : 1.0;
    const double rest = wanted - chance * opening.arriving;
    const double collar = rest > 0.0 && opening.collar.arriving > 0.0
                              ? std::min(1.0, rest / opening.collar.arriving)
                              : 0.0;
    for (std::size_t s = 0; s < species_.size(); ++s) {
        chances.chance[s] = chance * weight_[s];
        chances.collar_chance[s] = collar * weight_[s];
    }
}

/// Ambient air comes in where the bag's pressure is lower: isentropic through `area`, or through
/// fabric as fast as gas would leave at as much gauge pressure.
void Openings::set_intake(Index row, double t, double area, const Inside& inside) {
    Opening& opening = openings_[row];
    if (!ambient_ || opening.is_internal || inside.pressure + 3.0 * inside.error >= p_atm_) return;
    if (opening.law != Opening::Law::SEEPAGE) {
        opening.intake =
            area * orifice_flow(p_atm_, inside.pressure, T_atm_, ambient_->gamma(T_atm_),
                                gas_constant_ / ambient_->molar_mass());
        return;
    }
    const LeakCard& leak = leaks_[opening.leak];
    const double density = p_atm_ * ambient_->molar_mass() / (gas_constant_ * T_atm_);
    opening.intake = density * opening.area * opening.free * leak_share(opening, t) *
                     curve_or(leak.velocity_curve, 2.0 * p_atm_ - inside.pressure, leak.velocity) *
                     leak_speed(leak.law, p_atm_, inside.pressure, density, inside.gamma);
}

/// FLC, for the area that counts.
double Openings::leak_share(const Opening& opening, double t) const {
    const LeakCard& leak = leaks_[opening.leak];
    const double share = curve_or(leak.area_curve, t, leak.area);
    return leak.from_reference && opening.area > 0.0 ? share * opening.first_area / opening.area
                                                     : share;
}

/// What effuses from gas at rest sets the memory, and is the first guess of what arrives.
void Openings::expect_arrivals(Opening& opening, double dt, const Inside& inside) const {
    double count = 0.0, mass = 0.0;
    for (std::size_t s = 0; s < species_.size(); ++s) {
        const double flux = inside.density[s] * effusion_speed(inside.temperature, gas_constant_,
                                                               species_[s].molar_mass());
        count += flux * opening.area * opening.free / mass_[s];
        mass += flux * opening.area * opening.free * weight_[s];
    }
    const bool is_first = opening.memory == 0.0 || opening.arriving == 0.0;
    opening.memory = STEPS_KEPT * dt + (count > 0.0 ? ARRIVALS_KEPT / count : 0.0);
    if (!is_first) return;
    opening.arriving = mass;
    opening.collar.arriving = opening.collar.facets.empty() ? 0.0 : mass;
}

/// The share of a gas that is to pass, corrected by what has passed too little or too much before:
/// chance alone would scatter the mass by the square root of the number that has passed, and gas
/// that flows to the fabric arrives in greater number than gas at rest. Where all pass, it is a hole.
double Openings::steered(const Opening& opening, Opening::Seepage& seepage, std::size_t s,
                         double dt, const Inside& inside) const {
    const double arriving =
        inside.density[s] * opening.area * opening.free *
        effusion_speed(inside.temperature, gas_constant_, species_[s].molar_mass());
    const double share = seepage.share[s], passing = share * arriving;
    if (!(passing > 0.0) || share >= 1.0) return share;
    const double memory = STEPS_KEPT * dt + ARRIVALS_KEPT * mass_[s] / passing;
    seepage.flow[s] = passing;
    seepage.most[s] = passing * memory;
    return std::clamp(share + seepage.due[s] / (memory * arriving), 0.0, 1.0);
}

/// FLC · FAC · leak_speed() of a gas whose density is `own`.                                 [m/s]
double Openings::seepage_velocity(const Opening& opening, double t, const Inside& from,
                                  double p_out, double own, double molar_mass) const {
    const LeakCard& leak = leaks_[opening.leak];
    double density = from.air_density;
    for (const double of_species : from.density) density += of_species;
    const double component = own * gas_constant_ * from.temperature / molar_mass;  // its pressure
    return leak_share(opening, t) *
           leak_speed(leak.law, beyond_chance(from.pressure, p_out, from.error), p_out, density,
                      from.gamma) *
           curve_or(leak.velocity_curve, leak.by_component ? component : from.pressure,
                    leak.velocity);
}

/// density · area · FLC · FAC · leak_speed() of each gas; those that arrive are
/// density · effusion speed · area.
void Openings::set_seepage(Index row, double t, double dt, const Inside& inside) {
    Opening& opening = openings_[row];
    if (inside.pressure - 3.0 * inside.error <= p_atm_) return;
    const auto velocity = [&](double own, double molar_mass) {
        return seepage_velocity(opening, t, inside, p_atm_, own, molar_mass);
    };
    const double area = opening.area * opening.free;
    opening.air_flow =
        inside.air_density * area * velocity(inside.air_density, inside.air_molar_mass);
    opening.air_heat = 1.0;
    if (inside.is_uniform) {
        for (std::size_t s = 0; s < species_.size(); ++s)
            opening.air_flow +=
                inside.density[s] * area * velocity(inside.density[s], species_[s].molar_mass());
        return;
    }
    for (std::size_t s = 0; s < species_.size(); ++s) {
        const double M = species_[s].molar_mass();
        const double chance =
            velocity(inside.density[s], M) / effusion_speed(inside.temperature, gas_constant_, M);
        opening.seepage[0].share[s] = std::clamp(chance, 0.0, 1.0);
        transmission_.all[row].chance[s] = steered(opening, opening.seepage[0], s, dt, inside);
        if (chance > 1.0)
            opening.short_of += (1.0 - 1.0 / chance) * velocity(inside.density[s], M) * area *
                                inside.density[s] * dt;
    }
}

}  // namespace corpuscle::gas
