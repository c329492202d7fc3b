// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "contact/surface/cards.hpp"
#include "solver/base/curve.hpp"

namespace corpuscle::contact {

/// Rows of the parts by which the two sides of a pair touch.
using PartPair = std::pair<Index, Index>;

/// The cards by pairs of parts: which pairs may touch, by which card, from which distance.
///
/// Of several cards that name a pair, the first in the deck's order holds that is on: within its
/// birth and death. While none is on, the first of all stands for them and does nothing.
///
/// Rows of parts are the scene's, and behind them combined ones: that of a node or an edge on the
/// border of parts, which touches by any of them.
class Rules {
public:
    static constexpr int NONE = -1;  ///< row of no card

    /// @param parts  in the scene
    /// To be completed by combine() and choose().
    Rules(std::vector<ContactCard> cards, std::span<const Curve> curves, std::size_t parts);

    /// By row, in the deck's order.
    [[nodiscard]] const std::vector<ContactCard>& cards() const { return cards_; }
    /// The card of a row, not NONE.
    [[nodiscard]] const ContactCard& card(int row) const {
        return cards_[static_cast<std::size_t>(row)];
    }

    /// Row of a combined part; to be called before choose().
    /// @param parts  what it is of
    Index combine(const std::set<Index>& parts);
    /// Whether the same cards have two parts on the same sides.
    [[nodiscard]] bool are_alike(Index a, Index b) const;
    /// Whether the row is that of a combined part.
    [[nodiscard]] bool is_combined(Index part) const { return part >= scene_parts_; }
    /// Whether there are any.
    [[nodiscard]] bool has_combined() const { return is_combined(static_cast<Index>(parts_) - 1); }

    /// Says which cards are on from now on.
    /// @returns whether a card holds for a pair for which it did not hold before
    bool choose(std::span<const std::uint8_t> is_on);

    /// Whether a row is that of a card which is on.
    [[nodiscard]] bool holds(int card) const {
        return card != NONE && is_on_[static_cast<std::size_t>(card)] != 0;
    }

    /// Row of the card for nodes of part `a` against facets of part `b`, or NONE.
    [[nodiscard]] int nodes_against(Index a, Index b) const { return nodes_.now[at(a, b)]; }
    /// Row of the card for edges of the two parts, or NONE.
    [[nodiscard]] int edges_against(Index a, Index b) const { return edges_.now[at(a, b)]; }
    /// Row of the card that held for such a pair until choose() changed it last, or NONE.
    [[nodiscard]] int before(bool is_edges, Index a, Index b) const {
        return (is_edges ? edges_ : nodes_).before[at(a, b)];
    }

    /// Whether there is a card for nodes of two parts, and so for edges if at all, which need not be
    /// on.
    [[nodiscard]] bool may_touch(Index a, Index b) const {
        return nodes_against(a, b) != NONE || nodes_against(b, a) != NONE;
    }
    /// Whether there is one that is on.
    [[nodiscard]] bool touch(Index a, Index b) const {
        return holds(nodes_against(a, b)) || holds(nodes_against(b, a));
    }

    /// Of two parts that touch by a card: 1: a is on its SURFA, -1: b is; 0: it is a single
    /// surface.
    [[nodiscard]] int side_of(int card, Index a, Index b) const {
        if (this->card(card).kind == ContactCard::Kind::SINGLE_SURFACE) return 0;
        return is_first(card, a, b) ? 1 : -1;
    }

    /// Does the card speak of the part at all?
    [[nodiscard]] bool concerns(int card, Index part) const {
        return is_on_side(card, 0, part) || is_on_side(card, 1, part);
    }

    /// Greatest contact thickness that a facet of part `part` has by a card: that of the card, or
    /// its curve's greatest, or its section's.                                                  [m]
    [[nodiscard]] double thickness(int card, Index part, double of_section) const;
    /// Bound on the contact thickness at t: that of LCIDAB; INF without a curve.                [m]
    [[nodiscard]] double most(int card, double t) const;

    /// Whether t lies within birth and death of the card, ends included.                        [s]
    [[nodiscard]] bool is_on(int card, double t) const {
        return t >= this->card(card).birth && t <= this->card(card).death;
    }

    /// Whether the card has the part on its SURFA (side 0) or SURFB (1); a single surface on both.
    [[nodiscard]] bool is_on_side(int card, int side, Index part) const {
        return side_[static_cast<std::size_t>(2 * card + side)][static_cast<std::size_t>(part)];
    }

private:
    [[nodiscard]] std::size_t at(Index a, Index b) const {
        return static_cast<std::size_t>(a) * parts_ + static_cast<std::size_t>(b);
    }
    /// Is part `a` on the card's SURFA, and b on its SURFB?
    [[nodiscard]] bool is_first(int card, Index a, Index b) const {
        return is_on_side(card, 0, a) && is_on_side(card, 1, b);
    }
    void enter(int row);

    struct Table {  ///< parts × parts: row of a card or NONE
        std::vector<int> now, before;
    };

    std::vector<ContactCard> cards_;
    std::vector<Curve> curve_;  ///< by card; empty: none
    Index scene_parts_;
    std::size_t parts_;                    ///< with the combined ones
    std::vector<std::vector<bool>> side_;  ///< cards × 2: parts on SURFA, on SURFB
    Table nodes_, edges_;
    std::vector<std::uint8_t> is_on_;  ///< by card
};

}  // namespace corpuscle::contact
