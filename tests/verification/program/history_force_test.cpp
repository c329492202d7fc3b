// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the forces on walls and of contacts in the histories, each times the interval since the
// row before, sum up to the momentum that was passed on, however short the hit and wherever the
// rows fall; and a restart leaves no trace in them.

#include <catch2/catch.hpp>

#include <optional>

#include "io/results/hdf5.hpp"
#include "tests/support/geometry/cloth.hpp"
#include "tests/support/scenes/touching_bodies.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;

namespace {

struct History {
    std::vector<double> time;
    Points force, momentum;
    double total = 0.0;  ///< greatest momentum                                         [kg m/s]
};

Points points(const io::Hdf5Reader& file, const std::string& path) {
    const std::vector<double> values = file.read<double>(path);
    Points rows;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
        rows.emplace_back(values[i], values[i + 1], values[i + 2]);
    return rows;
}

/// Runs with a row every 5 steps.
/// @param stops  the step after which everything goes on from a checkpoint; none: never
History history(const Model& model, const std::string& force, std::optional<std::int64_t> stops) {
    parallel::set_threads(1);
    const scene::Folder folder("history_force");
    auto simulation = std::make_unique<Simulation>(model);
    const RecordLayout layout = simulation->layout();
    auto results = std::make_unique<io::ResultsFile>(folder.path, scene::info(), layout);
    const auto observe = [&](Simulation& at) {
        if (at.steps() % 5 == 0) results->append(at.sample());
    };
    while (!simulation->is_over()) {
        simulation->step(observe);
        if (stops != simulation->steps()) continue;
        StateWriter state;
        state(*simulation, *results);
        simulation = std::make_unique<Simulation>(model);
        StateReader from(state.bytes());
        from(*simulation);
        results = std::make_unique<io::ResultsFile>(folder.path, scene::info(), layout, from);
    }
    simulation->close([&](Simulation& at) { results->append(at.sample()); });
    results->finish("normal");

    const io::Hdf5Reader file(folder.path / "results.h5");
    History all;
    all.time = file.read<double>("/history/time");
    all.force = points(file, force);
    all.momentum = points(file, "/history/part/1/momentum");
    for (const Vec3& p : all.momentum) all.total = std::max(all.total, p.norm());
    return all;
}

/// Of what part 1 has gained up to each row, and of -sign times the impulse up to there.  [kg m/s]
double greatest_difference(const History& rows, double sign) {
    Vec3 impulse = Vec3::Zero();
    double worst = 0.0;
    for (std::size_t k = 1; k < rows.time.size(); ++k) {
        impulse += (rows.time[k] - rows.time[k - 1]) * rows.force[k];
        worst = std::max(worst, (rows.momentum[k] - rows.momentum[0] - sign * impulse).norm());
    }
    return worst;
}

/// A rigid ball (part 1) that is thrown on a wall; hits of one step.
Model ball_on_wall() {
    Model model = scenes::empty(4e-3);
    scenes::add(model, shapes::sphere(0.04, 2), scenes::rigid(200.0), 2e-3, Vec3(0, 0, 0.045));
    model.rigid_velocity = {{0, Vec3(2, 1, -15), Vec3(30, -80, 120)}};
    contact::WallCard wall;
    wall.id = 1;
    wall.shape = contact::HalfSpace{Vec3::Zero(), Vec3::UnitZ()};
    wall.friction = 0.3;
    for (std::size_t n = 0; n < model.x.size(); ++n) wall.nodes.push_back(static_cast<Index>(n));
    model.walls = {wall};
    return model;
}

/// Free cloth (part 1) that is thrown on a fixed rigid plate.
Model cloth_on_plate() {
    Model model = scenes::empty(4e-3);
    const support::Sheet sheet = support::square_sheet(4, 0.1);
    scenes::add(model, sheet.x, sheet.triangles, scenes::cloth(), 3e-4, Vec3(0, 0, 5e-3));
    for (Vec3& v : model.velocity) v = Vec3(1, 0, -10);
    fabric::RigidCard plate = scenes::rigid(1000.0);
    plate.fixed_moves = plate.fixed_turns = 0b111;
    const support::Sheet wide = support::square_sheet(3, 0.3);
    scenes::add(model, wide.x, wide.triangles, plate, 1e-3, Vec3(-0.1, -0.1, 0));
    contact::ContactCard card;
    card.friction_static = card.friction_dynamic = 0.2;
    scenes::touch(model, card);
    model.contacts[0].death = 0.53e-3;  // amid the hit: nothing is passed on from then on
    return model;
}

}  // namespace

TEST_CASE("forces on a wall times their intervals are the momentum that it took", "[results]") {
    const History rows = history(ball_on_wall(), "/history/rigidwall/1/force", {});
    CAPTURE(rows.time.size(), rows.total);
    REQUIRE(rows.time.size() > 20);
    REQUIRE((rows.momentum.back() - rows.momentum.front()).norm() > 0.5 * rows.total);
    CHECK(greatest_difference(rows, -1.0) < 1e-12 * rows.total);
}

TEST_CASE("forces of a contact times their intervals are the momentum that it passed on",
          "[results]") {
    const History rows = history(cloth_on_plate(), "/history/contact/1/force", {});
    CAPTURE(rows.time.size(), rows.total);
    REQUIRE(rows.time.size() > 20);
    REQUIRE((rows.momentum.back() - rows.momentum.front()).norm() > 0.5 * rows.total);
    CHECK(greatest_difference(rows, 1.0) < 1e-12 * rows.total);
    CHECK(rows.force.back().isZero(0.0));
}

TEST_CASE("a restart between two rows leaves the mean forces as they are", "[results]") {
    const bool has_wall = GENERATE(true, false);
    const Model model = has_wall ? ball_on_wall() : cloth_on_plate();
    const std::string force = has_wall ? "/history/rigidwall/1/force" : "/history/contact/1/force";
    const History whole = history(model, force, {});
    REQUIRE(whole.force.size() == whole.time.size());
    for (const std::int64_t stops : {43, 96, 152}) {
        const History broken = history(model, force, stops);
        CHECK(broken.time == whole.time);
        CHECK(broken.force == whole.force);
    }
}
