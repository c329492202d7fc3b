// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// After TSW: gas that leaves a bag, or goes from one of its chambers to another.

#include <algorithm>
#include <cmath>

#include "gas/uniform_gas.hpp"

namespace corpuscle::gas {
namespace {

/// What leaves in a step at a rate that falls with what is left, `wanted` at the rate of its
/// beginning.                                                                                 [kg]
double share_leaving(const ControlVolume& gas, double wanted) {
    return wanted > 0.0 ? -gas.mass() * std::expm1(-wanted / gas.mass()) : 0.0;
}

}  // namespace

/// The gas of a room as its openings see it.
Inside UniformGas::inside_of(std::size_t room) const {
    const ControlVolume& gas = rooms_[room];
    Inside inside;
    inside.is_uniform = true;
    inside.density.assign(bag_.particle_mass.size(), 0.0);
    if (gas.moles() == 0.0) return inside;
    inside.pressure = gas.pressure();
    inside.temperature = gas.temperature();
    inside.molar_mass = gas.mass() / gas.moles();
    inside.gamma = gas.gamma();
    inside.heat_capacity = gas.moles() * bag_.card.gas_constant / (gas.gamma() - 1.0);
    for (std::size_t s = 0; s < bag_.particle_mass.size(); ++s)
        inside.density[s] = gas.mass(s) / gas.volume();
    if (!bag_.air.empty()) {
        inside.air_density = gas.mass(bag_.particle_mass.size()) / gas.volume();
        inside.air_molar_mass = bag_.air[0].species().molar_mass();
    }
    return inside;
}

/// Gas leaves as the mixture that it is in its room, with its enthalpy; heat is drawn from the room
/// whose walls take it.
void UniformGas::let_out(double t, double dt, const Points& x) {
    for (std::size_t r = 0; r < rooms_.size(); ++r) bag_.rooms[r] = inside_of(r);
    for (std::size_t o = 0; o < bag_.openings.all().size(); ++o)
        bag_.openings.set_chances(o, t, dt, x, bag_.rooms[bag_.openings.all()[o].room]);
    bag_.openings.keep_to_balance(dt, bag_.volumes);
    for (std::size_t r = 0; r < rooms_.size(); ++r) let_out_of_room(r, dt);
    if (rooms_.size() > 1) pass_between_rooms(t, dt);
    if (bag_.heat_loss.empty()) return;
    bag_.samples.measure(x);
    for (const HeatLoss::Taken& taken : bag_.heat_loss.lose(t, dt, bag_.samples, bag_.rooms)) {
        rooms_[static_cast<std::size_t>(taken.room)].add_heat(-taken.heat);
        bag_.balance.lost_energy += taken.heat;
    }
}

/// External openings of one room; what has left in dt at a rate that falls with what is left.
void UniformGas::let_out_of_room(std::size_t room, double dt) {
    ControlVolume& gas = rooms_[room];
    const std::vector<Opening>& all = bag_.openings.all();
    double flow = 0.0;
    for (std::size_t o = 0; o < all.size(); ++o)
        if (all[o].room == static_cast<Index>(room)) flow += all[o].air_flow;
    const double mass = share_leaving(gas, flow * dt);
    if (mass > 0.0) bag_.balance.lost_energy += gas.remove(mass);
    for (std::size_t o = 0; o < all.size(); ++o) {
        if (all[o].room != static_cast<Index>(room)) continue;
        if (all[o].air_flow > 0.0) bag_.openings.book(o, mass * all[o].air_flow / flow);
        const double taken_in = all[o].intake * dt;
        if (!(taken_in > 0.0)) continue;
        const double energy = taken_in * bag_.air[0].species().h(bag_.card.T_atm);
        gas.add(bag_.particle_mass.size(), taken_in / bag_.air[0].species().molar_mass(), energy);
        bag_.balance.inflow_energy += energy;
        bag_.balance.mass_in += taken_in;
    }
}

/// Through internal holes gas goes where the pressure is lower, no more than evens it out; fabric that
/// seeps lets the gas of each side through.
void UniformGas::pass_between_rooms(double t, double dt) {
    const std::vector<Opening>& all = bag_.openings.all();
    const double holes = bag_.openings.holes();
    for (std::size_t o = 0; o < all.size(); ++o) {
        if (!all[o].is_internal) continue;
        const auto facet = static_cast<std::size_t>(all[o].facets[0]);
        auto from = static_cast<std::size_t>(bag_.surface->room(bag_.surface->side(facet, false))),
             to = static_cast<std::size_t>(bag_.surface->room(bag_.surface->side(facet, true)));
        if (from == to) continue;
        const auto wanted = [&](std::size_t giver, std::size_t taker) {
            const double out = rooms_[taker].pressure();
            return bag_.openings.flow_between(o, t, bag_.rooms[giver], out) * dt;
        };
        if (bag_.openings.seeps(o)) {
            const double there = share_leaving(rooms_[from], wanted(from, to)),
                         back = share_leaving(rooms_[to], wanted(to, from));
            rooms_.pass(from, to, there);
            rooms_.pass(to, from, back);
            continue;
        }
        if (rooms_[from].pressure() < rooms_[to].pressure()) std::swap(from, to);
        const ControlVolume &giver = rooms_[from], &taker = rooms_[to];
        if (!(giver.pressure() > taker.pressure())) continue;
        rooms_.pass(from, to, std::min(wanted(from, to), evening_mass(giver, taker) / holes));
    }
}

}  // namespace corpuscle::gas
