// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/decks/box_deck.hpp"

#include <fmt/format.h>

namespace corpuscle::test {

namespace {

/// Nodes of a grid as they are asked for.
struct GridNodes {
    const BoxDeck& box;
    DeckMesh& mesh;
    std::map<std::array<int, 3>, int> ids;

    int operator()(const std::array<int, 3>& grid) {
        const auto [at, fresh] = ids.try_emplace(grid, static_cast<int>(mesh.nodes.size()) + 1);
        if (fresh) {
            Vec3 x;
            for (int k = 0; k < 3; ++k) x[k] = box.size[k] * grid[k] / box.cells[k];
            mesh.nodes.push_back(x);
        }
        return at->second;
    }
};

}  // namespace

DeckMesh BoxDeck::mesh() const {
    DeckMesh mesh;
    GridNodes node{*this, mesh, {}};
    const auto quad = [&](int axis, int at, int i, int j, int of_part) {
        std::array<std::array<int, 3>, 4> corner{};
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        constexpr int DI[] = {0, 1, 1, 0}, DJ[] = {0, 0, 1, 1};
        for (int k = 0; k < 4; ++k) {
            corner[k][axis] = at;
            corner[k][u] = i + DI[k];
            corner[k][v] = j + DJ[k];
        }
        const bool inward = at == 0;  // normals look along the axis
        Vec3 centre = Vec3::Zero();
        std::array<int, 4> ids{};
        for (int k = 0; k < 4; ++k) {
            ids[k] = node(corner[inward ? k : 3 - k]);
            centre += 0.25 * mesh.nodes[static_cast<std::size_t>(ids[k] - 1)];
        }
        mesh.quads.push_back({of_part ? of_part : part(centre), ids});
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int at : {0, cells[axis]})
            for (int i = 0; i < cells[(axis + 1) % 3]; ++i)
                for (int j = 0; j < cells[(axis + 2) % 3]; ++j) quad(axis, at, i, j, 0);
    for (const auto& [at, of_part] : membranes)
        for (int i = 0; i < cells[1]; ++i)
            for (int j = 0; j < cells[2]; ++j) quad(0, at, i, j, of_part);
    return mesh;
}

std::string DeckMesh::cards(const std::function<bool(const Vec3&)>& is_held) const {
    std::string text = "*NODE\n", held = "*SET_NODE_LIST\n1\n";
    int held_so_far = 0;
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        text += fmt::format("{}, {:.12g}, {:.12g}, {:.12g}\n", n + 1, nodes[n].x(), nodes[n].y(),
                            nodes[n].z());
        if (!is_held(nodes[n])) continue;
        held += fmt::format("{}{}", n + 1, ++held_so_far % 8 ? ", " : "\n");
    }
    text += "*ELEMENT_SHELL\n";
    for (std::size_t e = 0; e < quads.size(); ++e) {
        const auto& [a, b, c, d] = quads[e].nodes;
        text += fmt::format("{}, {}, {}, {}, {}, {}\n", e + 1, quads[e].part, a, b, c, d);
    }
    if (held_so_far > 0) text += held + "\n*BOUNDARY_SPC_SET\n1, 0, 1, 1, 1, 1, 1, 1\n";
    return text;
}

std::string curve_card(int id, const std::vector<std::array<double, 2>>& points) {
    std::string text = fmt::format("*DEFINE_CURVE\n{}\n", id);
    for (const auto& [x, y] : points) text += fmt::format("{:.10g}, {:.12g}\n", x, y);
    return text;
}

std::string step_card(int id, double time, double value) {
    return curve_card(id, {{0.0, 0.0}, {time, 0.0}, {time, value}, {1.0, value}});
}

std::string set_card(int id, const std::vector<int>& parts) {
    std::string text = fmt::format("*SET_PART_LIST\n{}\n", id);
    for (const int part : parts) text += fmt::format("{}, ", part);
    text.resize(text.size() - 2);
    return text + "\n";
}

std::string part_card(int id, int material, int section) {
    return fmt::format("*PART\npart {}\n{}, {}, {}\n", id, id, section, material);
}

std::string section_card(int id, double thickness) {
    return fmt::format("*SECTION_SHELL\n{0}, 5\n{1:.9g}, {1:.9g}, {1:.9g}, {1:.9g}\n", id,
                       thickness);
}

std::string node_card(int id, const Vec3& x) {
    return fmt::format("*NODE\n{}, {:.12g}, {:.12g}, {:.12g}\n", id, x.x(), x.y(), x.z());
}

std::string box_deck(const std::string& title, const BoxDeck& box, const std::string& cards,
                     double end, double sample) {
    return "*KEYWORD\n*TITLE\n" + title + "\n" +
           box.mesh().cards([&](const Vec3& x) { return box.is_held(x); }) + cards +
           fmt::format("*CONTROL_TERMINATION\n{:.12g},\n*DATABASE_ABSTAT\n{:.10g},\n*END\n", end,
                       sample);
}

}  // namespace corpuscle::test
