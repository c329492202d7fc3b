// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Where files of *INCLUDE_TRANSFORM lie, and what of them goes along: places, directions, tensors,
// normals.

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include "tests/unit/io/deck/included/inclusion_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

using Eigen::Affine3d;

void check_near(const Vec3& x, const Vec3& expected) {
    INFO(x.transpose() << ", expected " << expected.transpose());
    CHECK((x - expected).norm() < 1e-12 * (1.0 + expected.norm()));
}

const std::string TURN = "ROTATE,1,2,3,0.5,0,0,40\nTRANSL,3,-2,1\n";
Affine3d turn() {
    return Eigen::Translation3d(3, -2, 1) * Eigen::Translation3d(0.5, 0, 0) *
           Eigen::AngleAxisd(40.0 * M_PI / 180.0, Vec3(1, 2, 3).normalized()) *
           Eigen::Translation3d(-0.5, 0, 0);
}

const std::string BODY =
    "*MAT_RIGID\n5,2.0,1.e9,0.3\n1,5,7\n\n*NODE\n21,5,0,0\n22,6,0,0\n23,5,1,0\n"
    "*PART_INERTIA\nhead\n50,1,5\n1,2,3,4.0\n2,0.1,0.2,3,0.3,4\n1,2,3,4,5,6\n"
    "*ELEMENT_SHELL\n91,50,21,22,23,23\n";

}  // namespace

TEST_CASE("a transformation may stand before the inclusion that it places, or behind", "[io]") {
    const DeckFolder folder;
    folder.write("file.k", small_deck());
    const std::string cards = inclusion("file.k", "0\n0\n", 7),
                      rows = "*DEFINE_TRANSFORMATION\n7\nTRANSL,1,2,3\n";
    CHECK(folder.read(cards + rows).x[0] == Vec3(1, 2, 3));
    CHECK(folder.read(rows + cards).x[0] == Vec3(1, 2, 3));
}

TEST_CASE("a bag that is placed is the bag whose nodes are moved by hand", "[io]") {
    const std::string ids = "100,200,300,400,500,600,700\n800\n";
    const std::string file =
        "*NODE\n1,0,0,0\n2,1,0,0\n3,0,1,0\n4,0,0,1\n*ELEMENT_SHELL\n1,1,1,3,2,2\n2,1,1,2,4,4\n"
        "3,1,2,3,4,4\n4,1,1,4,3,3\n*PART\nbag\n1,1,1\n*SECTION_SHELL\n1,5\n0.001\n"
        "*MAT_FABRIC\n1,800,1e8,0,0,0.3\n\n\n\n\n*SET_PART\n1\n1\n*DEFINE_CURVE\n1\n0,1\n1,1\n"
        "*DEFINE_VECTOR\n1,0,0,0,1,2,2\n*AIRBAG_PARTICLE_ID\n1,bag\n1,1\n100,1\n1,1,1\n\n"
        "1,1,0.028,29\n2,1.0,1\n*AIRBAG_REFERENCE_GEOMETRY\n1,0,0,0.1\n";
    const Model placed =
        read_included(file, inclusion("file.k", ids, 1) + "*DEFINE_TRANSFORMATION\n1\n" + TURN +
                                "*CONTROL_TERMINATION\n1\n");
    std::string by_hand = "*KEYWORD\n*CONTROL_TERMINATION\n1\n" + file + "*END\n";
    const DeckFolder folder;
    const Model plain = folder.read(by_hand);
    for (std::size_t i = 0; i < 4; ++i) {
        check_near(placed.x[i], turn() * plain.x[i]);
        CHECK(placed.node_id[i] == plain.node_id[i] + 100);
        CHECK(placed.shells[i].nodes == plain.shells[i].nodes);
        CHECK(placed.shells[i].id == plain.shells[i].id + 200);
    }
    CHECK(placed.bags[0].id == 801);
    CHECK(placed.bags[0].orifices[0].node == plain.bags[0].orifices[0].node);
    check_near(placed.bags[0].orifices[0].direction.value(),
               turn().linear() * Vec3(1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0));
    check_near(placed.references[0].nodes[0].second, turn() * Vec3(0, 0, 0.1));
}

