// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: joints and tied nodes of others' decks mean what their authors meant (tests/decks).

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/decks/stepped_deck.hpp"

using namespace corpuscle;

namespace {

/// Linear and angular momentum of all bodies, the latter about the origin of coordinates.
std::pair<Vec3, Vec3> momenta(const Simulation& scene, double dt) {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    for (const RigidBody& body : scene.bodies()) {
        linear += body.mass() * body.velocity();
        const Vec3 at = body.position() + dt * body.velocity();  // after the drift
        angular += body.mass() * at.cross(body.velocity()) + body.angular_momentum();
    }
    return {linear, angular};
}

double kinetic(const Simulation& scene) {
    double all = 0.0;
    for (const RigidBody& body : scene.bodies()) all += body.kinetic_energy();
    return all;
}

}  // namespace

TEST_CASE("balls between thrown bodies keep their places together, and all momenta", "[io]") {
    Run run("joints_chain.k");
    REQUIRE(run.scene.bodies().size() == 3);
    CHECK(tells(run.scene.model().warnings, "they are made to agree"));
    run.steps(1);
    const auto [linear, angular] = momenta(run.scene, run.scene.time());
    const double energy = kinetic(run.scene);
    double apart = 0.0, least = energy, most = energy, turned = 0.0;
    const Vec3 first = run.x(1) - run.x(31);
    while (!run.scene.is_over()) {
        run.steps(1);
        apart = std::max({apart, (run.x(31) - run.x(32)).norm(), (run.x(33) - run.x(34)).norm()});
        least = std::min(least, kinetic(run.scene));
        most = std::max(most, kinetic(run.scene));
        turned = std::max(turned, (run.x(1) - run.x(31) - first).norm());
    }
    CHECK(apart < 1e-13);
    CHECK(turned > 0.2);
    const auto [linear_then, angular_then] = momenta(run.scene, run.scene.time() - run.last_time);
    CHECK((linear_then - linear).norm() < 1e-13 * linear.norm());
    CHECK((angular_then - angular).norm() < 1e-12 * angular.norm());
    CHECK(most - least < 2e-3 * energy);
    CHECK(run.residual < 2e-3 * energy);
}

TEST_CASE("a plate on a hinge swings as a pendulum does", "[io]") {
    Run run("joint_hinge.k");
    constexpr double LENGTH = 0.3, GRAVITY = 9.81, QUARTER = 1.854074677301372;  // K(sin 45°)
    const RigidBody* swinging = nullptr;
    for (const RigidBody& body : run.scene.bodies())
        if (run.scene.model().parts[body.part()].id == 2) swinging = &body;
    REQUIRE(swinging != nullptr);
    double moment = 0.0, mass = 0.0, arm = 0.0;  // about the hinge, of six equal quads' corners
    for (const double x : {0.0, 0.1, 0.2, 0.3}) {
        const double m = 2000.0 * 0.002 * 0.1 * 0.1 * (x == 0.0 || x == LENGTH ? 0.5 : 1.0);
        mass += m;
        arm += m * x;
        moment += m * x * x;
    }
    arm /= mass;
    REQUIRE(swinging->mass() == Approx(mass).epsilon(1e-12));
    // from rest at the level: T / 4 = K(sin 45°) / sqrt(m g a / I) until it hangs
    const double quarter = QUARTER / std::sqrt(mass * GRAVITY * arm / moment);
    double hangs = NaN;
    while (!run.scene.is_over() && std::isnan(hangs)) {
        const double before = run.x(17).x(), t = run.scene.time();
        run.steps(1);
        const double after = run.x(17).x();
        if (before > 0.0 && after <= 0.0)
            hangs = t + (run.scene.time() - t) * before / (before - after);
        CHECK((run.x(11) - Vec3(0.0, -0.05, 0.0)).norm() < 1e-14);
        CHECK((run.x(12) - Vec3(0.0, 0.05, 0.0)).norm() < 1e-14);
    }
    CHECK(hangs == Approx(quarter).epsilon(1e-4));
    CHECK(run.x(1) == Vec3(-0.2, -0.05, 0.0));
}

