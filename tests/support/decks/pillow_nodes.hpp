// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>

#include "tests/support/decks/box_deck.hpp"

namespace corpuscle::test {

/// Nodes of a square pillow of two panels sewn at the rim,
///
///     z = ± rise (1 - X²)(1 - Y²),   X and Y from -1 to 1
class PillowNodes {
public:
    /// @param side   of the square                                                         [m]
    /// @param rise   of each panel's middle                                                [m]
    /// @param cells  along a side
    /// @param mesh   gets the nodes; outlives this
    PillowNodes(double side, double rise, int cells, DeckMesh& mesh)
        : side_(side), rise_(rise), cells_(cells), mesh_(mesh) {}

    /// Id of the node in column i and row j of the upper (1) or lower (-1) panel.
    int operator()(int i, int j, int panel) {
        const bool is_rim = i == 0 || j == 0 || i == cells_ || j == cells_;
        const auto [at, fresh] =
            ids_.try_emplace({i, j, is_rim ? 0 : panel}, static_cast<int>(mesh_.nodes.size()) + 1);
        if (fresh) {
            const double X = 2.0 * i / cells_ - 1.0, Y = 2.0 * j / cells_ - 1.0;
            mesh_.nodes.emplace_back(0.5 * side_ * X, 0.5 * side_ * Y,
                                     is_rim ? 0.0 : panel * rise_ * (1.0 - X * X) * (1.0 - Y * Y));
        }
        return at->second;
    }

private:
    double side_, rise_;
    int cells_;
    DeckMesh& mesh_;
    std::map<std::array<int, 3>, int> ids_;
};

}  // namespace corpuscle::test
