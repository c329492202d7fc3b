// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <map>
#include <set>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

const std::string RIGID = "*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n";
const std::string SOLID_PART = RIGID + "*SECTION_SOLID\n9,1\n*PART\nhead\n50,9,5\n";
const std::string INERTIA = RIGID + "*PART_INERTIA\nhead\n50,1,5\n";

/// A brick 2 x 3 x 4 at the origin from nodes 101-108, another one on top of it to z = 6.
const std::string BRICK_NODES = R"(*NODE
101,0,0,0
102,2,0,0
103,2,3,0
104,0,3,0
105,0,0,4
106,2,0,4
107,2,3,4
108,0,3,4
109,0,0,6
110,2,0,6
111,2,3,6
112,0,3,6
)";

Mat3 brick_inertia(double mass, const Vec3& size) {
    const Vec3 s = size.cwiseProduct(size);
    return mass / 12.0 * Vec3(s.y() + s.z(), s.x() + s.z(), s.x() + s.y()).asDiagonal();
}

/// Every edge of the part's shells is run along once each way, and the normals look outward.
void check_closed(const Model& model, Index part, double volume) {
    std::map<std::pair<Index, Index>, int> edges;
    double enclosed = 0.0;
    for (const Shell& shell : model.shells) {
        if (shell.part != part) continue;
        const std::size_t corners = shell.is_triangle() ? 3 : 4;
        for (std::size_t i = 0; i < corners; ++i)
            ++edges[{shell.nodes[i], shell.nodes[(i + 1) % corners]}];
        const auto x = [&](std::size_t i) { return model.x[shell.nodes[i]]; };
        enclosed += x(0).dot(x(1).cross(x(2))) / 6.0 + x(0).dot(x(2).cross(x(3))) / 6.0;
    }
    for (const auto& [edge, count] : edges) {
        CHECK(count == 1);
        CHECK(edges.contains({edge.second, edge.first}));
    }
    CHECK(enclosed == Approx(volume));
}

}  // namespace

TEST_CASE("loads on rigid bodies: what is expected of their cards", "[io]") {
    const std::string rigid = "*PART\nblock\n3,1,2\n*MAT_RIGID\n2,1000.,1.e9,0.3\n\n\n";
    const auto fault = [&](const std::string& card) {
        return only_fault(rigid + "*LOAD_RIGID_BODY\n" + card + "\n");
    };
    CHECK(contains(fault("1,1,7"), "field 1 (PID) = 1, expected a part with *MAT_RIGID"));
    CHECK(contains(fault("3,1,7"), "part 3 \"block\" has no elements and no nodes"));
    CHECK(contains(fault("3,9,7"), "field 2 (DOF) = 9, expected 1 or 2 or 3 or 4 or 5 or 6"));
    CHECK(contains(fault("3,1,8"), "field 3 (LCID) = 8"));
    CHECK(contains(fault("3,1,7,1,6"), "field 5 (CID) = 6"));
    CHECK(contains(fault("3,4,7,1,0,1,2,5"), "field 8 (M3) = 5, expected a node off the line"));
    CHECK(contains(fault("3,8,7,1,0,1,2"), "field 8 (M3)"));
}

TEST_CASE("*PART_INERTIA: mass, centre and inertia as they are written", "[io]") {
    const Model model = read_small(INERTIA + "1,2,3,4.5\n1,0.1,0.2,2,0.3,2.5\n7,8,9,1,2,3\n");
    REQUIRE(model.rigid_inertia.size() == 1);
    const RigidInertia& body = model.rigid_inertia[0];
    CHECK(body.part == 2);
    CHECK(body.mass == 4.5);
    CHECK(body.centre == Vec3(1, 2, 3));
    Mat3 inertia;
    inertia << 1, 0.1, 0.2, 0.1, 2, 0.3, 0.2, 0.3, 2.5;
    CHECK(body.inertia == inertia);
    REQUIRE(model.rigid_velocity.size() == 1);
    CHECK(model.rigid_velocity[0].part == 2);
    CHECK(model.rigid_velocity[0].velocity == Vec3(7, 8, 9));
    CHECK(model.rigid_velocity[0].spin == Vec3(1, 2, 3));
}

TEST_CASE("*PART_INERTIA: a node as centre, and local axes", "[io]") {
    // local x along global y, local y along -x
    const Model model = read_small(INERTIA + "1,2,3,4.5,1,6\n1,0,0,2,0,2.5\n\n0,3,0,-1,1,0\n");
    const RigidInertia& body = model.rigid_inertia.at(0);
    CHECK(body.centre == Vec3(2, 1, 0));
    CHECK((body.inertia - Mat3(Vec3(2, 1, 2.5).asDiagonal())).norm() < 1e-15);
    REQUIRE(model.rigid_extra_nodes.size() == 1);
    CHECK(model.rigid_extra_nodes[0].part == 2);
    CHECK(model.rigid_extra_nodes[0].node == 5);
    CHECK(model.rigid_velocity.empty());
}

