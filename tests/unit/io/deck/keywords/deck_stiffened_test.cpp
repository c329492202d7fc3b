// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Parts that are rigid from the start, tensors of their nodes, stiffness of their joints.

#include <catch2/catch.hpp>

#include <numbers>

#include "solver/bodies/rigid_parts.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

const std::string BLOCK = "*PART\nblock\n3,1,2\n*MAT_RIGID\n2,1000.,1.e9,0.3\n\n\n";

bool is_rigid_part(const Model& model, std::size_t part) {
    const auto material = static_cast<std::size_t>(model.parts[part].material);
    return std::holds_alternative<fabric::RigidCard>(model.materials[material].card);
}

}  // namespace

TEST_CASE(
    "a part that is rigid from the start keeps density and leak, others of its material deform",
    "[io]") {
    const Model model = read_small(
        "*MAT_FABRIC\n9,800,1e8,1e8,0,0.3\n1e7\n0,0.1,0.2,0,0,2,7\n\n\n*PART\nleaky\n9,1,9\n"
        "*NODE\n21,5,0,0\n22,6,0,0\n23,5,1,0\n*ELEMENT_SHELL\n91,9,21,22,23,23\n" +
        BLOCK + "*DEFORMABLE_TO_RIGID\n2,3,part\n9\n");
    CHECK_FALSE(is_rigid_part(model, 0));
    CHECK(is_rigid_part(model, 1));
    CHECK(is_rigid_part(model, 2));
    const auto material = static_cast<std::size_t>(model.parts[1].material);
    CHECK(std::get<fabric::RigidCard>(model.materials[material].card).density == 700.0);
    REQUIRE(model.rigid_merges.size() == 1);
    CHECK(model.rigid_merges[0].part == 1);
    CHECK(model.parts[static_cast<std::size_t>(model.rigid_merges[0].lead)].id == 3);
    REQUIRE(leakage_of(model, 2) != nullptr);
    CHECK(leakage_of(model, 2)->leak_area == 0.1);
    CHECK(leakage_of(model, 2)->leak_velocity == 0.2);
}

TEST_CASE("what is expected of parts that are to be rigid", "[io]") {
    const auto fault = [](const std::string& card) {
        return only_fault(BLOCK + "*DEFORMABLE_TO_RIGID\n" + card + "\n");
    };
    CHECK(contains(fault("2,1"), "field 2 (LRB) = 1, expected a part with *MAT_RIGID"));
    CHECK(contains(fault("2,2"), "field 2 (LRB) = 2, expected a part that PID does not lead"));
    CHECK(contains(fault("2,3\n3,2"), "card 2, field 2 (LRB) = 2"));
    CHECK(contains(fault("2,0,PSET"), "field 3 (PTYPE) = PSET, expected PART: a row for each"));
    CHECK(contains(fault("8"), "field 1 (PID) = 8"));
    CHECK(contains(only_fault("*DEFORMABLE_TO_RIGID_AUTOMATIC\n1\n"),
                   "no part becomes rigid or deforms again during a run, expected "
                   "*DEFORMABLE_TO_RIGID"));
}

TEST_CASE("a tensor of a node is its body's, about the body's centre", "[io]") {
    const std::string cards = "*DEFORMABLE_TO_RIGID\n1\n";
    const auto body = [&](const std::string& more) {
        const Model model = read_small(cards + more);
        std::vector<double> mass(model.x.size(), 1.0);
        for (const NodeMass& added : model.node_masses)
            mass[static_cast<std::size_t>(added.node)] += added.mass;
        return inertia_of_parts(model, {0}, mass);
    };
    const RigidInertia plain = body("*ELEMENT_MASS\n1,3,2.0\n");
    const RigidInertia more = body("*ELEMENT_INERTIA\n1,3\n3,0.1,0.2,4,0.3,5,2.0\n");
    Mat3 own;
    own << 3, 0.1, 0.2, 0.1, 4, 0.3, 0.2, 0.3, 5;
    CHECK(more.mass == plain.mass);
    CHECK((more.centre - plain.centre).norm() == 0.0);
    CHECK((more.inertia - plain.inertia - own).norm() < 1e-12);
    CHECK(read_small("*ELEMENT_INERTIA\n1,5\n0,0,0,0,0,0,2.0\n").node_masses.at(0).mass == 2.0);
    CHECK(contains(only_fault("*ELEMENT_INERTIA\n1,5\n1,0,0,1,0,1,2.0\n"),
                   "a tensor to node 5, expected a node of a rigid part"));
    CHECK(contains(only_fault("*ELEMENT_INERTIA\n1,5,7\n1,0,0,1,0,1\n"), "field 3 (CSID) = 7"));
    CHECK(contains(only_fault("*ELEMENT_INERTIA\n1,5\n1,2,0,1,0,1\n"), "field 1 (IXX) = 1"));
}

