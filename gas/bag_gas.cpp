// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/bag_gas.hpp"

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
constexpr double FIRST_PARTICLES_PER_CELL = 20.0;

/// Share of a cell that fabric may move before facet lists are made anew.
constexpr double MARGIN = 0.15;

/// Share of a cell that a particle of thermal speed crosses in a step that the gas limits.
constexpr double FLIGHT_SHARE = 0.5;

/// Cells of the flight's facet lists, in facet edges. Smaller: fewer candidates a particle, more
/// cells.
constexpr double FLIGHT_CELL = 2.25;

/// Reach of the table of free ways, in ways of thermal speed in a step: one component in two
/// thousand is longer. Farther: fewer look-ups, planes less tight.
constexpr double REACH = 3.5;

/// The same where layers lie closer than that reach: there no way is free.
constexpr double THIN_CELL = 1.5;

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

/// All nodes of the walls, and those that the jets push.
std::vector<Index> loaded_nodes(const FacetLists& lists, const Orifices& orifices) {
    std::vector<Index> nodes(lists.nodes().begin(), lists.nodes().end());
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
      store_(x.size(), loaded_nodes(lists_, orifices_), enclosure_, held,
             RELEASE_TIME * card.second * card.smoothing),
      collider_(collider_of(card, inflators_, seed)),
      openings_(card, walls_, curves, inflators_.species(), mass_, x, seed),
      heat_loss_(card, walls_, curves),
      roughness_(card, walls_, curves,
                 ImpulseStore::PATIENCE * RELEASE_TIME * card.second * card.smoothing),
      area_(x.size(), Vec3::Zero()),
      part_impulse_(walls_.part_ids.size(), 0.0),
      triangle_impulse_(walls_.triangles.size(), 0.0),
      part_air_(std::max<std::size_t>(1, chambers_.size()), 0.0),
      triangle_air_(part_air_) {
    volume_ = enclosure_.volume(x);
    if (!(volume_ > 0.0))
        throw InputError(name_of(card) +
                         ", SID1: the bag encloses no volume at the start, expected some: "
                         "particles have no place to enter");
    if (card.air && !card.air->is_particles) air_.emplace(*card.air, card.gas_constant, volume_);
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
    if (!chambers_.empty() && !card.heat.empty() && card.switch_at < card.all_in)
        faults.push_back(name_of(card) +
                         ": HCONV of a bag with chambers (CHM) that goes over to uniform pressure "
                         "(TSW), expected one of the three to be left out");
    if (!faults.empty()) throw InputError(std::move(faults));

    facet_size_ = std::sqrt(2.0 * enclosure_.area(x) / static_cast<double>(walls_.closing));

    double lightest = INF;
    for (const Species& species : inflators_.species())
        lightest = std::min(lightest, species.molar_mass());
    speed_ = std::sqrt(card.gas_constant * inflators_.highest_temperature() / lightest);
    cell_ = wanted_cell_ = cell_edge(volume_, card.particles, FIRST_PARTICLES_PER_CELL);
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
    enclosure_.node_areas(x, area_);
    store_.begin_with(card_.air->pressure, area_);
}

// ---- the load on the fabric
// -----------------------------------------------------------------------

void BagGas::add_load(const Points& x, double span, Points& f) {
    volume_ = enclosure_.volume(x);
    enclosure_.node_areas(x, area_);
    store_.release(span, area_, f);
    if (uniform_) settle(x);
    if (uniform_) uniform_->add_force(f);
    const double gauge = (uniform_ ? 0.0 : air_pressure()) - card_.p_atm;
    for (const Index n : enclosure_.nodes()) f[n] += gauge * area_[n];
}

void BagGas::book_load(const Points& v_mid, double span) {
    given_ += store_.work(v_mid, span);
    const auto nodes = enclosure_.nodes();
    const double swept = span * parallel::sum(nodes.size(), 0.0, [&](std::size_t i) {
                             return area_[nodes[i]].dot(v_mid[nodes[i]]);
                         });
    ambient_work_ += card_.p_atm * swept;
    note_air(span);
    if (uniform_)
        uniform_->work(v_mid, span);
    else if (air_)
        air_->add(-air_pressure() * swept);
}

// ---- the gas itself
// -------------------------------------------------------------------------------

void BagGas::prepare(double dt, const Points& x_0, const Points& x_1) {
    if (uniform_) return;
    if (card_.normal_damping > 0.0)
        store_.feel_motion(x_0, x_1, dt, area_, card_.normal_damping / speed_);
    if (lists_.hold_for(x_1)) return;
    if (const double far = ways_of_size(lists_, x_0, x_1); !(far < FARTHEST))
        throw PhysicsError(time_, fmt::format("{}: its fabric goes {:.3g} times the bag's size in "
                                              "one step: it is too light for its load",
                                              name_of(card_), far));
    const double reach = REACH * speed_ * dt;
    const bool is_thin = 2.0 * volume_ < reach * enclosure_.area(x_0);
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
        born_.push_back(share);
        particles_.add(from + share * (to - from), v, entry.internal, entry.inflow, entry.id);
        inflow_energy_ += 0.5 * mass * v.squaredNorm() + entry.internal;
        push_back(orifice, mass * entry.velocity, (to - from) / dt);
        mass_in_ += mass;
    }
}

/// IMOM = 1: the orifice's nodes are owed the impulse that the jet takes from them. What it does on
/// nodes that move comes from the inflator: gas that is thrown forward brings m v·w more than at
/// rest, and pushes back with m v·w less.
void BagGas::push_back(std::size_t orifice, const Vec3& impulse, const Vec3& moving) {
    const auto nodes = orifices_.pushed(orifice);
    if (nodes.empty()) return;
    for (const Index node : nodes) store_.owe(node, -impulse / static_cast<double>(nodes.size()));
    const double work = -impulse.dot(moving);
    inflow_energy_ += work;
    taken_ += work;
}

void BagGas::fly(double t, double dt, const Points& x_0, const Points& x_1) {
    if (uniform_) return;
    const bool loses = !openings_.empty() || !heat_loss_.empty();
    if (loses && (collisions_ != looked_at_ || collisions_ == 0)) look_inside(x_0);
    if (!openings_.empty()) openings_.set_gates(t, dt, x_0, inside_);
    gas::fly(lists_, x_0, x_1, dt, mass_, born_, particles_, flight_, openings_.gates(),
             roughness_.now());
    flights_ += particles_.size();
    store_.receive(flight_, lists_.triangles());
    roughness_.receive(flight_, dt, air_pressure(), x_1);
    record_hits(x_1);
    gone_.clear();
    if (!flight_.lost.empty()) book_lost(t);
    if (!openings_.empty()) let_out(dt);
    if (!heat_loss_.empty()) cool(t, dt, x_0);
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
            taken_ += hit.energy;
            ++hits_;
        }
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

double BagGas::stable_step() const {
    return uniform_ ? INF : FLIGHT_SHARE * cell_ / speed_;
}

}  // namespace corpuscle::gas
