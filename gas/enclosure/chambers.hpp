// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/enclosure/enclosure.hpp"

namespace corpuscle::gas {

class WettedSurface;

/// The chambers of a bag (*DEFINE_CPM_CHAMBER): each a closed surface of its own, of closing facets
/// and of internal ones that it shares with another chamber. Together they fill the bag.
///
/// A chamber may lie in another, closed by internal facets alone: what it encloses is not the
/// other's, whether the other's card names its walls or not. Where no chamber has a closing facet,
/// what is around them all is the bag's alone.
class Chambers {
public:
    /// No card: no chambers.
    /// @param walls    of the bag that is divided, closing and internal
    /// @param bag      its closed surface
    /// @param node_id  N: the deck's, for messages
    /// @param x        N × 3, nodes at the start                                            [m]
    /// @param name     of the bag, for messages
    /// @throws InputError  where surfaces are not closed, facets belong to too many or too few of
    ///                     them, or those in a chamber hold more than it encloses
    Chambers(const std::vector<ChamberCard>& cards, const BagWalls& walls, const Enclosure& bag,
             std::span<const int> node_id, std::span<const Vec3> x, const std::string& name);

    /// Whether the bag has none.
    [[nodiscard]] bool empty() const { return surfaces_.empty(); }
    /// Chambers of the bag, as many as cards.
    [[nodiscard]] std::size_t size() const { return surfaces_.size(); }

    /// Chambers on the two sides of a facet of the bag, the one that its normal leaves first; -1:
    /// none (outside, or a facet within one chamber).
    [[nodiscard]] const std::array<Index, 2>& beside(std::size_t facet) const {
        return beside_[facet];
    }

    /// The chamber that each room of the bag belongs to, -1: none.
    [[nodiscard]] std::vector<Index> of_rooms(const WettedSurface& surface,
                                              std::span<const Vec3> x) const;

private:
    void add(const ChamberCard& card, const BagWalls& walls, const Enclosure& bag,
             std::span<const int> node_id, std::span<const Vec3> x, const std::string& who);
    void find_cavities(Enclosure& surface, const std::vector<std::size_t>& facets,
                       std::size_t closing, std::span<const Vec3> x) const;
    [[nodiscard]] Index around(const Vec3& point, Index but, std::span<const Vec3> x) const;
    void find_outer_sides(std::size_t closing, std::span<const Vec3> x);
    void check_sides(const BagWalls& walls, const std::string& name) const;
    void check_volumes(const std::vector<ChamberCard>& cards, const BagWalls& walls,
                       const Enclosure& bag, std::span<const Vec3> x,
                       const std::string& name) const;

    std::vector<Enclosure> surfaces_;               ///< with those cavities that the cards name
    std::vector<std::vector<std::size_t>> facets_;  ///< of the bag, by triangle of each
    std::vector<std::array<Index, 2>> beside_;      ///< a row a facet of the bag
    bool fill_bag_ = false;                         ///< whether any has a closing facet
};

}  // namespace corpuscle::gas
