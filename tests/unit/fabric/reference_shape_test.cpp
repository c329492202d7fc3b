// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "fabric/reference_shape.hpp"
#include "sheet.hpp"
#include "solver/base/error.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

const Shell QUAD{5, 0, {0, 1, 2, 3}};
const Shell TRIANGLE{6, 0, {0, 1, 2, 2}};

ReferenceShape flat(const Shell& shell, const std::array<Vec3, 4>& x, const MaterialCard& card) {
    std::string fault;
    const ReferenceShape shape = lay_flat(shell, x, card, fault);
    INFO(fault);
    CHECK(fault.empty());
    return shape;
}

std::string fault_of(const Shell& shell, const std::array<Vec3, 4>& x, const MaterialCard& card) {
    std::string fault;
    lay_flat(shell, x, card, fault);
    return fault;
}

/// Direction in space of the warp: what u must be for its image to be along the first axis.
Vec3 warp_of(const ReferenceShape& s, const std::array<Vec3, 4>& x) {
    const Vec3 u = x[1] - x[0], v = x[2] - x[0];
    Eigen::Matrix2d flat;
    flat << s.x[1] - s.x[0], s.x[2] - s.x[0];
    const Eigen::Vector2d c = flat.inverse() * Eigen::Vector2d::UnitX();
    return c.x() * u + c.y() * v;
}

}  // namespace

TEST_CASE("the warp lies along side 1-2, along A, or along V × normal, turned by BETA",
          "[fabric][axes]") {
    const std::array<Vec3, 4> x{Vec3(0, 0, 1), Vec3(2, 1, 1), Vec3(1, 3, 1), Vec3(-1, 2, 1)};
    const Shell shell = GENERATE(QUAD, TRIANGLE);
    const double beta = GENERATE(0.0, 0.4, -1.2);
    const auto turned = [&](const Vec3& d) {
        return Vec3(Eigen::AngleAxisd(beta, Vec3::UnitZ()) * d.normalized());
    };
    FabricCard card = fabric_card();
    card.beta = beta;
    CHECK((warp_of(flat(shell, x, card), x) - turned(x[1] - x[0])).norm() < 1e-12);
    card.axes = 2;
    card.a = {1, 2, 5};
    CHECK((warp_of(flat(shell, x, card), x) - turned({1, 2, 0})).norm() < 1e-12);
    card.axes = 3;
    card.v = {0, 3, 1};
    CHECK((warp_of(flat(shell, x, card), x) - turned({3, 0, 0})).norm() < 1e-12);
}

TEST_CASE("a shape is laid flat with its area and lengths", "[fabric][axes]") {
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(3, 1, 2).normalized()).toRotationMatrix();
    std::array<Vec3, 4> x{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2.5, 1, 0), Vec3(0, 1.5, 0)};
    for (Vec3& p : x) p = turn * p + Vec3(1, 2, 3);
    const ReferenceShape s = flat(QUAD, x, fabric_card());
    CHECK(s.area == Approx(0.5 * (2.0 * 1.0 + 2.5 * 1.5)));
    CHECK(s.warp == Approx(0.0).margin(1e-14));
    for (std::size_t i = 0; i < 4; ++i)
        CHECK((s.x[i] - s.x[(i + 1) % 4]).norm() == Approx((x[i] - x[(i + 1) % 4]).norm()));
}

TEST_CASE("a quad that names a node twice is a triangle", "[fabric][axes]") {
    const std::array<Vec3, 4> x{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    CHECK(distinct_corners({1, 0, {4, 5, 6, 6}}).corners == 3);
    CHECK(distinct_corners({1, 0, {4, 4, 5, 6}}).corners == 3);
    CHECK(distinct_corners({1, 0, {4, 5, 5, 6}}).corners == 3);
    CHECK(distinct_corners({1, 0, {4, 5, 6, 4}}).corners == 3);
    CHECK(distinct_corners({1, 0, {4, 5, 6, 7}}).corners == 4);
    CHECK(fault_of({9, 0, {4, 5, 4, 5}}, x, fabric_card()).find("shell 9") == 0);
    CHECK(fault_of({9, 0, {4, 4, 4, 5}}, x, fabric_card()).find("shell 9") == 0);
    CHECK(fault_of({9, 0, {4, 5, 4, 6}}, x, fabric_card()).find("shell 9") == 0);
}

TEST_CASE("an impossible reference shape is refused with the shell's id", "[fabric][axes]") {
    const FabricCard card = fabric_card();
    const Vec3 o = Vec3::Zero(), a = Vec3::UnitX(), b = Vec3::UnitY();
    CHECK(fault_of(TRIANGLE, {o, a, Vec3(2 * a), Vec3(2 * a)}, card) ==
          "shell 6 has a reference area of 0");
    CHECK(fault_of(QUAD, {o, a, o, b}, card) == "shell 5 has a reference area of 0");
    // An arrow head, and a bow tie
    CHECK(fault_of(QUAD, {o, Vec3(2, 1, 0), Vec3(4, 0, 0), Vec3(2, 4, 0)}, card) ==
          "shell 5 is not convex in its reference shape");
    CHECK(fault_of(QUAD, {o, a, Vec3(-1, 1, 0), Vec3(2, 3, 0)}, card) ==
          "shell 5 is not convex in its reference shape");
    FabricCard upright = card;
    upright.axes = 2;
    upright.a = Vec3::UnitZ();
    CHECK(fault_of(QUAD, {o, a, Vec3(a + b), b}, upright) ==
          "shell 5: its material axis is normal to it");
    // A straight corner, and two corners in one place, are legal
    CHECK(fault_of(QUAD, {o, Vec3(0.5 * (a + b)), Vec3(a + b), b}, card).empty());
    CHECK(fault_of(QUAD, {o, o, a, b}, card).empty());
}

TEST_CASE("all faults of a mesh are told at once", "[fabric][axes]") {
    Sheet sheet = rectangle(fabric_card(), Mesh::ONE_POINT, 2, 2, 1, 1);
    sheet.x[4] = {1.2, 1.2, 0};  // three of the four quads at the middle node fold over
    MembraneSetup setup = sheet.setup();
    try {
        Membranes membranes(setup);
        FAIL("was accepted");
    } catch (const InputError& e) {
        CHECK(e.faults.size() >= 1);
        for (const std::string& fault : e.faults) CHECK(fault.find("shell 10") == 0);
    }
    // Inactive shells may have any shape
    sheet.active.assign(sheet.shells.size(), 0);
    CHECK(Membranes(setup).element_count() == 0);
}

TEST_CASE("mass comes from the reference area and goes to the distinct corners", "[fabric][mass]") {
    Sheet sheet = rectangle(fabric_card(), Mesh::MIXED, 3, 3, 0.6, 0.5);
    const double total = 700.0 * 0.3e-3 * 0.6 * 0.5;
    const MembraneSetup setup = sheet.setup();
    double shells = 0.0, nodes = 0.0;
    for (const double m : shell_mass(setup)) shells += m;
    for (const double m : lumped_mass(setup)) nodes += m;
    CHECK(shells == Approx(total).epsilon(1e-12));
    CHECK(nodes == Approx(total).epsilon(1e-12));
    // Null and rigid shells weigh, too
    sheet.materials[0].card = NullCard{700.0};
    sheet.active.assign(sheet.shells.size(), 0);
    nodes = 0.0;
    for (const double m : lumped_mass(setup)) nodes += m;
    CHECK(nodes == Approx(total).epsilon(1e-12));
}
