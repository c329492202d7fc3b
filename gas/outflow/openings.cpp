// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Which facets are ways out, worked out once.
#include "gas/outflow/openings.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace corpuscle::gas {
namespace {

/// Area of an isentropic vent's collar over C23 · the vent's own. Smaller: a choked vent whose gas
/// is thin runs short; larger: gas leaves farther from the hole.
constexpr double COLLAR = 3.0;

double greatest(const Curve& curve) {
    return *std::max_element(curve.y.begin(), curve.y.end());
}

}  // namespace

Openings::Openings(const BagCard& card, const BagWalls& walls, std::span<const Curve> curves,
                   std::span<const Species> species, std::span<const double> particle_mass,
                   std::span<const Vec3> x, std::uint64_t seed)
    : name_(fmt::format("*AIRBAG_PARTICLE {}", card.id)),
      vents_(card.vents),
      leaks_(walls.leaks),
      species_(species.begin(), species.end()),
      mass_(particle_mass.begin(), particle_mass.end()),
      triangles_(walls.triangles),
      part_(walls.part),
      shell_(walls.shell),
      block_(card.block),
      part_ids_(walls.part_ids),
      p_atm_(card.p_atm),
      T_atm_(card.T_atm),
      gas_constant_(card.gas_constant),
      part_mass_out_(walls.part_ids.size(), 0.0) {
    if (vents_.empty() && leaks_.empty()) return;
    if (card.air && card.air->flows_in)
        ambient_.emplace(card.air->species, card.gas_constant, "ambient air");
    curves_.assign(curves.begin(), curves.end());
    double heaviest = 0.0;
    for (const Species& gas : species_) heaviest = std::max(heaviest, gas.molar_mass());
    for (const Species& gas : species_) weight_.push_back(std::sqrt(gas.molar_mass() / heaviest));

    gates_.seed = seed;
    gates_.of_facet.assign(triangles_.size(), -1);
    gates_.collar_of.assign(triangles_.size(), -1);
    gates_.open.assign(triangles_.size(), 1.0);
    for (std::size_t v = 0; v < vents_.size(); ++v)
        add_vent(walls, vents_[v], static_cast<Index>(v));
    const std::size_t vents = openings_.size();
    for (std::size_t l = 0; l < leaks_.size(); ++l)
        add_leak(walls, leaks_[l], static_cast<Index>(l), x);

    for (std::size_t o = 0; o < vents; ++o) {
        Opening& vent = openings_[o];
        if (vent.is_internal) continue;
        const double factor = most(vents_[vent.vent]);
        const double own = vent.law == Opening::Law::ISENTROPIC ? COLLAR * factor : factor - 1.0;
        if (own > 0.0)
            add_collar(vent, static_cast<Index>(o), own * area_of(vent.facets, x), walls.closing,
                       x);
    }
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

void Openings::add_vent(const BagWalls& walls, const VentCard& vent, Index row) {
    Opening opening;
    opening.vent = row;
    opening.law = vent.is_isentropic ? Opening::Law::ISENTROPIC : Opening::Law::PLAIN;
    const auto gate = static_cast<Index>(openings_.size());
    for (std::size_t f = 0; f < walls.triangles.size(); ++f) {
        const Index part = walls.part_rows[walls.part[f]];
        if (std::find(vent.parts.begin(), vent.parts.end(), part) == vent.parts.end()) continue;
        if (gates_.of_facet[f] >= 0)
            throw InputError(fmt::format("{}, SID3: part {} is a vent twice", name_,
                                         walls.part_ids[walls.part[f]]));
        gates_.of_facet[f] = gate;
        opening.facets.push_back(static_cast<Index>(f));
    }
    if (opening.facets.empty())
        throw InputError(
            fmt::format("{}, SID3 of vent {}: no shell of it is in the bag", name_, row + 1));
    opening.is_internal = static_cast<std::size_t>(opening.facets.back()) >= walls.closing;
    if (opening.is_internal != (static_cast<std::size_t>(opening.facets[0]) >= walls.closing))
        throw InputError(
            fmt::format("{}, SID3 of vent {}: shells that close the bag and internal ones, "
                        "expected one kind",
                        name_, row + 1));
    if (opening.is_internal && vent.is_isentropic)
        throw InputError(fmt::format(
            "{}, SID3 of vent {}: internal with ENH_V, expected a plain one: it passes gas "
            "both ways",
            name_, row + 1));
    if (opening.is_internal && most(vent) > 1.0)
        throw InputError(fmt::format("{}, C23 of vent {}: {:g} of an internal one, expected 0 to 1",
                                     name_, row + 1, most(vent)));
    openings_.push_back(std::move(opening));
    // What leaves presses on the air outside, not on the hole: its share of a bounce is set with
    // the pressure. What crosses inside takes all its momentum with it.
    gates_.all.push_back({openings_.back().is_internal, vent.is_isentropic, 0.0,
                          std::vector<double>(species_.size(), 0.0),
                          std::vector<double>(species_.size(), 0.0)});
}

void Openings::add_leak(const BagWalls& walls, const LeakCard& leak, Index row,
                        std::span<const Vec3> x) {
    Opening opening;
    opening.leak = row;
    opening.law = leak.growth ? Opening::Law::ISENTROPIC : Opening::Law::SEEPAGE;
    const auto gate = static_cast<Index>(openings_.size());
    Index part = -1;
    for (std::size_t f = 0; f < walls.triangles.size(); ++f) {
        if (walls.part_rows[walls.part[f]] != leak.part || gates_.of_facet[f] >= 0) continue;
        gates_.of_facet[f] = gate;
        part = walls.part[f];
        opening.facets.push_back(static_cast<Index>(f));
    }
    if (opening.facets.empty()) return;  // the part is a vent, and open as such
    opening.is_internal = static_cast<std::size_t>(opening.facets[0]) >= walls.closing;
    if (opening.is_internal && leak.growth)
        throw InputError(
            fmt::format("{}: part {} is internal and leaks by X0 to X3, expected FLC "
                        "and FAC",
                        name_, walls.part_ids[part]));
    opening.first_area =
        leak.from_reference ? walls.reference_area[part] : area_of(opening.facets, x);
    opening.share.assign(species_.size(), 0.0);
    opening.due_of.assign(species_.size(), 0.0);
    openings_.push_back(std::move(opening));
    // Internal fabric is no wall to who passes; fabric that closes the bag is pushed by all who
    // come.
    gates_.all.push_back({openings_.back().is_internal, !openings_.back().is_internal,
                          openings_.back().is_internal ? 0.0 : 1.0,
                          std::vector<double>(species_.size(), 0.0),
                          std::vector<double>(species_.size(), 0.0)});
}

/// Rings of closed facets round the vent, until their area is as wanted or all are taken.
void Openings::add_collar(Opening& opening, Index row, double wanted, std::size_t closing,
                          std::span<const Vec3> x) {
    const auto is_vent = [&](std::size_t facet) {
        const Index gate = gates_.of_facet[facet];
        return gate >= 0 && openings_[gate].vent >= 0;
    };
    std::vector<char> near(x.size(), 0);
    for (const Index f : opening.facets)
        for (const Index n : triangles_[f]) near[n] = 1;
    double area = 0.0;
    while (area < wanted) {
        std::vector<Index> ring;
        for (std::size_t f = 0; f < closing; ++f) {
            if (is_vent(f) || gates_.collar_of[f] >= 0) continue;
            const auto& [a, b, c] = triangles_[f];
            if (near[a] || near[b] || near[c]) ring.push_back(static_cast<Index>(f));
        }
        if (ring.empty()) return;
        for (const Index f : ring) {
            gates_.collar_of[f] = row;
            opening.collar.push_back(f);
            for (const Index n : triangles_[f]) near[n] = 1;
        }
        area += area_of(ring, x);
    }
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
