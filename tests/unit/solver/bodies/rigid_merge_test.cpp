// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rigid parts that move as one, and supports along axes of their own.

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "solver/bodies/rigid_body.hpp"
#include "solver/bodies/rigid_parts.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

namespace {

/// Two quads side by side, of masses that differ: nodes 0-3 of part 0, 4-7 of part 1.
Model two_parts() {
    Model model;
    model.x = {{0, 0, 0}, {1, 0, 0.1}, {1, 1, 0}, {0, 1, 0.2},
               {3, 0, 0}, {4, 0, 0},   {4, 2, 1}, {3, 2, 0.5}};
    model.velocity.assign(8, Vec3::Zero());
    for (int n = 1; n <= 8; ++n) model.node_id.push_back(n);
    model.shells = {{1, 0, {0, 1, 2, 3}}, {2, 1, {4, 5, 6, 7}}};
    model.parts.resize(2);
    for (int p = 0; p < 2; ++p) {
        model.parts[p].id = p + 1;
        model.parts[p].material = 0;
    }
    fabric::RigidCard card;
    card.density = 1000;
    model.materials = {{1, "", card}};
    model.end_time = 1.0;
    return model;
}
const std::vector<double> MASS = {1.0, 2.0, 1.5, 0.5, 3.0, 0.7, 1.1, 2.2};

fabric::Nodes nodes_of(const Model& model) {
    return {model.x, model.x, model.velocity, Points(model.x.size(), Vec3::Zero()), MASS};
}

/// Forces that pull and turn, of the places.
void load(fabric::Nodes& nodes) {
    for (std::size_t n = 0; n < nodes.x.size(); ++n)
        nodes.f[n] = Vec3(1.0 + nodes.x[n].y(), -nodes.x[n].z(), 2.0 * nodes.x[n].x() - 3.0);
}

void step(RigidBody& body, fabric::Nodes& nodes, double t, double dt) {
    body.advance(t, dt, dt, {}, nodes);
    nodes.drift(dt);
    nodes.x.swap(nodes.x_1);
}

fabric::RigidCard& card_of(Model& model) {
    return std::get<fabric::RigidCard>(model.materials[0].card);
}

/// Axes turned by 30 degrees about x + y + z.
Mat3 tilted() {
    return Eigen::AngleAxisd(std::numbers::pi / 6.0, Vec3::Ones().normalized()).toRotationMatrix();
}

}  // namespace

TEST_CASE("merged parts move as the one part of all their shells does", "[solver][rigid]") {
    Model merged = two_parts();
    merged.rigid_merges = {{0, 1, false}};
    merged.rigid_velocity = {{0, Vec3(1, 2, 3), Vec3(4, -5, 6)}};
    Model one = two_parts();
    one.shells[1].part = 0;
    one.rigid_velocity = merged.rigid_velocity;
    fabric::Nodes a = nodes_of(merged), b = nodes_of(one);
    RigidBody body(merged, 0, MASS), twin(one, 0, MASS);
    CHECK(body.parts() == std::vector<Index>{0, 1});
    CHECK(body.mass() == Approx(12.0).epsilon(1e-15));
    for (int k = 0; k < 200; ++k) {
        load(a);
        load(b);
        step(body, a, 1e-3 * k, 1e-3);
        step(twin, b, 1e-3 * k, 1e-3);
    }
    for (std::size_t n = 0; n < 8; ++n) CHECK((a.x[n] - b.x[n]).norm() < 1e-12);
}

