// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "tests/support/scenes/relax.hpp"
#include "tests/unit/fabric/sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using namespace corpuscle::fabric;
using fabric::test::Mesh;
using fabric::test::PURE_MESHES;
using fabric::test::rectangle;
using fabric::test::Sheet;

namespace {

/// Force that a strip of 0.2 × 0.1 m cut at 45° takes per strain, ends clamped, n cells wide.   [N]
double bias_stiffness(Mesh mesh, int n) {
    FabricCard card;
    card.density = 700;
    card.E_warp = card.E_weft = 300e6;
    card.G = 1e6;
    card.axes = 2;
    card.a = {1, 1, 0};
    Sheet sheet = rectangle(card, mesh, 2 * n, n, 0.2, 0.1);
    const MembraneSetup setup = sheet.setup();
    Membranes membranes(setup);
    Relaxation at;
    at.mass = lumped_mass(setup);
    at.tolerance = 1e-8;
    const double strain = 1e-4;
    Points x = sheet.x;
    for (Vec3& p : x) {
        const bool held = p.x() < 1e-9 || p.x() > 0.2 - 1e-9;
        at.free.push_back(held ? Vec3(0, 0, 0) : Vec3(1, 1, 0));
        p.x() *= 1 + strain;
    }
    const Relaxed r = relax(at, membranes, x);
    REQUIRE(r.residual <= at.tolerance);
    double pull = 0.0;
    const Points f = fabric::test::force(membranes, x);
    for (std::size_t k = 0; k < x.size(); ++k)
        if (sheet.x[k].x() > 0.2 - 1e-9) pull -= f[k].x();
    return pull / strain;
}

/// Time of `crossings` / 2 periods of a mode that starts from rest at its greatest, by what
/// `amount` (positive at the start) says.
template <class Amount>
double frequency(Membranes& membranes, const std::vector<double>& mass, const Points& free,
                 Points x, int crossings, const Amount& amount) {
    Points v(x.size(), Vec3::Zero()), f(x.size());
    const double dt = 0.5 * membranes.stable_step().dt;
    double before = amount(x), first = NaN, last = NaN;
    int found = 0;
    for (int i = 0; found < crossings + 1; ++i) {
        std::fill(f.begin(), f.end(), Vec3::Zero());
        REQUIRE(membranes.add_force(x, v, f) == -1);
        const double kick = i == 0 ? 0.5 * dt : dt;  // v lives half a step later
        for (std::size_t n = 0; n < x.size(); ++n) {
            v[n] += kick / mass[n] * f[n].cwiseProduct(free[n]);
            x[n] += dt * v[n];
        }
        const double now = amount(x);
        if ((now < 0) != (before < 0)) {
            last = dt * (i + before / (before - now));
            if (found++ == 0) first = last;
        }
        before = now;
    }
    return 0.5 * crossings / (last - first);
}

}  // namespace

TEST_CASE("a strip cut at 45 degrees is not much too stiff") {
    // Clamped corners lock elements whose sides cross the yarns: the cost of coarse meshes
    const double converged =
        2 * bias_stiffness(Mesh::ONE_POINT, 40) - bias_stiffness(Mesh::ONE_POINT, 20);
    fmt::print("Bias strip, E/G = 300: {:.1f} N per strain\n", converged);
    for (const Mesh mesh : PURE_MESHES) {
        fmt::print("  {:<14}", name(mesh));
        for (const int n : {5, 10, 20}) {
            const double ratio = bias_stiffness(mesh, n) / converged;
            fmt::print("  {} wide: {:.3f}", n, ratio);
            if (n == 10 && mesh == Mesh::ONE_POINT) CHECK(ratio == Approx(1.0).margin(0.06));
            if (n == 10 && mesh == Mesh::TRIANGLES) CHECK(ratio == Approx(1.0).margin(0.16));
        }
        fmt::print("\n");
    }
}

TEST_CASE("a strip rings along warp and weft at the speed of sound") {
    // One end held, f = c/(4 L), c = sqrt(E/rho): 40 elements long
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    const bool weft = GENERATE(false, true);
    FabricCard card;
    card.density = 700;
    card.E_warp = 300e6;
    card.E_weft = 200e6;
    card.G = 3e6;
    card.axes = 2;
    if (weft) card.a = Vec3::UnitY();
    const double length = 0.4;
    Sheet sheet = rectangle(card, mesh, 40, 1, length, 0.01);
    const MembraneSetup setup = sheet.setup();
    Membranes membranes(setup);
    Points x = sheet.x, free;
    for (Vec3& p : x) {
        free.push_back(p.x() < 1e-9 ? Vec3(0, 0, 0) : Vec3(1, 0, 0));
        p.x() += 1e-6 * std::sin(0.5 * M_PI * p.x() / length);
    }
    const double f = frequency(membranes, lumped_mass(setup), free, x, 20,
                               [&](const Points& at) { return at[40].x() - sheet.x[40].x(); });
    const double c = 4 * length * f, exact = std::sqrt((weft ? 200e6 : 300e6) / 700);
    fmt::print("Wave speed, {}, along {}: {:.3f} m/s, exact {:.3f} ({:+.3f} %)\n", name(mesh),
               weft ? "weft" : "warp", c, exact, 100 * (c / exact - 1));
    CHECK(c == Approx(exact).epsilon(0.005));
}

TEST_CASE("a taut sheet sings at the frequency of its tension") {
    // f = sqrt(1/a² + 1/b²)/2 · sqrt(N/(rho h)); taut because its reference is smaller
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    const double E = 300e6, stretch = 1.01, a = 0.3, b = 0.2, rho = 900;
    Sheet sheet = rectangle(ElasticCard{rho, E, 0.3}, mesh, 24, 16, a, b);
    MembraneSetup setup = sheet.setup();
    for (auto& corners : sheet.reference)
        for (Vec3& p : corners) p /= stretch;
    setup.reference = sheet.reference;
    Membranes membranes(setup);
    Points x = sheet.x, free;
    for (Vec3& p : x) {
        const bool rim = p.x() < 1e-9 || p.x() > a - 1e-9 || p.y() < 1e-9 || p.y() > b - 1e-9;
        free.push_back(rim ? Vec3(0, 0, 0) : Vec3(1, 1, 1));
        p.z() = 1e-6 * std::sin(M_PI * p.x() / a) * std::sin(M_PI * p.y() / b);
    }
    const std::size_t middle = 8 * 25 + 12;
    const double f = frequency(membranes, lumped_mass(setup), free, x, 6,
                               [&](const Points& at) { return at[middle].z(); });
    // Tension and mass per area of the stretched sheet: N = S h, rho h / stretch²
    const double S = E / (1 - 0.3) * 0.5 * (stretch * stretch - 1);
    const double exact = 0.5 * std::sqrt(1 / (a * a) + 1 / (b * b)) * stretch * std::sqrt(S / rho);
    fmt::print("Taut sheet, {}: {:.3f} Hz, exact {:.3f} ({:+.3f} %)\n", name(mesh), f, exact,
               100 * (f / exact - 1));
    CHECK(f == Approx(exact).epsilon(0.005));
}
