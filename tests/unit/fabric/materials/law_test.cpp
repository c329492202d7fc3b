// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <random>

#include "fabric/materials/law.hpp"
#include "solver/base/error.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;

namespace {

struct FlatLaw {
    double E_1, E_2, nu_21, G;
};
const FlatLaw SHEETS[] = {{300e6, 250e6, 0.1, 3e6},    // woven
                          {300e6, 300e6, 0.2, 125e6},  // isotropic
                          {400e6, 50e6, 0.05, 20e6},   // warp much stiffer
                          {50e6, 400e6, 0.3, 200e6}};  // stiff in shear

OrthotropicTensionField law_of(const FlatLaw& s) {
    return {s.E_1, s.E_2, s.nu_21, s.G};
}

Strain<double> random_strain(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-0.1, 0.1);
    return {any(random), any(random), 2 * any(random)};
}

/// S:C:S/2, the energy of a stress in an unwrinkled sheet.
double complementary(const FlatLaw& m, double S_1, double S_2, double S_12) {
    return 0.5 * (S_1 * S_1 / m.E_1 + S_2 * S_2 / m.E_2 - 2 * m.nu_21 / m.E_2 * S_1 * S_2 +
                  S_12 * S_12 / m.G);
}

}  // namespace

TEST_CASE("a tension field never presses", "[fabric][law]") {
    const FlatLaw sheet = GENERATE(from_range(std::begin(SHEETS), std::end(SHEETS)));
    const OrthotropicTensionField law = law_of(sheet);
    std::mt19937 random(1);
    for (int i = 0; i < 2000; ++i) {
        const auto s = law.stress(random_strain(random));
        const double size = std::abs(s.warp) + std::abs(s.weft) + 1.0;
        REQUIRE(s.warp >= 0.0);
        REQUIRE(s.weft >= 0.0);
        REQUIRE(s.warp * s.weft - s.shear * s.shear >= -1e-12 * size * size);
    }
}

TEST_CASE("no stress without compression holds more energy than the tension field finds",
          "[fabric][law]") {
    // w = max over S >= 0 of S:E - S:C:S/2, here by trying many S
    const FlatLaw sheet = GENERATE(from_range(std::begin(SHEETS), std::end(SHEETS)));
    const OrthotropicTensionField law = law_of(sheet);
    std::mt19937 random(2);
    std::uniform_real_distribution<double> share(0.0, 1.0), angle(0.0, 3.141592653589793);
    for (int i = 0; i < 200; ++i) {
        const Strain<double> e = random_strain(random);
        const Stress<double> s = law.stress(e);
        REQUIRE(s.energy == Approx(complementary(sheet, s.warp, s.weft, s.shear)).epsilon(1e-9));
        for (int k = 0; k < 200; ++k) {
            const double big = 0.1 * sheet.E_1 * std::pow(share(random), 4), turn = angle(random);
            const double small = big * std::pow(share(random), 4);
            const double c = std::cos(turn), n = std::sin(turn);
            const double S_1 = big * c * c + small * n * n, S_2 = big * n * n + small * c * c;
            const double S_12 = (big - small) * c * n;
            const double holds =
                S_1 * e.warp + S_2 * e.weft + S_12 * e.shear - complementary(sheet, S_1, S_2, S_12);
            REQUIRE(holds <= s.energy * (1 + 1e-9) + 1e-6);
        }
    }
}

TEST_CASE("stress is the slope of energy, across all borders", "[fabric][law]") {
    const FlatLaw sheet = GENERATE(from_range(std::begin(SHEETS), std::end(SHEETS)));
    const OrthotropicTensionField law = law_of(sheet);
    const double step = 1e-7;
    std::mt19937 random(3);
    for (int i = 0; i < 1000; ++i) {
        const Strain<double> e = random_strain(random);
        const Stress<double> s = law.stress(e);
        const auto slope = [&](double a, double b, double c) {
            return (law.stress(Strain<double>{e.warp + a, e.weft + b, e.shear + c}).energy -
                    law.stress(Strain<double>{e.warp - a, e.weft - b, e.shear - c}).energy) /
                   (2 * step);
        };
        const double unit = 1e-5 * 0.1 * std::max(sheet.E_1, sheet.E_2);
        REQUIRE(slope(step, 0, 0) == Approx(s.warp).margin(unit));
        REQUIRE(slope(0, step, 0) == Approx(s.weft).margin(unit));
        REQUIRE(slope(0, 0, step) == Approx(s.shear).margin(unit));
    }
}

