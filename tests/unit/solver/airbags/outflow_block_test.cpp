// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <optional>
#include "gas/enclosure/enclosure.hpp"
#include "gas/outflow/openings.hpp"
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/unit/solver/airbags/outflow_setup.hpp"

using namespace corpuscle;
using namespace outflow_setup;

namespace {

/// Fabric that leaks, of one room; contact that touches its nodes blocks it.
class BlockedFabric {
public:
    BlockedFabric(std::vector<Triangle> triangles, std::vector<Index> shells, const Points& x,
                  double when_blocked) {
        card_.block = {true, true, true, false};
        walls_.closing = triangles.size();
        walls_.triangles = std::move(triangles);
        walls_.shell = std::move(shells);
        walls_.part.assign(walls_.closing, 0);
        walls_.part_ids = {1};
        walls_.part_rows = {0};
        gas::LeakCard leak;
        leak.part = 0;
        leak.area = leak.velocity = 1.0;
        leak.when_blocked = when_blocked;
        walls_.leaks = {leak};
        surface_ = std::make_shared<gas::WettedSurface>(walls_.triangles, walls_.closing, x);
        samples_ = gas::WallSamples(surface_, walls_, species_, mass_, GAS_CONSTANT, 1e-3,
                                    std::vector<char>(walls_.closing, 0), x);
        openings_.emplace(card_, walls_, std::span<const Curve>{}, species_, mass_, *surface_,
                          samples_, x, 1);
    }
    /// By triangle: share of its leak that is left.
    std::vector<double> open(const std::vector<std::uint8_t>& touching) {
        openings_->block(touching, {});
        return openings_->transmission()->open;
    }

private:
    gas::BagCard card_;
    gas::BagWalls walls_;
    std::vector<gas::Species> species_{{scenes::air(), GAS_CONSTANT, "air"}};
    std::vector<double> mass_{1.0};
    std::shared_ptr<const gas::WettedSurface> surface_;
    gas::WallSamples samples_;
    std::optional<gas::Openings> openings_;
};

}  // namespace

TEST_CASE("a touching node blocks a third of a triangle's leak and a quarter of a quad's",
          "[gas][block]") {
    const double when_blocked = GENERATE(0.0, 0.4), lost = 1.0 - when_blocked;
    BlockedFabric fabric({{0, 1, 2}, {0, 2, 3}, {3, 2, 4}}, {0, 0, 1},
                         {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 2, 0}}, when_blocked);
    CHECK(fabric.open({0, 0, 0, 0, 0}) == std::vector<double>{1.0, 1.0, 1.0});
    const auto one = fabric.open({1, 0, 0, 0, 0});
    CHECK(one[0] == Approx(1.0 - lost / 4.0));
    CHECK(one[1] == Approx(1.0 - lost / 4.0));
    CHECK(one[2] == 1.0);
    CHECK(fabric.open({0, 0, 1, 0, 0})[2] == Approx(1.0 - lost / 3.0));
    CHECK(fabric.open({1, 1, 1, 1, 1})[2] == Approx(when_blocked));
}

TEST_CASE("a touching node blocks a third of each triangle of a quad cut at hanging nodes",
          "[gas][block]") {
    // A quad of 1 m, one edge of which has as many nodes as there are triangles, less one.
    const Index hanging = GENERATE(1, 3, 40);
    Points x{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    std::vector<Triangle> triangles;
    for (Index k = 0; k <= hanging; ++k) {
        x.push_back({1.0 - (k + 1.0) / (hanging + 1.0), 1, 0});
        triangles.push_back({1, k + 2, k + 3});
    }
    triangles.push_back({0, 1, static_cast<Index>(x.size()) - 1});
    BlockedFabric fabric(triangles, std::vector<Index>(triangles.size(), 0), x, 0.0);
    std::vector<std::uint8_t> touching(x.size(), 0);
    touching[1] = touching[3] = 1;
    const std::vector<double> open = fabric.open(touching);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        CHECK(open[t] == Approx(t < 2 ? 1.0 / 3.0 : 2.0 / 3.0));
    touching.assign(x.size(), 1);
    CHECK(fabric.open(touching) == std::vector<double>(triangles.size(), 0.0));
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
