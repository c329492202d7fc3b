// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("rigid parts: constraints, motion, initial velocity", "[io]") {
    const DeckFolder folder;
    const std::string rigid =
        "*PART\nblock\n3,1,2\n*MAT_020\n2,1000.,1.e9,0.3\n1,5,4\n\n*DEFINE_VECTOR\n8,0,0,0,0,3,4\n";
    const Model model = folder.read(
        small_deck(rigid + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n3,2,0,7,2.5\n3,8,2,7,0,8,0.5,0.1\n"
                           "*INITIAL_VELOCITY_RIGID_BODY\n3,1,2,3,0,0,4\n"));
    const auto& card = std::get<fabric::RigidCard>(model.materials.at(1).card);
    CHECK(card.fixed_moves == 6U);  // y, z
    CHECK(card.fixed_turns == 3U);  // x, y
    REQUIRE(model.motions.size() == 2);
    CHECK(model.motions[0].rigid_part == 2);
    CHECK(model.motions[0].axis == Vec3::UnitY());
    CHECK(model.motions[0].scale == 2.5);
    CHECK_FALSE(model.motions[0].rotation);
    CHECK(model.motions[1].rotation);
    CHECK(model.motions[1].axis.isApprox(Vec3(0.0, 0.6, 0.8)));
    CHECK(model.motions[1].kind == MotionKind::DISPLACEMENT);
    CHECK(model.motions[1].scale == 1.0);
    CHECK(model.motions[1].death == 0.5);
    CHECK(model.motions[1].birth == 0.1);
    REQUIRE(model.rigid_velocity.size() == 1);
    CHECK(model.rigid_velocity[0].velocity == Vec3(1, 2, 3));
    CHECK(model.rigid_velocity[0].spin == Vec3(0, 0, 4));
    CHECK(folder.faults(small_deck("*BOUNDARY_PRESCRIBED_MOTION_RIGID\n1,1,0,7\n")).size() == 1);
    CHECK(
        folder.faults(small_deck(rigid + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n3,9,0,7\n")).size() ==
        1);
}

TEST_CASE("a rigid part starts with the momentum that its nodes were given", "[io]") {
    const DeckFolder folder;
    const std::string rigid = "*MAT_RIGID\n2,1000.,1.e9,0.3\n\n\n";
    const auto start = [&](const std::string& velocity) {
        std::string deck = small_deck(rigid + velocity);
        deck.replace(deck.find("more cloth\n2,1,1"), 16, "block\n2,1,2");
        return starts_of(folder.read(deck));
    };
    CHECK(start("").empty());
    const auto all = start("*INITIAL_VELOCITY\n\n0,0,3\n");
    REQUIRE(all.size() == 1);
    CHECK(all[0].part == 1);
    CHECK(all[0].velocity.isApprox(Vec3(0, 0, 3)));
    CHECK(all[0].spin.isZero(1e-12));
    // 2 rad/s about z through the origin; the square of 300 kg has its centre at (1.5, 0.5), and
    // cloth gives its corners (1, 0) and (1, 1) 35 and 70 kg
    const auto turning = start("*INITIAL_VELOCITY_GENERATION\n2,2,2.0\n0,0,0,0,0,1\n");
    REQUIRE(turning.size() == 1);
    CHECK(turning[0].velocity.isApprox(Vec3(-2.0 * 220.0, 2.0 * 555.0, 0.0) / 405.0));
    CHECK(turning[0].spin.isApprox(Vec3(0, 0, 2)));
    const auto own = start("*INITIAL_VELOCITY\n\n0,0,3\n*INITIAL_VELOCITY_RIGID_BODY\n2,1\n");
    REQUIRE(own.size() == 1);
    CHECK(own[0].velocity == Vec3(1, 0, 0));
}

TEST_CASE("nodes: supports and prescribed motion", "[io]") {
    const DeckFolder folder;
    const Model model =
        folder.read(small_deck("*BOUNDARY_SPC_NODE_ID\n1,held\n4,0,1,0,1,0,0,1\n*SET_NODE\n5\n1,2\n"
                               "*BOUNDARY_PRESCRIBED_MOTION_SET\n5,3,1,7\n"
                               "*BOUNDARY_PRESCRIBED_MOTION_NODE_ID\n1,moved\n6,1,2,7,-1\n"));
    REQUIRE(model.supports.size() == 1);
    CHECK(model.supports[0].node == 3);
    CHECK(model.supports[0].fixed == (1U | 4U | 32U));
    REQUIRE(model.motions.size() == 2);
    CHECK(model.motions[0].nodes == std::vector<Index>{0, 1});
    CHECK(model.motions[0].kind == MotionKind::ACCELERATION);
    CHECK(model.motions[1].nodes == std::vector<Index>{5});
    CHECK(model.motions[1].scale == -1.0);
    CHECK(folder.faults(small_deck("*BOUNDARY_PRESCRIBED_MOTION_NODE\n6,5,0,7\n")).size() == 1);
}

TEST_CASE("initial velocity: all nodes, a set and the rest, one node, a turning part", "[io]") {
    const DeckFolder folder;
    const auto velocity = [&](const std::string& text) {
        return folder.read(small_deck(text)).velocity;
    };
    CHECK(velocity("") == Points(6, Vec3::Zero()));
    CHECK(velocity("*INITIAL_VELOCITY\n\n0,0,3\n") == Points(6, Vec3(0, 0, 3)));
    const Points two = velocity("*SET_NODE\n5\n1\n*INITIAL_VELOCITY\n0,5\n0,0,3\n1,0,0\n");
    CHECK(two[0] == Vec3(1, 0, 0));
    CHECK(two[1] == Vec3(0, 0, 3));
    const Points one = velocity("*INITIAL_VELOCITY_NODE\n3,1,2,3\n");
    CHECK(one[2] == Vec3(1, 2, 3));
    CHECK(one[3] == Vec3::Zero());
    // 2 rad/s about z through node 2, and 5 along z
    const Points turning = velocity("*INITIAL_VELOCITY_GENERATION\n2,2,2.0,0,0,5\n1,0,0,0,0,10\n");
    CHECK(turning[0] == Vec3::Zero());
    CHECK(turning[1] == Vec3(0, 0, 5));
    CHECK(turning[4] == Vec3(0, 2, 5));
    CHECK(turning[2] == Vec3(-2, 0, 5));
}

TEST_CASE("loads, damping and walls", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(
        small_deck("*LOAD_BODY_Y\n7,9.81\n*DAMPING_GLOBAL\n0,25.0\n"
                   "*RIGIDWALL_PLANAR_ID\n4,floor\n\n0,0,-1,0,0,4,0.25\n"
                   "*SET_NODE\n5\n1,2\n*RIGIDWALL_PLANAR\n0,5\n1,0,0,-1,0,0\n\n0,0,0,0,1,0\n"
                   "*LOAD_SEGMENT\n7,1.0,0,1,2,3\n*LOAD_SHELL_ELEMENT\n13,7\n"));
    CHECK(model.body_loads.at(0).axis == 1);
    CHECK(model.body_loads.at(0).scale == 9.81);
    CHECK(model.mass_damping == 25.0);
    REQUIRE(model.walls.size() == 3);
    CHECK(model.walls[0].id == 4);
    CHECK(model.walls[0].title == "floor");
    const auto plane = [&](std::size_t i) {
        return std::get<contact::HalfSpace>(model.walls[i].shape);
    };
    CHECK(plane(0).normal == Vec3::UnitZ());
    CHECK(plane(0).point == Vec3(0, 0, -1));
    CHECK(model.walls[0].friction == 0.25);
    CHECK(model.walls[0].nodes.size() == 6);
    CHECK(model.walls[1].nodes == std::vector<Index>{2, 3, 4, 5});
    CHECK(plane(1).normal == -Vec3::UnitX());
    CHECK(plane(2).normal == Vec3::UnitY());
    REQUIRE(model.pressure_loads.size() == 2);
    CHECK(model.pressure_loads[0].facets[0] == std::array<Index, 4>{0, 1, 2, 2});
    CHECK(model.pressure_loads[1].facets[0] == std::array<Index, 4>{1, 4, 5, 2});

    CHECK(folder.faults(small_deck("*DAMPING_GLOBAL\n0,25.0,1,0,1\n")).size() == 1);
    const auto faults =
        folder.faults(small_deck("*RIGIDWALL_PLANAR_ORTHO\n\n0,0,0,0,0,1\n1,2\n"
                                 "*RIGIDWALL_GEOMETRIC_ELLIPSOID\n\n"
                                 "*RIGIDWALL_PLANAR\n\n0,0,0,0,0,1,2.0\n"));
    REQUIRE(faults.size() == 3);
    CHECK(contains(faults[0], "*RIGIDWALL_PLANAR_ORTHO is not acted on yet"));
    CHECK(contains(faults[1], "*RIGIDWALL_GEOMETRIC_ELLIPSOID is not supported"));
    CHECK(contains(faults[2], "(FRIC) = 2.0, expected 0 to 1"));
}

TEST_CASE("contact: one method, and a word on what does not count", "[io]") {
    const DeckFolder folder;
    const Model model =
        folder.read(small_deck("*CONTACT_AIRBAG_SINGLE_SURFACE_ID\n3,fabric on fabric\n2,0,3\n"
                               "0.3,0.2,1.5,0,20.0,0,0.1,0.9\n0,0,0.5\n2,0.1,7\n0\n1\n"
                               "*CONTACT_AUTOMATIC_SINGLE_SURFACE_MPP\n\n0\n\n\n"));
    REQUIRE(model.contacts.size() == 2);
    const contact::ContactCard& first = model.contacts[0];
    CHECK(first.id == 3);
    CHECK(first.title == "fabric on fabric");
    CHECK(first.parts == std::vector<Index>{1});
    CHECK(first.friction_static == 0.3);
    CHECK(first.friction_dynamic == 0.2);
    CHECK(first.friction_decay == 1.5);
    CHECK(first.damping == 20.0);
    CHECK(first.birth == 0.1);
    CHECK(first.death == 0.9);
    CHECK(first.thickness == 0.5);
    CHECK(first.thickness_curve == 0);
    CHECK(model.contacts[1].id == 2);
    CHECK(model.contacts[1].parts == std::vector<Index>{0, 1});
    CHECK(std::isnan(model.contacts[1].thickness));
    CHECK(model.contacts[1].death == 1e20);
    REQUIRE(model.warnings.size() == 1);
    CHECK(contains(model.warnings[0], "(SOFT) = 2: there is one contact method here"));
}

TEST_CASE("control and output", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(small_deck(
        "*TITLE\n  a bag  "
        "\n*CONTROL_TIMESTEP\n1e-7,0.67,0,0,-5e-7\n*DATABASE_BINARY_D3PLOT\n0,0,0,20\n"
        "*DATABASE_RBDOUT\n0.1\n*DATABASE_RWFORC\n0.2\n*DATABASE_HISTORY_NODE_ID\n3,tip\n"
        "*DATABASE_HISTORY_NODE\n1,3,0,5\n*DATABASE_BINARY_D3THDT\n1.0\n*CONTROL_ENERGY\n2,2\n"));
    CHECK(model.title == "a bag");
    CHECK(model.end_time == 1.0);
    CHECK(model.step_start == 1e-7);
    CHECK(model.step_factor == 0.67);
    CHECK(model.step_mass_scaled == -5e-7);
    CHECK(model.output.frames == Approx(0.05));
    CHECK(model.output.rbdout == 0.1);
    CHECK(model.output.rwforc == 0.2);
    CHECK(std::isnan(model.output.abstat));
    CHECK(model.history_nodes == std::vector<Index>{0, 2, 4});
    REQUIRE(model.notes.size() == 3);  // with that units are not known
    CHECK(contains(model.notes[1], "deck.k:44: *DATABASE_BINARY_D3THDT is not read"));
    CHECK(contains(model.notes[2], "deck.k:46: *CONTROL_ENERGY is not read"));
}

TEST_CASE("a number of frames goes before the time between them", "[io]") {
    const DeckFolder folder;
    io::DeckOptions options;
    const auto frames = [&](const char* cards) {
        const std::string deck = fmt::format("*DATABASE_BINARY_D3PLOT\n{}\n", cards);
        return folder.read(small_deck(deck), options).output.frames;
    };
    CHECK(frames("0.1") == 0.1);
    CHECK(frames("0.1,0,0,20") == Approx(0.05));
    options.until = 4.0;  // the deck's ENDTIM counts
    CHECK(frames("0.1,0,0,20") == Approx(0.05));
}

TEST_CASE("checks of shells and subcycles of LS-DYNA change no answer", "[io]") {
    for (const char* keyword : {"*CONTROL_CHECK_SHELL", "*CONTROL_SUBCYCLE"})
        CHECK(any_contains(read_small(fmt::format("{}\n0,0\n", keyword)).notes,
                           fmt::format("{} is not read", keyword)));
}

TEST_CASE("the reference geometry may be scaled about a node", "[io]") {
    const DeckFolder folder;
    const Model model =
        folder.read(small_deck("*AIRBAG_REFERENCE_GEOMETRY_BIRTH_RDT_ID\n1,2.0,1.0,0.5,3\n0\n"
                               "       1             0.0             0.0             4.0\n3,1,1,0\n"
                               "*AIRBAG_REFERENCE_GEOMETRY\n2,9,9,9\n"));
    REQUIRE(model.references.size() == 2);
    const ReferenceGeometry& first = model.references[0];
    REQUIRE(first.nodes.size() == 2);
    CHECK(first.nodes[0].first == 0);
    CHECK(first.nodes[0].second == Vec3(-1.0, 0.0, 2.0));
    CHECK(first.nodes[1].second == Vec3(1, 1, 0));
    CHECK(model.references[1].nodes[0].second == Vec3(9, 9, 9));
    CHECK(folder.faults(small_deck("*AIRBAG_REFERENCE_GEOMETRY\n2,9,9,9\n2,9,9,9\n77,1,1,1\n"))
              .size() == 2);
    const Model born = folder.read(small_deck("*AIRBAG_REFERENCE_GEOMETRY_BIRTH\n0.1\n2,9,9,9\n"));
    CHECK(born.references.at(0).birth == 0.1);
    CHECK(first.birth == 0.0);
}

TEST_CASE("shells may have reference corners of their own, scaled about a node", "[io]") {
    const DeckFolder folder;
    const Model model =
        folder.read(small_deck("*AIRBAG_SHELL_REFERENCE_GEOMETRY_RDT_ID\n1,2.0,1.0,1.0,2\n"
                               "      11       1       1       2       6\n13,2,2,5,6,3\n"));
    REQUIRE(model.shell_references.size() == 2);
    CHECK(model.shell_references[0].shell == 0);
    CHECK(model.shell_references[0].corners[0] == Vec3(-1, 0, 0));
    CHECK(model.shell_references[0].corners[2] == Vec3(3, 1, 0));
    CHECK(model.shell_references[0].corners[3] == Vec3(3, 1, 0));
    CHECK(model.shell_references[1].corners[1] == Vec3(3, 0, 0));
    const auto faults = [&](const std::string& rows) {
        return folder.faults(small_deck("*AIRBAG_SHELL_REFERENCE_GEOMETRY\n" + rows)).size();
    };
    CHECK(faults("11,2,1,2,3,3\n") == 1);   // not its part
    CHECK(faults("99,1,1,2,3,3\n") == 1);   // no such shell
    CHECK(faults("11,1,1,2,77,3\n") == 1);  // no such node
    CHECK(faults("11,1,1,2,3\n11,1,1,2,3\n") == 1);
}