TEST_CASE("a lead takes mass, centre and inertia of what it leads", "[solver][rigid]") {
    // two points' worth of bodies: the parallel axes by hand
    Model model = two_parts();
    RigidInertia lead, led;
    lead.part = 0;
    lead.mass = 2.0;
    lead.centre = Vec3(0, 0, 0);
    lead.inertia = Vec3(1, 2, 2.5).asDiagonal();
    led.part = 1;
    led.mass = 6.0;
    led.centre = Vec3(4, 0, 0);
    led.inertia = Vec3(3, 3, 3).asDiagonal();
    model.rigid_inertia = {lead, led};

    model.rigid_merges = {{0, 1, false}};
    const RigidInertia both = inertia_of_parts(model, merged_parts(model, 0), MASS);
    CHECK(both.mass == 8.0);
    CHECK(both.centre == Vec3(3, 0, 0));
    const double apart = 2.0 * 9.0 + 6.0 * 1.0;  // sum of m d²
    CHECK((both.inertia - Mat3(Vec3(4.0, 5.0 + apart, 5.5 + apart).asDiagonal())).norm() < 1e-12);

    model.rigid_merges = {{0, 1, true}};  // the lead's card speaks for both
    const RigidInertia kept = inertia_of_parts(model, merged_parts(model, 0), MASS);
    CHECK(kept.mass == 2.0);
    CHECK(kept.centre == lead.centre);
    CHECK(kept.inertia == lead.inertia);
}

TEST_CASE("nodes that merged parts share count once", "[solver][rigid]") {
    Model model = two_parts();
    model.shells[1].nodes = {1, 5, 6, 2};
    model.rigid_merges = {{0, 1, false}};
    const RigidInertia both = inertia_of_parts(model, merged_parts(model, 0), MASS);
    CHECK(both.mass == Approx(1.0 + 2.0 + 1.5 + 0.5 + 0.7 + 1.1));
}

TEST_CASE("parts share a merged body's mass", "[solver][rigid]") {
    Model model = two_parts();
    CHECK(mass_shares(model, {0}, MASS) == std::vector<double>{1.0});
    model.rigid_merges = {{0, 1, false}};
    const std::vector<Index> parts = merged_parts(model, 0);
    const auto by_nodes = mass_shares(model, parts, MASS);  // 5 and 7 kg
    CHECK(by_nodes[0] == Approx(5.0 / 12.0).epsilon(1e-15));
    CHECK(by_nodes[1] == Approx(7.0 / 12.0).epsilon(1e-15));

    RigidInertia lead;
    lead.part = 0;
    lead.mass = 21.0;
    lead.centre = Vec3::Zero();
    lead.inertia = Mat3::Identity();
    model.rigid_inertia = {lead};
    CHECK(mass_shares(model, parts, MASS)[0] == Approx(21.0 / 28.0).epsilon(1e-15));
    model.rigid_merges[0].keeps_inertia = true;  // the lead's card speaks for both
    CHECK(mass_shares(model, parts, MASS) == by_nodes);
    model.shells[1].nodes = {1, 5, 6, 2};  // 3.5 of 5 kg are shared, and the first part's
    CHECK(mass_shares(model, parts, MASS)[0] == Approx(5.0 / 6.8).epsilon(1e-15));
}

TEST_CASE("a damped part of a merged body damps its share of it", "[solver][rigid]") {
    constexpr double DAMPING = 20.0;
    Model model = scenes::empty(0.1);
    const auto damped = static_cast<Index>(GENERATE(0, 1));
    for (int k = 0; k < 2; ++k)
        scenes::add(model, shapes::sphere(0.1, 1), scenes::rigid(1000.0 * (1 + 2 * k)), 1e-3,
                    Vec3(k, 0, 0));
    model.rigid_merges = {{0, 1, false}};
    model.rigid_velocity = {{0, Vec3(0, 0, -2), Vec3(1, 0, 0)}};
    model.curves = {{1, {0.0, 1.0}, {DAMPING, DAMPING}}};
    model.part_dampings = {{damped, 0, 1.0}};
    Simulation simulation(model);
    REQUIRE(simulation.bodies().size() == 1);
    double residual = 0.0;
    while (!simulation.is_over())
        simulation.step(
            [&](Simulation& at) { residual = std::max(residual, std::abs(at.books().residual)); });
    const double left = std::exp(-DAMPING * (damped == 0 ? 0.25 : 0.75) * 0.1);
    CHECK(simulation.bodies()[0].velocity().z() == Approx(-2.0 * left).epsilon(1e-3));
    CHECK(simulation.bodies()[0].spin().x() == Approx(left).epsilon(1e-3));
    CHECK(residual < 1e-9);
}

