// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "fabric_membrane.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using fabric::FabricCard;

TEST_CASE("a bag given crumpled to half its size inflates to the shape of the flat one") {
    const Kind kind = GENERATE(Kind::TRIANGLES, Kind::ONE_POINT, Kind::FOUR_POINT);
    FabricCard cloth;
    cloth.density = 700;
    cloth.E_warp = 300e6;
    cloth.E_weft = 250e6;
    cloth.nu_ba = 0.1;
    cloth.G = 3e6;
    cloth.no_compression = true;
    cloth.axes = 2;
    const double radius = 0.3, h = 0.3e-3;
    const auto volume = [&](bool crumpled) {
        Quarter quarter(quarter_disc(8, radius, kind == Kind::TRIANGLES), cloth, h, kind, 20e3);
        quarter.hold([&](const Vec3& p) { return p.norm() > radius * (1 - 1e-6); }, Vec3(1, 1, 0));
        quarter.at.tolerance = 1e-3;
        Points x = quarter.mesh.x;
        if (crumpled)
            for (std::size_t n = 0; n < x.size(); ++n) {
                // Drawn in to half, pleated across; mirrors and seam stay where they are held
                const Vec3 p = quarter.mesh.x[n];
                x[n] = 0.5 * p;
                if (quarter.at.free[n].z() > 0)
                    x[n].z() = 0.02 * (1 + std::sin(120 * p.x()) * std::cos(95 * p.y()));
            }
        const Relaxed r = relax(quarter.at, quarter.membranes, x);
        CHECK(r.residual <= quarter.at.tolerance);
        return 8 * enclosed_volume(quarter.at.facets, x);
    };
    const double flat = volume(false), crumpled = volume(true);
    fmt::print("Reference geometry, {}: {:.6f} m³ from flat, {:.6f} m³ from crumpled ({:+.3f} %)\n",
               name(kind), flat, crumpled, 100 * (crumpled / flat - 1));
    CHECK(crumpled == Approx(flat).epsilon(0.005));
}
