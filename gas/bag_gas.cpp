// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/bag_gas.hpp"
#include "gas/thermo/orifice_flow.hpp"

#include <algorithm>
#include <cmath>

#include "gas/inflow/resident_air.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Impulse is released over this time at SFFDC = 1. Shorter: prompter and noisier. [s]
constexpr double RELEASE_TIME = 50e-6;

/// Particles in a cell of the full bag that the first cells are meant for.
constexpr double FIRST_PARTICLES_PER_CELL = 40.0;

/// Share of a cell that fabric may move before facet lists are made anew.
constexpr double MARGIN = 0.15;

/// Cells of the flight's facet lists, in facet edges. Smaller: fewer candidates a particle, more
/// cells.
constexpr double FLIGHT_CELL = 2.25;

/// Reach of the table of free ways, in ways of thermal speed in a step: one component in two
/// thousand is longer. Farther: fewer look-ups, planes less tight.
constexpr double REACH = 3.5;

/// The same where layers lie closer than that reach: there no way is free.
constexpr double THIN_CELL = 1.5;

/// Time over which the pressure is averaged that a part's roughness goes with.       [s]
constexpr double ROUGHNESS_MEMORY = 2e-3;

/// Longest time over which the state of the gas at an opening is averaged.           [s]
constexpr double LONGEST_MEMORY = 200e-6;

constexpr std::size_t MOST_CELLS = 2'000'000;

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

/// The way from x_0 to x_1 as a multiple of the bag's size.
double ways_of_size(const FacetLists& lists, const Points& x_0, const Points& x_1) {
    contact::Box box;
    for (const Index n : lists.nodes()) box.include(x_0[n]);
    const double size = (box.high - box.low).maxCoeff();
    for (const Index n : lists.nodes()) box.include(x_1[n]);
    return (box.high - box.low).maxCoeff() / size;
}

constexpr std::size_t MOST_LOSSES = 20;  ///< that are told one by one

std::string name_of(const BagCard& card) {
    return fmt::format("*AIRBAG_PARTICLE {}", card.id);
}

std::vector<Triangle> closing(const BagWalls& walls) {
    return {walls.triangles.begin(),
            walls.triangles.begin() + static_cast<std::ptrdiff_t>(walls.closing)};
}

/// All triangles, the closing ones as the enclosure has turned them.
std::vector<Triangle> turned(const Enclosure& enclosure, const BagWalls& walls) {
    std::vector<Triangle> all = walls.triangles;
    std::copy(enclosure.triangles().begin(), enclosure.triangles().end(), all.begin());
    return all;
}

std::vector<double> particle_masses(const Inflators& inflators) {
    std::vector<double> mass;
    for (const Species& species : inflators.species())
        mass.push_back(inflators.moles_each() * species.molar_mass());
    return mass;
}

