// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Gas that leaves a bag or goes from room to room, heat that its walls take, and who pays for it.

#include <algorithm>
#include <cmath>

#include "gas/particle_gas.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::gas {

/// Mean state of each room's particles and air: p and T of the gas come to rest, in its room: at the
/// mean velocity of the walls. They change with what flows only; the pressure of this instant
/// trembles about them.
void ParticleGas::look_inside(double dt, const Points& x_0, const Points& x_1) {
    looked_at_ = cells_.steps();
    bag_.surface->volumes(x_0, bag_.volumes);
    const std::vector<Vec3> way = bag_.surface->mean_way(x_0, x_1);
    const std::vector<Holding> holds = holdings();
    const std::size_t kinds = bag_.particle_mass.size();
    for (std::size_t r = 0; r < bag_.rooms.size(); ++r) {
        Inside& inside = bag_.rooms[r];
        inside = {};
        inside.density.assign(kinds, 0.0);
        const double volume = bag_.volumes[r];
        EnergyPolynomial content;
        double energy = 0.0, moles = 0.0, mass = 0.0, count = 0.0;
        for (std::size_t s = 0; s < kinds; ++s) {
            const Holding& own = holds[r * kinds + s];
            const double n = own.count * bag_.inflators.moles_each();
            content += n * bag_.inflators.species()[s].molar_energy();
            energy += own.about(way[r] / dt);
            moles += n;
            mass += own.mass;
            count += own.count;
            inside.density[s] = volume > 0.0 ? own.mass / volume : 0.0;
        }
        if (!bag_.air.empty()) {
            content += bag_.air[r].content();
            energy += bag_.air[r].energy();
            moles += bag_.air[r].moles();
            mass += bag_.air[r].mass();
            inside.air_density = volume > 0.0 ? bag_.air[r].mass() / volume : 0.0;
            inside.air_molar_mass = bag_.air[r].species().molar_mass();
        }
        if (!(moles > 0.0 && volume > 0.0 && energy > 0.0)) continue;
        const double T = content.temperature(energy);
        if (!(T > 0.0)) continue;
        double heat = 0.0;  // capacity at constant pressure                             [J/K]
        for (std::size_t s = 0; s < kinds; ++s)
            heat += holds[r * kinds + s].mass * bag_.inflators.species()[s].cp(T);
        if (!bag_.air.empty()) heat += bag_.air[r].mass() * bag_.air[r].species().cp(T);
        const double R = bag_.card.gas_constant;
        inside.temperature = T;
        inside.pressure = moles * R * T / volume;
        inside.air_pressure = bag_.air.empty() ? 0.0 : bag_.air[r].moles() * R * T / volume;
        inside.error =
            count > 0.0 ? (inside.pressure - inside.air_pressure) / count : 0.0;  // one particle
        inside.molar_mass = mass / moles;
        inside.heat_capacity = heat - moles * R;
        inside.gamma = heat / inside.heat_capacity;
    }
}

namespace {

/// What a vent drew in the step before; of porous fabric, which is its own sample, nothing.
WallSamples::Drawn drawn_by(const Opening& opening) {
    const double hole = opening.free * opening.area;
    if (opening.vent < 0 || !(hole > 0.0)) return {};
    return {.flux = opening.flow / hole, .size = std::sqrt(hole)};
}

}  // namespace

/// The gas at each opening, on its own side; at an internal hole, through which gas goes both ways,
/// the mean of both sides.
void ParticleGas::look_at_openings() {
    const std::vector<Opening>& all = bag_.openings.all();
    for (std::size_t o = 0; o < all.size(); ++o) {
        Inside& here = at_opening_[o];
        const Inside& room = bag_.rooms[all[o].room];
        if (all[o].is_strong && !all[o].is_internal) {
            // Its own hits are of gas that it has set in motion far and wide.
            here = room;
            continue;
        }
        if (!all[o].is_internal) {
            bag_.samples.state(static_cast<std::size_t>(all[o].sample), room, drawn_by(all[o]),
                               here);
            continue;
        }
        const auto facet = static_cast<std::size_t>(all[o].facets[0]);
        const Inside& ahead = bag_.rooms[bag_.surface->room(bag_.surface->side(facet, true))];
        here = room.pressure >= ahead.pressure ? room : ahead;  // of the one that gives
    }
}

/// Particles that have passed an internal gate are in the room on its other side.
void ParticleGas::pass_on() {
    for (const auto& arrivals : flight_.arrivals)
        for (const Arrival& arrival : arrivals) {
            if (arrival.outcome.fate != Transmission::Fate::THROUGH) continue;
            const auto facet = static_cast<std::size_t>(arrival.facet);
            const Index behind = bag_.surface->room(bag_.surface->side(facet, false)),
                        ahead = bag_.surface->room(bag_.surface->side(facet, true));
            std::int16_t& room = particles_.room[arrival.particle];
            room = static_cast<std::int16_t>(room == behind ? ahead : behind);
        }
}

