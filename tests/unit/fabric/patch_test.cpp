// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <Eigen/Dense>

#include "sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

constexpr double LENGTH = 0.4, PATCH_WIDTH = 0.3, THICKNESS = 0.3e-3;

Sheet patch(const MaterialCard& card, Mesh mesh) {
    Sheet sheet = rectangle(card, mesh, 4, 3, LENGTH, PATCH_WIDTH);
    // Inner nodes only: the edge stays straight
    const Points moves = noise(sheet.x.size(), 0.02, 11);
    for (std::size_t n = 0; n < sheet.x.size(); ++n) {
        Vec3& p = sheet.x[n];
        const bool inside =
            p.x() > 1e-9 && p.x() < LENGTH - 1e-9 && p.y() > 1e-9 && p.y() < PATCH_WIDTH - 1e-9;
        if (inside) p += Vec3(moves[n].x(), moves[n].y(), 0.0);
    }
    return sheet;
}

/// Fabric whose warp follows x everywhere, whatever the elements' sides do.
FabricCard warp_along_x() {
    FabricCard c = fabric_card();
    c.axes = 2;
    return c;
}

struct Pulls {
    Vec3 right = Vec3::Zero(), top = Vec3::Zero();  ///< what must hold the edge x = L, y = W
    double inner = 0.0;                             ///< greatest force on inner nodes
};

/// Forces on the edges of the patch under the gradient F (columns: images of x and y).
Pulls pulls(Sheet& sheet, const Eigen::Matrix<double, 3, 2>& F) {
    Membranes membranes = sheet.membranes();
    const Points x = moved(sheet.x, [&](const Vec3& p) { return Vec3(F * p.head<2>()); });
    const Points f = force(membranes, x);
    Pulls out;
    for (std::size_t n = 0; n < x.size(); ++n) {
        const Vec3& p = sheet.x[n];
        const bool right = p.x() > LENGTH - 1e-9, top = p.y() > PATCH_WIDTH - 1e-9;
        if (right) out.right -= f[n];
        if (top) out.top -= f[n];
        const bool edge = right || top || p.x() < 1e-9 || p.y() < 1e-9;
        if (!edge) out.inner = std::max(out.inner, f[n].norm());
    }
    return out;
}

/// Strain that a uniaxial stress S at `angle` to the warp makes: compliance turned.
Eigen::Vector3d strain_under(const FabricCard& c, const Eigen::Vector3d& S) {
    const double nu_ab = c.nu_ba * c.E_warp / c.E_weft;
    Eigen::Matrix3d compliance;
    compliance << 1 / c.E_warp, -c.nu_ba / c.E_weft, 0,  //
        -nu_ab / c.E_warp, 1 / c.E_weft, 0,              //
        0, 0, 1 / c.G;
    return compliance * S;
}

/// A gradient with Green strain E (E11, E22, 2·E12), turned out of the plane.
Eigen::Matrix<double, 3, 2> gradient_of(const Eigen::Vector3d& E) {
    Eigen::Matrix2d C;
    C << 1 + 2 * E[0], E[2], E[2], 1 + 2 * E[1];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> split(C);
    const Eigen::Matrix2d U = split.operatorSqrt();
    const Mat3 turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    Eigen::Matrix<double, 3, 2> out = Eigen::Matrix<double, 3, 2>::Zero();
    out.topRows<2>() = U;
    return turn * out;
}

}  // namespace

