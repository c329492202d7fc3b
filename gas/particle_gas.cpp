// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/particle_gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gas/flight/bag_lists.hpp"
#include "gas/inflow/resident_air.hpp"
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Share of a cell that fabric may move before facet lists are made anew.
constexpr double MARGIN = 0.15;

/// Cells of the flight's facet lists, in facet edges. Smaller: fewer candidates a particle, more
/// cells.
constexpr double FLIGHT_CELL = 2.25;

/// Reach of the table of safe distances, in paths at thermal speed in a step: one component in two
/// thousand is longer. Farther: fewer look-ups, planes less tight.
constexpr double REACH = 3.5;

/// The same where layers lie closer than that reach: there no distance is safe.
constexpr double THIN_CELL = 1.5;

/// Time over which the pressure is averaged that a part's roughness goes with.       [s]
constexpr double ROUGHNESS_MEMORY = 2e-3;

/// Particles for which memory is set aside at once; pages are taken only when particles come.
constexpr std::size_t MOST_RESERVED = 4'000'000;

/// Entries of a step whose memory is kept for the next: a burst's is given back.
constexpr std::size_t MOST_KEPT = 10'000;

/// Empties a list that is filled anew in each step.
template <class T>
void begin_anew(std::vector<T>& list) {
    list.clear();
    if (list.capacity() > MOST_KEPT) list.shrink_to_fit();
}

/// Widths of the bag that its fabric may go in one step: beyond, particles meet it without end.
constexpr double FARTHEST = 1000.0;

constexpr std::size_t MOST_LOSSES = 20;  ///< that are told one by one

Collider collider_of(const Envelope& bag, std::uint64_t seed) {
    const Inflators& inflators = bag.inflators;
    if (bag.card.collision)
        return {inflators.species(), inflators.moles_each(), seed, *bag.card.collision,
                bag.card.mean_free_path};
    return {inflators.species(), inflators.moles_each(), seed};
}

/// sqrt(R T / M) of the lightest gas at the highest temperature.                       [m/s]
double first_speed(const Envelope& bag) {
    double lightest = INF;
    for (const Species& species : bag.inflators.species())
        lightest = std::min(lightest, species.molar_mass());
    return std::sqrt(bag.card.gas_constant * bag.inflators.highest_temperature() / lightest);
}

}  // namespace

ParticleGas::ParticleGas(Envelope& bag, std::span<const Curve> curves, const Points& x,
                         std::uint64_t seed)
    : bag_(bag),
      lists_(bag.surface->triangles(), x, FacetLists::Of::EIGHTS),
      facet_size_(std::sqrt(2.0 * bag.enclosure.area(x) / static_cast<double>(bag.walls.closing))),
      collider_(collider_of(bag, seed)),
      cells_(bag.surface->triangles(), bag.walls.closing, x, bag.enclosure.volume(x),
             bag.card.particles, first_speed(bag)),
      roughness_(bag.card, bag.walls, bag.surface, curves,
                 ROUGHNESS_MEMORY * bag.card.second * bag.card.smoothing),
      at_opening_(bag.openings.all().size()) {
    if (!bag.air.empty())
        for (const Opening& opening : bag.openings.all()) holes_of_air_ += opening.is_internal;
    const Inflators& inflators = bag.inflators;
    particles_.reserve(std::min(inflators.particles() + inflators.resident(), MOST_RESERVED));
    if (inflators.resident() > 0) fill_with_air(x, seed);
}

/// Initial air as particles. The fabric feels it from the start.
void ParticleGas::fill_with_air(const Points& x, std::uint64_t seed) {
    const std::size_t row = bag_.inflators.inflows();
    add_resident_air({bag_.inflators.resident(), static_cast<std::int32_t>(row),
                      static_cast<std::int32_t>(bag_.inflators.particles()),
                      bag_.particle_mass[row], bag_.card.air->temperature},
                     bag_.inflators.species()[row], bag_.enclosure, *bag_.surface, x, seed,
                     bag_.name(), particles_);
    if (const std::size_t asked = bag_.card.air->particles;
        asked > 0 && asked != bag_.inflators.resident())
        bag_.warnings.push_back(
            fmt::format("{}: all particles stand for as many moles, so that initial air is {} of "
                        "all {} particles "
                        "instead of the {} asked for",
                        bag_.name(), bag_.inflators.resident(),
                        bag_.inflators.resident() + bag_.inflators.particles(), asked));
    if (bag_.surface->rooms() > 1)
        for (const Index room : bag_.surface->rooms_of(particles_.x, x))
            particles_.room.push_back(static_cast<std::int16_t>(room));
    const InitialAirCard& air = *bag_.card.air;
    const double M = air.species.molar_mass;
    const double density = air.pressure * M / (bag_.card.gas_constant * air.temperature);
    bag_.load.begin_with(air.pressure,
                         density * effusion_speed(air.temperature, bag_.card.gas_constant, M), x);
}

