// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what a run says a rigid body felt is what happened to it: impulse = m Δv to 1e-6 and
// energy absorbed = change of kinetic energy, however the steps fall between the history's rows.

#include <catch2/catch.hpp>

#include <map>

#include "solver/base/parallel.hpp"
#include "tests/support/geometry/cloth.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/support/scenes/touching_bodies.hpp"
#include "tests/unit/io/results/results_scene.hpp"
#include "tools/body_tracker.hpp"

using namespace corpuscle;
using scenes::add;

namespace {

/// A ball (part 2) on its way into free cloth, SI.
Model ball_and_cloth() {
    Model model;
    model.title = model.deck = "test";
    model.unit_system = "SI";
    model.end_time = 4e-3;
    const support::Sheet sheet = support::square_sheet(12, 0.2);
    add(model, sheet.x, sheet.triangles, scenes::cloth(), 3e-4, Vec3(-0.1, -0.1, 0));
    fabric::RigidCard rigid;
    rigid.density = 200.0;
    rigid.E = 1e9;
    const shapes::Shape ball = shapes::sphere(0.04, 3);
    add(model, ball.x, ball.triangles, rigid, 2e-3, Vec3(0.011, 0.007, 0.045));
    model.rigid_velocity = {{1, Vec3(2, 1, -15), Vec3(30, -80, 120)}};
    contact::ContactCard card;
    card.id = 1;
    card.friction_static = card.friction_dynamic = 0.3;
    card.parts = {0, 1};
    model.contacts = {card};
    return model;
}

}  // namespace

TEST_CASE("the impulse on a body is m times its change of velocity", "[responses]") {
    parallel::set_threads(1);
    const scene::Folder folder("ball_responses");
    Simulation simulation(ball_and_cloth());
    io::RunInfo info = scene::info();
    info.unit_system = "SI";
    io::ResultsFile results(folder.path, info, simulation.layout());
    tools::BodyTracker tracker(simulation, results);
    const auto observe = [&](Simulation& s) { tracker.observe(s, false); };
    const Vec3 v_0 = simulation.bodies()[0].velocity();
    while (!simulation.is_over()) simulation.step(observe);
    simulation.close([&](Simulation& s) { tracker.observe(s, true); });

    const std::vector<io::BodyTable> tables = results.responses();
    REQUIRE(tables.size() == 1);
    CHECK(tables[0].id == 2);
    std::map<std::string, double> r;
    for (const io::Response& response : tables[0].responses) r[response.name] = response.value;
    results.finish("normal");
    const io::Hdf5Reader file(folder.path / "results.h5");
    const io::BodyMotion motion = io::read_motion(file, 2);
    CHECK(motion.velocity.size() == 401);
    CHECK(motion.interval == Approx(1e-5));

    const double mass = simulation.bodies()[0].mass();
    const Vec3 v_1 = motion.velocity.back();
    REQUIRE((v_1 - v_0).norm() > 1.0);  // they did meet
    CHECK((v_1 - simulation.bodies()[0].velocity()).norm() < 0.01 * (v_1 - v_0).norm());
    CHECK(r.at("impulse") == Approx(mass * (v_1 - v_0).norm()).epsilon(1e-6));
    CHECK(r.at("energy_absorbed") ==
          Approx(0.5 * mass * (v_0.squaredNorm() - v_1.squaredNorm())).epsilon(1e-6));
    CHECK(1e3 * r.at("peak_force") ==  // kN
          Approx(mass * 9.80665 * r.at("peak_acceleration")).epsilon(1e-6));
}
