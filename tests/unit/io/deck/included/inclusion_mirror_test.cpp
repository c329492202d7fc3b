// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a file that is mirrored is the mirror image of its scene, normals of facets with it.

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include <set>
#include <utility>

#include "solver/loads.hpp"
#include "solver/scene/scene_surface.hpp"
#include "tests/unit/io/deck/included/inclusion_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// y' = 4 - y
const std::string ROWS = "MIRROR,0,2,0,0,3,0\n";
Vec3 image_of(const Vec3& x) {
    return {x[0], 4.0 - x[1], x[2]};
}
Vec3 reflected(const Vec3& v) {
    return {v[0], -v[1], v[2]};
}

Vec3 normal_of(const Model& model, const std::array<Index, 4>& facet) {
    const auto at = [&](std::size_t k) { return model.x[static_cast<std::size_t>(facet[k])]; };
    return (at(1) - at(0)).cross(at(2) - at(0)).normalized();
}

void check_same(const Vec3& x, const Vec3& expected) {
    INFO(x.transpose() << ", expected " << expected.transpose());
    CHECK((x - expected).norm() < 1e-12);
}

/// A pyramid of two quads' worth of nodes off the plane, so that normals are of all directions.
const std::string TENT = "*NODE\n7,0.5,0.5,0.7\n*ELEMENT_SHELL\n21,1,1,2,7,7\n22,1,2,3,7,7\n";

}  // namespace

TEST_CASE("normals of shells and segments are those of the mirror image", "[io]") {
    const auto [plain, moved] = placed_small(TENT +
                                                 "*SET_SEGMENT\n5\n1,2,7,7\n2,5,6,3\n*LOAD_SEGMENT_"
                                                 "SET\n5,7\n*LOAD_SEGMENT\n7,1,0,3,4,7\n",
                                             ROWS);
    for (std::size_t i = 0; i < plain.x.size(); ++i) check_same(moved.x[i], image_of(plain.x[i]));
    for (std::size_t s = 0; s < plain.shells.size(); ++s)
        check_same(normal_of(moved, moved.shells[s].nodes),
                   reflected(normal_of(plain, plain.shells[s].nodes)));
    REQUIRE(moved.pressure_loads.size() == 2);
    for (std::size_t l = 0; l < 2; ++l)
        for (std::size_t f = 0; f < plain.pressure_loads[l].facets.size(); ++f)
            check_same(normal_of(moved, moved.pressure_loads[l].facets[f]),
                       reflected(normal_of(plain, plain.pressure_loads[l].facets[f])));
}

TEST_CASE("quads are cut as the mirror image, and their yarns begin along the same side", "[io]") {
    // a warped quad, and one whose cut is the diagonal of another one
    const auto [plain, moved] = placed_small(
        "*NODE\n7,3,0,0\n8,3,1,0.4\n9,2,0,-1\n*ELEMENT_SHELL\n21,2,5,7,8,6\n22,2,5,9,8,7\n", ROWS);
    const auto pieces = [](const Model& model) {
        std::set<std::set<Index>> all;
        for (const Triangle& t : triangles_of(model, {true, true}).triangles)
            all.insert({t[0], t[1], t[2]});
        return all;
    };
    CHECK(pieces(moved) == pieces(plain));
    CHECK(moved.mirrored_quads == std::vector<Index>{2, 3, 4});
    for (std::size_t s = 0; s < plain.shells.size(); ++s) {
        const auto &was = plain.shells[s].nodes, &is = moved.shells[s].nodes;
        CHECK(std::pair(is[0], is[1]) == std::pair(was[1], was[0]));
    }
    for (const Triangle& t : triangles_of(moved, {true, true}).triangles)
        CHECK((moved.x[t[1]] - moved.x[t[0]]).cross(moved.x[t[2]] - moved.x[t[0]]).norm() > 0.1);
}

TEST_CASE("a stress-free shape of a shell's own keeps its corners", "[io]") {
    const auto [plain, moved] = placed_small(
        "*NODE\n41,0,0,0\n42,1.1,0,0\n43,1,1.2,0\n44,0,1.3,0\n"
        "*AIRBAG_SHELL_REFERENCE_GEOMETRY\n13,2,41,42,43,44\n",
        ROWS);
    const auto corner_of = [](const Model& model, Index node) {
        const auto& nodes = model.shells[2].nodes;
        const auto k = std::find(nodes.begin(), nodes.end(), node) - nodes.begin();
        return model.shell_references[0].corners[static_cast<std::size_t>(k)];
    };
    for (const Index node : plain.shells[2].nodes)
        check_same(corner_of(moved, node), image_of(corner_of(plain, node)));
}

TEST_CASE("yarns at an angle to a direction are mirrored with it", "[io]") {
    const auto [plain, moved] = placed_small(
        "*MAT_FABRIC\n9,800,4e8,0,0,0.3\n\n2,0,0,0,0,0,7\n0,0,0,1,2,2\n0,0,0,0,0,0,30\n", ROWS);
    const auto card = [](const Model& model) {
        return std::get<fabric::FabricCard>(model.materials.at(1).card);
    };
    check_same(card(moved).a, reflected(card(plain).a));
    CHECK(card(moved).beta == -card(plain).beta);
}

