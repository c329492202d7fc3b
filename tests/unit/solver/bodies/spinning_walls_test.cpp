// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: hits turn a rigid body where and when they were: gas and walls keep their angular momentum
// about any place that rests, to rounding, however far the walls turn in a step.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <map>
#include <memory>

#include "gas/particles.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

namespace {

const Vec3 SIZE(0.1, 0.08, 0.06), SPIN(700.0, -400.0, 1200.0), FLIES(20.0, -5.0, 10.0);

/// Faces of a box: 0, 1 across x, 2, 3 across y, 4, 5 across z.
int face_of(const Model& model, const Shell& shell) {
    const Vec3 middle =
        (model.x[shell.nodes[0]] + model.x[shell.nodes[1]] + model.x[shell.nodes[2]]) / 3.0;
    for (int a = 0; a < 3; ++a) {
        if (middle[a] < 1e-9) return 2 * a;
        if (middle[a] > SIZE[a] - 1e-9) return 2 * a + 1;
    }
    return -1;
}

/// A free box full of gas that flies and turns about an axis that it does not keep. Each face is of
/// the part that `parts` says.
Model spinning_box(const std::vector<fabric::MaterialCard>& materials,
                   const std::array<Index, 6>& parts) {
    Model model = scenes::of(shapes::box(SIZE, 4), materials[0], 1e-3);
    model.end_time = 0.3e-3;
    for (std::size_t k = 1; k < materials.size(); ++k) {
        model.parts.push_back(model.parts[0]);
        model.parts[k].id = static_cast<int>(k) + 1;
        model.parts[k].material = static_cast<Index>(k);
        model.materials.push_back({static_cast<int>(k) + 1, "", materials[k]});
    }
    for (Shell& shell : model.shells)
        shell.part = parts[static_cast<std::size_t>(face_of(model, shell))];
    gas::BagCard bag;
    bag.id = 1;
    bag.p_atm = 101325.0;
    for (std::size_t k = 0; k < materials.size(); ++k) {
        const auto part = static_cast<Index>(k);
        bag.external_parts.push_back(part);
        if (!std::holds_alternative<fabric::RigidCard>(materials[k])) continue;
        Vec3 centre = Vec3::Zero();
        double corners = 0.0;
        for (const Shell& shell : model.shells)
            for (int c = 0; c < 3 && shell.part == part; ++c, ++corners)
                centre += model.x[shell.nodes[c]];
        const Vec3 goes = FLIES + SPIN.cross(centre / corners - 0.5 * SIZE);
        model.rigid_velocity.push_back({part, goes, SPIN});
    }
    for (std::size_t n = 0; n < model.x.size(); ++n)
        model.velocity[n] = FLIES + SPIN.cross(model.x[n] - 0.5 * SIZE);
    bag.particles = 2000;
    bag.air = gas::InitialAirCard{scenes::air(), 5e5, 300.0, true};
    model.bags = {bag};
    return model;
}

/// The box, which a wall across the middle of z parts into two rooms.
Model parted_box() {
    Model model = spinning_box({scenes::rigid(2000.0)}, {0, 0, 0, 0, 0, 0});
    std::map<std::pair<int, int>, Index> rows;
    const auto column = [](double x, int a) {
        return static_cast<int>(std::lround(4.0 * x / SIZE[a]));
    };
    for (std::size_t n = 0; n < model.x.size(); ++n)
        if (std::abs(model.x[n].z() - 0.5 * SIZE.z()) < 1e-9)
            rows[{column(model.x[n].x(), 0), column(model.x[n].y(), 1)}] = static_cast<Index>(n);
    const auto node = [&](int i, int j) {
        const auto [at, is_new] = rows.try_emplace({i, j}, static_cast<Index>(model.x.size()));
        if (is_new) {
            model.x.push_back(SIZE.cwiseProduct(Vec3(0.25 * i, 0.25 * j, 0.5)));
            model.velocity.push_back(FLIES + SPIN.cross(model.x.back() - 0.5 * SIZE));
            model.node_id.push_back(static_cast<int>(model.x.size()));
        }
        return at->second;
    };
    model.parts.push_back(model.parts[0]);
    model.parts[1].id = 2;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const auto id = static_cast<int>(model.shells.size()) + 1;
            model.shells.push_back(
                {id, 1, {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)}});
        }
    model.rigid_merges = {{0, 1}};
    model.bags[0].internal_parts = {1};
    return model;
}

