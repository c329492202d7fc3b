// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/support/decks/box_deck.hpp"
#include "tests/support/runs/deck_run.hpp"

/// Keyword decks of square sheets, one above the other. SI units.
namespace corpuscle::test {

/// A square sheet of cloth, across z; its part is its place in the deck + 1.
struct Layer {
    double z = 0.0;              ///< [m]
    int cells = 8;               ///< along an edge
    double side = 0.1;           ///< [m]
    Vec3 centre = Vec3::Zero();  ///< z of it does not count                                 [m]
    enum class Kind { CLOTH, FIXED_PLATE, FREE_PLATE, HELD_CLOTH } kind = Kind::CLOTH;
    double density = 800.0;  ///< [kg/m^3]
};

/// A deck of layers that touch; all else that it needs is added as cards.
struct LayersDeck {
    std::vector<Layer> layers;
    double thickness = 0.33e-3;  ///< of sections and of contact                             [m]
    double modulus = 300e6;      ///< of cloth in the plane                                  [Pa]
    double friction = 0.0;       ///< FS = FD
    double damping = 0.0;        ///< VDC                                                    [%]
    double step = 0.9;           ///< TSSFAC

    /// Ids of a layer's nodes and shells, the first and the one behind the last.
    struct Ids {
        int node, node_end, shell, shell_end;
    };
    [[nodiscard]] Ids ids(std::size_t layer) const;
    /// *LOAD_SHELL_SET: curve · scale presses a layer along -z.
    [[nodiscard]] std::string press(std::size_t layer, int curve, double scale) const;
    /// *INITIAL_VELOCITY_NODE of a layer's nodes.
    [[nodiscard]] std::string velocity(std::size_t layer, const Vec3& v) const;

    [[nodiscard]] std::string text(const std::string& title, const std::string& cards, double end,
                                   double sample) const;
};

/// What the nodes of a layer have in a frame.
struct LayerState {
    Points x, v;  ///< [m], [m/s]
    Vec3 mean_x = Vec3::Zero(), mean_v = Vec3::Zero();
};
[[nodiscard]] LayerState layer_state(const DeckRun& run, const LayersDeck& deck, std::size_t layer,
                                     std::size_t frame);
/// Number of the last frame.
[[nodiscard]] std::size_t last_frame(const DeckRun& run);

}  // namespace corpuscle::test
