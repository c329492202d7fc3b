// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include "gas/enclosure/enclosure.hpp"
#include "gas/outflow/openings.hpp"
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/unit/solver/airbags/outflow_setup.hpp"

using namespace corpuscle;
using namespace outflow_setup;

TEST_CASE("a touching node blocks a third of a triangle's leak and a quarter of a quad's",
          "[gas][block]") {
    gas::BagCard card;
    card.block = {true, true, true, false};
    gas::BagWalls walls;
    walls.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}};
    walls.shell = {0, 0, 1};
    walls.part = {0, 0, 0};
    walls.closing = 3;
    walls.part_ids = {1};
    walls.part_rows = {0};
    gas::LeakCard leak;
    leak.part = 0;
    leak.area = leak.velocity = 1.0;
    leak.when_blocked = GENERATE(0.0, 0.4);
    walls.leaks = {leak};
    const Points x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 2, 0}};
    const std::vector<gas::Species> species{{scenes::air(), GAS_CONSTANT, "air"}};
    const std::vector<double> mass{1.0};
    const auto surface = std::make_shared<gas::WettedSurface>(walls.triangles, 3, x);
    gas::WallSamples samples(surface, walls, species, mass, GAS_CONSTANT, 1e-3,
                             std::vector<char>(3, 0), x);
    gas::Openings openings(card, walls, {}, species, mass, *surface, samples, x, 1);
    const auto open = [&](std::vector<std::uint8_t> touching) {
        openings.block(touching, {});
        return openings.transmission()->open;
    };
    const double lost = 1.0 - leak.when_blocked;
    CHECK(open({0, 0, 0, 0, 0}) == std::vector<double>{1.0, 1.0, 1.0});
    const auto one = open({1, 0, 0, 0, 0});
    CHECK(one[0] == Approx(1.0 - lost / 4.0));
    CHECK(one[1] == Approx(1.0 - lost / 4.0));
    CHECK(one[2] == 1.0);
    CHECK(open({0, 0, 1, 0, 0})[2] == Approx(1.0 - lost / 3.0));
    CHECK(open({1, 1, 1, 1, 1})[2] == Approx(leak.when_blocked));
}

TEST_CASE(
    "with BLOCK of 20 a vent shuts where contact presses harder than the gas, not where it "
    "touches",
    "[solver][block]") {
    Model model = tank(500);
    gas::BagCard& card = model.bags[0];
    card.vents = {vent(1.0, true)};
    card.block.by_pressure = true;
    card.air = gas::InitialAirCard{scenes::air(), 3.0 * P_ATM, 300.0};
    gas::BagWalls walls;
    for (const Shell& shell : model.shells) {
        walls.shell.push_back(static_cast<Index>(walls.triangles.size()));
        walls.triangles.push_back({shell.nodes[0], shell.nodes[1], shell.nodes[2]});
        walls.part.push_back(shell.part);
    }
    walls.closing = walls.triangles.size();
    walls.part_ids = {1, 2};
    walls.part_rows = {0, 1};
    const std::size_t count = model.x.size();
    const std::vector<std::uint8_t> all(count, 1);
    gas::BagGas bag(card, walls, model.curves, model.node_id, all, model.x, 1);
    Points area(count, Vec3::Zero()), force(count, Vec3::Zero());
    const Points v(count, Vec3::Zero());
    bag.add_load(model.x, v, std::vector<double>(count, 1.0), 1e-6, force);
    bag.prepare(1e-6, model.x, model.x);
    bag.inject(0.0, 1e-6, model.x, model.x);
    bag.fly(0.0, 1e-6, model.x, model.x);
    bag.enclosure().node_areas(model.x, area);
    for (const double share : {0.5, 1.5}) {
        std::fill(force.begin(), force.end(), Vec3::Zero());
        for (const Index n : model.shells.back().nodes) force[n] = -share * 2.0 * P_ATM * area[n];
        bag.set_touching(all, force);
        const std::vector<double>& open = bag.openings().transmission()->open;
        CHECK(open.back() == Approx(share > 1.0 ? 0.0 : 1.0));
        CHECK(open.front() == 1.0);
    }
}
