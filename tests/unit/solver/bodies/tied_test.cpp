// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Nodes that ride on edges, with what else the deck says of them.

#include <catch2/catch.hpp>

#include "solver/base/error.hpp"
#include "solver/scene/closing.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

/// A square, and a triangle that hangs with node 4 on the middle of its edge from 0 to 1.
Model hanging() {
    shapes::Shape shape;
    shape.x = {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}, {0.05, 0, 0}, {0.05, -0.05, 0}};
    shape.triangles = {{0, 1, 2}, {0, 2, 3}, {4, 5, 1}};
    Model model = scenes::of(shape, scenes::cloth(), 1e-3);
    model.tied_nodes = {{4, {0, 1}, 0.5}};
    model.end_time = 1e-3;
    return model;
}

std::string fault_of(const Model& model) {
    try {
        const Simulation scene(model);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

PrescribedMotion lift(Model& model, std::vector<Index> nodes) {
    model.curves = {{1, {0.0, 1.0}, {2.0, 2.0}}};
    PrescribedMotion motion;
    motion.nodes = std::move(nodes);
    motion.axis = Vec3::UnitZ();
    motion.curve = 0;
    return motion;
}

}  // namespace

TEST_CASE("a support of a tied node is refused unless both ends have it", "[solver][tied]") {
    using Catch::Contains;
    Model model = hanging();
    model.supports = {{4, 7U}};
    CHECK_THAT(fault_of(model), Contains("node 5 is tied to nodes 1 and 2") &&
                                    Contains("held or moved as these are not"));
    model.supports.push_back({0, 7U});
    CHECK_THAT(fault_of(model), Contains("node 5"));
    model.supports.push_back({1, 3U});
    CHECK_THAT(fault_of(model), Contains("node 5"));
    model.supports.push_back({1, 4U});
    CHECK(fault_of(model).empty());
    model.supports = {{4, 0b111000U}};  // rotations that membranes have not
    CHECK(fault_of(model).empty());
}

TEST_CASE("a motion of a tied node is refused unless both ends have it", "[solver][tied]") {
    using Catch::Contains;
    Model model = hanging();
    model.motions = {lift(model, {0, 4})};
    CHECK_THAT(fault_of(model), Contains("node 5 is tied to nodes 1 and 2"));
    model.motions = {lift(model, {0, 4}), lift(model, {1})};
    CHECK(fault_of(model).empty());
    model.motions[1].scale = 2.0;
    CHECK_THAT(fault_of(model), Contains("node 5"));
    model.motions = {lift(model, {0, 1, 4})};
    CHECK(fault_of(model).empty());
}

TEST_CASE("a tied node's mass is damped with its part, and pulled by its part's load",
          "[solver][tied]") {
    constexpr double DAMPING = 300.0;
    Model model = hanging();
    model.velocity.assign(model.x.size(), Vec3(0, 0, 3));
    const bool is_damped = GENERATE(true, false);
    model.curves = {{1, {0.0, 1.0}, {DAMPING, DAMPING}}};
    if (is_damped)
        model.part_dampings = {{0, 0, 1.0}};
    else
        model.body_loads = {{2, 0, 1.0, {0}}};
    Simulation simulation(model);
    if (is_damped) {
        double damped = 0.0, all = 0.0;
        for (const double m : simulation.scene().forces.damped_mass[0]) damped += m;
        for (const double m : simulation.nodes().mass) all += m;
        CHECK(damped == Approx(all).epsilon(1e-14));
    }
    while (!simulation.is_over()) {
        simulation.step([](Simulation&) {});
        for (const Vec3& v : simulation.nodes().v)
            REQUIRE((v - simulation.nodes().v[0]).norm() < 1e-12);
    }
    CHECK(simulation.nodes().v[0].z() < 3.0 - 0.2);
}

TEST_CASE("tied nodes start with the momentum that they were given", "[solver][tied]") {
    const auto momentum = [](const Simulation& simulation) {
        Vec3 all = Vec3::Zero();
        for (std::size_t n = 0; n < simulation.nodes().size(); ++n)
            all += simulation.nodes().mass[n] * simulation.nodes().v[n];
        return all;
    };
    Model model = hanging();
    const double third = 750.0 * 1e-3 * 0.5 * 0.05 * 0.05 / 3.0;
    for (const Index node : {3, 4, 5}) model.velocity[node] = Vec3(1, -2, 3 + node);
    const double corner = 750.0 * 1e-3 * 0.5 * 0.01 / 3.0;  // node 3 is one triangle's
    CHECK((momentum(Simulation(model)) -
           (corner * model.velocity[3] + third * model.velocity[4] + third * model.velocity[5]))
              .norm() < 1e-15);

    // nodes in one place: the mean by mass, through a chain of ties too
    model.tied_nodes = {{4, {5, 5}, 0.5}, {5, {3, 3}, 0.5}};
    model.x[4] = model.x[5] = model.x[3];
    model.shells.pop_back();
    model.node_masses = {{4, 2.0 * corner}, {5, 5.0 * corner}};
    const Simulation joined(model);
    const Vec3 mean = (model.velocity[3] + 2.0 * model.velocity[4] + 5.0 * model.velocity[5]) / 8.0;
    for (const Index node : {3, 4, 5}) CHECK((joined.nodes().v[node] - mean).norm() < 1e-14);

    // a motion of the whole stays
    Model turning = hanging();
    for (std::size_t n = 0; n < turning.x.size(); ++n)
        turning.velocity[n] = Vec3(1, 2, 3) + Vec3(4, 5, 6).cross(turning.x[n]);
    const Simulation whole(turning);
    for (std::size_t n = 0; n < turning.x.size(); ++n)
        CHECK((whole.nodes().v[n] - turning.velocity[n]).norm() < 1e-14);
}

TEST_CASE("a load on one part pulls what of it hangs on another", "[solver][tied]") {
    Model model = hanging();
    model.parts.push_back(model.parts[0]);
    model.parts[1].id = 2;
    model.shells[2].part = 1;
    model.body_loads = {{2, -1, 10.0, {1}}};
    Simulation simulation(model);
    simulation.step([](Simulation&) {});
    Vec3 pulled = Vec3::Zero();
    for (const Vec3& f : simulation.scene().forces.loads.f) pulled += f;
    CHECK(pulled.z() == Approx(-10.0 * simulation.scene().cloth.shell_mass[2]).epsilon(1e-13));
}

TEST_CASE("closing a bag says which supports of the nodes that it ties do not count",
          "[solver][tied][closing]") {
    // a cube's lower face is cut in two at node 8, which hangs on its neighbour's edge 0-1
    Model model = scenes::of(shapes::box({1, 1, 1}, 1), scenes::cloth(), 1e-3);
    const auto hung = static_cast<Index>(model.x.size());
    const Shell first = model.shells[0];
    const Index a = first.nodes[0], b = first.nodes[1], c = first.nodes[2];
    model.x.push_back(0.5 * (model.x[a] + model.x[b]));
    model.velocity.push_back(Vec3::Zero());
    model.node_id.push_back(static_cast<int>(model.x.size()));
    model.shells[0].nodes = {a, hung, c, c};
    model.shells.push_back({100, 0, {hung, b, c, c}});
    gas::BagCard bag;
    bag.id = 1;
    bag.external_parts = {0};
    model.bags = {bag};
    model.supports = {{hung, 7U}, {a, 7U}};
    const bool is_held_at_both = GENERATE(false, true);
    if (is_held_at_both) model.supports.push_back({b, 7U});
    close_bags(model);
    REQUIRE(model.tied_nodes.size() == 1);
    CHECK(model.tied_nodes[0].node == hung);
    CHECK(model.supports.size() == (is_held_at_both ? 3 : 1));
    REQUIRE(model.warnings.size() == (is_held_at_both ? 0 : 1));
    if (!is_held_at_both)
        CHECK_THAT(model.warnings[0],
                   Catch::Contains("node 9 hangs on edge") && Catch::Contains("does not count"));
}
