// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// After TSW: the bag's gas at uniform pressure, its particles frozen.

#include <algorithm>
#include <cmath>

#include "gas/bag_gas.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

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

}  // namespace

bool BagGas::switches(double t) const {
    constexpr double ROUNDING = 1e-12;  // t is a sum of many steps
    return !uniform_ && t >= card_.switch_at * (1.0 - ROUNDING);
}

/// Mass, energy and so temperature stay as they are, room by room; motion becomes heat.
/// Uniform pressure takes the place of what hits gave on average; what they have brought beyond it
/// is still released.
void BagGas::become_uniform(const Points& x) {
    if (inflators_.species().empty() && air_.empty()) return;
    surface_->volumes(x, volumes_);
    open_rooms();
    sum_up();
    settle(x);
    std::vector<double> pressure;
    for (std::size_t r = 0; r < uniform_->size(); ++r)
        pressure.push_back((*uniform_)[r].pressure() -
                           (air_.empty() ? 0.0 : air_[r].pressure(volumes_[r])));
    load_.end_of_hits(pressure, x);
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        particles_.e[i] += 0.5 * mass_[particles_.species[i]] * particles_.v[i].squaredNorm();
        particles_.v[i].setZero();
    }
}

/// Rooms at uniform pressure, empty as yet.
void BagGas::open_rooms() {
    std::vector<Species> kinds = inflators_.species();
    if (!air_.empty()) kinds.push_back(air_[0].species());
    uniform_.emplace(surface_, std::vector<ControlVolume>(surface_->rooms(), ControlVolume(kinds)),
                     area_.size());
}

/// Puts what each room's particles and initial air hold into the room.
void BagGas::sum_up() {
    const std::vector<Holding> holds = holdings();
    const std::size_t kinds = mass_.size();
    for (std::size_t r = 0; r < uniform_->size(); ++r) {
        ControlVolume& gas = (*uniform_)[r];
        for (std::size_t s = 0; s < kinds; ++s) {
            const Holding& own = holds[r * kinds + s];
            gas.add(s, own.count * inflators_.moles_each(), own.all());
        }
        if (!air_.empty()) gas.add(kinds, air_[r].moles(), air_[r].energy());
    }
}

void BagGas::settle(const Points& x) {
    if (uniform_->settle(x)) return;
    for (std::size_t r = 0; r < uniform_->size(); ++r) {
        const ControlVolume& gas = (*uniform_)[r];
        if (gas.volume() > 0.0 && gas.temperature() >= 0.0 && gas.pressure() < INF) continue;
        throw PhysicsError(
            time_,
            fmt::format("*AIRBAG_PARTICLE {}{}: at uniform pressure the volume is {:g} and "
                        "the gas holds {:g} of energy",
                        card_.id,
                        uniform_->size() == 1 ? std::string() : fmt::format(", room {}", r + 1),
                        gas.volume(), gas.energy()));
    }
}

/// Gas flows in by its curve; the smoothing account is paid back as fast as impulse is released.
void BagGas::flow_uniform(double t, double dt, const Points& x, const Points& x_1) {
    orifices_.axes(x, axes_);
    for (std::size_t s = 0; s < inflators_.inflows(); ++s) {
        const double mass = inflators_.mass_until(s, t + dt) - inflators_.mass_until(s, t);
        if (!(mass > 0.0)) continue;
        const double energy = mass * inflators_.enthalpy(s, t + 0.5 * dt);
        const double moles = mass / inflators_.species()[s].molar_mass();
        for (std::size_t o = 0; o < orifices_.size(); ++o) {
            const double share = inflators_.share(s, o);
            (*uniform_)[static_cast<std::size_t>(orifice_room_[o])].add(s, share * moles,
                                                                        share * energy);
        }
        inflow_energy_ += energy;
        mass_in_ += mass;
        thrust(s, mass, t + 0.5 * dt, dt, x, x_1);
    }
    for (std::size_t r = 0; r < uniform_->size(); ++r)
        (*uniform_)[r].add_heat(settled_account(load_, r, (*uniform_)[r], dt) +
                                (r == 0 ? load_.pay_jets() : 0.0));
    if (!openings_.empty() || !heat_loss_.empty()) let_out_uniform(t, dt, x);
}

/// The jets of what an inflow brings push their nodes (IMOM = 1) as they do with particles; the gas
/// at uniform pressure takes nothing of their momentum on.
void BagGas::thrust(std::size_t inflow, double mass, double t, double dt, const Points& x_0,
                    const Points& x_1) {
    for (std::size_t o = 0; o < orifices_.size(); ++o) {
        const double share = inflators_.share(inflow, o);
        if (share == 0.0 || orifices_.pushed(o).empty()) continue;
        const Vec3 moving = (orifices_.place(o, x_1) - orifices_.place(o, x_0)) / dt;
        push_back(o, orifices_.place(o, x_0), share * mass * inflators_.jet(inflow, o, t, axes_[o]),
                  moving);
    }
}

GasState BagGas::uniform_state(const Points& x) const {
    GasState now;
    now.volume = enclosure_.volume(x);
    now.area = enclosure_.area(x);
    now.mass_in = mass_in_;
    now.mass_out_vent = openings_.mass_out(true);
    now.mass_out_fabric = openings_.mass_out(false);
    now.particles_out = static_cast<double>(openings_.particles_out());
    now.mass = uniform_->mass();
    now.pressure = uniform_->pressure();
    now.temperature = uniform_->temperature();
    now.energy = uniform_->energy();
    now.translational = 1.5 * now.pressure * now.volume;
    const auto include = [&](std::size_t s) {
        const double T = now.temperature;
        const double moles = uniform_->moles(s), energy = uniform_->energy(s);
        const Species& gas = (*uniform_)[0].species()[s];
        // In several rooms a gas has several temperatures: that of what it holds.
        const double of_gas =
            uniform_->size() == 1 ? T : (moles * gas.molar_energy()).temperature(energy, T);
        now.species.push_back({moles * gas.molar_mass(), moles > 0.0 ? of_gas : 0.0, energy});
    };
    if (card_.air) include(inflators_.inflows());
    for (std::size_t s = 0; s < inflators_.inflows(); ++s) include(s);
    return now;
}

}  // namespace corpuscle::gas
