// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a rigid body starts with the momentum and angular momentum of all masses that it has.

#include <catch2/catch.hpp>

#include "solver/simulation.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// Node 1 of 70 kg and node 5 of 52.5 kg, both of cloth, in one body.
const std::string JOINED_PAIR = "*SET_NODE\n6\n1,5\n*CONSTRAINED_NODAL_RIGID_BODY\n60,0,6\n";

/// A unit square of 0.6 kg at z = 5.
const std::string LONE_PLATE =
    "*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n*PART\nplate\n50,1,5\n"
    "*NODE\n21,0,0,5\n22,1,0,5\n23,1,1,5\n24,0,1,5\n*ELEMENT_SHELL\n20,50,21,22,23,24\n";

/// A rod of 1.2 kg from (5, 0, 5) to (7, 0, 5).
const std::string LONE_ROD =
    "*SECTION_BEAM\n9,3,1.0,2,0.0\n0.3,0,0,0\n*PART\nrod\n51,9,5\n*NODE\n31,5,0,5\n32,6,0,5\n"
    "33,7,0,5\n*ELEMENT_BEAM\n41,51,31,32,0\n42,51,32,33,0\n";

/// 10 rad/s about z through the origin, of all nodes.
const std::string ALL_TURNING = "*INITIAL_VELOCITY_GENERATION\n0,0,10.0\n0,0,0,0,0,1\n";

struct BodyStart {
    Vec3 centre, velocity, spin;
};
BodyStart body_start(const std::string& more) {
    const Simulation simulation(read_small(more));
    REQUIRE(simulation.bodies().size() == 1);
    const RigidBody& body = simulation.bodies()[0];
    return {body.position(), body.velocity(), body.spin()};
}

void check_start(const Vec3& is, const Vec3& expected) {
    INFO(is.transpose() << ", expected " << expected.transpose());
    CHECK((is - expected).norm() < 1e-11);
}

}  // namespace

TEST_CASE("nodes that are joined into a body start it", "[io][rigid]") {
    const BodyStart two =
        body_start(JOINED_PAIR + "*INITIAL_VELOCITY_NODE\n1,0.0,0.0,1.0\n5,0.0,2.0,-1.0\n");
    check_start(two.centre, {105.0 / 122.5, 0, 0});
    check_start(two.velocity, {0, 105.0 / 122.5, 17.5 / 122.5});
    check_start(two.spin, {0, 1, 1});
    for (const char* velocity : {"*INITIAL_VELOCITY\n\n1,2,3\n", "*INITIAL_VELOCITY\n6\n1,2,3\n",
                                 "*INITIAL_VELOCITY_GENERATION\n60,2,0,1,2,3\n\n"}) {
        const BodyStart all = body_start(JOINED_PAIR + velocity);
        check_start(all.velocity, {1, 2, 3});
        check_start(all.spin, {0, 0, 0});
    }
    const BodyStart own =
        body_start(JOINED_PAIR + ALL_TURNING + "*INITIAL_VELOCITY_RIGID_BODY\n60,1,2,3\n");
    CHECK(own.velocity == Vec3(1, 2, 3));
}

TEST_CASE("a weld starts with the momentum of its two nodes", "[io][rigid]") {
    const BodyStart weld = body_start(
        "*CONSTRAINED_SPOTWELD\n1,5\n*INITIAL_VELOCITY_NODE\n1,0.0,0.0,1.0\n5,0.0,2.0,-1.0\n");
    check_start(weld.velocity, {0, 105.0 / 122.5, 17.5 / 122.5});
    check_start(weld.spin, {0, 1, 1});
}

TEST_CASE("a body of beams starts as its nodes move", "[io][rigid]") {
    const BodyStart rod =
        body_start("*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n" + LONE_ROD + "*INITIAL_VELOCITY\n\n1,2,3\n");
    check_start(rod.velocity, {1, 2, 3});
    check_start(rod.spin, {0, 0, 0});
    const BodyStart turning = body_start("*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n" + LONE_ROD +
                                         "*INITIAL_VELOCITY_GENERATION\n51,2,10.0\n0,0,0,0,0,1\n");
    check_start(turning.velocity, {0, 60, 0});
    check_start(turning.spin, {0, 0, 10});
}

TEST_CASE("all that turns as one goes on as one, whatever gives the body its mass", "[io][rigid]") {
    const struct {
        std::string name, more;
        Vec3 centre;
    } cases[] = {
        {"shells alone", "", {0.5, 0.5, 5}},
        {"a mass", "*ELEMENT_MASS\n1,23,0.9\n", {0.8, 0.8, 5}},
        {"a mass with a tensor",
         "*ELEMENT_INERTIA\n1,23,0\n1e-3,0.,0.,1e-3,0.,1e-3,0.9\n",
         {0.8, 0.8, 5}},
        {"beams", LONE_ROD + "*CONSTRAINED_RIGID_BODIES\n50,51\n", {7.5 / 1.8, 0.3 / 1.8, 5}},
        {"cloth on extra nodes",
         "*SET_NODE\n6\n5,6\n*CONSTRAINED_EXTRA_NODES_SET\n50,6\n",
         {210.3 / 105.6, 52.8 / 105.6, 3.0 / 105.6}},
        {"a joined node",
         "*SET_NODE\n6\n21,5\n*CONSTRAINED_NODAL_RIGID_BODY\n60,0,6\n",
         {105.3 / 53.1, 0.3 / 53.1, 3.0 / 53.1}}};
    for (const auto& [name, more, centre] : cases) {
        CAPTURE(name);
        const BodyStart start = body_start(LONE_PLATE + more + ALL_TURNING);
        check_start(start.centre, centre);
        check_start(start.velocity, Vec3(0, 0, 10).cross(centre));
        check_start(start.spin, {0, 0, 10});
    }
}

TEST_CASE("cloth that rides on a part at rest sets it in motion", "[io][rigid]") {
    // 105 kg of cloth at 3 m/s, 0.6 kg at rest
    const BodyStart start = body_start(LONE_PLATE +
                                       "*SET_NODE\n6\n5,6\n*CONSTRAINED_EXTRA_NODES_SET\n50,6\n"
                                       "*INITIAL_VELOCITY\n6\n0,0,3\n");
    check_start(start.velocity, {0, 0, 315.0 / 105.6});
}