TEST_CASE("a rod of no breadth swings on a ball as a pendulum does, whichever way it lies",
          "[io]") {
    Run run("joint_rod.k");
    constexpr double LENGTH = 0.2, GRAVITY = 9.81;
    const Vec3 along = Vec3(1.0, 0.5, 0.2).normalized(), level = Vec3(1.0, 0.5, 0.0).normalized();
    const RigidBody* rod = nullptr;
    for (const RigidBody& body : run.scene.bodies())
        if (run.scene.model().parts[body.part()].id == 2) rod = &body;
    REQUIRE(rod != nullptr);
    double angle = std::asin(along.z()), rate = 0.0, apart = 0.0;  // of the exact pendulum
    const auto pull = [&](double at) { return -1.5 * GRAVITY / LENGTH * std::cos(at); };
    while (!run.scene.is_over()) {
        const double t = run.scene.time();
        run.steps(1);
        const double dt = run.scene.time() - t;
        const double half = angle + 0.5 * dt * rate;  // midpoint rule, of the step's fineness
        const double mid = rate + 0.5 * dt * pull(angle);
        rate += dt * pull(half);
        angle += dt * mid;
        apart = std::max(apart, (run.x(15) - LENGTH * (std::cos(angle) * level +
                                                       std::sin(angle) * Vec3::UnitZ()))
                                    .norm());
    }
    CHECK(angle < -1.0);
    CHECK(apart < 1e-5 * LENGTH);
    CHECK(run.residual < 1e-5 * rod->kinetic_energy());
    CHECK(rod->kinetic_energy() > 0.1 * rod->mass() * GRAVITY * LENGTH);
}

TEST_CASE("what a hinge gives is what its plate's momentum lacks", "[io]") {
    constexpr double GRAVITY = 9.81, HALF = 0.05;  // between the joint's places
    Run run("joint_hinge.k");
    CHECK(run.scene.layout().joints == std::vector<int>{4});
    for (int k = 0; k < 9; ++k) {
        run.steps(99);
        Sample now;
        run.scene.step([&](Simulation& at) { now = at.sample(); });
        const auto at = static_cast<std::size_t>(
            run.scene.model().parts[run.scene.bodies()[0].part()].id == 2 ? 0 : 1);
        const double mass = run.scene.bodies()[at].mass();
        const Vec3 given =
            mass * (now.rigid_bodies[at].velocity + GRAVITY * now.time * Vec3::UnitZ());
        REQUIRE(now.joints.size() == 1);  // its force is on the body of N1, the held one
        CHECK((now.joints[0].impulse + given).norm() < 1e-10 * given.norm());
        CHECK((now.joints[0].turning - HALF * Vec3::UnitY().cross(now.joints[0].impulse)).norm() <
              1e-10 * HALF * given.norm());
    }
}

TEST_CASE("a hit on one body is passed on through its joints", "[contact]") {
    Run run("joints_hit.k");
    run.steps(1);
    const auto [linear, angular] = momenta(run.scene, run.scene.time() - run.last_time);
    double apart = 0.0;
    while (!run.scene.is_over()) {
        run.steps(1);
        apart = std::max({apart, (run.x(31) - run.x(32)).norm(), (run.x(33) - run.x(34)).norm()});
    }
    CHECK(apart < 1e-13);
    const auto [linear_then, angular_then] = momenta(run.scene, run.scene.time() - run.last_time);
    CHECK((linear_then - linear).norm() < 1e-12 * linear.norm());
    CHECK((angular_then - angular).norm() < 1e-11 * angular.norm());
    CHECK(run.x(1).z() != 0.0);            // the first plate has felt it
    CHECK(run.x(41).z() > run.x(25).z());  // and the bullet has not passed the third
}

