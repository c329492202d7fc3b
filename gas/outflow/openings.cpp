// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Which facets are ways out, worked out once.
#include "gas/outflow/openings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace corpuscle::gas {
namespace {

/// Area of an isentropic vent's collar over C23 · the vent's own. Smaller: a choked vent whose gas
/// is thin runs short; larger: gas leaves farther from the hole.
constexpr double COLLAR = 3.0;

/// Area of the wall that tells the state of the gas at a vent, over the vent's own. Smaller: fewer
/// hits, later to know; larger: less local.
constexpr double SURROUNDINGS = 2.0;

double greatest(const Curve& curve) {
    return *std::max_element(curve.y.begin(), curve.y.end());
}

}  // namespace

Openings::Openings(const BagCard& card, const BagWalls& walls, std::span<const Curve> curves,
                   std::span<const Species> species, std::span<const double> particle_mass,
                   const WettedSurface& surface, WallSamples& samples, std::span<const Vec3> x,
                   std::uint64_t seed)
    : name_(card.name()),
      vents_(card.vents),
      leaks_(walls.leaks),
      species_(species.begin(), species.end()),
      mass_(particle_mass.begin(), particle_mass.end()),
      triangles_(surface.triangles()),
      part_(walls.part),
      shell_(walls.shell),
      block_(card.block),
      part_ids_(walls.part_ids),
      p_atm_(card.p_atm),
      T_atm_(card.T_atm),
      gas_constant_(card.gas_constant),
      imbalance_(surface.rooms()),
      part_mass_out_(walls.part_ids.size(), 0.0) {
    if (vents_.empty() && leaks_.empty()) return;
    if (card.air && card.air->flows_in)
        ambient_.emplace(card.air->species, card.gas_constant, "ambient air");
    curves_.assign(curves.begin(), curves.end());
    double heaviest = 0.0;
    for (const Species& gas : species_) heaviest = std::max(heaviest, gas.molar_mass());
    for (const Species& gas : species_) weight_.push_back(std::sqrt(gas.molar_mass() / heaviest));
    for (const double mass : mass_) heaviest_ = std::max(heaviest_, mass);

    transmission_.seed = seed;
    transmission_.of_facet.assign(triangles_.size(), -1);
    transmission_.collar_of.assign(triangles_.size(), -1);
    transmission_.open.assign(triangles_.size(), 1.0);
    for (std::size_t v = 0; v < vents_.size(); ++v)
        add_vent(walls, vents_[v], static_cast<Index>(v), surface);
    const std::size_t vents = openings_.size();
    for (std::size_t l = 0; l < leaks_.size(); ++l)
        add_leak(walls, leaks_[l], static_cast<Index>(l), surface, samples, x);

    for (std::size_t o = 0; o < vents; ++o) {
        Opening& vent = openings_[o];
        if (vent.is_internal) continue;
        const double factor = most(vents_[vent.vent]);
        const double own = vent.law == Opening::Law::ISENTROPIC ? COLLAR * factor : factor - 1.0;
        const double area = area_of(vent.facets, x);
        vent.is_strong = factor > 1.0;
        std::vector<Index> sides = surroundings(vent, SURROUNDINGS * area, surface, x);
        if (own > 0.0) add_collar(vent, static_cast<Index>(o), own * area, sides, surface, x);
        vent.sample = samples.add(std::move(sides), true);
    }
    passed_.still_owed.assign(openings_.size(), 0.0);
    came_.assign(openings_.size(), 0.0);
    came_to_collar_.assign(openings_.size(), 0.0);
}

/// Greatest C23 that the vent may get.
double Openings::most(const VentCard& vent) const {
    double factor = vent.coefficient;
    for (const Index curve : {vent.time_curve, vent.pressure_curve})
        if (curve >= 0) factor *= greatest(curves_[curve]);
    return factor;
}

void Openings::add_opening(Opening opening, bool counts_all, double push) {
    transmission_.all.push_back({opening.is_internal, counts_all, push,
                                 std::vector<double>(species_.size(), 0.0),
                                 std::vector<double>(species_.size(), 0.0)});
    const auto row = static_cast<Index>(openings_.size());
    for (const Index f : opening.facets) {
        transmission_.of_facet[f] = row;
        const auto is_it = [&](const Opening::OfPart& own) { return own.part == part_[f]; };
        if (std::none_of(opening.parts.begin(), opening.parts.end(), is_it))
            opening.parts.push_back({part_[f]});
    }
    openings_.push_back(std::move(opening));
}

