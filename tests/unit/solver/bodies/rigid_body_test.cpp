// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/rigid_body.hpp"

#include <catch2/catch.hpp>

#include "solver/simulation.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

namespace {

/// A brick of four masses with three different principal moments.
Model brick(const Vec3& velocity, const Vec3& spin) {
    Model model;
    model.x = {{0.3, 0, 0}, {-0.3, 0, 0}, {0, 0.2, 0.05}, {0, -0.2, -0.05}};
    model.velocity.assign(4, Vec3::Zero());
    model.node_id = {1, 2, 3, 4};
    model.shells = {{1, 0, {0, 2, 1, 3}}};
    model.parts.resize(1);
    model.parts[0].id = 7;
    model.parts[0].material = 0;
    fabric::RigidCard card;
    card.density = 1000;
    model.materials = {{1, "", card}};
    model.rigid_velocity = {{0, velocity, spin}};
    model.end_time = 1.0;
    return model;
}

struct Motion {
    fabric::Nodes nodes;
    RigidBody body;
    explicit Motion(const Model& model, const std::vector<double>& mass = {1.0, 2.0, 1.5, 0.5})
        : nodes{model.x, model.x, model.velocity, Points(4, Vec3::Zero()), mass},
          body(model, 0, mass) {}

    void step(double t, double dt, double span) {
        body.advance(t, dt, span, {}, nodes);
        nodes.drift(dt);
        nodes.x.swap(nodes.x_1);
    }
    Vec3 angular_momentum() const {
        Vec3 centre = Vec3::Zero(), sum = Vec3::Zero();
        double all = 0.0;
        for (std::size_t n = 0; n < 4; ++n) {
            centre += nodes.mass[n] * nodes.x[n];
            all += nodes.mass[n];
        }
        centre /= all;
        for (std::size_t n = 0; n < 4; ++n)
            sum += nodes.mass[n] * (nodes.x[n] - centre).cross(nodes.v[n]);
        return sum;
    }
};

}  // namespace

TEST_CASE("a rigid body keeps its shape, momentum and angular momentum when nothing acts on it",
          "[solver][rigid]") {
    Motion motion(brick({1, 2, 3}, {0.1, 12.0, 0.2}));
    const Points start = motion.nodes.x;
    const Vec3 momentum = motion.body.angular_momentum();
    const double dt = 1e-4;
    for (int step = 0; step < 5000; ++step) motion.step(step * dt, dt, dt);
    CHECK((motion.body.angular_momentum() - momentum).norm() == 0.0);
    for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = 0; b < a; ++b)
            CHECK((motion.nodes.x[a] - motion.nodes.x[b]).norm() ==
                  Approx((start[a] - start[b]).norm()).epsilon(1e-12));
    CHECK((motion.angular_momentum() - momentum).norm() < 1e-5 * momentum.norm());
    CHECK(motion.body.velocity() == Vec3(1, 2, 3));
}

TEST_CASE("a force through the centre pushes, a couple turns", "[solver][rigid]") {
    Motion motion(brick(Vec3::Zero(), Vec3::Zero()), {1, 1, 1, 1});
    for (Vec3& f : motion.nodes.f) f = Vec3(0, 0, 2.0);
    motion.step(0.0, 1e-3, 1e-3);
    CHECK((motion.body.velocity() - Vec3(0, 0, 2e-3)).norm() < 1e-15);
    CHECK(motion.body.angular_momentum().norm() < 1e-15);
    CHECK((motion.body.acceleration() - Vec3(0, 0, 2.0)).norm() < 1e-12);

    for (Vec3& f : motion.nodes.f) f.setZero();
    motion.nodes.f[0] = Vec3(0, 5, 0);
    motion.nodes.f[1] = Vec3(0, -5, 0);
    motion.step(1e-3, 1e-3, 1e-3);
    CHECK((motion.body.angular_momentum() - Vec3(0, 0, 3e-3)).norm() < 1e-15);
    CHECK((motion.body.velocity() - Vec3(0, 0, 2e-3)).norm() < 1e-15);
}

