// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/enclosure/chambers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gas/enclosure/inside.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "solver/base/error.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {
namespace {

/// Share of the bag's volume by which a chamber's may lie below 0: rounding.
constexpr double VOLUME_ROUNDING = 1e-9;

bool names(const std::vector<Index>& parts, Index part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// Do both triangles go round their nodes the same way?
bool is_turned_alike(const Triangle& a, const Triangle& b) {
    const auto at = std::find(b.begin(), b.end(), a[0]) - b.begin();
    return b[(at + 1) % 3] == a[1];
}

Vec3 centre(const Triangle& t, std::span<const Vec3> x) {
    return (x[t[0]] + x[t[1]] + x[t[2]]) / 3.0;
}

}  // namespace

Chambers::Chambers(const std::vector<ChamberCard>& cards, const BagWalls& walls,
                   const Enclosure& bag, std::span<const int> node_id, std::span<const Vec3> x,
                   const std::string& name) {
    if (cards.empty()) return;
    beside_.assign(walls.triangles.size(), {-1, -1});
    for (const ChamberCard& card : cards)
        add(card, walls, bag, node_id, x, fmt::format("{}, chamber {}", name, card.id));
    find_outer_sides(walls.closing, x);
    check_sides(walls, name);
    check_volumes(cards, walls, bag, x, name);
}

/// @param who  the chamber, for messages
void Chambers::add(const ChamberCard& card, const BagWalls& walls, const Enclosure& bag,
                   std::span<const int> node_id, std::span<const Vec3> x, const std::string& who) {
    std::vector<Triangle> triangles;
    std::vector<std::size_t> facets;
    for (std::size_t f = 0; f < walls.triangles.size(); ++f)
        if (names(card.parts, walls.part_rows[walls.part[f]])) {
            const bool closes = f < walls.closing;
            triangles.push_back(closes ? bag.triangles()[f] : walls.triangles[f]);
            facets.push_back(f);
            fill_bag_ |= closes;
        }
    if (triangles.empty()) throw InputError(who + " has no shell of the bag");
    Enclosure surface(std::move(triangles), x, node_id, who);
    find_cavities(surface, facets, walls.closing, x);
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const std::size_t f = facets[i];
        const bool along = is_turned_alike(surface.triangles()[i], walls.triangles[f]);
        Index& side = beside_[f][along ? 0 : 1];
        if (side >= 0 || (f < walls.closing && beside_[f][along ? 1 : 0] >= 0))
            throw InputError(
                fmt::format("{}: a shell of part {} has another chamber on the "
                            "same side",
                            who, walls.part_ids[walls.part[f]]));
        side = static_cast<Index>(surfaces_.size());
    }
    surfaces_.push_back(std::move(surface));
    facets_.push_back(std::move(facets));
}

/// Turns pieces of internal facets that lie in the chamber's other pieces, but not in a cavity.
void Chambers::find_cavities(Enclosure& surface, const std::vector<std::size_t>& facets,
                             std::size_t closing, std::span<const Vec3> x) const {
    const std::vector<Index>& piece = surface.piece();
    const auto pieces = static_cast<std::size_t>(*std::max_element(piece.begin(), piece.end())) + 1;
    if (pieces == 1) return;
    std::vector<std::vector<Triangle>> walls(pieces);
    std::vector<char> closes(pieces, 0);
    for (std::size_t i = 0; i < piece.size(); ++i) {
        walls[piece[i]].push_back(surface.triangles()[i]);
        closes[piece[i]] |= facets[i] < closing;
    }
    for (std::size_t p = 0; p < pieces; ++p) {
        if (closes[p]) continue;
        int depth = 0;
        for (std::size_t q = 0; q < pieces; ++q)
            depth += q != p && holds(walls[q], centre(walls[p][0], x), x);
        if (depth % 2 == 1) surface.turn(static_cast<Index>(p));
    }
}