TEST_CASE("stiffness of joints: axes, stops in degrees, and what is expected of curves", "[io]") {
    const std::string bodies =
        "*DEFORMABLE_TO_RIGID\n1\n2\n*DEFINE_CURVE\n8\n-1,-5\n1,5\n*DEFINE_CURVE\n9\n-1,5\n1,5\n"
        "*DEFINE_CURVE\n10\n-1,-1\n0,-1\n0,1\n1,1\n*DEFINE_COORDINATE_SYSTEM\n1,0,0,0,0,1\n-1\n"
        "*DEFINE_COORDINATE_NODES\n2,1,2,4,1\n3,2,5,3,1\n*SET_NODE\n5\n2,3\n"
        "*NODE\n31,1,0,0\n32,1,1,0\n";
    const std::string apart = [] {
        std::string deck = small_deck();
        return deck.replace(deck.find("13,2,2,5,6,3"), 12, "13,2,31,5,6,32");
    }();
    const DeckFolder folder;
    const auto with = [&](const std::string& joint) {
        std::string deck = apart;
        const std::string cards =
            bodies + "*CONSTRAINED_JOINT_STIFFNESS_GENERALIZED\n" + joint + "\n";
        return deck.insert(deck.find("*END"), cards);
    };
    const Model model = folder.read(with("4,1,2,1,0\n8,0,0,0,0,8\n1,2,3\n-10,20,0,30"));
    REQUIRE(model.joint_stiffnesses.size() == 1);
    const JointStiffness& joint = model.joint_stiffnesses[0];
    CHECK(joint.id == 4);
    CHECK(joint.parts == std::array<Index, 2>{0, 1});
    CHECK((joint.axes[0].col(0) - Vec3::UnitY()).norm() < 1e-12);
    CHECK(joint.axes[1] == joint.axes[0]);
    CHECK(joint.about[0].spring == joint.about[2].damper);
    CHECK(joint.about[0].stiffness == 1.0);
    CHECK(joint.about[0].friction == 2.0);
    CHECK(joint.about[0].low == Approx(-std::numbers::pi / 18.0));
    CHECK(joint.about[0].high == Approx(std::numbers::pi / 9.0));
    CHECK(joint.about[1].low == -INF);
    const auto fault = [&](const std::string& joint_cards) {
        const auto faults = folder.faults(with(joint_cards));
        return faults.size() == 1 ? faults[0] : std::to_string(faults.size()) + " faults";
    };
    CHECK(contains(fault("4,1,1,1\n\n\n"), "(PIDB) = 1, expected a part of another body"));
    CHECK(contains(fault("4,1,2,2,2\n\n\n"), "(CIDB) = 2, expected a system whose nodes are of"));
    CHECK(
        contains(fault("4,1,2,1\n0,10\n\n"), "(LCIDT) = 10, expected a curve without two points"));
    CHECK(contains(fault("4,1,2,1\n0,0,0,9\n\n"), "(DLCIDPH) = 9, expected a curve of moments"));
    CHECK(contains(fault("4,1,2,1\n\n1,-9\n"), "(FMPH) = -9, expected 0 or above: a curve of"));
    CHECK(contains(only_fault("*CONSTRAINED_JOINT_STIFFNESS_TRANSLATIONAL\n1\n"),
                   "is not supported yet"));
}
