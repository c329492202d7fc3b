// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the forms of the out-of-position models start where their parameters say, keep to their
// lines, and take from the bag what they lose: impulse = m dv, to rounding.

#include <catch2/catch.hpp>

#include <cmath>

#include "io/responses/body_responses.hpp"
#include "tests/support/runs/model_run.hpp"

using namespace corpuscle;
using corpuscle::test::ModelRun;

namespace {

io::BodyMotion form(const ModelRun& run, int part) {
    REQUIRE(run.status() == 0);
    return io::read_motion(io::Hdf5Reader(run.results()), part);
}

/// Of the whole run.                                                                      [N s]
Vec3 impulse(const io::BodyMotion& motion) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& force : motion.force) sum += motion.interval * force;
    return sum;
}

void check_near(const Vec3& found, const Vec3& expected, double within) {
    INFO(found.transpose() << ", expected " << expected.transpose());
    CHECK((found - expected).norm() <= within);
}

}  // namespace

TEST_CASE("a guided headform keeps to its line and loses what it gives to the bag", "[models]") {
    const ModelRun run("oop_linear",
                       "-j 1 --quiet -D NP=5000 -D ENDTIM=2 -D MEET=1 -D DISTANCE=65 -D SPEED=8 "
                       "-D ANGLE=20 -D OFFX=12 -D OFFY=-7");
    const io::BodyMotion head = form(run, 100);
    CHECK(head.mass == 6.8);
    const double tilt = 20.0 * M_PI / 180.0;
    const Vec3 line(0.0, std::sin(tilt), -std::cos(tilt));
    // its foremost point would be at (12, -7, 65) at 1 ms
    const Vec3 start = Vec3(12.0, -7.0, 65.0) - (1.0 * 8.0 + 82.5) * line;
    check_near(head.position.front(), start, 1e-6);
    check_near(head.velocity.front(), 8.0 * line, 1e-8);
    for (const Vec3& x : head.position)
        REQUIRE((x - start).cross(line).norm() < 1e-9 * (x - start).norm() + 1e-9);

    const double lost = (8.0 * line - head.velocity.back()).dot(line);
    CHECK(lost > 0.001);
    CHECK(head.mass * lost == Approx(-impulse(head).dot(line)).epsilon(1e-9));
    CHECK(std::abs(run.history("/history/energy/residual").back()) <
          0.01 * run.history("/history/energy/inflow").back());
}

TEST_CASE("a free torso form takes the bag's push in all directions", "[models]") {
    const ModelRun run("oop_linear_torso",
                       "-j 1 --quiet -D NP=5000 -D ENDTIM=2 -D MEET=1 -D DISTANCE=65 -D SPEED=8 "
                       "-D ANGLE=10 -D OFFX=60 -D GUIDED=0",
                       "oop_linear");
    const io::BodyMotion torso = form(run, 101);
    CHECK(torso.mass == 34.0);
    const Vec3 change = torso.velocity.back() - torso.velocity.front();
    check_near(torso.mass * change, impulse(torso), 1e-9 * impulse(torso).norm());
    CHECK(change.norm() > 1e-4);
    CHECK(change.x() != 0.0);  // nothing holds it on its line
}

TEST_CASE("forms stand before the folded bag where the position says", "[models]") {
    const auto [model, part, depth, mass] = GENERATE(table<std::string, int, double, double>(
        {{"oop_static", 100, 82.5, 6.8}, {"oop_static_torso", 101, 90.044, 34.0}}));
    const ModelRun run(model, "-j 1 --quiet -D NP=5000 -D ENDTIM=0.01 -D GAP=12 -D POSITION=2",
                       "oop_static");
    const io::BodyMotion form_at_rest = form(run, part);
    CHECK(form_at_rest.mass == mass);
    check_near(form_at_rest.position.front(), {0.0, 185.0, 47.7 + 12.0 + depth}, 1e-6);
    check_near(form_at_rest.velocity.back(), Vec3::Zero(), 0.0);
}
