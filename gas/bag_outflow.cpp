// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Gas that leaves a bag or goes from room to room, heat that its walls take, and who pays for it.

#include <algorithm>
#include <cmath>
#include <numeric>

#include "gas/bag_gas.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::gas {

/// Mean state of each room's particles and air: p and T of the gas come to rest. They change with
/// what flows only; the pressure of this instant trembles about them.
void BagGas::look_inside(const Points& x) {
    looked_at_ = collisions_;
    surface_->volumes(x, volumes_);
    const std::vector<Holding> holds = holdings();
    const std::size_t kinds = mass_.size();
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        Inside& inside = rooms_[r];
        inside = {};
        inside.density.assign(kinds, 0.0);
        const double volume = volumes_[r];
        EnergyPolynomial content;
        double energy = 0.0, moles = 0.0, mass = 0.0, count = 0.0;
        for (std::size_t s = 0; s < kinds; ++s) {
            const Holding& own = holds[r * kinds + s];
            const double n = own.count * inflators_.moles_each();
            content += n * inflators_.species()[s].molar_energy();
            energy += own.all();
            moles += n;
            mass += own.count * mass_[s];
            count += own.count;
            inside.density[s] = own.count * mass_[s] / volume;
        }
        if (!air_.empty()) {
            content += air_[r].content();
            energy += air_[r].energy();
            moles += air_[r].moles();
            mass += air_[r].mass();
            inside.air_density = air_[r].mass() / volume;
            inside.air_molar_mass = air_[r].species().molar_mass();
        }
        if (!(moles > 0.0 && volume > 0.0 && energy > 0.0)) continue;
        const double T = content.temperature(energy);
        if (!(T > 0.0)) continue;
        double heat = 0.0;  // capacity at constant pressure                             [J/K]
        for (std::size_t s = 0; s < kinds; ++s)
            heat += holds[r * kinds + s].count * mass_[s] * inflators_.species()[s].cp(T);
        if (!air_.empty()) heat += air_[r].mass() * air_[r].species().cp(T);
        const double R = card_.gas_constant;
        inside.temperature = T;
        inside.pressure = moles * R * T / volume;
        inside.air_pressure = air_.empty() ? 0.0 : air_[r].moles() * R * T / volume;
        inside.error =
            count > 0.0 ? (inside.pressure - inside.air_pressure) / count : 0.0;  // one particle
        inside.molar_mass = mass / moles;
        inside.heat_capacity = heat - moles * R;
        inside.gamma = heat / inside.heat_capacity;
    }
}

/// The gas at each opening, on its own side; at an internal one, through which gas goes both ways,
/// the mean of both sides.
void BagGas::look_at_openings() {
    const std::vector<Opening>& all = openings_.all();
    for (std::size_t o = 0; o < all.size(); ++o) {
        Inside& here = at_opening_[o];
        const Inside& room = rooms_[all[o].room];
        if (all[o].is_strong && !all[o].is_internal) {
            // Its own hits are of gas that it has set in motion far and wide.
            here = room;
            continue;
        }
        if (!all[o].is_internal) {
            samples_.state(static_cast<std::size_t>(all[o].sample), room, here);
            continue;
        }
        const auto facet = static_cast<std::size_t>(all[o].facets[0]);
        const Inside& ahead = rooms_[surface_->room(surface_->side(facet, true))];
        here = room.holds_gas() ? room : ahead;
        if (!room.holds_gas() || !ahead.holds_gas()) continue;
        here.pressure = std::midpoint(room.pressure, ahead.pressure);
        here.temperature = std::midpoint(room.temperature, ahead.temperature);
        for (std::size_t s = 0; s < here.density.size(); ++s)
            here.density[s] = std::midpoint(room.density[s], ahead.density[s]);
    }
}

/// Particles that have passed an internal gate are in the room on its other side.
void BagGas::pass_on() {
    for (const auto& arrivals : flight_.arrivals)
        for (const Arrival& arrival : arrivals) {
            if (arrival.passage.way != Gates::Way::THROUGH) continue;
            const auto facet = static_cast<std::size_t>(arrival.facet);
            const Index behind = surface_->room(surface_->side(facet, false)),
                        ahead = surface_->room(surface_->side(facet, true));
            std::int16_t& room = particles_.room[arrival.particle];
            room = static_cast<std::int16_t>(room == behind ? ahead : behind);
        }
}

/// Takes out who has passed and books the energy. Enthalpy that they did not take along is owed by
/// the gas round the opening: the next to hit there pay.
void BagGas::let_out(double dt) {
    const Openings::Passed& passed = openings_.count(flight_, dt, at_opening_, particles_.species);
    lost_energy_ += passed.energy;
    gone_.insert(gone_.end(), passed.rows.begin(), passed.rows.end());
    for (std::size_t o = 0; o < passed.still_owed.size(); ++o) {
        if (passed.still_owed[o] == 0.0) continue;
        load_.charge(samples_.points(static_cast<std::size_t>(openings_.all()[o].sample)),
                     passed.still_owed[o]);
        lost_energy_ += passed.still_owed[o];
    }
    for (std::size_t r = 0; r < air_.size(); ++r) {
        InitialAir& air = air_[r];
        if (const double mass = openings_.intake(r) * dt; mass > 0.0) {
            inflow_energy_ += air.take_in(mass, card_.T_atm);
            mass_in_ += mass;
        }
        const Openings::Air leaving = openings_.air_leaving(r, dt);
        if (leaving.mass <= 0.0) continue;
        // What has left in dt at a rate that falls with what is left.
        const double mass = -air.mass() * std::expm1(-leaving.mass / air.mass());
        const double energy = air.release(mass, leaving.heat);
        openings_.book_air(r, mass);
        lost_energy_ += energy;
    }
}

/// Heat that the fabric takes: those that hit it pay; the air where a room has no particles.
void BagGas::cool(double t, double dt) {
    std::vector<char> has_particles(rooms_.size(), 0);
    for (std::size_t r = 0; r < rooms_.size(); ++r)
        for (const double density : rooms_[r].density) has_particles[r] |= density > 0.0;
    for (const HeatLoss::Taken& taken : heat_loss_.lose(t, dt, samples_, rooms_)) {
        const auto room = static_cast<std::size_t>(taken.room);
        if (has_particles[room])
            load_.charge(samples_.points(static_cast<std::size_t>(taken.sample)), taken.heat);
        else if (!air_.empty())
            air_[room].add(-taken.heat);
        else
            continue;
        lost_energy_ += taken.heat;
    }
}

}  // namespace corpuscle::gas