TEST_CASE("rows of the transformation may name nodes of the file and of the deck", "[io]") {
    const DeckFolder folder;
    folder.write("file.k", "*NODE\n1,1,0,0\n2,2,0,0\n3,1,1,0\n4,1,0,7\n");
    const Model model = folder.read(small_deck(
        "*NODE\n51,10,10,10\n52,10,11,10\n53,10,10,11\n" + inclusion("file.k", "100\n0\n", 7) +
        "*DEFINE_TRANSFORMATION\n7\nPOS6N,101,102,103,51,52,53\n"));
    const auto at = [&](int id) {
        const auto found = std::find(model.node_id.begin(), model.node_id.end(), id);
        return model.x[static_cast<std::size_t>(found - model.node_id.begin())];
    };
    check_near(at(101), {10, 10, 10});
    check_near(at(102), {10, 11, 10});
    check_near(at(104), {17, 10, 10});
}

TEST_CASE("files that are placed onto each other's nodes in a circle are refused", "[io]") {
    const DeckFolder folder;
    folder.write("file.k", "*NODE\n1,1,0,0\n2,2,0,0\n");
    folder.write("chain.k", "*NODE\n1,1,0,0\n2,2,0,0\n");
    const std::string both =
        inclusion("file.k", "100\n0\n", 7) + inclusion("chain.k", "200\n0\n", 8);
    const auto rows = [](const char* first, const char* second) {
        return std::string("*DEFINE_TRANSFORMATION\n7\nTRANSL2ND,") + first +
               "\n*DEFINE_TRANSFORMATION\n8\nTRANSL2ND," + second + "\n";
    };
    const auto faults = folder.faults(small_deck(both + rows("1,201,5", "1,102,5")));
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0], "whose places depend on where this file lies"));
    CHECK(folder.faults(small_deck(both + rows("1,201,5", "1,2,5"))).empty());
}

TEST_CASE("walls, vectors and boxes go with their file", "[io]") {
    const auto [plain, moved] = placed_small(
        "*RIGIDWALL_PLANAR_FINITE_MOVING\n\n0,0,-1,0,0,1\n2,0,-1,2,1\n3,4\n"
        "*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n0,0,6\n1,2,3\n0.5\n7,0,0,0,1\n"
        "*DEFINE_BOX\n6,0.5,1.5,0.5,1.5,-1,1\n*DEFINE_VECTOR\n3,0,0,0,0,0,5\n"
        "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,4,0,7,1,3\n1,1,0,7\n",
        TURN);
    const auto& plate = std::get<contact::Plate>(moved.walls[0].shape);
    const auto& was = std::get<contact::Plate>(plain.walls[0].shape);
    check_near(plate.corner, turn() * was.corner);
    for (int k = 0; k < 3; ++k) check_near(plate.axes.col(k), turn().linear() * was.axes.col(k));
    check_near(moved.walls[0].motion.direction, turn().linear() * plain.walls[0].motion.direction);
    check_near(std::get<contact::Ball>(moved.walls[1].shape).centre, turn() * Vec3(1, 2, 3));
    CHECK(moved.walls[1].nodes == plain.walls[1].nodes);
    CHECK(plain.walls[1].nodes == std::vector<Index>{2});
    check_near(moved.walls[1].motion.direction, turn().linear() * Vec3(0, 0, 1));
    check_near(moved.motions[0].axis, turn().linear() * Vec3(0, 0, 1));
    check_near(moved.motions[1].axis, turn().linear() * Vec3(1, 0, 0));
}

TEST_CASE("velocities, inertia and yarns turn with their file", "[io]") {
    const std::string more =
        BODY +
        "*INITIAL_VELOCITY_NODE\n1,1,2,3\n*INITIAL_VELOCITY_GENERATION\n2,2,5.0\n0,0,1,0,0,2\n"
        "*MAT_FABRIC\n9,800,4e8,0,0,0.3\n\n2,0,0,0,0,0,7\n0,0,0,1,2,2\n\n"
        "*MAT_FABRIC\n8,800,4e8,0,0,0.3\n\n3,0,0,0,0,0,7\n\n0,0,1,0,0,0,30\n";
    const auto [plain, moved] = placed_small(more, TURN);
    const Mat3 R = turn().linear();
    check_near(moved.velocity[0], R * Vec3(1, 2, 3));
    for (std::size_t i = 0; i < plain.velocity.size(); ++i)
        check_near(moved.velocity[i], R * plain.velocity[i]);
    check_near(moved.rigid_inertia[0].centre, turn() * Vec3(1, 2, 3));
    CHECK((moved.rigid_inertia[0].inertia - R * plain.rigid_inertia[0].inertia * R.transpose())
              .norm() < 1e-12);
    check_near(moved.rigid_velocity[0].velocity, R * Vec3(1, 2, 3));
    check_near(moved.rigid_velocity[0].spin, R * Vec3(4, 5, 6));
    const auto card = [](const Model& model, std::size_t m) {
        return std::get<fabric::FabricCard>(model.materials.at(m).card);
    };
    check_near(card(moved, 2).a, R * card(plain, 2).a);
    check_near(card(moved, 3).v, R * card(plain, 3).v);
    CHECK(card(moved, 3).beta == card(plain, 3).beta);
}