TEST_CASE(
    "velocities of *PART_INERTIA stand back behind the body's own, and with IRIGID behind "
    "its nodes'",
    "[io]") {
    const std::string deck = INERTIA +
                             "1,1,0,4.5\n1,0,0,2,0,2.5\n7,8,9\n*ELEMENT_SHELL\n"
                             "14,50,2,5,6,6\n";
    const Model own = read_small(deck + "*INITIAL_VELOCITY_RIGID_BODY\n50,1,0,0\n");
    REQUIRE(own.rigid_velocity.size() == 1);
    CHECK(own.rigid_velocity[0].velocity == Vec3(1, 0, 0));
    const std::string generation = "*INITIAL_VELOCITY_GENERATION\n50,2,0,0,0,5\n";
    const Model kept = read_small(deck + generation + "\n");
    CHECK(kept.rigid_velocity.at(0).velocity == Vec3(7, 8, 9));
    const Model given = read_small(deck + generation + "0,0,0,0,0,0,0,1\n");
    CHECK((starts_of(given).at(0).velocity - Vec3(0, 0, 5)).norm() < 1e-12);
}

TEST_CASE("a turning field of velocities gives a part with its own centre that centre's", "[io]") {
    // 2 rad/s about z through node 2 at (1, 0, 0); the centre of mass is set to (1, 4, 0)
    const Model model = read_small(INERTIA +
                                   "1,4,0,4.5\n1,0,0,2,0,2.5\n\n*ELEMENT_SHELL\n"
                                   "14,50,2,5,6,6\n15,50,2,6,3,3\n"
                                   "*INITIAL_VELOCITY_GENERATION\n50,2,2.0\n1,0,0,0,0,1\n");
    const auto start = starts_of(model);
    REQUIRE(start.size() == 1);
    CHECK((start[0].spin - Vec3(0, 0, 2)).norm() < 1e-12);
    CHECK((start[0].velocity - Vec3(-8, 0, 0)).norm() < 1e-12);
}

TEST_CASE("what is wrong with *PART_INERTIA is told", "[io]") {
    CHECK(contains(only_fault(INERTIA + "0,0,0,0\n1,0,0,2,0,2.5\n\n"), "(TM)"));
    CHECK(contains(only_fault(INERTIA + "0,0,0,1\n1,2,0,2,0,2.5\n\n"),
                   "three principal moments are above 0"));
    CHECK(contains(only_fault(INERTIA + "0,0,0,1,1\n1,0,0,2,0,2.5\n\n1,0,0,2,0,0\n"),
                   "span the local xy plane"));
    CHECK(contains(only_fault("*PART_INERTIA\nsoft\n50,1,1\n0,0,0,1\n1,0,0,2,0,2.5\n\n"),
                   "(MID) = 1, expected a *MAT_RIGID"));
    CHECK(any_contains(read_small(INERTIA + "0,0,0,1\n1,0,0,2,0,9\n\n").warnings,
                       "no body has such principal moments"));
}

TEST_CASE("solids of a rigid part: skin, mass, centre, inertia", "[io]") {
    const bool on_two_lines = GENERATE(false, true);
    const std::string solids = on_two_lines ? "7,50\n101,102,103,104,105,106,107,108\n"
                                              "8,50\n105,106,107,108,109,110,111,112\n"
                                            : "7,50,101,102,103,104,105,106,107,108\n"
                                              "8,50,105,106,107,108,109,110,111,112\n";
    const Model model = read_small(SOLID_PART + BRICK_NODES + "*ELEMENT_SOLID\n" + solids);
    CHECK(model.shells.size() == 3 + 10);
    CHECK(model.shells[3].id == 14);  // after shell 13
    check_closed(model, 2, 36.0);
    REQUIRE(model.rigid_inertia.size() == 1);
    const RigidInertia& body = model.rigid_inertia[0];
    CHECK(body.mass == Approx(72.0));
    CHECK((body.centre - Vec3(1, 1.5, 3)).norm() < 1e-12);
    CHECK((body.inertia - brick_inertia(72.0, {2, 3, 6})).norm() < 1e-10);
    CHECK(model.rigid_extra_nodes.empty());
    // lumped on the skin they weigh as much
    CHECK(model.parts[2].thickness * (2 * (2 * 3 + 2 * 6 + 3 * 6)) == Approx(36.0));
    CHECK(model.parts[2].contact_thickness == 0.3);
}

TEST_CASE("wedges, pyramids and tetrahedra fill a brick as well", "[io]") {
    // a wedge and, for the other half, a pyramid and a tetrahedron
    const Model model = read_small(SOLID_PART + BRICK_NODES +
                                   "*ELEMENT_SOLID\n"
                                   "1,50,102,101,105,106,104,104,108,108\n"
                                   "2,50,102,104,108,106,107,107,107,107\n"
                                   "3,50,102,103,104,107,107,107,107,107\n");
    check_closed(model, 2, 24.0);
    const RigidInertia& body = model.rigid_inertia.at(0);
    CHECK(body.mass == Approx(48.0));
    CHECK((body.centre - Vec3(1, 1.5, 2)).norm() < 1e-12);
    CHECK((body.inertia - brick_inertia(48.0, {2, 3, 4})).norm() < 1e-10);
}

