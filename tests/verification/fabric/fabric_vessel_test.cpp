// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Vessels of orthotropic cloth under pressure, against closed forms in large strain.

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>

#include "fabric/materials/plane_stress.hpp"
#include "tests/support/geometry/shapes.hpp"
#include "tests/support/scenes/relax.hpp"
#include "tests/unit/fabric/sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using namespace corpuscle::fabric;
using fabric::test::add_part;
using fabric::test::Mesh;
using fabric::test::Sheet;

namespace {

constexpr double R = 0.1, h = 0.33e-3, p = 50e3;

FabricCard woven_tube() {
    FabricCard card;
    card.density = 700;
    card.E_warp = 400e6;
    card.E_weft = 300e6;
    card.nu_ba = 0.15 * 300.0 / 400.0;
    card.G = 4e6;
    return card;
}

/// A ring of a long closed tube, n cells around and two along: warp around, weft along.
Sheet ring(Mesh mesh, int n) {
    FabricCard card = woven_tube();
    card.axes = 3;  // V × normal: around
    card.v = Vec3::UnitZ();
    Sheet sheet;
    add_part(sheet, card, mesh, h);
    const double width = 2 * M_PI * R / n;
    for (int j = 0; j <= 2; ++j)
        for (int i = 0; i < n; ++i)
            sheet.x.push_back(
                {R * std::cos(2 * M_PI * i / n), R * std::sin(2 * M_PI * i / n), width * j});
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = j * n + i, b = j * n + (i + 1) % n, c = b + n, d = a + n;
            const int id = static_cast<int>(sheet.shells.size());
            if (mesh == Mesh::TRIANGLES) {
                sheet.shells.push_back({id + 1, 0, {a, b, c, c}});
                sheet.shells.push_back({id + 2, 0, {a, c, d, d}});
            } else {
                sheet.shells.push_back({id + 1, 0, {a, b, c, d}});
            }
        }
    return sheet;
}

Relaxation under_pressure(Sheet& sheet) {
    Relaxation at;
    at.mass = lumped_mass(sheet.setup());
    at.pressure = p;
    at.tolerance = 1e-7;
    for (const Shell& s : sheet.shells) at.facets.push_back(s.nodes);
    at.free.assign(sheet.x.size(), Vec3::Ones());
    return at;
}

/// Stretch around and along: h S1 = p R l2, h S2 l2 = p R l1²/2.
std::pair<double, double> tube() {
    const FabricCard c = woven_tube();
    const PlaneModuli d = orthotropic_moduli(c.E_warp, c.E_weft, c.nu_ba, c.G);
    const double det = d.warp * d.weft - d.cross * d.cross;
    double l1 = 1, l2 = 1;
    for (int i = 0; i < 200; ++i) {
        const double s1 = p * R * l2 / h, s2 = p * R * l1 * l1 / (2 * l2 * h);
        l1 = std::sqrt(1 + 2 * (d.weft * s1 - d.cross * s2) / det);
        l2 = std::sqrt(1 + 2 * (d.warp * s2 - d.cross * s1) / det);
    }
    return {l1, l2};
}

}  // namespace

TEST_CASE("a closed tube of orthotropic cloth widens and lengthens as its closed form says") {
    const Mesh mesh = GENERATE(Mesh::TRIANGLES, Mesh::ONE_POINT, Mesh::FOUR_POINT);
    const auto [l1, l2] = tube();
    double before = NaN, error = NaN, length = NaN;
    for (const int n : {12, 24, 48}) {
        Sheet sheet = ring(mesh, n);
        Relaxation at = under_pressure(sheet);
        // The lower rim stays in its plane; the lids pull at the upper one
        const double pull = p * M_PI * R * R * l1 * l1 / n;
        at.load.assign(sheet.x.size(), Vec3::Zero());
        for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
            at.free[i].z() = 0;
            at.load[i + 2 * static_cast<std::size_t>(n)].z() = pull;
        }
        Membranes membranes = sheet.membranes();
        Points x = sheet.x;
        REQUIRE(relax(at, membranes, x).residual <= at.tolerance);
        double radius = 0.0, height = 0.0;
        for (int i = 0; i < n; ++i) {
            radius += Vec3(x[n + i].x(), x[n + i].y(), 0).norm() / n;
            height += x[2 * n + i].z() / n;
        }
        before = error;
        error = radius / (R * l1) - 1;
        length = height / (2 * 2 * M_PI * R / n * l2) - 1;
        fmt::print(
            "Tube, {}, {} around: radius {:+.4f} %, length {:+.4f} %, stretch {:.5f} and {:.5f}, "
            "order {:.2f}\n",
            name(mesh), n, 100 * error, 100 * length, l1, l2, std::log2(std::abs(before / error)));
    }
    CHECK(std::abs(error) < 1e-3);
    CHECK(std::abs(length) < 1e-3);
    CHECK(std::log2(std::abs(before / error)) > 1.8);
}

TEST_CASE("a sphere of cloth that is weak in shear swells as a film does") {
    // Equal pull in all directions shears nothing, wherever the yarns lie:
    // h (D11 + D12) (l² - 1)/2 = p R l/2
    FabricCard card = woven_tube();
    card.E_weft = card.E_warp;
    card.nu_ba = 0.2;
    const PlaneModuli d = orthotropic_moduli(card.E_warp, card.E_weft, card.nu_ba, card.G);
    const double q = p * R / (2 * h * (d.warp + d.cross)), l = q + std::sqrt(q * q + 1);
    double before = NaN, error = NaN;
    for (const int level : {2, 3, 4}) {
        const shapes::Shape shape = shapes::sphere(R, level);
        Sheet sheet;
        card.axes = 2;
        card.a = {0.3, 0.2, 1.0};
        add_part(sheet, card, Mesh::TRIANGLES, h);
        sheet.x = shape.x;
        for (const auto& [a, b, c] : shape.triangles)
            sheet.shells.push_back({static_cast<int>(sheet.shells.size()) + 1, 0, {a, b, c, c}});
        Relaxation at = under_pressure(sheet);
        at.tolerance = 1e-6;
        Membranes membranes = sheet.membranes();
        Points x = sheet.x;
        REQUIRE(relax(at, membranes, x).residual <= at.tolerance);
        const double volume = enclosed_volume(at.facets, x);
        const double radius = std::cbrt(0.75 * volume / M_PI);
        before = error;
        error = radius / (R * l) - 1;
        fmt::print("Sphere, {} triangles: radius {:+.4f} %, stretch {:.5f}, order {:.2f}\n",
                   sheet.shells.size(), 100 * error, l, std::log2(std::abs(before / error)));
    }
    CHECK(std::abs(error) < 5e-3);
    CHECK(std::log2(std::abs(before / error)) > 1.7);
}