/// Takes out who has passed and books the energy. Enthalpy that they did not take along is owed by
/// the gas round the opening: the next to hit there pay.
void ParticleGas::let_out(double dt) {
    const Openings::Passed& passed =
        bag_.openings.count(flight_, dt, at_opening_, bag_.rooms, particles_.species);
    bag_.balance.lost_energy += passed.energy;
    gone_.insert(gone_.end(), passed.rows.begin(), passed.rows.end());
    for (std::size_t o = 0; o < passed.still_owed.size(); ++o) {
        if (passed.still_owed[o] == 0.0) continue;
        const Opening& opening = bag_.openings.all()[o];
        bag_.load.charge(bag_.samples.points(static_cast<std::size_t>(opening.sample)),
                         passed.still_owed[o]);
        if (opening.is_internal)
            bag_.load.charge(opening.ahead.points, -passed.still_owed[o]);
        else
            bag_.balance.lost_energy += passed.still_owed[o];
    }
    for (std::size_t r = 0; r < bag_.air.size(); ++r) {
        InitialAir& air = bag_.air[r];
        if (const double mass = bag_.openings.intake(r) * dt; mass > 0.0) {
            bag_.balance.inflow_energy += air.take_in(mass, bag_.card.T_atm);
            bag_.balance.mass_in += mass;
        }
        const Openings::Air leaving = bag_.openings.air_leaving(r, dt);
        if (leaving.mass <= 0.0) continue;
        // What has left in dt at a rate that falls with what is left.
        const double mass = -air.mass() * std::expm1(-leaving.mass / air.mass());
        const double energy = air.release(mass, leaving.heat);
        bag_.openings.book_air(r, mass);
        bag_.balance.lost_energy += energy;
    }
}

/// Initial air goes through internal holes where the pressure is lower, no more than evens it out,
/// and both ways through fabric that seeps. Particles pass by themselves, both ways.
void ParticleGas::pass_air(double t, double dt) {
    const std::vector<Opening>& all = bag_.openings.all();
    const double holes = bag_.openings.holes();
    const auto pass = [&](std::size_t o, std::size_t from, std::size_t to, double most) {
        const double flow = bag_.openings.air_between(o, t, bag_.rooms[from], bag_.rooms[to]);
        if (!(flow > 0.0)) return;
        InitialAir& air = bag_.air[from];
        const double mass = -air.mass() * std::expm1(-std::min(flow * dt, most) / air.mass());
        bag_.air[to].receive(mass, air.release(mass, 1.0));
    };
    for (std::size_t o = 0; o < all.size(); ++o) {
        if (!all[o].is_internal) continue;
        const auto facet = static_cast<std::size_t>(all[o].facets[0]);
        auto from = static_cast<std::size_t>(bag_.surface->room(bag_.surface->side(facet, false))),
             to = static_cast<std::size_t>(bag_.surface->room(bag_.surface->side(facet, true)));
        if (from == to) continue;
        if (bag_.openings.seeps(o)) {
            pass(o, from, to, INF);
            pass(o, to, from, INF);
            continue;
        }
        if (bag_.rooms[from].pressure < bag_.rooms[to].pressure) std::swap(from, to);
        const Inside &giver = bag_.rooms[from], &taker = bag_.rooms[to];
        if (!giver.holds_gas()) continue;
        const double evening =
            (giver.pressure - taker.pressure) /
            (giver.gamma * bag_.card.gas_constant * giver.temperature / giver.air_molar_mass *
             (1.0 / bag_.volumes[from] + 1.0 / bag_.volumes[to]));
        pass(o, from, to, evening / holes);
    }
}

/// Heat that the fabric takes: those that hit it pay, and the air by its share of the pressure.
void ParticleGas::cool(double t, double dt) {
    for (const HeatLoss::Taken& taken : bag_.heat_loss.lose(t, dt, bag_.samples, bag_.rooms)) {
        const auto row = static_cast<std::size_t>(taken.room);
        const Inside& room = bag_.rooms[row];
        if (!room.holds_gas()) continue;
        const double by_air = bag_.air.empty() ? 0.0 : room.air_pressure / room.pressure;
        if (by_air < 1.0)
            bag_.load.charge(bag_.samples.points(static_cast<std::size_t>(taken.sample)),
                             (1.0 - by_air) * taken.heat);
        if (by_air > 0.0) bag_.air[row].add(-by_air * taken.heat);
        bag_.balance.lost_energy += taken.heat;
    }
}

}  // namespace corpuscle::gas
