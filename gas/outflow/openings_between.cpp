// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What internal openings let through from room to room, but for particles.

#include <algorithm>
#include <cmath>

#include "gas/outflow/beyond_chance.hpp"
#include "gas/outflow/leak_speed.hpp"
#include "gas/outflow/openings.hpp"
#include "gas/thermo/orifice_flow.hpp"

namespace corpuscle::gas {

bool Openings::seeps(std::size_t row) const {
    const Opening& opening = openings_[row];
    return opening.is_internal && opening.leak >= 0 &&
           leaks_[opening.leak].law == LeakLaw::VELOCITY;
}

double Openings::holes() const {
    double count = 0.0;
    for (std::size_t o = 0; o < openings_.size(); ++o)
        count += openings_[o].is_internal && !seeps(o);
    return count;
}

double Openings::flow_between(std::size_t row, double t, const Inside& from, double p_out) {
    if (!from.holds_gas()) return 0.0;
    Opening& opening = openings_[row];
    const double area = opening.free * opening.area;
    if (opening.vent >= 0)
        return vent_factor(opening, t, from) * area *
               orifice_flow(from.pressure, p_out, from.temperature, from.gamma,
                            gas_constant_ / from.molar_mass);
    const LeakCard& leak = leaks_[opening.leak];
    const double density = from.pressure * from.molar_mass / (gas_constant_ * from.temperature);
    return density * area * leak_share(opening, t) *
           curve_or(leak.velocity_curve, from.pressure, leak.velocity) *
           leak_speed(leak.law, from.pressure, p_out, density, from.gamma);
}

/// Through fabric inside the bag: as set_seepage(), for the gas on each side by itself. Where all pass,
/// from both sides, it is a hole.
void Openings::set_between(Index row, double t, double dt, std::span<const Inside> rooms) {
    Opening& opening = openings_[row];
    const auto set = [&](const Inside& from, const Inside& to, Opening::Seepage& seepage,
                         std::vector<double>& chance) {
        chance.assign(species_.size(), 0.0);
        if (!from.holds_gas()) return;
        for (std::size_t s = 0; s < species_.size(); ++s) {
            const double M = species_[s].molar_mass();
            const double velocity =
                seepage_velocity(opening, t, from, to.pressure, from.density[s], M);
            seepage.share[s] =
                std::clamp(velocity / effusion_speed(from.temperature, gas_constant_, M), 0.0, 1.0);
            chance[s] = steered(opening, seepage, s, dt, from);
        }
    };
    Transmission::Chances& chances = transmission_.all[row];
    const Inside &behind = rooms[opening.room], &ahead = rooms[opening.ahead.room];
    set(behind, ahead, opening.seepage[0], chances.chance);
    set(ahead, behind, opening.seepage[1], chances.front_chance);
    const auto is_open = [](const Opening::Seepage& side) {
        return std::all_of(side.share.begin(), side.share.end(),
                           [](double share) { return share >= 1.0; });
    };
    if (!is_open(opening.seepage[0]) || !is_open(opening.seepage[1])) return;
    for (Opening::Seepage& side : opening.seepage) std::fill(side.due.begin(), side.due.end(), 0.0);
    std::fill(chances.chance.begin(), chances.chance.end(), 1.0);
    chances.front_chance.clear();
}

/// Gas that seeps takes its enthalpy along: what a particle that has passed lacks of it is owed by
/// the gas that it came from, to that where it goes.
void Openings::count_through(const Arrival& arrival, std::span<const Inside> rooms,
                             std::int32_t species) {
    const Index row = arrival.outcome.opening;
    const Opening& opening = openings_[row];
    if (opening.leak < 0 || opening.room == opening.ahead.room) return;
    const bool from_front = arrival.outcome.from_front;
    if (opening.seepage[from_front ? 1 : 0].share[species] >= 1.0) return;  // as through a hole
    const Inside& from = rooms[from_front ? opening.ahead.room : opening.room];
    const double lacks = mass_[species] * species_[species].h(from.temperature) - arrival.energy;
    passed_.still_owed[row] += from_front ? -lacks : lacks;
}

double Openings::air_between(std::size_t row, double t, const Inside& from, const Inside& to) {
    if (!from.holds_gas()) return 0.0;
    Inside driving = from;
    if (!seeps(row)) {
        driving.pressure =
            beyond_chance(from.pressure, to.pressure, std::hypot(from.error, to.error));
        if (!(driving.pressure > to.pressure)) return 0.0;
    }
    double density = from.air_density;
    for (const double of_species : from.density) density += of_species;
    return from.air_density / density * flow_between(row, t, driving, to.pressure);
}

}  // namespace corpuscle::gas