TEST_CASE("nodes inside solids ride on them, sets know the skin, *PART_INERTIA goes before",
          "[io]") {
    // a brick of eight bricks around one node in the middle
    std::string deck = RIGID +
                       "*SECTION_SOLID\n9\n*PART_INERTIA\nhead\n50,9,5\n0,0,0,4.5\n"
                       "1,0,0,2,0,2.5\n\n*NODE\n";
    const auto id = [](int i, int j, int k) { return 100 + i + 3 * j + 9 * k; };
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) deck += fmt::format("{},{},{},{}\n", id(i, j, k), i, j, k);
    deck += "*ELEMENT_SOLID\n";
    for (int n = 0; n < 8; ++n) {
        const int i = n & 1, j = n >> 1 & 1, k = n >> 2;
        deck += fmt::format("{},50,{},{},{},{},{},{},{},{}\n", n + 1, id(i, j, k), id(i + 1, j, k),
                            id(i + 1, j + 1, k), id(i, j + 1, k), id(i, j, k + 1),
                            id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1));
    }
    const Model model = read_small(deck + "*INITIAL_VELOCITY_GENERATION\n50,2,0,0,0,5\n\n");
    check_closed(model, 2, 8.0);
    REQUIRE(model.rigid_extra_nodes.size() == 1);
    CHECK(model.node_id[model.rigid_extra_nodes[0].node] == id(1, 1, 1));
    REQUIRE(model.rigid_inertia.size() == 1);
    CHECK(model.rigid_inertia[0].mass == 4.5);
    CHECK((starts_of(model).at(0).velocity - Vec3(0, 0, 5)).norm() < 1e-12);
}

TEST_CASE("what is wrong with solids is told", "[io]") {
    const std::string brick = "7,50,101,102,103,104,105,106,107,108\n";
    const Model soft = read_small("*SECTION_SOLID\n9,1\n*PART\nsoft\n50,9,1\n" + BRICK_NODES +
                                  "*ELEMENT_SOLID\n" + brick + "*BOUNDARY_SPC_NODE\n101,0,1,1,1\n");
    CHECK(any_contains(soft.warnings, "(SECID) = 9: solids that deform are taken as one rigid"));
    const auto& stiff = std::get<fabric::RigidCard>(soft.materials[soft.parts[2].material].card);
    CHECK(stiff.density == 700.0);
    CHECK(stiff.fixed_moves == 7);
    CHECK(stiff.fixed_turns == 0);
    CHECK(soft.supports.empty());
    CHECK(contains(only_fault("*SECTION_SOLID\n9,1\n*PART\nsoft\n50,9,1\n" + BRICK_NODES +
                              "*ELEMENT_SOLID\n7,50,1,102,103,104,105,106,107,108\n"),
                   "solids deform and hold cloth at node 1"));
    CHECK(contains(only_fault(SOLID_PART + BRICK_NODES +
                              "*ELEMENT_SOLID\n7,50,105,106,107,108,101,102,103,104\n"),
                   "*ELEMENT_SOLID 7 has no volume"));
    CHECK(contains(only_fault(SOLID_PART + BRICK_NODES + "*ELEMENT_SOLID\n" + brick + brick),
                   "*ELEMENT_SOLID has id 7, as another one has"));
    CHECK(
        contains(only_fault(BRICK_NODES + "*ELEMENT_SOLID\n7,1,101,102,103,104,105,106,107,108\n"),
                 "expected a part with *SECTION_SOLID"));
    CHECK(contains(only_fault(SOLID_PART + "*ELEMENT_SHELL\n14,50,1,2,3,3\n"),
                   "expected a part with *SECTION_SHELL"));
}

TEST_CASE("extra nodes ride on a rigid part, once, and on no other", "[io]") {
    const std::string deck = RIGID +
                             "*PART\nplate\n50,1,5\n*PART\nother\n51,1,5\n*ELEMENT_SHELL\n"
                             "14,50,2,5,6,6\n*SET_NODE\n4\n1,4,2\n";
    const Model model = read_small(deck +
                                   "*CONSTRAINED_EXTRA_NODES_SET\n50,4\n"
                                   "*CONSTRAINED_EXTRA_NODES_NODE\n50,1\n50,3\n");
    std::set<Index> riders;
    for (const RigidExtraNode& extra : model.rigid_extra_nodes) {
        CHECK(extra.part == 2);
        riders.insert(extra.node);
    }
    CHECK(riders == std::set<Index>{0, 2, 3});  // node 2 is the part's own
    CHECK(model.rigid_extra_nodes.size() == 3);
    CHECK(contains(only_fault(deck + "*CONSTRAINED_EXTRA_NODES_NODE\n51,5\n"),
                   "node 5 is of part 50"));
    CHECK(contains(only_fault(deck + "*CONSTRAINED_EXTRA_NODES_NODE\n1,4\n"),
                   "expected a part with *MAT_RIGID"));
}