TEST_CASE("prescribed and fixed motions of a rigid body hold exactly", "[solver][rigid]") {
    Model model = brick(Vec3::Zero(), Vec3::Zero());
    std::get<fabric::RigidCard>(model.materials[0].card).fixed_moves = 0b110;
    std::get<fabric::RigidCard>(model.materials[0].card).fixed_turns = 0b111;
    model.curves = {Curve{1, {0.0, 0.5, 1.0}, {0.0, 4.0, 0.0}}};
    PrescribedMotion push;
    push.rigid_part = 0;
    push.curve = 0;
    push.axis = Vec3::UnitX();
    model.motions = {push};
    Motion motion(model);
    const double start = motion.nodes.x[0].x();
    const double dt = 1e-2;
    for (int step = 0; step < 100; ++step) {
        for (Vec3& f : motion.nodes.f) f = Vec3(100, 50, -20);
        motion.step(step * dt, dt, dt);
    }
    CHECK(motion.nodes.x[0].x() - start == Approx(2.0).epsilon(1e-12));
    CHECK(motion.nodes.x[0].y() == Approx(0.0).margin(1e-12));
    CHECK(motion.nodes.x[0].z() == Approx(0.0).margin(1e-12));
}

TEST_CASE("free rotation about the middle axis flips and keeps energy and angular momentum",
          "[solver][rigid]") {
    Motion motion(brick(Vec3::Zero(), {0.02, 12.0, 0.01}));
    const auto spin_in_body = [&] {
        return Vec3(motion.body.turn().conjugate() * motion.body.spin());
    };
    // along whichever principal axis is the middle one: the spin starts nearly along it
    Eigen::Index middle = 0;
    const Vec3 first = spin_in_body();
    first.cwiseAbs().maxCoeff(&middle);
    const Vec3 momentum = motion.body.angular_momentum();
    const double energy = motion.body.kinetic_energy(), dt = 1e-3;
    bool has_flipped = false;
    for (int step = 0; step < 100000; ++step) {
        motion.step(step * dt, dt, dt);
        has_flipped |=
            spin_in_body()[middle] * first[middle] < -0.5 * first[middle] * first[middle];
    }
    CHECK(has_flipped);
    CHECK((motion.body.angular_momentum() - momentum).norm() == 0.0);
    CHECK(motion.body.kinetic_energy() == Approx(energy).epsilon(1e-9));
}

TEST_CASE("a body on a hinge turns by the moment about it alone", "[solver][rigid]") {
    Model model = brick(Vec3::Zero(), Vec3::Zero());
    auto& card = std::get<fabric::RigidCard>(model.materials[0].card);
    card.fixed_moves = 0b111;
    card.fixed_turns = 0b011;  // free about z, which is no principal axis
    const std::vector<double> mass = {1.0, 2.0, 1.5, 0.5};
    Motion motion(model, mass);
    motion.nodes.f[0] = Vec3(0.0, 4.0, 7.0);
    const Vec3 centre = motion.body.position();
    double moment_of_inertia = 0.0;
    for (std::size_t n = 0; n < 4; ++n) {
        const Vec3 r = model.x[n] - centre;
        moment_of_inertia += mass[n] * (r.x() * r.x() + r.y() * r.y());
    }
    const double moment = ((model.x[0] - centre).cross(motion.nodes.f[0])).z();
    const double dt = 1e-4;
    motion.step(0.0, dt, dt);
    CHECK(motion.body.spin().z() == Approx(dt * moment / moment_of_inertia).epsilon(1e-9));
    CHECK(std::abs(motion.body.spin().x()) < 1e-6 * motion.body.spin().z());
    CHECK(motion.body.velocity().norm() == 0.0);
}

