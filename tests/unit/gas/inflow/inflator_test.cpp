// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "gas/inflow/inflator.hpp"
#include "solver/base/error.hpp"
#include "solver/base/random.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// Two gases through two inflators' three orifices; curves 0 and 1 are flows, 2 and 3 temperatures.
struct TwoInflators {
    BagCard card;
    std::vector<Curve> curves;

    TwoInflators() {
        curves = {{1, {0.0, 0.9e-3, 1.1e-3, 1.0}, {0.1, 0.1, 0.0, 0.0}},
                  {2, {1e-4, 5e-4, 5e-4, 2e-3}, {0.0, 0.2, 0.05, 0.01}},
                  {3, {0.0, 1.0}, {210.9, 210.9}},
                  {4, {0.0, 1e-3}, {180.0, 400.0}}};
        card.id = 1;
        card.particles = 1000;
        card.inflow = {{AIR, 0, 2, 1}, {HELIUM, 1, 3, 2}};
        card.orifices.resize(3);
        card.orifices[0].inflator = 1;
        card.orifices[1].inflator = 2;
        card.orifices[1].weight = 3.0;
        card.orifices[2].inflator = 2;
        card.orifices[2].weight = 1.5;
        card.orifices[2].direction = Vec3(0, 0, 2);
        card.orifices[2].cone = 0.5;
    }
    [[nodiscard]] Inflators inflators(std::uint64_t seed = 7) const { return {card, curves, seed}; }
    [[nodiscard]] std::vector<Vec3> axes() const {
        return {Vec3::Zero(), Vec3::Zero(), Vec3(0, 0, 2)};
    }
};

std::vector<Entry> all_of(const TwoInflators& scene) {
    std::vector<Entry> entries;
    scene.inflators().entering(INF, scene.axes(), entries);
    return entries;
}

/// Some flow curve with jumps, holes and corners.
Curve random_flow(std::uint64_t seed) {
    Random draw(seed, Stream::INITIAL, 0, 0);
    Curve curve{1, {}, {}};
    double t = 0.01 * draw.uniform() - 0.003;
    for (int i = 0; i < 8; ++i) {
        curve.x.push_back(t);
        curve.y.push_back(draw.uniform() < 0.3 ? 0.0 : draw.uniform());
        if (draw.uniform() < 0.7) t += 0.01 * draw.uniform();
    }
    curve.x.push_back(t + 0.01);
    curve.y.push_back(0.5);
    return curve;
}

}  // namespace

TEST_CASE("a flow curve's time_of undoes its sum", "[gas]") {
    const std::uint64_t seed = GENERATE(range(1, 30));
    const double end = GENERATE(0.02, 1e10);
    const FlowCurve flow(random_flow(seed), end);
    CHECK(flow.sum_until(flow.ends()) == flow.total());
    CHECK(flow.sum_until(-1.0) == 0.0);
    CHECK(flow.ends() <= end);
    for (int i = 1; i <= 50; ++i) {
        const double amount = flow.total() * (i / 50.0);
        CHECK(flow.sum_until(flow.time_of(amount)) == Approx(amount).epsilon(1e-12));
    }
}

TEST_CASE("inflow follows the curve within one particle at every instant", "[gas]") {
    const std::uint64_t seed = GENERATE(range(1, 25));
    TwoInflators scene;
    scene.card.particles = GENERATE(17, 400);
    scene.curves[0] = random_flow(seed);
    scene.curves[1] = random_flow(1000 + seed);
    const Inflators inflators = scene.inflators();
    const std::vector<Entry> entries = all_of(scene);

    REQUIRE(entries.size() == scene.card.particles);
    std::vector<double> come(2, 0.0);
    for (const Entry& entry : entries) {
        const double each = inflators.moles_each() * inflators.species()[entry.inflow].molar_mass();
        const double due = inflators.mass_until(entry.inflow, entry.time) / each;
        CHECK(std::abs(come[entry.inflow] - due) < 1.0);  // just before
        come[entry.inflow] += 1.0;
        CHECK(std::abs(come[entry.inflow] - due) < 1.0);  // just after
    }
    for (std::size_t g = 0; g < 2; ++g) {
        const double each = inflators.moles_each() * inflators.species()[g].molar_mass();
        CHECK(std::abs(come[g] - inflators.mass_until(g, INF) / each) < 1.0);
        CHECK(come[g] == inflators.particles(g));
    }
}

TEST_CASE("each orifice gets its share within one particle at every instant", "[gas]") {
    TwoInflators scene;
    scene.card.orifices.clear();
    for (double weight : {1.0, 2.5, 0.01, 7.0, 0.0, 3.3}) {
        scene.card.orifices.emplace_back().weight = weight;
        scene.card.orifices.back().inflator = 1;
    }
    scene.card.inflow.resize(1);
    Inflators inflators = scene.inflators();
    std::vector<Entry> entries;
    inflators.entering(INF, std::vector<Vec3>(6, Vec3::Zero()), entries);

    std::vector<double> come(6, 0.0);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        come[entries[k].orifice] += 1.0;
        for (std::size_t o = 0; o < 6; ++o) {
            const double due = scene.card.orifices[o].weight / 13.81 * static_cast<double>(k + 1);
            REQUIRE(std::abs(come[o] - due) < 1.0);
        }
    }
}