TEST_CASE("the force on a jointed body is that of contact alone", "[contact]") {
    Run run("joints_hit.k");
    Vec3 on_third = Vec3::Zero(), on_bullet = Vec3::Zero();
    double others = 0.0, accelerated = 0.0, half = 0.0;
    while (!run.scene.is_over()) {
        Sample now;
        const StepReport report = run.scene.step([&](Simulation& at) { now = at.sample(); });
        const double span = half + 0.5 * report.dt;  // of the kick at t
        half = 0.5 * report.dt;
        REQUIRE(now.rigid_bodies.size() == 4);
        others += now.rigid_bodies[0].force.norm() + now.rigid_bodies[1].force.norm();
        accelerated += now.rigid_bodies[1].acceleration.norm();
        on_third += span * now.rigid_bodies[2].force;
        on_bullet += span * now.rigid_bodies[3].force;
    }
    CHECK(accelerated > 0.0);  // by the joint
    CHECK(others == 0.0);
    CHECK(on_third.norm() > 0.01);
    CHECK((on_third + on_bullet).norm() < 1e-12 * on_third.norm());
}

TEST_CASE("springs, a damper, friction and a stop of joints move plates as one degree of freedom",
          "[io]") {
    Run run("joint_stiffness.k");
    constexpr double ABOUT_Z = 1e-3, ABOUT_Y = 8e-4, SPIN = 20.0;  // of a plate; at the start
    constexpr double SPRING = 100.0, DAMPER = 0.1, FRICTION = 0.5, STOP = 1e4, MOVES = 1e-9;
    run.to_the_end();
    const auto spin = [&](int part) -> Vec3 {
        for (const RigidBody& body : run.scene.bodies())
            if (run.scene.model().parts[body.part()].id == part) return body.spin();
        return Vec3::Constant(NaN);
    };
    const double t = run.half_step, all = 5.0 * 0.5 * ABOUT_Z * SPIN * SPIN;
    const double on_spring = std::sqrt(SPRING / ABOUT_Z), dt = run.scene.time() - run.last_time;
    CHECK(spin(1).norm() < MOVES);
    // leapfrog's frequency is above the exact one by (w dt)^2 / 24
    CHECK(spin(2).z() == Approx(SPIN * std::cos(on_spring * t)).margin(1e-2));
    CHECK(spin(3).z() == Approx(SPIN * std::exp(-DAMPER / ABOUT_Z * t)).epsilon(5e-2));
    CHECK(std::abs(spin(4).z()) < FRICTION / std::sqrt(1e5 * ABOUT_Z));  // stopped at 0.04 s
    CHECK(spin(5).z() == Approx(-SPIN).epsilon(std::pow(std::sqrt(STOP / ABOUT_Z) * dt, 2.0)));
    const double free_pair = std::sqrt(2.0 * SPRING / ABOUT_Y);
    CHECK(spin(6).y() == Approx(10.0 * std::cos(free_pair * t)).margin(2e-2));
    CHECK((spin(6) + spin(7)).norm() < MOVES);
    EnergyBooks books;
    run.scene.close([&](Simulation& at) { books = at.books(); });
    CHECK(books.friction == Approx(0.5 * ABOUT_Z * SPIN * SPIN).epsilon(1e-2));
    CHECK(books.damping == Approx(0.5 * ABOUT_Z * SPIN * SPIN).epsilon(1e-2));
    CHECK(std::abs(books.external) < MOVES);
    CHECK(run.residual < 5e-3 * all);
    CHECK(std::abs(books.residual) < 1e-3 * all);
}

TEST_CASE("nodes that are tied in one place are one", "[io][fabric]") {
    Run tied("tied_nodes.k"), whole("wang_nefske_inflator_card.k");
    CHECK(tied.scene.model().tied_nodes.size() == 8);
    CHECK(tells(tied.scene.model().warnings, "the tie does not break"));
    const auto& bag = tied.scene.uniform_bags().at(0);
    const auto& other = whole.scene.uniform_bags().at(0);
    CHECK(bag.gas().volume() == Approx(other.gas().volume()).epsilon(1e-14));
    tied.steps(200);
    whole.steps(200);
    CHECK(tied.scene.time() == Approx(whole.scene.time()).epsilon(1e-12));
    CHECK(bag.gas().pressure() == Approx(other.gas().pressure()).epsilon(1e-9));
    CHECK(bag.gas().volume() == Approx(other.gas().volume()).epsilon(1e-9));
    CHECK(tied.x(60) == tied.x(10));
    CHECK((tied.x(18) - whole.x(18)).norm() < 1e-10);
}