/// The smallest chamber that a point lies in, of all but one; -1: none.
Index Chambers::around(const Vec3& point, Index but, std::span<const Vec3> x) const {
    Index found = -1;
    double smallest = INF;
    for (std::size_t c = 0; c < size(); ++c) {
        if (static_cast<Index>(c) == but || !holds(surfaces_[c].triangles(), point, x)) continue;
        const double own = surfaces_[c].volume(x);
        if (own >= smallest) continue;
        smallest = own;
        found = static_cast<Index>(c);
    }
    return found;
}

/// Where a piece of a chamber's surface lies in another whose card does not name its parts, it is a
/// wall of the other too.
void Chambers::find_outer_sides(std::size_t closing, std::span<const Vec3> x) {
    constexpr Index UNKNOWN = -2;
    for (std::size_t c = 0; c < size(); ++c) {
        std::vector<Index> outer(facets_[c].size(), UNKNOWN);  // by piece
        for (std::size_t i = 0; i < facets_[c].size(); ++i) {
            auto& [behind, ahead] = beside_[facets_[c][i]];
            if (facets_[c][i] < closing || (behind >= 0 && ahead >= 0)) continue;
            Index& other = outer[static_cast<std::size_t>(surfaces_[c].piece()[i])];
            if (other == UNKNOWN)
                other = around(centre(surfaces_[c].triangles()[i], x), static_cast<Index>(c), x);
            (behind < 0 ? behind : ahead) = other;
        }
    }
}

void Chambers::check_sides(const BagWalls& walls, const std::string& name) const {
    if (!fill_bag_) return;
    for (std::size_t f = 0; f < walls.triangles.size(); ++f) {
        const auto [a, b] = beside_[f];
        const bool closes = f < walls.closing;
        if (closes ? a < 0 && b < 0 : (a < 0) != (b < 0))
            throw InputError(fmt::format(
                "{}: part {} {}, expected {}", name, walls.part_ids[walls.part[f]],
                closes ? "closes the bag but no chamber" : "parts one chamber from nothing",
                closes ? "a chamber that it closes" : "two chambers at it, or none"));
    }
}

/// What is left of each when those in it are taken away.
void Chambers::check_volumes(const std::vector<ChamberCard>& cards, const BagWalls& walls,
                             const Enclosure& bag, std::span<const Vec3> x,
                             const std::string& name) const {
    const Vec3 origin = x[walls.triangles[0][0]];
    std::vector<double> volume(size(), 0.0);
    for (std::size_t f = 0; f < walls.triangles.size(); ++f) {
        const auto& [a, b, c] = walls.triangles[f];
        const double share = signed_volume(x[a] - origin, x[b] - origin, x[c] - origin);
        if (beside_[f][0] >= 0) volume[beside_[f][0]] += share;
        if (beside_[f][1] >= 0) volume[beside_[f][1]] -= share;
    }
    for (std::size_t c = 0; c < size(); ++c)
        if (volume[c] < -VOLUME_ROUNDING * bag.volume(x))
            throw InputError(
                fmt::format("{}, chamber {}: chambers in it hold {:g} more than it encloses", name,
                            cards[c].id, -volume[c]));
}

/// That of the facets round a room, or the one around all of them.
std::vector<Index> Chambers::of_rooms(const WettedSurface& surface, std::span<const Vec3> x) const {
    std::vector<Index> chamber(surface.rooms(), -1);
    if (empty()) return chamber;
    std::vector<Index> facet(surface.rooms(), -1);
    for (std::size_t s = 0; s < surface.sides(); ++s) {
        const Index f = surface.facet(s), room = surface.room(s);
        const auto [behind, ahead] = beside_[f];
        const Index own = surface.closes(static_cast<std::size_t>(f)) ? std::max(behind, ahead)
                          : surface.is_front(s)                       ? ahead
                                                                      : behind;
        if (own >= 0) chamber[room] = own;
        facet[room] = f;
    }
    for (std::size_t r = 0; r < chamber.size(); ++r)
        if (chamber[r] < 0 && facet[r] >= 0)
            chamber[r] = around(centre(surface.triangles()[facet[r]], x), -1, x);
    return chamber;
}

}  // namespace corpuscle::gas