/// About a place that rests.
Vec3 angular_momentum(const Simulation& now, const Vec3& about) {
    Vec3 sum = Vec3::Zero();
    for (const RigidBody& body : now.bodies())
        sum += body.mass() * (body.position() - about).cross(body.velocity()) +
               body.angular_momentum();
    const fabric::Nodes& nodes = now.nodes();
    for (std::size_t n = 0; n < nodes.size(); ++n)
        sum += nodes.mass[n] * (nodes.x[n] - about).cross(nodes.v[n]);
    for (const gas::BagGas& bag : now.bags()) {
        const gas::Particles& gas = bag.particles();
        for (std::size_t i = 0; i < gas.size(); ++i)
            sum += bag.particle_mass()[gas.species[i]] * (gas.x[i] - about).cross(gas.v[i]);
        const gas::Wrench owed = bag.owed();
        sum += owed.angular - about.cross(owed.linear);
    }
    return sum;
}

struct Found {
    double change = 0.0;     ///< of the angular momentum, worst, over that at the start
    double taken = 0.0;      ///< what bodies and gas have exchanged of it, likewise
    double residual = 0.0;   ///< of the energy of the gas, worst
    std::vector<char> told;  ///< all samples
};

Found run(const Model& model, bool is_restarted = false) {
    auto simulation = std::make_unique<Simulation>(model);
    const Vec3 about(0.7, -0.4, 0.2);
    Found found;
    const auto watch = [&](Simulation& at_t) {
        const EnergyBooks books = at_t.books();
        found.residual = std::max(found.residual, std::abs(books.residual) / books.gas);
        StateWriter bytes;
        Sample sample = at_t.sample();
        bytes(sample);
        const std::vector<char> now = bytes.take();
        found.told.insert(found.told.end(), now.begin(), now.end());
    };
    simulation->step(watch);  // in which what free walls are owed at the start is found
    const Vec3 start = angular_momentum(*simulation, about),
               of_body = simulation->bodies()[0].angular_momentum();
    while (!simulation->is_over()) {
        simulation->step(watch);
        const Vec3 change = angular_momentum(*simulation, about) - start;
        found.change = std::max(found.change, change.norm() / start.norm());
        if (!is_restarted) continue;
        StateWriter state;
        state(*simulation);
        const std::vector<char> kept = state.take();
        simulation = std::make_unique<Simulation>(model);
        StateReader reader(kept);
        reader(*simulation);
        REQUIRE(reader.is_at_end());
    }
    found.taken = (simulation->bodies()[0].angular_momentum() - of_body).norm() / start.norm();
    return found;
}

const auto RIGID = scenes::rigid(2000.0);

}  // namespace

TEST_CASE("a rigid box that spins and its gas keep their angular momentum",
          "[solver][rigid][gas]") {
    const Found found = run(spinning_box({RIGID}, {0, 0, 0, 0, 0, 0}));
    CHECK(found.taken > 0.002);
    CHECK(found.change < 1e-12);
    CHECK(found.residual < 1e-12);
}

TEST_CASE("a rigid wall that parts a box turns with what its rooms' gas does",
          "[solver][rigid][gas]") {
    const Found found = run(parted_box());
    CHECK(found.taken > 0.002);
    CHECK(found.change < 1e-12);
    CHECK(found.residual < 1e-12);
}

TEST_CASE("rigid walls and cloth of one bag keep their angular momentum together",
          "[solver][rigid][gas]") {
    const int bodies = GENERATE(1, 2);
    const Found found =
        bodies == 1 ? run(spinning_box({RIGID, scenes::cloth()}, {0, 0, 0, 1, 0, 1}))
                    : run(spinning_box({RIGID, RIGID, scenes::cloth()}, {0, 1, 2, 2, 2, 2}));
    CHECK(found.taken > 0.002);
    CHECK(found.change < 1e-12);
    CHECK(found.residual < 2e-3);
}

TEST_CASE("what drives a rigid box round bears what turns it: energy is balanced",
          "[solver][rigid][gas]") {
    Model model = spinning_box({RIGID}, {0, 0, 0, 0, 0, 0});
    model.curves = {Curve{1, {0.0, 1.0}, {1200.0, 1200.0}}};
    PrescribedMotion drive;
    drive.rigid_part = 0;
    drive.rotation = true;
    drive.axis = Vec3::UnitZ();
    drive.curve = 0;
    model.motions = {drive};
    CHECK(run(model).residual < 1e-12);
}

TEST_CASE("rigid walls that spin: a restart after every step, or more threads, leave no trace",
          "[solver][rigid][restart]") {
    Model model = spinning_box({RIGID, scenes::cloth()}, {0, 0, 0, 1, 0, 1});
    model.end_time = 0.1e-3;
    const int before = parallel::threads();
    parallel::set_threads(1);
    const Found whole = run(model), broken = run(model, true);
    parallel::set_threads(3);
    const Found shared = run(model);
    parallel::set_threads(before);
    CHECK((whole.told == broken.told));
    CHECK((whole.told == shared.told));
}
