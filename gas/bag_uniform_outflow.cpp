// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// After TSW: gas that leaves a bag, or goes from one of its chambers to another.

#include <algorithm>
#include <cmath>

#include "gas/bag_gas.hpp"

namespace corpuscle::gas {

/// The gas of a room as its openings see it.
Inside BagGas::inside_of(std::size_t room) const {
    const ControlVolume& gas = (*uniform_)[room];
    Inside inside;
    inside.is_uniform = true;
    inside.density.assign(mass_.size(), 0.0);
    if (gas.moles() == 0.0) return inside;
    inside.pressure = gas.pressure();
    inside.temperature = gas.temperature();
    inside.molar_mass = gas.mass() / gas.moles();
    inside.gamma = gas.gamma();
    inside.heat_capacity = gas.moles() * card_.gas_constant / (gas.gamma() - 1.0);
    for (std::size_t s = 0; s < mass_.size(); ++s) inside.density[s] = gas.mass(s) / gas.volume();
    if (!air_.empty()) {
        inside.air_density = gas.mass(mass_.size()) / gas.volume();
        inside.air_molar_mass = air_[0].species().molar_mass();
    }
    return inside;
}

/// Gas leaves as the mixture that it is in its room, with its enthalpy; heat is drawn from the room
/// whose walls take it.
void BagGas::let_out_uniform(double t, double dt, const Points& x) {
    for (std::size_t r = 0; r < uniform_->size(); ++r) rooms_[r] = inside_of(r);
    for (std::size_t o = 0; o < openings_.all().size(); ++o)
        openings_.set_gate(o, t, dt, x, rooms_[openings_.all()[o].room]);
    for (std::size_t r = 0; r < uniform_->size(); ++r) let_out_of_room(r, dt);
    if (uniform_->size() > 1) pass_between_rooms(t, dt);
    if (heat_loss_.empty()) return;
    samples_.measure(x);
    for (const HeatLoss::Taken& taken : heat_loss_.lose(t, dt, samples_, rooms_)) {
        (*uniform_)[static_cast<std::size_t>(taken.room)].add_heat(-taken.heat);
        lost_energy_ += taken.heat;
    }
}

/// External openings of one room; what has left in dt at a rate that falls with what is left.
void BagGas::let_out_of_room(std::size_t room, double dt) {
    ControlVolume& gas = (*uniform_)[room];
    const std::vector<Opening>& all = openings_.all();
    double flow = 0.0;
    for (std::size_t o = 0; o < all.size(); ++o)
        if (all[o].room == static_cast<Index>(room)) flow += all[o].air_flow;
    const double mass = flow > 0.0 ? -gas.mass() * std::expm1(-flow * dt / gas.mass()) : 0.0;
    if (mass > 0.0) lost_energy_ += gas.remove(mass);
    for (std::size_t o = 0; o < all.size(); ++o) {
        if (all[o].room != static_cast<Index>(room)) continue;
        if (all[o].air_flow > 0.0) openings_.book(o, mass * all[o].air_flow / flow);
        const double taken_in = all[o].intake * dt;
        if (!(taken_in > 0.0)) continue;
        const double energy = taken_in * air_[0].species().h(card_.T_atm);
        gas.add(mass_.size(), taken_in / air_[0].species().molar_mass(), energy);
        inflow_energy_ += energy;
        mass_in_ += taken_in;
    }
}

/// Through internal openings gas goes where the pressure is lower, no more than evens it out.
void BagGas::pass_between_rooms(double t, double dt) {
    const std::vector<Opening>& all = openings_.all();
    const auto holes = static_cast<double>(std::count_if(
        all.begin(), all.end(), [](const Opening& opening) { return opening.is_internal; }));
    for (std::size_t o = 0; o < all.size(); ++o) {
        if (!all[o].is_internal) continue;
        const auto facet = static_cast<std::size_t>(all[o].facets[0]);
        Index from = surface_->room(surface_->side(facet, false)),
              to = surface_->room(surface_->side(facet, true));
        if (from == to) continue;
        if ((*uniform_)[from].pressure() < (*uniform_)[to].pressure()) std::swap(from, to);
        const ControlVolume &giver = (*uniform_)[from], &taker = (*uniform_)[to];
        if (!(giver.pressure() > taker.pressure())) continue;
        const double mass = openings_.flow_between(o, t, rooms_[from], taker.pressure()) * dt;
        uniform_->pass(static_cast<std::size_t>(from), static_cast<std::size_t>(to),
                       std::min(mass, evening_mass(giver, taker) / holes));
    }
}

}  // namespace corpuscle::gas