TEST_CASE("a sample has velocity, momentum and energy of a body at its own time",
          "[solver][rigid]") {
    constexpr double G = 9.81;
    Model model = scenes::empty(0.02);
    scenes::add(model, shapes::sphere(0.1, 1), scenes::rigid(1000.0), 1e-3, Vec3::Zero());
    scenes::pull(model, Vec3(0, 0, -G));
    model.rigid_velocity = {{0, Vec3(1, 0, 2), Vec3(0, 40, 0)}};
    Simulation simulation(model);
    const RigidBody& body = simulation.bodies()[0];
    const double turning = 0.5 * body.angular_momentum().dot(body.spin());
    double worst = 0.0, last_dt = 0.0;
    const auto watch = [&](Simulation& at) {
        const Sample sample = at.sample();
        const Vec3 v(1, 0, 2 - G * sample.time);  // exact for a leapfrog
        const Vec3 p = sample.parts[0].momentum;
        const double energy = 0.5 * body.mass() * v.squaredNorm() + turning;
        worst = std::max({worst, (sample.rigid_bodies[0].velocity - v).norm(),
                          (p / body.mass() - v).norm(),
                          std::abs(sample.parts[0].kinetic_energy / energy - 1.0)});
        last_dt = sample.dt;
    };
    while (!simulation.is_over()) simulation.step(watch);
    simulation.close(watch);
    CHECK(G * last_dt > 1e-6);  // half a step would be seen
    CHECK(worst < 1e-11);
}

TEST_CASE("nodes of a body have its motion from the first frame on", "[solver][rigid]") {
    fabric::RigidCard card;
    card.density = 1000;
    Model model = scenes::of(shapes::box(Vec3(0.1, 0.08, 0.06), 1), card, 1e-3);
    model.rigid_velocity = {{0, {1, 2, 3}, {0, 40, 10}}};
    model.end_time = 1e-3;
    Simulation run(model, 1);
    const Vec3 centre = run.bodies()[0].position();
    Points shown;
    run.step([&](Simulation& at_t) { shown = at_t.frame().velocity; });
    for (std::size_t n = 0; n < model.x.size(); ++n)
        CHECK((shown[n] - Vec3(1, 2, 3) - Vec3(0, 40, 10).cross(model.x[n] - centre)).norm() <
              1e-12);
}

TEST_CASE("two nodes that are one body turn as a rod, and nothing spins them about themselves",
          "[solver][rigid]") {
    Model model;
    model.x = {{1, 0, 0}, {2, 1, 0}};
    model.node_id = {1, 2};
    model.velocity.assign(2, Vec3::Zero());
    model.parts.resize(1);
    model.parts[0].material = 0;
    model.materials = {{1, "", fabric::RigidCard{}}};
    model.rigid_extra_nodes = {{0, 0}, {0, 1}};
    model.rigid_velocity = {{0, Vec3(1, 0, 1.45), Vec3(0.0, 0.4, 0.0)}};
    model.end_time = 1.0;
    const std::vector<double> mass{87.5, 52.5};
    RigidBody body(model, 0, mass);
    fabric::Nodes nodes{model.x, model.x, model.velocity, Points(2, Vec3::Zero()), mass};
    // of the spin 0.4 about y what is across the rod: (-0.2, 0.2, 0)
    const double reduced = 87.5 * 52.5 / 140.0 * 2.0;
    const double energy = 70.0 * (1.0 + 1.45 * 1.45) + 0.5 * reduced * 0.08;
    for (int k = 0; k < 2000; ++k) {
        body.advance(1e-2 * k, 1e-2, 1e-2, {}, nodes);
        nodes.drift(1e-2);
        nodes.x.swap(nodes.x_1);
        REQUIRE(body.kinetic_energy() == Approx(energy).epsilon(1e-12));
        REQUIRE((nodes.x[1] - nodes.x[0]).norm() == Approx(std::sqrt(2.0)).epsilon(1e-12));
    }
    CHECK(body.spin().norm() == Approx(std::sqrt(0.08)).epsilon(1e-10));
}
