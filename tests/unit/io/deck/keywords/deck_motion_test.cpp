// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Curves and axes of prescribed motions, and damping of the whole scene.

#include <catch2/catch.hpp>

#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// Local x along y, local y against x.
const std::string TURNED_AXES = "*DEFINE_COORDINATE_SYSTEM\n9,0,0,0,0,1,0\n-1,0,0\n";

const Curve& curve_of_motion(const Model& model, std::size_t motion) {
    return model.curves[static_cast<std::size_t>(model.motions.at(motion).curve)];
}

}  // namespace

TEST_CASE("BIRTH shifts a motion's curve, one copy for motions that share it", "[io]") {
    const Model model = read_small(
        "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,7,1,0,0,0.25\n2,1,2,7,1,0,0,0.25\n3,1,0,7\n"
        "4,1,0,7,1,0,0,1e20\n");
    CHECK(curve_of_motion(model, 0).x == std::vector<double>{0.25, 1.25});
    CHECK(curve_of_motion(model, 0).y == std::vector<double>{1.0, 3.0});
    CHECK(curve_of_motion(model, 0).id == 7);
    CHECK(model.motions[1].curve == model.motions[0].curve);
    CHECK(curve_of_motion(model, 2).x == std::vector<double>{0.0, 1.0});
    CHECK(model.motions[3].curve == model.motions[2].curve);  // it never acts
    const Model function = read_small(
        "*DEFINE_CURVE_FUNCTION\n8\nTIME\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,8,1,0,0,0.25\n");
    CHECK(function.motions.at(0).birth == 0.0);
    CHECK(curve_of_motion(function, 0).x.front() == 0.0);
    CHECK(any_contains(function.warnings, "(BIRTH) = 0.25: does not count"));
}

TEST_CASE("VID below 0 names the axes of a motion", "[io]") {
    const auto axis = [](const std::string& row) {
        return read_small(RIGID_TRIANGLE + TURNED_AXES + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n" +
                          row + "\n")
            .motions.at(0)
            .axis;
    };
    CHECK((axis("3,1,0,7,1,-9") - Vec3::UnitY()).norm() < 1e-15);
    CHECK((axis("3,2,0,7,1,-9") + Vec3::UnitX()).norm() < 1e-15);
    CHECK((axis("3,5,0,7,1,-9") - Vec3::UnitY()).norm() < 1e-15);
    CHECK((axis("3,7,0,7,1,-9") - Vec3::UnitZ()).norm() < 1e-15);
    CHECK(axis("3,1,0,7,1,5") == Vec3::UnitX());  // a vector counts for DOF 4 and 8
    const auto fault = [](const std::string& system) {
        return only_fault(system + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,7,1,-9\n");
    };
    CHECK(contains(fault(""), "(VID) = -9, expected 0, or minus the id of a *DEFINE_COORDINATE_"));
    CHECK(contains(fault("*DEFINE_COORDINATE_NODES\n9,1,2,4,1\n"),
                   "(VID) = -9, expected a coordinate system that stays"));
    CHECK(read_small("*DEFINE_COORDINATE_NODES\n9,1,4,2\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n"
                     "1,1,0,7,1,-9\n")
              .motions.at(0)
              .axis.isApprox(Vec3::UnitY(), 1e-15));
}

TEST_CASE("blank rows of a curve are the point (0, 0), but not behind the last", "[io]") {
    const auto points = [](const std::string& rows) {
        return read_small("*DEFINE_CURVE\n8\n" + rows).curves.back();
    };
    CHECK(points("\n5,10\n10,10\n\n\n").x == std::vector<double>{0.0, 5.0, 10.0});
    CHECK(points("\n5,10\n10,10\n").y == std::vector<double>{0.0, 10.0, 10.0});
    CHECK(points("-5,10\n\n10,10\n").x == std::vector<double>{-5.0, 0.0, 10.0});
    CHECK(contains(only_fault("*DEFINE_CURVE\n8\n0,1\n5,10\n\n10,10\n"),
                   "(A) = blank, expected abscissae that do not decrease"));
}

TEST_CASE("factors of damping are 1 where all six are blank", "[io]") {
    const auto damping = [](const std::string& factors, const std::string& more = "") {
        return read_small(more + "*DAMPING_GLOBAL\n0,0.5," + factors + "\n");
    };
    CHECK(damping("").mass_damping == 0.5);
    CHECK(damping("1,1,1").warnings.empty());
    CHECK(damping("1,1,1,1,1,1", RIGID_TRIANGLE).warnings.empty());
    CHECK(any_contains(damping("1,1,1", RIGID_TRIANGLE).warnings, "(SRX) = blank: taken as 1"));
    CHECK(contains(only_fault("*DAMPING_GLOBAL\n0,0.5,0,0,0,1,1,1\n"), "(STX) = 0, expected"));
    CHECK(contains(only_fault("*DAMPING_GLOBAL\n0,0.5,1\n"), "(STX) = 1, expected"));
}

TEST_CASE("supports from the start to the end, and local axes where all is held", "[io]") {
    const auto supports = [](const std::string& cards) {
        return read_small(TURNED_AXES + cards).supports;
    };
    CHECK(supports("*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1,1,1\n0,1e20\n2,0,1\n0,0\n").size() == 2);
    CHECK(supports("*BOUNDARY_SPC_NODE\n1,9,1,1,1\n").at(0).fixed == 7U);
    CHECK(supports("*BOUNDARY_SPC_NODE\n1,9,1,1,1,1,1,1\n").at(0).fixed == 63U);
    const auto fault = [](const std::string& cards) { return only_fault(TURNED_AXES + cards); };
    CHECK(contains(fault("*BOUNDARY_SPC_NODE\n1,9,1,1,0\n"), "(CID) = 9, expected 0 or blank, or"));
    CHECK(contains(fault("*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1\n0.1,1e20\n"),
                   "(BIRTH) = 0.1, expected 0"));
    CHECK(contains(fault("*BOUNDARY_SPC_NODE_BIRTH_DEATH\n1,0,1\n0,0.5\n"),
                   "(DEATH) = 0.5, expected a time that is not before the end"));
}
