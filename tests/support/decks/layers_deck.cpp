// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/decks/layers_deck.hpp"

#include <fmt/format.h>

namespace corpuscle::test {

LayersDeck::Ids LayersDeck::ids(std::size_t layer) const {
    Ids at{1, 1, 1, 1};
    for (std::size_t l = 0; l <= layer; ++l) {
        const int n = layers[l].cells;
        at = {at.node_end, at.node_end + (n + 1) * (n + 1), at.shell_end, at.shell_end + n * n};
    }
    return at;
}

std::string LayersDeck::press(std::size_t layer, int curve, double scale) const {
    const Ids of = ids(layer);
    const int set = 1000 + static_cast<int>(layer);
    std::string text = fmt::format("*SET_SHELL_LIST\n{}\n", set);
    for (int s = of.shell; s < of.shell_end; ++s)
        text += fmt::format("{}{}", s, (s - of.shell) % 8 == 7 ? "\n" : ", ");
    return text + fmt::format("\n*LOAD_SHELL_SET\n{}, {}, {}\n", set, curve, scale);
}

std::string LayersDeck::velocity(std::size_t layer, const Vec3& v) const {
    const Ids of = ids(layer);
    std::string text = "*INITIAL_VELOCITY_NODE\n";
    for (int n = of.node; n < of.node_end; ++n)
        text += fmt::format("{}, {}, {}, {}\n", n, v.x(), v.y(), v.z());
    return text;
}

std::string LayersDeck::text(const std::string& title, const std::string& cards, double end,
                             double sample) const {
    DeckMesh mesh;
    std::string parts;
    std::vector<bool> is_held;
    for (std::size_t l = 0; l < layers.size(); ++l) {
        const Layer& layer = layers[l];
        const int part = static_cast<int>(l) + 1, n = layer.cells, first = ids(l).node;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                mesh.nodes.emplace_back(layer.centre.x() + layer.side * (i / double(n) - 0.5),
                                        layer.centre.y() + layer.side * (j / double(n) - 0.5),
                                        layer.z);
                is_held.push_back(layer.kind == Layer::Kind::HELD_CLOTH &&
                                  (i == 0 || j == 0 || i == n || j == n));
            }
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const int a = first + j * (n + 1) + i;
                mesh.quads.push_back({part, {a, a + 1, a + n + 2, a + n + 1}});
            }
        parts += part_card(part, part, 1);
        const bool is_fixed = layer.kind == Layer::Kind::FIXED_PLATE;
        if (is_fixed || layer.kind == Layer::Kind::FREE_PLATE)
            parts += fmt::format("*MAT_RIGID\n{}, {}, 2.1e11, 0.3\n{}\n\n", part, layer.density,
                                 is_fixed ? "1, 7, 7" : "0, 0, 0");
        else
            parts += fmt::format("*MAT_FABRIC\n{0}, {1}, {2}, {2}, , 0.3, 0.3\n{3}\n0\n0\n, 0\n0\n",
                                 part, layer.density, modulus, 0.4 * modulus);
    }
    std::string held = "*SET_NODE_LIST\n1\n";
    int so_far = 0;
    for (std::size_t k = 0; k < is_held.size(); ++k)
        if (is_held[k]) held += fmt::format("{}{}", k + 1, ++so_far % 8 ? ", " : "\n");
    std::string text = "*KEYWORD\n*TITLE\n" + title + "\n";
    text += mesh.cards([](const Vec3&) { return false; });
    if (so_far > 0) text += held + "\n*BOUNDARY_SPC_SET\n1, 0, 1, 1, 1, 1, 1, 1\n";
    text += parts + section_card(1, thickness) + cards;
    text += fmt::format(
        "*CONTACT_AIRBAG_SINGLE_SURFACE\n0, 0, 0\n{0}, {0}, 0.0, 0.0, {1}\n1.0, 1.0, {2}, {2}\n",
        friction, damping, thickness);
    text += fmt::format(
        "*CONTROL_TIMESTEP\n0.0, {}\n*CONTROL_TERMINATION\n{:.12g}\n*DATABASE_GLSTAT\n{:.10g}\n"
        "*DATABASE_BINARY_D3PLOT\n{:.10g}\n*END\n",
        step, end, sample, sample);
    return text;
}

std::size_t last_frame(const DeckRun& run) {
    return run.read("/frames/time").size() - 1;
}

LayerState layer_state(const DeckRun& run, const LayersDeck& deck, std::size_t layer,
                       std::size_t frame) {
    const auto of = deck.ids(layer);
    const auto x = run.read(fmt::format("/frames/{:05}/coordinates", frame));
    const auto v = run.read(fmt::format("/frames/{:05}/velocity", frame));
    LayerState out;
    for (int n = of.node - 1; n < of.node_end - 1; ++n) {
        const auto at = static_cast<std::size_t>(3 * n);
        out.x.emplace_back(x[at], x[at + 1], x[at + 2]);
        out.v.emplace_back(v[at], v[at + 1], v[at + 2]);
        out.mean_x += out.x.back();
        out.mean_v += out.v.back();
    }
    out.mean_x /= static_cast<double>(out.x.size());
    out.mean_v /= static_cast<double>(out.v.size());
    return out;
}

}  // namespace corpuscle::test
