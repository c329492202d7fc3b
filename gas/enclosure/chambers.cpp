// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/enclosure/chambers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gas/enclosure/inside.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Share of the bag's volume by which the sum of the chambers' may differ from it: rounding.
constexpr double VOLUME_ROUNDING = 1e-9;

bool holds(const std::vector<Index>& parts, Index part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// Do both triangles go round their nodes the same way?
bool is_turned_alike(const Triangle& a, const Triangle& b) {
    const auto at = std::find(b.begin(), b.end(), a[0]) - b.begin();
    return b[(at + 1) % 3] == a[1];
}

}  // namespace

Chambers::Chambers(const std::vector<ChamberCard>& cards, const BagWalls& walls,
                   const Enclosure& bag, std::span<const int> node_id, std::span<const Vec3> x,
                   const std::string& name) {
    if (cards.empty()) return;
    beside_.assign(walls.triangles.size(), {-1, -1});
    double volume = 0.0;
    for (const ChamberCard& card : cards) {
        std::vector<Triangle> triangles;
        std::vector<std::size_t> facets;
        for (std::size_t f = 0; f < walls.triangles.size(); ++f)
            if (holds(card.parts, walls.part_rows[walls.part[f]])) {
                const bool closes = f < walls.closing;
                triangles.push_back(closes ? bag.triangles()[f] : walls.triangles[f]);
                facets.push_back(f);
            }
        const std::string who = fmt::format("{}, chamber {}", name, card.id);
        if (triangles.empty()) throw InputError(who + " has no shell of the bag");
        surfaces_.emplace_back(std::move(triangles), x, node_id, who);
        volume += surfaces_.back().volume(x);
        for (std::size_t i = 0; i < facets.size(); ++i) {
            const std::size_t f = facets[i];
            const bool along = is_turned_alike(surfaces_.back().triangles()[i], walls.triangles[f]);
            Index& side = beside_[f][along ? 0 : 1];
            if (side >= 0 || (f < walls.closing && beside_[f][along ? 1 : 0] >= 0))
                throw InputError(
                    fmt::format("{}: a shell of part {} has another chamber on the "
                                "same side",
                                who, walls.part_ids[walls.part[f]]));
            side = static_cast<Index>(surfaces_.size()) - 1;
        }
    }
    for (std::size_t f = 0; f < walls.triangles.size(); ++f) {
        const auto [a, b] = beside_[f];
        const bool closes = f < walls.closing;
        if (closes ? a < 0 && b < 0 : (a < 0) != (b < 0))
            throw InputError(fmt::format(
                "{}: part {} {}, expected {}", name, walls.part_ids[walls.part[f]],
                closes ? "closes the bag but no chamber" : "parts one chamber from nothing",
                closes ? "a chamber that it closes" : "two chambers at it, or none"));
    }
    const double whole = bag.volume(x);
    if (std::abs(volume - whole) > VOLUME_ROUNDING * whole)
        throw InputError(fmt::format("{}: its chambers hold {:g} together, the bag holds {:g}",
                                     name, volume, whole));
}

std::vector<Index> Chambers::of(std::span<const Vec3> points, std::span<const Vec3> x) const {
    std::vector<InsideTest> tests;
    for (const Enclosure& surface : surfaces_) tests.emplace_back(surface.triangles(), x);
    std::vector<Index> found(points.size(), 0);
    parallel::for_each(points.size(), [&](std::size_t i) {
        for (std::size_t c = 0; c < tests.size(); ++c) {
            const auto winding = tests[c].winding(points[i]);
            if (winding ? *winding > 0 : surfaces_[c].contains(points[i], x)) {
                found[i] = static_cast<Index>(c);
                return;
            }
        }
    });
    return found;
}

}  // namespace corpuscle::gas