/// Nodes that the jets push.
std::vector<Index> jet_nodes(const Orifices& orifices) {
    std::vector<Index> nodes;
    for (std::size_t o = 0; o < orifices.size(); ++o)
        nodes.insert(nodes.end(), orifices.pushed(o).begin(), orifices.pushed(o).end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

Collider collider_of(const BagCard& card, const Inflators& inflators, std::uint64_t seed) {
    if (card.collision)
        return {inflators.species(), inflators.moles_each(), seed, *card.collision,
                card.mean_free_path};
    return {inflators.species(), inflators.moles_each(), seed};
}

}  // namespace

BagGas::BagGas(const BagCard& card, BagWalls walls, std::span<const Curve> curves,
               std::span<const int> node_id, std::span<const std::uint8_t> held, const Points& x,
               std::uint64_t seed)
    : card_(card),
      walls_(std::move(walls)),
      enclosure_(closing(walls_), x, node_id, name_of(card) + ", SID1"),
      chambers_(card.chambers, walls_, enclosure_, node_id, x, name_of(card)),
      inflators_(card, curves, seed, enclosure_.volume(x)),
      mass_(particle_masses(inflators_)),
      lists_(turned(enclosure_, walls_), x, FacetLists::Of::EIGHTS),
      side_lists_(lists_.triangles(), x, FacetLists::Of::FACETS),
      orifices_(card.orifices, lists_.triangles(), walls_.triangles, walls_.shell, card.frame, x),
      surface_(std::make_shared<WettedSurface>(lists_.triangles(), walls_.closing, x)),
      load_(surface_, held, jet_nodes(orifices_), RELEASE_TIME * card.second * card.smoothing,
            card.normal_damping),
      collider_(collider_of(card, inflators_, seed)),
      samples_(card.vents.empty() && walls_.leaks.empty() && card.heat.empty()
                   ? WallSamples()
                   : WallSamples(surface_, walls_, inflators_.species(), mass_, card.gas_constant,
                                 LONGEST_MEMORY * card.second, passing_facets(), x)),
      openings_(card, walls_, curves, inflators_.species(), mass_, *surface_, samples_, x, seed),
      heat_loss_(card, walls_, *surface_, samples_, curves),
      roughness_(card, walls_, curves, ROUGHNESS_MEMORY * card.second * card.smoothing),
      area_(x.size(), Vec3::Zero()),
      part_impulse_(walls_.part_ids.size(), 0.0),
      triangle_impulse_(walls_.triangles.size(), 0.0),
      part_air_(surface_->rooms(), 0.0),
      triangle_air_(part_air_) {
    surface_->volumes(x, volumes_);
    const double volume = enclosure_.volume(x);
    if (!(volume > 0.0))
        throw InputError(name_of(card) +
                         ", SID1: the bag encloses no volume at the start, expected some: "
                         "particles have no place to enter");
    if (card.air && !card.air->is_particles)
        for (const double room : volumes_) air_.emplace_back(*card.air, card.gas_constant, room);
    rooms_.resize(surface_->rooms());
    if (!chambers_.empty()) {
        chamber_of_room_.assign(surface_->rooms(), 0);
        for (std::size_t f = 0; f < walls_.closing; ++f) {
            const auto [a, b] = chambers_.beside(f);
            chamber_of_room_[surface_->room(surface_->side(f, false))] = std::max(a, b);
        }
    }
    at_opening_.resize(openings_.all().size());
    particles_.reserve(std::min(inflators_.particles() + inflators_.resident(), MOST_RESERVED));
    if (inflators_.resident() > 0) fill_with_air(x, seed);
    if (enclosure_.turned() > 0)
        warnings_.push_back(
            fmt::format("{}: the normals of {} facets were turned to agree with their "
                        "neighbours",
                        name_of(card), enclosure_.turned()));
    std::vector<std::string> faults;
    for (std::size_t o = 0; o < orifices_.size(); ++o)
        if (const Vec3 at = orifices_.place(o, x); !enclosure_.contains(at, x))
            faults.push_back(fmt::format(
                "{}, NID of orifice {}: ({:g}, {:g}, {:g}) lies outside the bag, expected inside",
                name_of(card), o + 1, at[0], at[1], at[2]));
    if (!faults.empty()) throw InputError(std::move(faults));

    facet_size_ = std::sqrt(2.0 * enclosure_.area(x) / static_cast<double>(walls_.closing));

    double lightest = INF;
    for (const Species& species : inflators_.species())
        lightest = std::min(lightest, species.molar_mass());
    speed_ = std::sqrt(card.gas_constant * inflators_.highest_temperature() / lightest);
    cell_ = wanted_cell_ = cell_edge(volume, card.particles, FIRST_PARTICLES_PER_CELL);
    std::vector<Vec3> nozzles;
    for (std::size_t o = 0; o < orifices_.size(); ++o) nozzles.push_back(orifices_.place(o, x));
    orifice_room_ = surface_->rooms_of(nozzles, x);
}

/// By facet: 1 where particles may pass without a full bounce, vents and what is internal.
std::vector<char> BagGas::passing_facets() const {
    std::vector<char> passes(walls_.triangles.size(), 0);
    for (std::size_t f = 0; f < passes.size(); ++f) {
        const Index part = walls_.part_rows[walls_.part[f]];
        const bool leaks = f >= walls_.closing &&
                           std::any_of(walls_.leaks.begin(), walls_.leaks.end(),
                                       [&](const LeakCard& leak) { return leak.part == part; });
        const bool is_vent =
            std::any_of(card_.vents.begin(), card_.vents.end(), [&](const VentCard& vent) {
                return std::find(vent.parts.begin(), vent.parts.end(), part) != vent.parts.end();
            });
        passes[f] = leaks || is_vent;
    }
    return passes;
}

/// Initial air as particles. The fabric feels it from the start.
void BagGas::fill_with_air(const Points& x, std::uint64_t seed) {
    const std::size_t row = inflators_.inflows();
    add_resident_air(
        {inflators_.resident(), static_cast<std::int32_t>(row),
         static_cast<std::int32_t>(inflators_.particles()), mass_[row], card_.air->temperature},
        inflators_.species()[row], enclosure_, x, seed, name_of(card_), particles_);
    if (const std::size_t asked = card_.air->particles; asked > 0 && asked != inflators_.resident())
        warnings_.push_back(fmt::format(
            "{}: all particles stand for as many moles, so that initial air is {} of NP + NPAIR = "
            "{} particles instead of NPAIR = {}",
            name_of(card_), inflators_.resident(), inflators_.resident() + inflators_.particles(),
            asked));
    if (surface_->rooms() > 1)
        for (const Index room : surface_->rooms_of(particles_.x, x))
            particles_.room.push_back(static_cast<std::int16_t>(room));
    const InitialAirCard& air = *card_.air;
    const double M = air.species.molar_mass;
    const double density = air.pressure * M / (card_.gas_constant * air.temperature);
    load_.begin_with(air.pressure, density * effusion_speed(air.temperature, card_.gas_constant, M),
                     x);
}

// ---- the load on the fabric
// -----------------------------------------------------------------------

void BagGas::add_load(const Points& x, const Points& v, std::span<const double> mass, double span,
                      Points& f) {
    surface_->volumes(x, volumes_);
    enclosure_.node_areas(x, area_);
    load_.release(span, x, v, mass, f);
    if (uniform_) settle(x);
    if (uniform_)
        uniform_->add_force(f);
    else if (!air_.empty())
        press_with_air(f);
    for (const Index n : enclosure_.nodes()) f[n] -= card_.p_atm * area_[n];
}

void BagGas::press_with_air(Points& f) {
    std::vector<double> pressure(surface_->rooms());
    for (std::size_t r = 0; r < pressure.size(); ++r) pressure[r] = air_pressure(r);
    air_force_.resize(f.size(), Vec3::Zero());
    load_.press(pressure, air_force_);
    const auto& nodes = lists_.nodes();
    parallel::for_each(nodes.size(), [&](std::size_t i) { f[nodes[i]] += air_force_[nodes[i]]; });
}

double BagGas::air_pressure() const {
    if (uniform_) return uniform_->pressure();
    if (air_.empty()) return 0.0;
    double pV = 0.0, V = 0.0;
    for (std::size_t r = 0; r < air_.size(); ++r) {
        pV += air_pressure(r) * volumes_[r];
        V += volumes_[r];
    }
    return pV / V;
}

void BagGas::book_load(const Points& v_mid, double span) {
    given_ += load_.book(v_mid, span);
    const auto nodes = enclosure_.nodes();
    const double swept = span * parallel::sum(nodes.size(), 0.0, [&](std::size_t i) {
                             return area_[nodes[i]].dot(v_mid[nodes[i]]);
                         });
    ambient_work_ += card_.p_atm * swept;
    note_air(span);
    if (uniform_) {
        uniform_->work(v_mid, span);
        return;
    }
    const WettedSurface& wall = *surface_;
    for (std::size_t r = 0; r < air_.size(); ++r) {
        const double opened = span * parallel::sum(wall.points(), 0.0, [&](std::size_t p) {
                                  return wall.room_of_point(p) == static_cast<Index>(r)
                                             ? load_.area()[p].dot(v_mid[wall.node(p)])
                                             : 0.0;
                              });
        air_[r].add(-air_pressure(r) * opened);
    }
}

// ---- the gas itself
// -------------------------------------------------------------------------------

void BagGas::prepare(double dt, const Points& x_0, const Points& x_1) {
    if (uniform_) return;
    if (lists_.hold_for(x_1)) return;
    if (const double far = ways_of_size(lists_, x_0, x_1); !(far < FARTHEST))
        throw PhysicsError(time_, fmt::format("{}: its fabric goes {:.3g} times the bag's size in "
                                              "one step: it is too light for its load",
                                              name_of(card_), far));
    const double reach = REACH * speed_ * dt;
    const bool is_thin = 2.0 * enclosure_.volume(x_0) < reach * enclosure_.area(x_0);
    const double cell = (is_thin ? THIN_CELL : FLIGHT_CELL) * facet_size_;
    build(lists_, cell, MARGIN * cell, is_thin ? 0.0 : reach, x_0, x_1);
}

/// Facet lists over the whole bag in cells of the wanted edge: neither finer than a hundredth of
/// the bag, which only costs, nor coarser than a quarter of it.
void BagGas::build(FacetLists& lists, double edge, double margin, double reach, const Points& x_0,
                   const Points& x_1) {
    contact::Box bag;
    for (const Index n : lists.nodes()) {
        bag.include(x_0[n]);
        bag.include(x_1[n]);
    }
    const double size = (bag.high - bag.low).maxCoeff();
    edge = std::clamp(edge, size / 100.0, size / 4.0);
    bag.inflate(margin);
    lists.build(Grid::over(bag.low, bag.high, edge, MOST_CELLS), x_0, x_1, margin, reach);
}

void BagGas::inject(double t, double dt, const Points& x_0, const Points& x_1) {
    time_ = t + dt;
    if (uniform_) return flow_uniform(t, dt, x_0, x_1);
    begin_anew(entries_);
    begin_anew(born_);
    if (const int passed = orifices_.passed_by_fabric(lists_, x_0, x_1); passed >= 0) {
        const Vec3 at = orifices_.place(static_cast<std::size_t>(passed), x_1);
        throw PhysicsError(t, fmt::format("{}: fabric passes over orifice {} at ({:g}, {:g}, {:g})",
                                          name_of(card_), passed + 1, at[0], at[1], at[2]));
    }
    orifices_.axes(x_0, axes_);
    inflators_.entering(t + dt, axes_, entries_);
    for (const Entry& entry : entries_) {
        const auto orifice = static_cast<std::size_t>(entry.orifice);
        const Vec3 from = orifices_.place(orifice, x_0), to = orifices_.place(orifice, x_1);
        const double share = std::clamp((entry.time - t) / dt, 0.0, 1.0);
        const Vec3 v = entry.velocity + (to - from) / dt;
        const double mass = mass_[entry.inflow];
        if (!std::isfinite(mass * v.squaredNorm() + entry.internal))
            throw PhysicsError(
                t, fmt::format("{}: what inflow {} brings through orifice {} is not finite: speed "
                               "{:g}, internal energy {:g}",
                               name_of(card_), entry.inflow + 1, entry.orifice + 1, v.norm(),
                               entry.internal));
        born_.push_back(share);
        // The first takes along what jets took beyond the work of their push.
        const double paid = &entry == entries_.data() ? load_.pay_jets() : 0.0;
        particles_.add(from + share * (to - from), v, entry.internal + paid, entry.inflow,
                       entry.id);
        if (surface_->rooms() > 1)
            particles_.room.push_back(static_cast<std::int16_t>(orifice_room_[orifice]));
        inflow_energy_ += 0.5 * mass * v.squaredNorm() + entry.internal;
        push_back(orifice, from, mass * entry.velocity, (to - from) / dt);
        mass_in_ += mass;
    }
}

/// IMOM = 1: the orifice's nodes are owed the impulse that the jet takes from them. What it does on
/// nodes that move comes from the inflator: gas that is thrown forward brings m v·w more than at
/// rest, and pushes back with m v·w less.
void BagGas::push_back(std::size_t orifice, const Vec3& at, const Vec3& impulse,
                       const Vec3& moving) {
    const auto nodes = orifices_.pushed(orifice);
    if (nodes.empty()) return;
    const auto count = static_cast<double>(nodes.size());
    const double work = -impulse.dot(moving);
    for (const Index node : nodes) load_.owe_jet(node, at, -impulse / count, work / count);
    inflow_energy_ += work;
}

void BagGas::fly(double t, double dt, const Points& x_0, const Points& x_1) {
    if (uniform_) return;
    if (loses() && (collisions_ != looked_at_ || collisions_ == 0)) look_inside(x_0);
    if (!openings_.empty()) {
        look_at_openings();
        openings_.set_gates(t, dt, x_0, at_opening_);
    }
    try {
        gas::fly(lists_, x_0, x_1, dt, mass_, born_, particles_, flight_, openings_.gates(),
                 roughness_.now());
    } catch (const BrokenParticle& broken) {
        stop_for(broken.row, broken.in_flight ? "in its flight, where it met a facet"
                                              : "before its flight, after collisions and inflow");
    }
    flights_ += particles_.size();
    load_.find_sides(flight_, x_0, x_1);
    samples_.receive(flight_, load_.sides(), dt, x_1, rooms_, particles_);
    load_.receive(flight_, mass_, particles_);
    roughness_.receive(flight_, dt, air_pressure(), x_1);
    record_hits(x_1);
    gone_.clear();
    if (!flight_.lost.empty()) book_lost(t);
    if (!particles_.room.empty()) pass_on();
    if (!openings_.empty()) let_out(dt);
    if (!heat_loss_.empty()) cool(t, dt);
    std::sort(gone_.begin(), gone_.end());
    particles_.erase(gone_);
}

/// Adds up what hits give to triangles and parts: outward on the closing ones, along the normal
/// inside.
void BagGas::record_hits(const Points& x_1) {
    for (const auto& hits : flight_.hits)
        for (const Hit& hit : hits) {
            const auto& [a, b, c] = lists_.triangles()[hit.facet];
            const bool closes = static_cast<std::size_t>(hit.facet) < walls_.closing;
            const double push =
                closes ? hit.impulse.norm()
                       : hit.impulse.dot(vector_area(x_1[a], x_1[b], x_1[c]).normalized());
            triangle_impulse_[hit.facet] += push;
            part_impulse_[walls_.part[hit.facet]] += push;
            ++hits_;
        }
}

/// Stops for a particle that is not finite.
void BagGas::stop_for(std::size_t particle, const char* when) const {
    const Vec3 &at = particles_.x[particle], &v = particles_.v[particle];
    const std::size_t row = static_cast<std::size_t>(particles_.species[particle]);
    throw PhysicsError(
        time_, fmt::format("{}: particle {} of {} near ({:g}, {:g}, {:g}) is not finite {}: "
                           "velocity ({:g}, {:g}, {:g}), internal energy {:g}",
                           name_of(card_), particles_.id[particle],
                           row == inflators_.inflows() ? std::string("the initial air")
                                                       : fmt::format("gas {}", row + 1),
                           at[0], at[1], at[2], when, v[0], v[1], v[2], particles_.e[particle]));
}

/// Stops where the groups' energies, all added up, are not finite.
void BagGas::check_collided(double thermal) const {
    if (std::isfinite(thermal)) return;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        if (!(particles_.x[i].squaredNorm() + particles_.v[i].squaredNorm() +
                  std::abs(particles_.e[i]) <
              INF))
            stop_for(i, "at its collisions");
    throw PhysicsError(time_, fmt::format("{}: the thermal energy of its particles overflows at "
                                          "their collisions",
                                          name_of(card_)));
}

void BagGas::book_lost(double t) {
    for (const Lost& lost : flight_.lost) {
        const std::size_t i = lost.particle;
        lost_energy_ +=
            0.5 * mass_[particles_.species[i]] * particles_.v[i].squaredNorm() + particles_.e[i];
        gone_.push_back(i);
        if (losses_.size() == MOST_LOSSES) continue;
        losses_.push_back(
            fmt::format("{}: particle {} was lost at time {:g} near ({:g}, {:g}, {:g}), "
                        "caught between closing facets",
                        name_of(card_), particles_.id[i], t, lost.at[0], lost.at[1], lost.at[2]));
    }
    lost_ += flight_.lost.size();
}

}  // namespace corpuscle::gas