TEST_CASE("what turns, turns the other way in the mirror", "[io]") {
    const std::string body =
        "*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n*NODE\n21,5,0,0\n22,6,0,0\n23,5,1,0\n*PART_INERTIA\nhead\n"
        "50,1,5\n1,2,3,4.0\n2,0.1,0.2,3,0.3,4\n1,2,3,4,5,6\n*ELEMENT_SHELL\n91,50,21,22,23,23\n"
        "*INITIAL_VELOCITY_GENERATION\n2,2,5.0\n0,0,1,1,2,2\n"
        "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n50,5,0,7\n50,6,0,7\n50,7,0,7\n50,1,0,7\n50,2,0,7\n";
    const auto [plain, moved] = placed_small(body, ROWS);
    for (std::size_t i = 0; i < plain.velocity.size(); ++i)
        check_same(moved.velocity[i], reflected(plain.velocity[i]));
    check_same(moved.rigid_velocity[0].velocity, reflected(Vec3(1, 2, 3)));
    check_same(moved.rigid_velocity[0].spin, Vec3(-4, 5, -6));
    const Mat3 M = Vec3(1, -1, 1).asDiagonal();
    CHECK((moved.rigid_inertia[0].inertia - M * plain.rigid_inertia[0].inertia * M).norm() < 1e-12);
    check_same(moved.motions[0].axis, {-1, 0, 0});
    check_same(moved.motions[1].axis, {0, 1, 0});
    check_same(moved.motions[2].axis, {0, 0, -1});
    check_same(moved.motions[3].axis, {1, 0, 0});
    check_same(moved.motions[4].axis, {0, -1, 0});
}

TEST_CASE("loads on a rigid body push and turn the mirror image", "[io]") {
    const std::string body =
        "*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n*NODE\n21,5,0,0\n22,6,0.1,0.2\n23,5,1,0.3\n*PART\nhead\n"
        "50,1,5\n*ELEMENT_SHELL\n91,50,21,22,23,23\n*DEFINE_COORDINATE_NODES\n3,21,22,23\n"
        "4,21,22,23,1\n*LOAD_RIGID_BODY\n";
    for (const int dof : {1, 2, 3, 4, 5, 6, 7, 8})
        for (const int system : {0, 3, 4}) {
            CAPTURE(dof, system);
            const std::string load = fmt::format("50,{},7,1.0,{},21,22,23\n", dof, system);
            const auto [plain, moved] = placed_small(body + load, ROWS);
            const auto push = [](const Model& model) {
                return Loads(model).push(1.0, model.x, {2});
            };
            const auto was = push(plain), is = push(moved);
            CHECK((was.force + was.moment).norm() == Approx(3.0));
            check_same(is.force, reflected(was.force));
            check_same(is.moment, -reflected(was.moment));
        }
}

TEST_CASE("solids of every shape keep their volume above zero", "[io]") {
    const std::string solids =
        "*SECTION_SOLID\n2,1\n*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n*PART\nblock\n50,2,5\n"
        "*NODE\n31,5,0,0\n32,6,0,0\n33,6,1,0\n34,5,1,0\n35,5,0,1\n36,6,0,1\n37,6,1,1\n38,5,1,1\n"
        "39,9,0,0\n40,5,9,0\n41,5,5,9\n*ELEMENT_SOLID\n";
    for (const char* solid : {"91,50,31,32,33,34,35,36,37,38\n",     // brick
                              "91,50,31,32,33,35,35,35,35,35\n",     // tetrahedron
                              "91,50,31,32,33,34,35,35,35,35\n",     // pyramid
                              "91,50,31,32,33,34,35,35,38,38\n"}) {  // wedge
        CAPTURE(solid);
        const auto [plain, moved] = placed_small(solids + solid, ROWS);
        CHECK(moved.rigid_inertia[0].mass == Approx(plain.rigid_inertia[0].mass));
        check_same(moved.rigid_inertia[0].centre, image_of(plain.rigid_inertia[0].centre));
        CHECK(moved.shells.size() == plain.shells.size());
    }
}

TEST_CASE("a plate covers the mirror image of what it covered", "[io]") {
    const auto [plain, moved] =
        placed_small("*RIGIDWALL_GEOMETRIC_FLAT\n\n0,0,-1,0,0,1\n2,1,-1,2,1\n", ROWS);
    const auto& was = std::get<contact::Plate>(plain.walls[0].shape);
    const auto& is = std::get<contact::Plate>(moved.walls[0].shape);
    const auto corners = [](const contact::Plate& plate) {
        std::vector<Vec3> at;
        for (const double u : {plate.low[0], plate.high[0]})
            for (const double v : {plate.low[1], plate.high[1]})
                at.push_back(plate.corner + u * plate.axes.col(0) + v * plate.axes.col(1));
        return at;
    };
    for (const Vec3& corner : corners(was)) {
        const auto all = corners(is);
        CHECK(std::any_of(all.begin(), all.end(),
                          [&](const Vec3& x) { return (x - image_of(corner)).norm() < 1e-12; }));
    }
    check_same(is.axes.col(2), reflected(was.axes.col(2)));
}

TEST_CASE("two mirrors are none: facets are as they were", "[io]") {
    const auto [plain, moved] = placed_small(TENT, ROWS + "MIRROR,1,0,0,2,0,0\n");
    for (std::size_t s = 0; s < plain.shells.size(); ++s)
        CHECK(moved.shells[s].nodes == plain.shells[s].nodes);
}