void Openings::add_vent(const BagWalls& walls, const VentCard& vent, Index row,
                        const WettedSurface& surface) {
    const std::string which = fmt::format("vent {}", row + 1);
    std::vector<Index> facets;
    for (std::size_t f = 0; f < walls.triangles.size(); ++f) {
        const Index part = walls.part_rows[walls.part[f]];
        if (std::find(vent.parts.begin(), vent.parts.end(), part) == vent.parts.end()) continue;
        if (transmission_.of_facet[f] >= 0)
            throw InputError(Fault{
                .of = name_,
                .property = Property::VENT_WALL,
                .which = which,
                .why = fmt::format("part {} is a vent twice", walls.part_ids[walls.part[f]])});
        facets.push_back(static_cast<Index>(f));
    }
    if (facets.empty())
        throw InputError(Fault{.of = name_,
                               .property = Property::VENT_WALL,
                               .which = which,
                               .why = "no shell of it is in the bag"});
    const bool is_internal = static_cast<std::size_t>(facets.back()) >= walls.closing;
    if (is_internal != (static_cast<std::size_t>(facets[0]) >= walls.closing))
        throw InputError(
            Fault{.of = name_,
                  .property = Property::VENT_WALL,
                  .which = which,
                  .why = "shells that close the bag and internal ones, expected one kind"});
    if (is_internal && vent.is_isentropic)
        throw InputError(Fault{.of = name_,
                               .property = Property::VENT_LAW,
                               .which = which,
                               .why = "nozzle flow through an internal one, expected plain holes: "
                                      "they pass gas both ways"});
    if (is_internal && most(vent) > 1.0)
        throw InputError(Fault{.of = name_,
                               .property = Property::VENT_COEFFICIENT,
                               .which = which,
                               .value = most(vent),
                               .why = "expected 0 to 1 of an internal one"});
    for (std::size_t room = 0; room < surface.rooms(); ++room) {
        Opening opening;
        opening.vent = row;
        opening.law = vent.is_isentropic ? Opening::Law::ISENTROPIC : Opening::Law::PLAIN;
        opening.is_internal = is_internal;
        opening.room = static_cast<Index>(room);
        for (const Index f : facets)
            if (surface.room(surface.side(static_cast<std::size_t>(f), false)) == opening.room)
                opening.facets.push_back(f);
        // What leaves presses on the air outside, not on the hole: its share of a bounce is set
        // with the pressure. What crosses inside takes all its momentum with it.
        if (!opening.facets.empty()) add_opening(std::move(opening), vent.is_isentropic, 0.0);
    }
}