TEST_CASE("gases keep to their inflator's orifices and particles to equal moles", "[gas]") {
    const TwoInflators scene;
    const Inflators inflators = scene.inflators();
    for (const Entry& entry : all_of(scene)) CHECK((entry.orifice == 0) == (entry.inflow == 0));

    const double moles_0 = inflators.mass_until(0, INF) / 0.028;
    const double moles_1 = inflators.mass_until(1, INF) / 0.004;
    CHECK(inflators.particles() == 1000);
    CHECK(inflators.moles_each() == Approx((moles_0 + moles_1) / 1000).epsilon(1e-14));
    CHECK(std::abs(static_cast<double>(inflators.particles(0)) - moles_0 / inflators.moles_each()) <
          1);
}

TEST_CASE("a particle brings u(T_stag), its translation in one direction inside the cone",
          "[gas]") {
    const TwoInflators scene;
    const Inflators inflators = scene.inflators();
    Vec3 mean = Vec3::Zero();
    double jets = 0.0, mean_cosine = 0.0;
    for (const Entry& entry : all_of(scene)) {
        const Species& gas = inflators.species()[entry.inflow];
        const double mass = inflators.moles_each() * gas.molar_mass();
        const double T = gas.temperature_of(gas.h(scene.curves[2 + entry.inflow](entry.time)));
        CHECK(entry.energy == Approx(mass * gas.u(T)).epsilon(1e-13));
        CHECK(entry.velocity.norm() ==
              Approx(std::sqrt(3 * GAS_CONSTANT * T / gas.molar_mass())).epsilon(1e-13));
        CHECK(0.5 * mass * entry.velocity.squaredNorm() + entry.internal ==
              Approx(entry.energy).epsilon(1e-13));
        const double cosine = entry.velocity.z() / entry.velocity.norm();
        if (entry.orifice == 2) {
            CHECK(cosine >= std::cos(0.5) - 1e-12);
            mean_cosine += cosine;
            jets += 1.0;
        }
        if (entry.orifice == 0) mean += entry.velocity.normalized();
    }
    // Even in solid angle: the cosine is uniform from cos(half angle) to 1; 4 standard deviations.
    const double spread = (1 - std::cos(0.5)) / std::sqrt(12.0);
    CHECK(std::abs(mean_cosine / jets - 0.5 * (1 + std::cos(0.5))) < 4 * spread / std::sqrt(jets));
    const double n = static_cast<double>(inflators.particles(0));
    CHECK((mean / n).cwiseAbs().maxCoeff() < 4 * std::sqrt(1 / (3 * n)));
}

TEST_CASE("entries do not depend on how time is cut, nor on a stop and restart", "[gas]") {
    const TwoInflators scene;
    const std::vector<Entry> whole = all_of(scene);

    std::vector<Entry> pieces;
    Inflators inflators = scene.inflators();
    for (int i = 1; i <= 777; ++i) {
        if (i == 300) {
            Inflators again = scene.inflators();
            again.restore(inflators.state());
            inflators = again;
        }
        inflators.entering(3e-3 * i / 777, scene.axes(), pieces);
    }
    REQUIRE(pieces.size() == whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        CHECK(pieces[i].id == static_cast<std::int32_t>(i));
        CHECK(whole[i].id == pieces[i].id);
        CHECK(whole[i].time == pieces[i].time);
        CHECK(whole[i].orifice == pieces[i].orifice);
        CHECK(whole[i].velocity == pieces[i].velocity);
        if (i > 0) CHECK(whole[i].time >= whole[i - 1].time);
    }
}

TEST_CASE("all faults of an inflator are told at once", "[gas]") {
    TwoInflators scene;
    scene.curves[0].y[1] = -0.1;
    scene.curves[3].y[0] = -50.0;
    scene.card.inflow[1].inflator = 5;
    scene.card.orifices[2].cone = NaN;
    try {
        static_cast<void>(scene.inflators());
        FAIL("accepted");
    } catch (const InputError& e) {
        CHECK(e.faults.size() == 3);  // the gas without an orifice is not looked into further
        CHECK_THAT(e.what(), Catch::Contains("falls to -0.1") && Catch::Contains("no orifice") &&
                                 Catch::Contains("cone"));
    }
}

TEST_CASE("inflow that cannot be is refused", "[gas]") {
    TwoInflators scene;
    SECTION("nothing flows before all is to be in") {
        scene.card.all_in = 1e-4;
        CHECK_THROWS_WITH(scene.inflators(), Catch::Contains("brings nothing in"));
    }
    SECTION("a temperature at absolute zero") {
        scene.curves[3].y[0] = -50.0;
        CHECK_THROWS_WITH(scene.inflators(), Catch::Contains("expected > 0 K"));
    }
    SECTION("a gas too scarce for one particle") {
        scene.card.particles = 1;
        CHECK_THROWS_WITH(scene.inflators(), Catch::Contains("too few"));
    }
    SECTION("no particles") {
        scene.card.particles = 0;
        CHECK_THROWS_WITH(scene.inflators(), Catch::Contains("number of particles = 0"));
    }
    SECTION("a heat capacity that no gas has at the heat of its neighbour") {
        scene.card.inflow[0].species = {0.044, 22.26, 59.81e-3, -35.01e-6};
        CHECK_NOTHROW(scene.inflators());
        scene.curves[3].y[1] = 2000.0;
        CHECK_THROWS_WITH(scene.inflators(), Catch::Contains("gas 1 of bag 1: Cv"));
    }
    SECTION("orifices without area") {
        scene.card.orifices[0].weight = 0.0;
        CHECK_THROWS_WITH(scene.inflators(), Catch::Contains("no area"));
    }
}
