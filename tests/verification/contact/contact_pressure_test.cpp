// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: contact pressure over area adds up to the contact's normal forces, on the facets that the
// contact faces.

#include <catch2/catch.hpp>

#include "tests/support/geometry/cloth.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

using scenes::add;
using scenes::pull;
using scenes::rigid;
using scenes::run;
using scenes::touch;

namespace {

constexpr double FREE_FALL = 9.81;

/// Pressure times area over the shells that `wanted` takes, by part and the unit normal.
template <class Wanted>
double force_on(const Simulation& simulation, const Frame& frame, Wanted&& wanted) {
    REQUIRE(frame.shell_contact_pressure.size() == simulation.model().shells.size());
    double force = 0.0;
    for (std::size_t s = 0; s < frame.shell_contact_pressure.size(); ++s) {
        const Shell& shell = simulation.model().shells[s];
        const Points& x = frame.coordinates;
        const Vec3 area = vector_area(x[shell.nodes[0]], x[shell.nodes[1]], x[shell.nodes[2]]);
        if (wanted(shell.part, area.normalized()))
            force += static_cast<double>(frame.shell_contact_pressure[s]) * area.norm();
    }
    return force;
}
double force_on(const Simulation& simulation, const Frame& frame, Index part) {
    return force_on(simulation, frame, [&](Index p, const Vec3&) { return p == part; });
}

void hold(Model& model, Index plate) {
    auto& card = std::get<fabric::RigidCard>(model.materials[plate].card);
    card.fixed_moves = card.fixed_turns = 7;
}

struct Seen {
    double t = 0.0;
    Frame frame;
    Vec3 velocity = Vec3::Zero();  ///< of the last body
};

/// Runs to the end; what is seen at half the time and at the end.
std::pair<Seen, Seen> watch(Simulation& simulation) {
    std::pair<Seen, Seen> seen;
    const double half = 0.5 * simulation.model().end_time;
    const auto look = [&](Simulation& s) {
        Seen now{s.time(), s.frame(), s.bodies().back().velocity()};
        return now;
    };
    bool is_half = false;
    run(simulation, [&](Simulation& s) {
        if (!is_half && s.time() >= half) {
            seen.first = look(s);
            is_half = true;
        }
        if (s.is_over()) seen.second = look(s);
    });
    return seen;
}

}  // namespace

TEST_CASE("a block at rest on a plate: its weight on what faces the plate, nothing elsewhere",
          "[contact][pressure]") {
    Model model = scenes::empty(0.2);
    const support::Sheet floor = support::square_sheet(7, 0.6);
    const Index plate =
        add(model, floor.x, floor.triangles, rigid(1000.0), 1e-3, Vec3(-0.3, -0.3, 0));
    hold(model, plate);
    // faces of two triangles each: a node has facets of three faces
    const Index block =
        add(model, shapes::box(Vec3(0.1, 0.08, 0.03)), rigid(1000.0), 1e-3, Vec3(0, 0, 1.0005e-3));
    pull(model, Vec3(0, 0, -FREE_FALL));
    touch(model);
    Simulation simulation(model);
    const double weight = FREE_FALL * simulation.bodies()[1].mass();
    const auto [half, end] = watch(simulation);
    // mean force over the second half = weight + mass times the change of velocity
    const double change = (end.velocity - half.velocity).z() / (end.t - half.t);
    const double wanted = weight * (1.0 + change / FREE_FALL);
    INFO("weight " << weight << ", mean " << wanted);
    CHECK(wanted == Approx(weight).epsilon(1e-3));
    const auto faces = [](Index part, double z) {
        return [part, z](Index p, const Vec3& n) { return p == part && z * n.z() > 0.9; };
    };
    CHECK(force_on(simulation, end.frame, block) == Approx(wanted).epsilon(1e-5));
    CHECK(force_on(simulation, end.frame, faces(block, -1.0)) == Approx(wanted).epsilon(1e-5));
    CHECK(force_on(simulation, end.frame, plate) == Approx(wanted).epsilon(1e-5));
    const auto sides = [&](Index p, const Vec3& n) { return p == block && n.z() > -0.9; };
    CHECK(force_on(simulation, end.frame, sides) < 1e-6 * weight);
}

TEST_CASE("what cloth between two bodies feels on both sides adds up", "[contact][pressure]") {
    Model model = scenes::empty(0.2);
    const support::Sheet floor = support::square_sheet(3, 0.2),
                         sheet = support::square_sheet(10, 0.15);
    const Index plate =
        add(model, floor.x, floor.triangles, rigid(1000.0), 1e-3, Vec3(-0.1, -0.1, 0));
    hold(model, plate);
    const Index cloth = add(model, sheet.x, sheet.triangles, scenes::cloth(), 1e-3,
                            Vec3(-0.075, -0.075, 1.0005e-3));
    const Index block = add(model, shapes::box(Vec3(0.1, 0.08, 0.03), 2), rigid(3000.0), 1e-3,
                            Vec3(-0.05, -0.04, 2.001e-3));
    pull(model, Vec3(0, 0, -FREE_FALL));
    touch(model);
    Simulation simulation(model);
    const double weight = FREE_FALL * simulation.bodies()[1].mass();
    const Frame frame = watch(simulation).second.frame;
    const double above = force_on(simulation, frame, block),
                 below = force_on(simulation, frame, plate);
    CHECK(above == Approx(weight).epsilon(0.01));
    CHECK(below > above);  // the cloth's own weight
    CHECK(force_on(simulation, frame, cloth) == Approx(above + below).epsilon(1e-5));
}

TEST_CASE("a ball thrown on cloth: as much on the one as on the other, and the impulse it took",
          "[contact][pressure]") {
    Model model = scenes::empty(4e-3);
    const support::Sheet sheet = support::square_sheet(12, 0.2);
    const Index cloth =
        add(model, sheet.x, sheet.triangles, scenes::cloth(), 3e-4, Vec3(-0.1, -0.1, 0));
    const Index ball =
        add(model, shapes::sphere(0.04, 3), rigid(200.0), 2e-3, Vec3(0.011, 0.007, 0.045));
    const double speed = 15.0;
    model.rigid_velocity = {{ball, Vec3(0, 0, -speed), Vec3::Zero()}};
    contact::ContactCard card;  // not the cloth against itself
    card.kind = contact::ContactCard::Kind::SURFACE_TO_SURFACE;
    card.id = 1;
    card.parts = {ball};
    card.other_parts = {cloth};
    model.contacts = {card};
    Simulation simulation(model);
    Frame frame;
    const auto look = [&](Simulation& s) {
        if (s.is_over()) frame = s.frame();  // of the whole run
    };
    while (!simulation.is_over()) simulation.step(look);
    simulation.close(look);
    const double on_ball = force_on(simulation, frame, ball);
    CHECK(force_on(simulation, frame, cloth) == Approx(on_ball).epsilon(1e-5));
    const double taken = simulation.bodies()[0].mass() *
                         (simulation.bodies()[0].velocity().z() + speed) / model.end_time;
    INFO(on_ball << " N against " << taken << " N along the way");
    CHECK(on_ball > taken);  // normals lean
    CHECK(on_ball < 1.05 * taken);
}
