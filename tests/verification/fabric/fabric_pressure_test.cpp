// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "fabric_membrane.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using fabric::ElasticCard;
using fabric::FabricCard;

namespace {

const Kind PRESSED[] = {Kind::TRIANGLES, Kind::ONE_POINT, Kind::FOUR_POINT};

FabricCard film(double E, double nu) {
    FabricCard c;
    c.density = 1000.0;
    c.E_warp = c.E_weft = E;
    c.nu_ba = nu;
    c.G = 0.5 * E / (1 + nu);
    c.no_compression = true;
    return c;
}

}  // namespace

TEST_CASE("Hencky's clamped membrane rises as the finite-deflection solution says") {
    // Green strain, follower pressure, Q = p a/(E h) = 0.01, nu = 0.3: w0/a = 0.141385 by shooting
    const Kind kind = GENERATE(from_range(std::begin(PRESSED), std::end(PRESSED)));
    const double a = 0.1, h = 1e-3, E = 1e8, Q = 0.01, exact = 0.141385;
    double error = 0.0;
    for (const int n : {5, 10, 20}) {
        Quarter quarter(quarter_disc(n, a, kind == Kind::TRIANGLES), ElasticCard{1000, E, 0.3}, h,
                        kind, Q * E * h / a);
        quarter.hold([&](const Vec3& p) { return p.norm() > a * (1 - 1e-6); }, Vec3::Zero());
        Points x = quarter.mesh.x;
        const Relaxed r = relax(quarter.at, quarter.membranes, x);
        const double before = error;
        error = x[0].z() / a / exact - 1;
        fmt::print(
            "Hencky, {}, {} elements in all: w0/a = {:.6f}, error {:+.3f} %, order {:.2f}; {} "
            "steps, residual {:.1e}\n",
            name(kind), 4 * quarter.mesh.shells.size(), x[0].z() / a, 100 * error,
            before != 0 ? std::log2(std::abs(before / error)) : NaN, r.steps, r.residual);
    }
    CHECK(std::abs(error) < 0.002);
}

TEST_CASE("a bag of two stiff discs that wrinkle holds 1.2185 a³") {
    const Kind kind = GENERATE(from_range(std::begin(PRESSED), std::end(PRESSED)));
    const double a = 0.3, h = 0.3e-3, E = 3e8, Q = 1e-3;
    for (const int n : {5, 10, 20}) {
        Quarter quarter(quarter_disc(n, a, kind == Kind::TRIANGLES), film(E, 0.3), h, kind,
                        Q * E * h / a);
        quarter.hold([&](const Vec3& p) { return p.norm() > a * (1 - 1e-6); }, Vec3(1, 1, 0));
        quarter.at.tolerance = 1e-3;
        Points x = quarter.mesh.x;
        const Relaxed r = relax(quarter.at, quarter.membranes, x);
        const double volume = 8 * enclosed_volume(quarter.at.facets, x) / (a * a * a);
        fmt::print(
            "Mylar bag, {}, {} elements in all: V/a³ = {:.4f} ({:+.2f} %), thickness/a {:.4f} "
            "(.9139); {} steps, residual {:.1e}\n",
            name(kind), 8 * quarter.mesh.shells.size(), volume, 100 * (volume / 1.2185242 - 1),
            2 * x[0].z() / a, r.steps, r.residual);
        if (n == 20) CHECK(volume == Approx(1.2185242).epsilon(0.01));
    }
}

TEST_CASE("the square airbag rises to its published height") {
    // Side 0.8485 m, E 588 MPa, nu 0.4, h 0.6 mm, 5 kPa: 0.2165 m at the middle, 0.1249 m³
    const Kind kind = GENERATE(from_range(std::begin(PRESSED), std::end(PRESSED)));
    const double half = 0.42425;
    for (const int n : {8, 16, 32}) {
        Quarter quarter(square(n, half, kind == Kind::TRIANGLES), film(588e6, 0.4), 0.6e-3, kind,
                        5e3);
        quarter.hold([&](const Vec3& p) { return std::max(p.x(), p.y()) > half * (1 - 1e-6); },
                     Vec3(1, 1, 0));
        quarter.at.tolerance = 1e-3;
        Points x = quarter.mesh.x;
        const Relaxed r = relax(quarter.at, quarter.membranes, x);
        const double volume = 8 * enclosed_volume(quarter.at.facets, x);
        fmt::print(
            "Square airbag, {}, N = {}: w = {:.4f} m (.2165), V = {:.4f} m³ (.1249); {} steps, "
            "residual {:.1e}\n",
            name(kind), n, x[0].z(), volume, r.steps, r.residual);
        if (n == 32) {
            CHECK(x[0].z() == Approx(0.2165).epsilon(0.01));
            CHECK(volume == Approx(0.1249).epsilon(0.01));
        }
    }
}
