// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

TEST_CASE("a pull across the yarns meets the curves that the yarns and their angle follow",
          "[fabric][curves]") {
    // Yarns at 45°, stretched by a along x and b along y: both yarns have l² = (a² + b²)/2 and turn
    // towards each other by γ, sin γ = ±(a² - b²)/(a² + b²)
    const Mesh mesh = GENERATE(Mesh::TRIANGLES, Mesh::ONE_POINT, Mesh::FOUR_POINT);
    const bool is_engineering = GENERATE(false, true);
    const double a = GENERATE(1.05, 1.25), b = 0.9;
    FabricCard card = fabric_card();
    card.form = is_engineering ? 14 : 4;
    card.axes = 2;
    card.a = {1, 1, 0};
    card.curves.load = {0, 0, 1};
    const double width = 0.2, h = 0.3e-3;
    Sheet sheet = rectangle(card, mesh, 4, 3, 0.3, width);
    const Curve yarn{1, {0, 0.02, 0.1, 0.3}, {0, 2e6, 20e6, 90e6}};
    const Curve angle{2, {0, 0.2, 1.0}, {0, 0.2e6, 6e6}};
    sheet.curves = {yarn, angle};
    Membranes membranes = sheet.membranes();
    const Points x = moved(sheet.x, [&](const Vec3& p) { return Vec3(a * p.x(), b * p.y(), 0); });
    const Points f = force(membranes, x);
    double pull = 0.0, across = 0.0;
    for (std::size_t n = 0; n < x.size(); ++n) {
        if (sheet.x[n].x() > 0.3 - 1e-9) pull -= f[n].x();
        if (sheet.x[n].y() > width - 1e-9) across -= f[n].y();
    }

    // dw/da and dw/db of w(l, l, γ), by hand
    const double square = 0.5 * (a * a + b * b), l = std::sqrt(square);
    const auto along = [&](double e) {  // straight on below 0
        return e < 0 ? yarn(0.02) / 0.02 * e : yarn(e);
    };
    double by_a, by_b;
    if (is_engineering) {
        const double sine = (a * a - b * b) / (a * a + b * b), gamma = std::asin(sine);
        const double turn = angle(gamma) / std::sqrt(1 - sine * sine) / (square * square);
        by_a = along(l - 1) * a / l + turn * a * b * b;
        by_b = along(l - 1) * b / l - turn * b * a * a;
    } else {
        const double s = along(0.5 * (square - 1)), t = angle(0.5 * (a * a - b * b));
        by_a = a * (s + t);
        by_b = b * (s - t);
    }
    CHECK(pull == Approx(by_a * h * width).epsilon(1e-9));
    CHECK(across == Approx(by_b * h * 0.3).epsilon(1e-9));
}