TEST_CASE("what is held stays held along axes of the deck, or the body along its own", "[io]") {
    const std::string held = "*NODE\n31,0,0,0,4,2\n*BOUNDARY_SPC_NODE\n2,0,0,1,1,0,0,1\n";
    const auto [plain, moved] = placed_small(held + BODY, "ROTATE,1,1,1,0,0,0,120\n");  // x to y
    REQUIRE(moved.supports.size() == 2);
    CHECK(plain.supports[0].fixed == (0b011U | 0b010U << 3U));  // x y, about y
    CHECK(moved.supports[0].fixed == (0b110U | 0b100U << 3U));  // y z, about z
    CHECK(plain.supports[1].fixed == (0b110U | 0b100U << 3U));  // y z, about z
    CHECK(moved.supports[1].fixed == (0b101U | 0b001U << 3U));  // z x, about x
    const auto rigid = [](const Model& model) {
        return std::get<fabric::RigidCard>(model.materials.at(1).card);
    };
    CHECK(rigid(plain).fixed_moves == 0b110U);  // y z
    CHECK(rigid(moved).fixed_moves == 0b101U);  // z x
    CHECK(rigid(moved).axes == Mat3::Identity());
    const Model turned = placed_small(BODY, TURN).moved;
    CHECK(rigid(turned).fixed_moves == 0b110U);
    for (int k = 0; k < 3; ++k)
        check_near(rigid(turned).axes.col(k), turn().linear() * Vec3::Unit(k));
    // two axes of a plane that is the deck's
    const Model plane =
        placed_small("*BOUNDARY_SPC_NODE\n2,0,1,1\n", "ROTATE,0,0,1,0,0,0,30\n").moved;
    CHECK(plane.supports[0].fixed == 0b011U);
}

TEST_CASE("what is held along no axis of the deck is refused, and gravity that turns", "[io]") {
    const auto faults = [](const std::string& more) {
        return included_faults(small_deck(more), inclusion("file.k", "0\n0\n", 7) +
                                                     "*DEFINE_TRANSFORMATION\n7\n" + TURN);
    };
    CHECK(any_contains(faults("*BOUNDARY_SPC_NODE\n2,0,1\n"),
                       "file.k:31: *BOUNDARY_SPC_NODE card 1, field 3 (DOFX) = 1, expected what is "
                       "held along axes of the deck"));
    CHECK(any_contains(faults("*NODE\n31,0,0,0,1\n"),
                       "turns node 31, expected TC and RC that hold it along axes of the deck"));
    CHECK(any_contains(faults("*LOAD_BODY_Z\n7\n"), "expected a body load in the deck itself"));
    CHECK(faults("*BOUNDARY_SPC_NODE\n2,0,1,1,1,1,1,1\n").empty());
}

TEST_CASE("a scale acts on places alone, which is a warning", "[io]") {
    const auto [plain, moved] =
        placed_small("*RIGIDWALL_GEOMETRIC_SPHERE\n\n1,2,3\n0.5\n*INITIAL_VELOCITY_NODE\n1,1,2,3\n",
                     "SCALE,2,3,4\n");
    CHECK(moved.x[2] == Vec3(2, 3, 0));
    CHECK(std::get<contact::Ball>(moved.walls[0].shape).centre == Vec3(2, 6, 12));
    CHECK(std::get<contact::Ball>(moved.walls[0].shape).radius == 0.5);
    CHECK(moved.velocity[0] == Vec3(1, 2, 3));
    CHECK(any_contains(moved.warnings, "SCALE acts on places alone"));
    CHECK_FALSE(any_contains(plain.warnings, "SCALE"));
}

TEST_CASE("a transformation that numbers cannot hold is refused", "[io]") {
    std::string rows;
    for (int i = 0; i < 12; ++i) rows += "SCALE,1e9,1e9,1e9\n";
    CHECK(any_contains(included_faults(small_deck(), inclusion("file.k", "0\n0\n", 7) +
                                                         "*DEFINE_TRANSFORMATION\n7\n" + rows),
                       "expected a transformation that keeps lengths within"));
    CHECK(any_contains(included_faults(small_deck("*NODE\n9,1e99\n"),
                                       inclusion("file.k", "0\n0\n", 7) +
                                           "*DEFINE_TRANSFORMATION\n7\nSCALE,1e9\n"),
                       "moves node 9, expected no farther than 1e+100"));
}