TEST_CASE("the tension field of woven cloth holds that of a film", "[fabric][law]") {
    const double E = 300e6, nu = 0.2;
    const IsotropicTensionField film(E, nu);
    const OrthotropicTensionField cloth(E, E, nu, 0.5 * E / (1 + nu));
    std::mt19937 random(4);
    for (int i = 0; i < 2000; ++i) {
        const Strain<double> e = random_strain(random);
        const auto a = film.stress(e), b = cloth.stress(e);
        REQUIRE(a.warp == Approx(b.warp).margin(1e-6 * E));
        REQUIRE(a.weft == Approx(b.weft).margin(1e-6 * E));
        REQUIRE(a.shear == Approx(b.shear).margin(1e-6 * E));
        REQUIRE(a.energy == Approx(b.energy).margin(1e-9 * E));
    }
}

TEST_CASE("warp and weft may change places, and shear its sign", "[fabric][law]") {
    const FlatLaw m = GENERATE(from_range(std::begin(SHEETS), std::end(SHEETS)));
    const OrthotropicTensionField one = law_of(m);
    const OrthotropicTensionField other(m.E_2, m.E_1, m.nu_21 * m.E_1 / m.E_2, m.G);
    std::mt19937 random(5);
    for (int i = 0; i < 1000; ++i) {
        const Strain<double> e = random_strain(random);
        const auto a = one.stress(e);
        const auto b = other.stress(Strain<double>{e.weft, e.warp, -e.shear});
        const double unit = 1e-9 * m.E_1;
        REQUIRE(a.warp == Approx(b.weft).margin(unit));
        REQUIRE(a.weft == Approx(b.warp).margin(unit));
        REQUIRE(a.shear == Approx(-b.shear).margin(unit));
    }
}

TEST_CASE("many lanes give what each gives alone", "[fabric][law]") {
    const OrthotropicTensionField law = law_of(SHEETS[0]);
    std::mt19937 random(6);
    for (int i = 0; i < 200; ++i) {
        Strain<Lanes> many{};
        for (int l = 0; l < LANES; ++l) {
            const Strain<double> e = random_strain(random);
            many.warp[l] = e.warp;
            many.weft[l] = e.weft;
            many.shear[l] = e.shear;
        }
        const Stress<Lanes> s = law.stress(many);
        for (int l = 0; l < LANES; ++l) {
            const Stress<double> one =
                law.stress(Strain<double>{many.warp[l], many.weft[l], many.shear[l]});
            REQUIRE(s.warp[l] == Approx(one.warp).margin(1e-3));
            REQUIRE(s.weft[l] == Approx(one.weft).margin(1e-3));
            REQUIRE(s.shear[l] == Approx(one.shear).margin(1e-3));
        }
    }
}

TEST_CASE("a card picks its law, and its faults are named together", "[fabric][law]") {
    FabricCard c;
    c.density = 700;
    c.E_warp = c.E_weft = 300e6;
    c.nu_ba = 0.2;
    c.G = 125e6;
    CHECK(std::holds_alternative<Linear>(make_law({1, "", c}).law));
    c.no_compression = true;
    CHECK(std::holds_alternative<IsotropicTensionField>(make_law({1, "", c}).law));
    c.G = 3e6;
    CHECK(std::holds_alternative<OrthotropicTensionField>(make_law({1, "", c}).law));
    c.liner_E = 1e6;
    c.liner_ratio = 0.1;
    CHECK(std::holds_alternative<Lined<OrthotropicTensionField>>(make_law({1, "", c}).law));
    c.liner_ratio = 0.0;
    CHECK(std::holds_alternative<OrthotropicTensionField>(make_law({1, "", c}).law));

    c.G = 0.0;
    c.E_warp = -1.0;
    try {
        static_cast<void>(make_law({17, "", c}));
        FAIL("was accepted");
    } catch (const InputError& e) {
        REQUIRE(e.faults.size() == 2);
        CHECK(e.faults[0].find("material 17: modulus along the warp = -1") != std::string::npos);
        CHECK(e.faults[1].find("material 17: shear modulus = 0") != std::string::npos);
    }
    CHECK_THROWS_AS(make_law({1, "", ElasticCard{900, 1e6, 1.0}}), InputError);
    CHECK_THROWS_AS(make_law({1, "", RigidCard{}}), InputError);
}
