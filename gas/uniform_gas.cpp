// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/uniform_gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace corpuscle::gas {
namespace {

/// Share of what a room's gas holds that it pays in one step at most.
constexpr double MOST_PAID = 0.25;

/// What the accounts at a room's wall give to its gas in dt, as fast as impulse is released; what
/// would be more than the gas can pay stays there.                                      [J]
double settled_account(WallLoad& load, std::size_t room, const ControlVolume& gas, double dt) {
    const double settled = load.drain(room, -std::expm1(-dt / load.time()));
    const double most = gas.moles() > 0.0 ? MOST_PAID * std::max(0.0, gas.energy()) : 0.0;
    if (settled >= -most) return settled;
    std::vector<Index> wall;
    for (std::size_t p = 0; p < load.surface().points(); ++p)
        if (load.surface().room_of_point(p) == static_cast<Index>(room))
            wall.push_back(static_cast<Index>(p));
    load.charge(wall, -settled - most);
    return -most;
}

/// Rooms at uniform pressure, empty as yet.
UniformRooms empty_rooms(const Envelope& bag) {
    std::vector<Species> kinds = bag.inflators.species();
    if (!bag.air.empty()) kinds.push_back(bag.air[0].species());
    return {bag.surface, std::vector<ControlVolume>(bag.surface->rooms(), ControlVolume(kinds)),
            bag.area.size()};
}

}  // namespace

UniformGas::UniformGas(Envelope& bag) : bag_(bag), rooms_(empty_rooms(bag)) {}

void UniformGas::take_over(std::span<const Holding> holds, std::span<const Vec3> wall,
                           const Points& x) {
    bag_.surface->volumes(x, bag_.volumes);
    sum_up(holds, wall);
    settle(x);
    std::vector<double> of_hits;
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        of_hits.push_back(rooms_[r].pressure() - (bag_.air.empty() ? 0.0 : bag_.air[r].pressure()));
        if (!bag_.air.empty()) rooms_[r].add_heat(-bag_.air[r].worked());
    }
    bag_.load.end_of_hits(of_hits, x);
}

/// Puts what each room's particles and initial air hold into the room. A gas that is uniform has no
/// momentum, so that none of its energy is that of motion with the room.
void UniformGas::sum_up(std::span<const Holding> holds, std::span<const Vec3> wall) {
    const std::size_t kinds = bag_.particle_mass.size();
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        ControlVolume& gas = rooms_[r];
        for (std::size_t s = 0; s < kinds; ++s) {
            const Holding& own = holds[r * kinds + s];
            const double kept = own.about(wall[r]);
            gas.add(s, own.count * bag_.inflators.moles_each(), kept);
            bag_.balance.lost_energy += own.all() - kept;
        }
        if (!bag_.air.empty()) gas.add(kinds, bag_.air[r].moles(), bag_.air[r].energy());
    }
}

void UniformGas::add_load(const Points& x, Points& f) {
    settle(x);
    rooms_.add_force(f);
}

void UniformGas::settle(const Points& x) {
    if (rooms_.settle(x, bag_.volumes)) return;
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        const ControlVolume& gas = rooms_[r];
        if (gas.volume() > 0.0 && gas.temperature() >= 0.0 && gas.pressure() < INF) continue;
        throw PhysicsError(
            bag_.time,
            fmt::format("{}{}: at uniform pressure the volume is {:g} and "
                        "the gas holds {:g} of energy",
                        bag_.name(),
                        rooms_.size() == 1 ? std::string() : fmt::format(", room {}", r + 1),
                        gas.volume(), gas.energy()));
    }
}

/// Gas flows in by its curve; the smoothing account is paid back as fast as impulse is released.
void UniformGas::inject(double t, double dt, const Points& x, const Points& x_1) {
    bag_.orifices.axes(x, bag_.axes);
    for (std::size_t s = 0; s < bag_.inflators.inflows(); ++s) {
        const double mass = bag_.inflators.mass_until(s, t + dt) - bag_.inflators.mass_until(s, t);
        if (!(mass > 0.0)) continue;
        const double energy = mass * bag_.inflators.enthalpy(s, t + 0.5 * dt);
        const double moles = mass / bag_.inflators.species()[s].molar_mass();
        for (std::size_t o = 0; o < bag_.orifices.size(); ++o) {
            const double share = bag_.inflators.share(s, o);
            rooms_[static_cast<std::size_t>(bag_.orifice_room[o])].add(s, share * moles,
                                                                       share * energy);
        }
        bag_.balance.inflow_energy += energy;
        bag_.balance.mass_in += mass;
        thrust(s, mass, t + 0.5 * dt, dt, x, x_1);
    }
    for (std::size_t r = 0; r < rooms_.size(); ++r)
        rooms_[r].add_heat(settled_account(bag_.load, r, rooms_[r], dt) +
                           bag_.load.pay_jets(static_cast<Index>(r)));
    if (bag_.loses()) let_out(t, dt, x);
}

/// The jets of what an inflow brings push their nodes (IMOM = 1) as they do with particles; the gas
/// at uniform pressure takes nothing of their momentum on.
void UniformGas::thrust(std::size_t inflow, double mass, double t, double dt, const Points& x_0,
                        const Points& x_1) {
    for (std::size_t o = 0; o < bag_.orifices.size(); ++o) {
        const double share = bag_.inflators.share(inflow, o);
        if (share == 0.0 || bag_.orifices.pushed(o).empty()) continue;
        const Vec3 moving = (bag_.orifices.place(o, x_1) - bag_.orifices.place(o, x_0)) / dt;
        bag_.push_back(o, bag_.orifices.place(o, x_0),
                       share * mass * bag_.inflators.jet(inflow, o, t, bag_.axes[o]), moving);
    }
}

void UniformGas::describe(GasState& now) const {
    now.mass = rooms_.mass();
    now.pressure = rooms_.pressure();
    now.temperature = rooms_.temperature();
    now.static_pressure = now.pressure;
    now.static_temperature = now.temperature;
    now.energy = rooms_.energy();
    now.translational = 1.5 * now.pressure * now.volume;
    const auto include = [&](std::size_t s) {
        const double T = now.temperature;
        const double moles = rooms_.moles(s), energy = rooms_.energy(s);
        const Species& gas = rooms_[0].species()[s];
        // In several rooms a gas has several temperatures: that of what it holds.
        const double of_gas =
            rooms_.size() == 1 ? T : (moles * gas.molar_energy()).temperature(energy, T);
        now.species.push_back({moles * gas.molar_mass(), moles > 0.0 ? of_gas : 0.0, energy});
    };
    if (bag_.card.air) include(bag_.inflators.inflows());
    for (std::size_t s = 0; s < bag_.inflators.inflows(); ++s) include(s);
}

void UniformGas::add_rooms(std::span<const double> volume, std::span<const Index> sum_of,
                           std::span<ChamberSum> sums) const {
    for (std::size_t r = 0; r < rooms_.size(); ++r) {
        if (sum_of[r] < 0) continue;
        ChamberSum& sum = sums[static_cast<std::size_t>(sum_of[r])];
        const ControlVolume& gas = rooms_[r];
        sum.state.mass += gas.mass();
        sum.state.energy += gas.energy();
        sum.pV += gas.pressure() * volume[r];
        for (std::size_t s = 0; s < gas.species().size(); ++s)
            sum.content += gas.moles(s) * gas.species()[s].molar_energy();
    }
}

}  // namespace corpuscle::gas
