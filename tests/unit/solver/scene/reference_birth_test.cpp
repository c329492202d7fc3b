// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <memory>

#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/reference_geometry.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

/// A sphere that its reference geometry would have smaller by a tenth, tugged at.
Model taut_sphere() {
    fabric::FabricCard card;
    card.density = 700;
    card.E_warp = card.E_weft = 300e6;
    card.nu_ba = 0.3;
    card.G = 115e6;
    Model model = scenes::of(shapes::sphere(0.1, 2), card, 3e-4);
    ReferenceGeometry reference;
    for (std::size_t n = 0; n < model.x.size(); ++n)
        reference.nodes.emplace_back(static_cast<Index>(n), 0.9 * model.x[n]);
    model.references = {reference};
    model.velocity[0] = {0, 0, 5};
    model.end_time = 1e-3;
    model.step_factor = 0.1;
    return model;
}

struct History {
    std::vector<double> time;
    std::vector<Points> x;
    double worst = 0.0, external = 0.0;
};
History history_of(Model model) {
    Simulation simulation(std::move(model));
    History out;
    const auto look = [&](Simulation& s) {
        out.time.push_back(s.time());
        out.x.push_back(s.nodes().x);
        const EnergyBooks books = s.books();
        out.worst = std::max(out.worst, std::abs(books.residual));
        out.external = books.external;
    };
    while (!simulation.is_over()) simulation.step(look);
    simulation.close(look);
    return out;
}

}  // namespace

TEST_CASE("before its birth a reference geometry does not count, afterwards it does",
          "[solver][reference]") {
    Model model = taut_sphere();
    const bool by_material = GENERATE(false, true);
    const double birth = 0.4e-3;
    if (by_material) std::get<fabric::FabricCard>(model.materials[0].card).reference_birth = birth;
    model.references[0].birth = by_material ? 5.0 : birth;
    const History born = history_of(model);
    model.references.clear();
    // Masses are those of the reference shape throughout
    std::get<fabric::FabricCard>(model.materials[0].card).density *= 0.81;
    const History without = history_of(model);
    std::size_t i = 0;
    for (; born.time[i + 1] < birth; ++i) {
        REQUIRE(born.time[i] == Approx(without.time[i]).epsilon(1e-12));
        for (std::size_t n = 0; n < model.x.size(); ++n)
            REQUIRE((born.x[i][n] - without.x[i][n]).norm() < 1e-9);
    }
    CHECK(i > 20);
    double moved = 0.0;
    for (std::size_t n = 0; n < model.x.size(); ++n)
        moved = std::max(moved, (born.x.back()[n] - without.x.back()[n]).norm());
    CHECK(moved > 0.005);
    // The strain that is born is work from outside, 1.7 of it for 10 % in all directions
    CHECK(without.external == 0.0);
    CHECK(born.external > 10.0);
    CHECK(born.worst < 0.01 * born.external);
}

TEST_CASE("born at the start is not born later", "[solver][reference]") {
    Model model = taut_sphere();
    CHECK(reference_births(model).empty());
    const History from_start = history_of(model);
    model.references[0].birth = 1e-9;  // the second step is the first after it
    const History born = history_of(model);
    CHECK(born.external > 10.0);
    CHECK(from_start.external == 0.0);
}

TEST_CASE("births are those of the shells' nodes, or of their material", "[solver][reference]") {
    Model model = taut_sphere();
    ReferenceGeometry later;
    later.nodes = {model.references[0].nodes[0]};
    later.birth = 2e-3;
    model.references[0].birth = 1e-3;
    model.references.push_back(later);
    const std::vector<double> births = reference_births(model);
    for (std::size_t s = 0; s < births.size(); ++s) {
        const auto& nodes = model.shells[s].nodes;
        const bool has_first = std::find(nodes.begin(), nodes.end(), 0) != nodes.end();
        CHECK(births[s] == (has_first ? 2e-3 : 1e-3));
    }
    CHECK(next_birth(0.0, births) == 1e-3);
    CHECK(next_birth(1e-3, births) == 2e-3);
    CHECK(next_birth(2e-3, births) == INF);
    const auto corners = reference_corners(model);
    const auto at = corners_before(2e-3, births, corners, model);
    for (std::size_t s = 0; s < births.size(); ++s)
        CHECK((at[s][0] == corners[s][0]) == (births[s] == 1e-3));
}

TEST_CASE("a restart at a birth that has come but does not count yet leaves no trace",
          "[solver][reference][restart]") {
    Model model = taut_sphere();
    model.references[0].birth = 0.2e-3;
    ReferenceGeometry later;
    later.nodes = {model.references[0].nodes[0]};
    later.birth = 0.4e-3;
    model.references.push_back(later);
    const auto told = [&](bool is_restarted) {
        auto simulation = std::make_unique<Simulation>(model);
        std::vector<std::vector<char>> states;
        int restarts_at_birth = 0;
        while (!simulation->is_over()) {
            simulation->step([](Simulation&) {});
            StateWriter state;
            state(*simulation);
            states.push_back(state.take());
            if (!is_restarted) continue;
            restarts_at_birth += simulation->scene().cloth.next_birth <= simulation->time() ? 1 : 0;
            simulation = std::make_unique<Simulation>(model);
            StateReader reader(states.back());
            reader(*simulation);
            REQUIRE(reader.is_at_end());
        }
        CHECK(restarts_at_birth == (is_restarted ? 2 : 0));
        return states;
    };
    const auto whole = told(false), broken = told(true);
    REQUIRE(whole.size() == broken.size());
    for (std::size_t k = 0; k < whole.size(); ++k) REQUIRE(whole[k] == broken[k]);
}

TEST_CASE("a birth does not go with added mass or strains that come back", "[solver][reference]") {
    Model model = taut_sphere();
    model.references[0].birth = 1e-4;
    model.step_mass_scaled = -1e-6;
    std::get<fabric::FabricCard>(model.materials[0].card).restoration.share = 0.1;
    try {
        Simulation simulation(model);
        FAIL();
    } catch (const InputError& error) {
        CHECK(error.faults.size() == 2);
    }
}

TEST_CASE("strains of the start that come back are booked, and the books close",
          "[solver][reference]") {
    Model model = taut_sphere();
    std::get<fabric::FabricCard>(model.materials[0].card).restoration.share = 0.002;
    const History history = history_of(model);
    CHECK(history.external > 1e-3);
    CHECK(history.worst < 0.01 * history.external);
}
