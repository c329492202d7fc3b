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

/// The chambers of a bag (*DEFINE_CPM_CHAMBER): each a closed surface of its own, of closing facets
/// and of internal ones that it shares with another chamber. Together they fill the bag.
class Chambers {
public:
    /// No card: no chambers.
    /// @param walls    of the bag that is divided, closing and internal
    /// @param bag      its closed surface
    /// @param node_id  N: the deck's, for messages
    /// @param x        N × 3, nodes at the start                                            [m]
    /// @param name     of the bag, for messages
    /// @throws InputError  where surfaces are not closed, facets belong to too
    ///                     many or too few of them, or their volumes do not add up to the bag's
    Chambers(const std::vector<ChamberCard>& cards, const BagWalls& walls, const Enclosure& bag,
             std::span<const int> node_id, std::span<const Vec3> x, const std::string& name);

    /// Whether the bag has none.
    [[nodiscard]] bool empty() const { return surfaces_.empty(); }
    /// Chambers of the bag, as many as cards.
    [[nodiscard]] std::size_t size() const { return surfaces_.size(); }
    /// Closed surface of one chamber, in the order of the cards.
    [[nodiscard]] const Enclosure& surface(std::size_t chamber) const { return surfaces_[chamber]; }

    /// Chambers on the two sides of a facet of the bag, the one that its normal leaves first; -1:
    /// none (outside, or a facet within one chamber).
    [[nodiscard]] const std::array<Index, 2>& beside(std::size_t facet) const {
        return beside_[facet];
    }

    /// The chamber that each point lies in, or the nearest to say so: the first where rounding
    /// leaves none.  Cost: one ray a chamber and point.
    [[nodiscard]] std::vector<Index> of(std::span<const Vec3> points,
                                        std::span<const Vec3> x) const;

private:
    std::vector<Enclosure> surfaces_;
    std::vector<std::array<Index, 2>> beside_;  ///< a row a facet of the bag
};

}  // namespace corpuscle::gas