// ---- what initial air does to the walls

void ParticleGas::add_load(const Points& /*x*/, Points& f) {
    if (bag_.air.empty()) return;
    for (std::size_t r = 0; r < bag_.air.size(); ++r)
        if (!bag_.air[r].settle(bag_.volumes[r])) stop_for_air(r);
    air_force_.resize(f.size(), Vec3::Zero());
    bag_.load.press(air_pressures(), air_force_, f);
}

void ParticleGas::book_load(const Points& /*v_mid*/, double span) {
    for (std::size_t r = 0; r < bag_.air.size(); ++r) bag_.air[r].work(span * bag_.load.swept(r));
}

/// Stops for initial air that has no state in its room.
void ParticleGas::stop_for_air(std::size_t room) const {
    throw PhysicsError(
        bag_.time,
        fmt::format("{}{}: the volume is {:g} and the initial air holds {:g} of energy",
                    bag_.name(),
                    bag_.air.size() == 1 ? std::string() : fmt::format(", room {}", room + 1),
                    bag_.volumes[room], bag_.air[room].energy()));
}

/// Of initial air in each room.                                                            [Pa]
std::vector<double> ParticleGas::air_pressures() const {
    std::vector<double> of_room(bag_.surface->rooms());
    for (std::size_t r = 0; r < of_room.size(); ++r) of_room[r] = pressure(r);
    return of_room;
}

// ---- the gas itself

void ParticleGas::prepare(double dt, const Points& x_0, const Points& x_1) {
    if (lists_.hold_for(x_1)) return;
    if (const double far = displacement_over_size(lists_, x_0, x_1); !(far < FARTHEST))
        throw PhysicsError(bag_.time,
                           fmt::format("{}: its fabric goes {:.3g} times the bag's size in "
                                       "one step: it is too light for its load, "
                                       "or what moves it is too fast",
                                       bag_.name(), far));
    const double reach = REACH * cells_.speed() * dt;
    const bool is_thin = 2.0 * bag_.enclosure.volume(x_0) < reach * bag_.enclosure.area(x_0);
    const double cell = (is_thin ? THIN_CELL : FLIGHT_CELL) * facet_size_;
    build_over_bag(lists_, cell, MARGIN * cell, is_thin ? 0.0 : reach, x_0, x_1);
}

void ParticleGas::inject(double t, double dt, const Points& x_0, const Points& x_1) {
    begin_anew(entries_);
    begin_anew(born_);
    if (const int passed = bag_.orifices.passed_by_fabric(lists_, x_0, x_1); passed >= 0) {
        const Vec3 at = bag_.orifices.place(static_cast<std::size_t>(passed), x_1);
        throw PhysicsError(t, fmt::format("{}: fabric passes over orifice {} at ({:g}, {:g}, {:g})",
                                          bag_.name(), passed + 1, at[0], at[1], at[2]));
    }
    bag_.orifices.axes(x_0, bag_.axes);
    bag_.inflators.entering(t + dt, bag_.axes, entries_);
    for (const Entry& entry : entries_) let_in(entry, t, dt, x_0, x_1);
}

/// A particle enters where its orifice is at its time, or a part of a step before (Orifices).
void ParticleGas::let_in(const Entry& entry, double t, double dt, const Points& x_0,
                         const Points& x_1) {
    const auto orifice = static_cast<std::size_t>(entry.orifice);
    const Vec3 from = bag_.orifices.place(orifice, x_0), to = bag_.orifices.place(orifice, x_1);
    const double share = std::clamp((entry.time - t) / dt, 0.0, 1.0);
    const Vec3 v = entry.velocity + (to - from) / dt;
    const double mass = bag_.particle_mass[entry.inflow];
    if (!std::isfinite(mass * v.squaredNorm() + entry.internal))
        throw PhysicsError(
            t, fmt::format("{}: what inflow {} brings through orifice {} is not finite: speed "
                           "{:g}, internal energy {:g}",
                           bag_.name(), entry.inflow + 1, entry.orifice + 1, v.norm(),
                           entry.internal));
    const Birth birth = bag_.orifices.birth(orifice, share, x_0, x_1);
    born_.push_back(birth.share);
    const double motion = 0.5 * mass * v.squaredNorm();
    const double internal =
        entry.internal + bag_.load.pay_jets(bag_.orifice_room[orifice], entry.internal, motion);
    particles_.add(birth.at, v, internal, entry.inflow, entry.id);
    if (bag_.surface->rooms() > 1)
        particles_.room.push_back(static_cast<std::int16_t>(bag_.orifice_room[orifice]));
    bag_.balance.inflow_energy += motion + entry.internal;
    bag_.push_back(orifice, from, mass * entry.velocity, (to - from) / dt);
    bag_.balance.mass_in += mass;
}

