// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <array>
#include <map>

#include "solver/scene/bag_walls.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

constexpr int SIDE = 4;          ///< cells of a panel along x and y
constexpr double PRESSED = 500;  ///< gauge pressure inside [Pa]

enum class Seam { SHARED, TIED };
enum class Cells { QUADS, TRIANGLES };

/// Two square panels of 1 m, 20 mm apart but at their rim. Triangles are cut alike in both panels.
Model flat_bag(Seam seam, Cells kind) {
    Model model = scenes::of({}, scenes::cloth(), 3e-4);
    std::map<std::array<int, 3>, Index> rows;
    const auto node = [&](int i, int j, int panel) {
        const bool is_rim = i == 0 || j == 0 || i == SIDE || j == SIDE;
        const int layer = is_rim && seam == Seam::SHARED ? 0 : panel;
        const auto [at, is_new] =
            rows.try_emplace({i, j, layer}, static_cast<Index>(model.x.size()));
        if (is_new) {
            const double z = is_rim ? 0.0 : 0.01 * panel;
            model.x.emplace_back(Vec3(i, j, 0.0) / SIDE + z * Vec3::UnitZ());
            model.velocity.push_back(Vec3::Zero());
            model.node_id.push_back(static_cast<int>(model.x.size()));
        }
        if (is_new && is_rim && layer == 1) {
            const Index twin = rows.at({i, j, -1});
            model.tied_nodes.push_back({at->second, {twin, twin}, 0.0});
        }
        return at->second;
    };
    const auto add = [&](bool is_front, Index a, Index b, Index c, Index d) {
        std::array<Index, 4> nodes{a, b, c, d};
        if (is_front && c == d) std::swap(nodes[0], nodes[1]);
        if (is_front && c != d) std::swap(nodes[1], nodes[3]);
        model.shells.push_back({static_cast<int>(model.shells.size()) + 1, 0, nodes});
    };
    for (const int panel : {-1, 1})
        for (int i = 0; i < SIDE; ++i)
            for (int j = 0; j < SIDE; ++j) {
                const Index a = node(i, j, panel), b = node(i + 1, j, panel),
                            c = node(i + 1, j + 1, panel), d = node(i, j + 1, panel);
                if (kind == Cells::QUADS) {
                    add(panel > 0, a, b, c, d);
                } else {
                    add(panel > 0, a, b, d, d);
                    add(panel > 0, b, c, d, d);
                }
            }
    gas::UniformBagCard card;
    card.keyword = "*AIRBAG_SIMPLE_AIRBAG_MODEL";
    card.id = 1;
    for (std::size_t s = 0; s < model.shells.size(); ++s)
        card.shells.push_back(static_cast<Index>(s));
    card.cv = 718.0, card.cp = 1005.0;
    card.p_atm = 101325.0;
    card.overpressure = PRESSED;
    card.density = 1.2;
    model.uniform_bags = {card};
    model.end_time = 1e-3;
    return model;
}

double volume_after(Simulation& scene) {
    while (!scene.is_over()) scene.step([](Simulation&) {});
    return scene.uniform_bags()[0].gas().volume();
}

}  // namespace

TEST_CASE("a flat bag of quads runs with a tied seam as with shared nodes", "[solver][closing]") {
    Simulation shared(flat_bag(Seam::SHARED, Cells::QUADS));
    Simulation tied(flat_bag(Seam::TIED, Cells::QUADS));
    CHECK(tied.model().mendings.empty());
    const double first = shared.uniform_bags()[0].gas().volume();
    CHECK(tied.uniform_bags()[0].gas().volume() == Approx(first).epsilon(1e-12));
    const double last = volume_after(shared);
    CHECK(last > 1.001 * first);
    CHECK(volume_after(tied) == Approx(last).epsilon(1e-9));
}

TEST_CASE("corner triangles that two panels share are no wall of the gas", "[solver][closing]") {
    const Seam seam = GENERATE(Seam::SHARED, Seam::TIED);
    const Model whole = flat_bag(seam, Cells::TRIANGLES);
    const gas::BagWalls walls = bag_walls(whole, whole.uniform_bags[0]);
    CHECK(walls.empty_pairs == 2);  // at (0, 0) and (1, 1)
    CHECK(walls.closing == whole.shells.size() - 4);
    CHECK(walls.shell.size() == walls.closing);
    CHECK(walls.part.size() == walls.closing);

    Simulation scene(whole);
    REQUIRE(scene.model().mendings.size() == 1);
    CHECK_THAT(scene.model().mendings[0],
               Catch::Contains("2 pairs of facets with all nodes in common enclose nothing"));
    const double first = scene.uniform_bags()[0].gas().volume();
    CHECK(volume_after(scene) > 1.001 * first);
}

TEST_CASE("as it is, a bag with corner triangles of both panels is refused", "[solver][closing]") {
    Model model = flat_bag(Seam::SHARED, Cells::TRIANGLES);
    model.closes_bags = false;
    CHECK_THROWS_WITH(Simulation(std::move(model)), Catch::Contains("not a simple surface"));
}
