// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/envelope.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"

namespace corpuscle::gas {
namespace {

/// Longest time over which the state of the gas at an opening is averaged.           [s]
constexpr double LONGEST_MEMORY = 200e-6;

/// Share of the bag's volume up to which a room has none at the start: membranes that lie on each
/// other have one of rounding, of either sign.
constexpr double FLAT = 1e-9;

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

/// By facet: 1 where particles may pass without a full bounce, vents and what is internal.
std::vector<char> passing_facets(const BagCard& card, const BagWalls& walls) {
    std::vector<char> passes(walls.triangles.size(), 0);
    for (std::size_t f = 0; f < passes.size(); ++f) {
        const Index part = walls.part_rows[walls.part[f]];
        const bool leaks = f >= walls.closing &&
                           std::any_of(walls.leaks.begin(), walls.leaks.end(),
                                       [&](const LeakCard& leak) { return leak.part == part; });
        const bool is_vent =
            std::any_of(card.vents.begin(), card.vents.end(), [&](const VentCard& vent) {
                return std::find(vent.parts.begin(), vent.parts.end(), part) != vent.parts.end();
            });
        passes[f] = leaks || is_vent;
    }
    return passes;
}

void require_inside(const Orifices& orifices, const Enclosure& enclosure, const Points& x,
                    const std::string& name) {
    std::vector<Fault> faults;
    for (std::size_t o = 0; o < orifices.size(); ++o)
        if (const Vec3 at = orifices.place(o, x); !enclosure.contains(at, x))
            faults.push_back(
                {.of = name,
                 .property = Property::ORIFICE_PLACE,
                 .which = fmt::format("orifice {}", o + 1),
                 .why = fmt::format("({:g}, {:g}, {:g}) lies outside the bag, expected inside",
                                    at[0], at[1], at[2])});
    if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

Envelope::Envelope(const BagCard& bag, BagWalls bag_walls, std::span<const Curve> curves,
                   std::span<const int> node_id, std::span<const std::uint8_t> held,
                   const Points& x, std::uint64_t seed, std::span<const Index> body)
    : card(bag),
      walls(std::move(bag_walls)),
      enclosure(closing(walls), x, node_id, card.name(), Property::CLOSING_WALL),
      chambers(card.chambers, walls, enclosure, node_id, x, card.name()),
      inflators(card, curves, seed, enclosure.volume(x)),
      particle_mass(particle_masses(inflators)),
      surface(std::make_shared<WettedSurface>(turned(enclosure, walls), walls.closing, x)),
      orifices(card.orifices, surface->triangles(), walls.triangles, walls.closing, walls.shell,
               card.frame, x),
      load(surface, held, jet_nodes(orifices),
           LoadTimes::of(LoadTimes::LONGEST * card.second * card.smoothing, surface->points(),
                         std::max<std::size_t>(1, inflators.particles() + inflators.resident())),
           card.normal_damping, body),
      samples(card.vents.empty() && walls.leaks.empty() && card.heat.empty()
                  ? WallSamples()
                  : WallSamples(surface, walls, inflators.species(), particle_mass,
                                card.gas_constant, LONGEST_MEMORY * card.second,
                                passing_facets(card, walls), x)),
      openings(card, walls, curves, inflators.species(), particle_mass, *surface, samples, x, seed),
      heat_loss(card, walls, *surface, samples, curves),
      monitor(surface, walls, !card.friction.empty()),
      area(x.size(), Vec3::Zero()) {
    surface->volumes(x, volumes);
    if (!(enclosure.volume(x) > 0.0))
        throw InputError(Fault{.of = name(),
                               .property = Property::CLOSING_WALL,
                               .why = "the bag encloses no volume at the start, expected some: "
                                      "particles have no place to enter"});
    require_inside(orifices, enclosure, x, name());
    if (card.air && !card.air->is_particles) fill_with_air(enclosure.volume(x));
    rooms.resize(surface->rooms());
    chamber_of_room = chambers.of_rooms(*surface, x);
    if (enclosure.turned() > 0)
        warnings.push_back(
            fmt::format("{}: the normals of {} facets were turned to agree with their neighbours",
                        name(), enclosure.turned()));
    std::vector<Vec3> nozzles;
    for (std::size_t o = 0; o < orifices.size(); ++o) nozzles.push_back(orifices.place(o, x));
    orifice_room = surface->rooms_of(nozzles, x);
    if (!card.air && volumes.size() > 1) tell_vacuum(enclosure.volume(x));
}

/// By room: 1 where gas comes in, through orifices or, from such a room, through internal openings.
std::vector<char> Envelope::rooms_that_fill() const {
    std::vector<char> fills(volumes.size(), 0);
    for (std::size_t o = 0; o < orifices.size(); ++o)
        for (std::size_t s = 0; s < inflators.inflows(); ++s)
            if (inflators.share(s, o) > 0.0) fills[orifice_room[o]] = 1;
    for (bool goes_on = true; goes_on;) {
        goes_on = false;
        for (const Opening& hole : openings.all()) {
            if (!hole.is_internal) continue;
            const auto facet = static_cast<std::size_t>(hole.facets[0]);
            char &behind = fills[surface->room(surface->side(facet, false))],
                 &ahead = fills[surface->room(surface->side(facet, true))];
            if (behind == ahead) continue;
            behind = ahead = 1;
            goes_on = true;
        }
    }
    return fills;
}

/// Warns of rooms that no gas is in and none comes to.
void Envelope::tell_vacuum(double volume) {
    const std::vector<char> fills = rooms_that_fill();
    for (std::size_t r = 0; r < fills.size(); ++r)
        if (fills[r] == 0 && volumes[r] > FLAT * volume)
            warnings.push_back(fmt::format(
                "{}: a vacuum for good that the atmosphere may turn inside out, without "
                "an orifice or an opening to gas: IAIR = 1 or 2 expected, or an opening",
                name_of_room(r)));
}

std::string Envelope::name_of_room(std::size_t room) const {
    if (const Index chamber = chamber_of_room[room]; chamber >= 0)
        return fmt::format("{}, chamber {}", name(),
                           card.chambers[static_cast<std::size_t>(chamber)].id);
    return fmt::format("{}, room {}", name(), room + 1);
}

/// A room without volume has no initial air.
void Envelope::fill_with_air(double volume) {
    for (std::size_t r = 0; r < volumes.size(); ++r) {
        const bool is_flat = !(volumes[r] > FLAT * volume);
        air.emplace_back(*card.air, card.gas_constant, is_flat ? 0.0 : volumes[r]);
        if (is_flat)
            warnings.push_back(
                fmt::format("{}, room {}: the volume is {:g} at the start: it has no initial air",
                            name(), r + 1, volumes[r]));
    }
}

std::string Envelope::name() const {
    return card.name();
}

std::vector<ChamberState> Envelope::sums_of_rooms(const GasPhase& gas,
                                                  std::span<const Index> sum_of, std::size_t count,
                                                  const Points& x) const {
    std::vector<ChamberSum> sums(count);
    std::vector<double> volume;
    surface->volumes(x, volume);
    for (std::size_t r = 0; r < volume.size(); ++r)
        if (sum_of[r] >= 0) sums[static_cast<std::size_t>(sum_of[r])].state.volume += volume[r];
    gas.add_rooms(volume, sum_of, sums);
    std::vector<ChamberState> all;
    for (const ChamberSum& sum : sums) all.push_back(sum.whole());
    return all;
}

void Envelope::push_back(std::size_t orifice, const Vec3& at, const Vec3& impulse,
                         const Vec3& moving) {
    const auto nodes = orifices.pushed(orifice);
    if (nodes.empty()) return;
    const auto count = static_cast<double>(nodes.size());
    const double work = -impulse.dot(moving);
    for (const Index node : nodes)
        load.owe_jet(node, orifice_room[orifice], at, -impulse / count, work / count);
    balance.inflow_energy += work;
}

}  // namespace corpuscle::gas