void ParticleGas::fly(double t, double dt, const Points& x_0, const Points& x_1) {
    if (bag_.loses() && (cells_.steps() != looked_at_ || cells_.steps() == 0 ||
                         holes_of_air_ > 0.0 || (bag_.card.air && bag_.card.air->flows_in)))
        look_inside(dt, x_0, x_1);
    if (!bag_.openings.empty()) {
        look_at_openings();
        bag_.openings.set_transmission(t, dt, x_0, at_opening_, bag_.rooms);
        bag_.openings.keep_to_balance(dt, bag_.volumes);
    }
    try {
        gas::fly(lists_, x_0, x_1, dt, bag_.particle_mass, born_, particles_, flight_,
                 bag_.openings.transmission(), roughness_.now());
    } catch (const BrokenParticle& broken) {
        stop_for(broken.row, broken.in_flight ? "in its flight, where it met a facet"
                                              : "before its flight, after collisions and inflow");
    }
    flights_ += particles_.size();
    bag_.load.find_sides(flight_, x_0, x_1);
    bag_.samples.receive(bag_.load.hits(), dt, x_0, x_1, bag_.rooms, particles_);
    bag_.load.receive(flight_, bag_.particle_mass, particles_);
    if (roughness_.follows_pressure())
        roughness_.receive(flight_, bag_.load.hits(), dt, air_pressures(), x_1);
    bag_.monitor.record(bag_.load.hits(), x_1);
    hits_ += bag_.load.hits().size();
    gone_.clear();
    if (!flight_.lost.empty()) book_lost(t);
    if (!particles_.room.empty()) pass_on();
    if (!bag_.openings.empty()) let_out(dt);
    if (holes_of_air_ > 0.0) pass_air(t, dt);
    if (!bag_.heat_loss.empty()) cool(t, dt);
    std::sort(gone_.begin(), gone_.end());
    particles_.erase(gone_);
}

/// Stops for a particle that is not finite.
void ParticleGas::stop_for(std::size_t particle, const char* when) const {
    const Vec3 &at = particles_.x[particle], &v = particles_.v[particle];
    const std::size_t row = static_cast<std::size_t>(particles_.species[particle]);
    throw PhysicsError(
        bag_.time,
        fmt::format("{}: particle {} of {} near ({:g}, {:g}, {:g}) is not finite {}: "
                    "velocity ({:g}, {:g}, {:g}), internal energy {:g}",
                    bag_.name(), particles_.id[particle],
                    row == bag_.inflators.inflows() ? std::string("the initial air")
                                                    : fmt::format("gas {}", row + 1),
                    at[0], at[1], at[2], when, v[0], v[1], v[2], particles_.e[particle]));
}

void ParticleGas::book_lost(double t) {
    for (const Lost& lost : flight_.lost) {
        const std::size_t i = lost.particle;
        bag_.balance.lost_energy +=
            0.5 * bag_.particle_mass[particles_.species[i]] * particles_.v[i].squaredNorm() +
            particles_.e[i];
        gone_.push_back(i);
        if (losses_.size() == MOST_LOSSES) continue;
        losses_.push_back(
            fmt::format("{}: particle {} was lost at time {:g} near ({:g}, {:g}, {:g}), "
                        "caught between closing facets",
                        bag_.name(), particles_.id[i], t, lost.at[0], lost.at[1], lost.at[2]));
    }
    lost_ += flight_.lost.size();
}

void ParticleGas::freeze(std::span<const Vec3> wall) {
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        particles_.e[i] += 0.5 * bag_.particle_mass[particles_.species[i]] *
                           (particles_.v[i] - wall[particles_.room_of(i)]).squaredNorm();
        particles_.v[i].setZero();
    }
}

}  // namespace corpuscle::gas