TEST_CASE("a uniform pull at any angle to the warp is met exactly", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const double angle = GENERATE(0.0, 15.0, 30.0, 45.0, 90.0) * 3.141592653589793 / 180.0;
    const bool no_compression = GENERATE(false, true);
    // Along the sheet's x a stress of S; the warp lies at -angle to x
    FabricCard c = warp_along_x();
    c.no_compression = no_compression;
    c.a = {std::cos(angle), -std::sin(angle), 0};
    Sheet sheet = patch(c, mesh);

    const double S = 1.2e6, co = std::cos(angle), si = std::sin(angle);
    const Eigen::Vector3d E = strain_under(c, {S * co * co, S * si * si, S * co * si});
    // Strain turned from warp and weft to x and y
    const double Exx = co * co * E[0] + si * si * E[1] + co * si * E[2];
    const double Eyy = si * si * E[0] + co * co * E[1] - co * si * E[2];
    const double Gxy = 2 * co * si * (E[1] - E[0]) + (co * co - si * si) * E[2];
    const Pulls p = pulls(sheet, gradient_of({Exx, Eyy, Gxy}));

    const double expected = S * THICKNESS * PATCH_WIDTH * std::sqrt(1 + 2 * Exx);
    CHECK(p.right.norm() == Approx(expected).epsilon(1e-9));
    CHECK(p.top.norm() < 1e-9 * expected);
    CHECK(p.inner < 1e-9 * expected);

    // 1/Ex = c⁴/E1 + (1/G - 2 nu12/E1) s²c² + s⁴/E2
    const double nu_ab = c.nu_ba * c.E_warp / c.E_weft;
    const double one_over = std::pow(co, 4) / c.E_warp +
                            (1 / c.G - 2 * nu_ab / c.E_warp) * si * si * co * co +
                            std::pow(si, 4) / c.E_weft;
    CHECK(Exx == Approx(S * one_over).epsilon(1e-12));
}

TEST_CASE("a picture frame shears at the force of its closed form", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const double gamma = GENERATE(0.05, 0.3, 0.8);
    const FabricCard c = warp_along_x();
    Sheet sheet = patch(c, mesh);
    // Yarns keep their length and turn towards each other: g1·g2 = sin γ, S12 = G·sin γ
    Eigen::Matrix<double, 3, 2> F;
    F << 1, std::sin(gamma), 0, std::cos(gamma), 0, 0;
    const Pulls p = pulls(sheet, F);
    // P1 = S12·g2 on the edge x = L, P2 = S12·g1 on y = W
    const double S = c.G * std::sin(gamma);
    CHECK((p.right - S * THICKNESS * PATCH_WIDTH * F.col(1)).norm() < 1e-9 * p.right.norm());
    CHECK((p.top - S * THICKNESS * LENGTH * F.col(0)).norm() < 1e-9 * p.top.norm());
    CHECK(p.inner < 1e-9 * p.right.norm());
}

TEST_CASE("a wrinkled sheet bears a pull along its wrinkles only", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const double gathered = GENERATE(0.05, 0.2, 0.6);
    FabricCard c = warp_along_x();
    c.no_compression = true;
    const bool isotropic = GENERATE(false, true);
    if (isotropic) {
        c.E_weft = c.E_warp;
        c.G = 0.5 * c.E_warp / (1 + c.nu_ba);
    }
    Sheet sheet = patch(c, mesh);
    const double stretch = 1.01;
    Eigen::Matrix<double, 3, 2> F;
    F << stretch, 0, 0, 1 - gathered, 0, 0;
    const Pulls p = pulls(sheet, F);
    const double S = c.E_warp * 0.5 * (stretch * stretch - 1);
    CHECK(p.right.x() == Approx(S * stretch * THICKNESS * PATCH_WIDTH).epsilon(1e-9));
    CHECK(p.top.norm() < 1e-9 * p.right.norm());
    // and none at all when gathered both ways
    F << 0.9, 0, 0, 0.8, 0, 0;
    CHECK(pulls(sheet, F).right.norm() < 1e-12 * p.right.norm());
}

TEST_CASE("strain and stress for pictures are those of the patch", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const FabricCard c = warp_along_x();
    Sheet sheet = patch(c, mesh);
    Membranes membranes = sheet.membranes();
    const Points x =
        moved(sheet.x, [](const Vec3& p) { return Vec3(1.02 * p.x(), 1.01 * p.y(), 0); });
    std::vector<std::array<float, 3>> stress(sheet.shells.size()), strain(sheet.shells.size());
    membranes.stress_strain(x, stress, strain);
    const double E1 = 0.5 * (1.02 * 1.02 - 1), E2 = 0.5 * (1.01 * 1.01 - 1);
    const double D = 1 / (1 - c.nu_ba * c.nu_ba * c.E_warp / c.E_weft);
    for (std::size_t e = 0; e < strain.size(); ++e) {
        CHECK(strain[e][0] == Approx(E1).epsilon(1e-6));
        CHECK(strain[e][1] == Approx(E2).epsilon(1e-6));
        CHECK(std::abs(strain[e][2]) < 1e-9);
        CHECK(stress[e][0] ==
              Approx(D * c.E_warp * (E1 + c.nu_ba * E2) * 1.02 * 1.02).epsilon(1e-6));
    }
}