/// What is on the other side of internal fabric.
void Openings::add_ahead(Opening& opening, const WettedSurface& surface) {
    const auto front = [&](Index f) { return surface.side(static_cast<std::size_t>(f), true); };
    opening.ahead.room = surface.room(front(opening.facets[0]));
    std::vector<Index>& points = opening.ahead.points;
    for (const Index f : opening.facets)
        for (const Index p : surface.points(front(f))) points.push_back(p);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

void Openings::add_leak(const BagWalls& walls, const LeakCard& leak, Index row,
                        const WettedSurface& surface, const WallSamples& samples,
                        std::span<const Vec3> x) {
    double whole = 0.0;
    const std::size_t first = openings_.size();
    for (std::size_t k = 0; k < samples.patches().size(); ++k) {
        Opening opening;
        opening.leak = row;
        opening.law = leak.growth ? Opening::Law::ISENTROPIC : Opening::Law::SEEPAGE;
        opening.sample = static_cast<Index>(k);
        for (const Index side : samples.patches()[k]) {
            const auto f = static_cast<std::size_t>(surface.facet(side));
            if (surface.is_front(side) || walls.part_rows[walls.part[f]] != leak.part ||
                transmission_.of_facet[f] >= 0)  // else the part is a vent, and open as such
                continue;
            opening.facets.push_back(static_cast<Index>(f));
        }
        if (opening.facets.empty()) continue;
        const auto one = static_cast<std::size_t>(opening.facets[0]);
        opening.room = surface.room(surface.side(one, false));
        opening.is_internal = !surface.closes(one);
        if (opening.is_internal) add_ahead(opening, surface);
        if (opening.is_internal && leak.growth)
            throw InputError(
                Fault{.of = name_,
                      .property = Property::POROSITY,
                      .which = fmt::format("part {}", walls.part_ids[walls.part[one]]),
                      .why = "internal, and its pores grow with strain, expected a constant leak"});
        opening.first_area = area_of(opening.facets, x);
        whole += opening.first_area;
        const std::vector<double> none(species_.size(), 0.0);
        opening.seepage.assign(2, {none, none, none, none});
        // Internal fabric is no wall to who passes; fabric that closes the bag is pushed by all who
        // come.
        const double push = opening.is_internal ? 0.0 : 1.0;
        add_opening(std::move(opening), true, push);
    }
    if (!leak.from_reference) return;
    for (std::size_t o = first; o < openings_.size(); ++o) {
        const Index part = part_[openings_[o].facets[0]];
        openings_[o].first_area *= walls.reference_area[part] / whole;
    }
}

/// take(facet) for closed facets of the vent's room, ring after ring round it, until their area is
/// as wanted or all are taken.
template <class Take>
void Openings::grow_rings(const Opening& opening, const WettedSurface& surface,
                          std::span<const Vec3> x, double wanted, Take&& take) const {
    const auto is_vent = [&](std::size_t facet) {
        const Index row = transmission_.of_facet[facet];
        return row >= 0 && openings_[row].vent >= 0;
    };
    std::vector<char> near(surface.points(), 0), taken(triangles_.size(), 0);
    for (const Index f : opening.facets)
        for (const Index p : surface.points(surface.side(static_cast<std::size_t>(f), false)))
            near[p] = 1;
    for (double area = 0.0; area < wanted;) {
        std::vector<Index> ring;
        for (std::size_t f = 0; f < triangles_.size() && surface.closes(f); ++f) {
            if (is_vent(f) || taken[f]) continue;
            const auto& [a, b, c] = surface.points(surface.side(f, false));
            if (near[a] || near[b] || near[c]) ring.push_back(static_cast<Index>(f));
        }
        if (ring.empty()) return;
        for (const Index f : ring) {
            taken[f] = 1;
            take(f);
            for (const Index p : surface.points(surface.side(static_cast<std::size_t>(f), false)))
                near[p] = 1;
        }
        area += area_of(ring, x);
    }
}

/// The collar keeps off the sides that tell the state at the vent: where gas leaves, hits tell less.
void Openings::add_collar(Opening& opening, Index row, double wanted, std::span<const Index> sides,
                          const WettedSurface& surface, std::span<const Vec3> x) {
    std::vector<Index> near;
    for (const Index side : sides) near.push_back(surface.facet(static_cast<std::size_t>(side)));
    grow_rings(opening, surface, x, wanted + area_of(near, x), [&](Index f) {
        if (transmission_.collar_of[f] >= 0 || std::find(near.begin(), near.end(), f) != near.end())
            return;
        transmission_.collar_of[f] = row;
        opening.collar.facets.push_back(f);
    });
}

/// Sides of closed facets round a vent; its own where there are none.
std::vector<Index> Openings::surroundings(const Opening& opening, double wanted,
                                          const WettedSurface& surface,
                                          std::span<const Vec3> x) const {
    std::vector<Index> sides;
    grow_rings(opening, surface, x, wanted, [&](Index f) {
        sides.push_back(static_cast<Index>(surface.side(static_cast<std::size_t>(f), false)));
    });
    if (sides.empty())
        for (const Index f : opening.facets)
            sides.push_back(static_cast<Index>(surface.side(static_cast<std::size_t>(f), false)));
    return sides;
}

double Openings::area_of(std::span<const Index> facets, std::span<const Vec3> x) const {
    double area = 0.0;
    for (const Index f : facets) {
        const auto& [a, b, c] = triangles_[f];
        area += vector_area(x[a], x[b], x[c]).norm();
    }
    return area;
}

}  // namespace corpuscle::gas