TEST_CASE("a body on a rail that is no axis of the deck slides with g sin", "[solver][rigid]") {
    // free along local x alone, under gravity: s = (g·x) t² / 2
    Model model = two_parts();
    card_of(model).axes = tilted();
    card_of(model).fixed_moves = 0b110;
    card_of(model).fixed_turns = 0b111;
    fabric::Nodes nodes = nodes_of(model);
    RigidBody body(model, 0, MASS);
    const Vec3 g(0, 0, -9.81), rail = tilted().col(0), start = body.position();
    const double dt = 1e-3;
    const int steps = 1000;
    for (int k = 0; k < steps; ++k) {
        // the first kick spans half a step, so that x = a t² / 2 holds exactly
        body.advance(k * dt, dt, k == 0 ? 0.5 * dt : dt, {g, 0.0}, nodes);
        nodes.drift(dt);
        nodes.x.swap(nodes.x_1);
    }
    body.arrive();
    const Vec3 wanted = start + 0.5 * g.dot(rail) * rail;
    CHECK((body.position() - wanted).norm() < 1e-11);
    CHECK(body.spin().norm() < 1e-12);
    CHECK(std::abs(tilted().col(1).dot(body.velocity())) < 1e-12);
    CHECK(std::abs(tilted().col(2).dot(body.velocity())) < 1e-12);
}

TEST_CASE("a body on a hinge that is no axis of the deck turns about it alone", "[solver][rigid]") {
    // free about local z: spin = dt M·z / (z·I z), I the tensor of the nodes
    Model model = two_parts();
    card_of(model).axes = tilted();
    card_of(model).fixed_moves = 0b111;
    card_of(model).fixed_turns = 0b011;
    fabric::Nodes nodes = nodes_of(model);
    RigidBody body(model, 0, MASS);
    load(nodes);
    Vec3 moment = Vec3::Zero();
    for (const Index n : body.nodes()) moment += (nodes.x[n] - body.position()).cross(nodes.f[n]);
    const Vec3 hinge = tilted().col(2);
    const double inertia = hinge.dot(inertia_of_parts(model, {0}, MASS).inertia * hinge);
    const double dt = 1e-4;
    step(body, nodes, 0.0, dt);
    CHECK(hinge.dot(body.spin()) == Approx(dt * hinge.dot(moment) / inertia).epsilon(1e-12));
    body.arrive();
    for (const int held : {0, 1})
        CHECK(std::abs(tilted().col(held).dot(body.spin())) < 1e-6 * body.spin().norm());
    CHECK(body.velocity().norm() < 1e-15);
}

TEST_CASE("a prescribed motion askew to held axes keeps both", "[solver][rigid]") {
    Model model = two_parts();
    card_of(model).axes = tilted();
    card_of(model).fixed_moves = 0b001;
    model.curves = {Curve{1, {0.0, 1.0}, {3.0, 3.0}}};
    PrescribedMotion push;
    push.rigid_part = 0;
    push.curve = 0;
    push.axis = Vec3(1, 1, 0).normalized();  // not at right angles to what is held
    model.motions = {push};
    fabric::Nodes nodes = nodes_of(model);
    RigidBody body(model, 0, MASS);
    for (int k = 0; k < 5; ++k) {
        load(nodes);
        step(body, nodes, 1e-2 * k, 1e-2);
        CHECK(body.velocity().dot(push.axis) == Approx(3.0).epsilon(1e-12));
        CHECK(std::abs(body.velocity().dot(tilted().col(0))) < 1e-12);
    }
}
