// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/transmission.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "gas/flight/flight.hpp"
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/constants.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// A square in the plane z = 0.1, of two triangles, moving at `speed`; particles below fly up.
struct Sheet {
    shapes::Shape shape{{{-1, -1, 0.1}, {1, -1, 0.1}, {1, 1, 0.1}, {-1, 1, 0.1}},
                        {{0, 1, 2}, {0, 2, 3}}};
    Points x_1 = shape.x;
    Particles gas;
    FlightResult flight;
    Transmission transmission;
    static constexpr double DT = 1e-3;

    Sheet(std::size_t count, double chance, bool is_internal, double push, double speed = 0.0) {
        for (Vec3& x : x_1) x.z() += speed * DT;
        for (std::size_t i = 0; i < count; ++i) {
            const double s = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
            gas.add({0.9 - 1.8 * s, 0.3, 0.05}, {3.0, 0.0, 100.0}, 7.0, 0, static_cast<int>(i));
        }
        transmission.all.push_back({is_internal, true, push, {chance}, {0.0}});
        transmission.of_facet = {0, 0};
        transmission.collar_of = {-1, -1};
        transmission.open = {1.0, 1.0};
    }
    void fly_through() {
        FacetLists lists(shape.triangles, shape.x, FacetLists::Of::EIGHTS);
        lists.build(Grid::over(Vec3(-1.1, -1.1, 0.0), Vec3(1.1, 1.1, 0.3), 0.1, 1000000), shape.x,
                    x_1, 0.0);
        const std::vector<double> mass{2.0};
        fly(lists, shape.x, x_1, DT, mass, {}, gas, flight, &transmission);
    }
    [[nodiscard]] std::size_t passed(Transmission::Fate fate) const {
        std::size_t count = 0;
        for (const auto& chunk : flight.arrivals)
            for (const Arrival& arrival : chunk) count += arrival.outcome.fate == fate;
        return count;
    }
};

}  // namespace

TEST_CASE("the share of particles that pass an opening is its chance", "[gas][transmission]") {
    const double chance = GENERATE(0.0, 0.25, 0.8, 1.0);
    Sheet sheet(20000, chance, false, 0.0);
    sheet.fly_through();
    const auto out = static_cast<double>(sheet.passed(Transmission::Fate::OUT));
    CHECK(out + static_cast<double>(sheet.passed(Transmission::Fate::BACK)) == 20000.0);
    // four standard deviations of a binomial share
    CHECK(std::abs(out - 20000.0 * chance) <= 4.0 * std::sqrt(20000.0 * chance * (1.0 - chance)));
    CHECK(sheet.flight.lost.empty());
}

TEST_CASE("what leaves takes its energy, less the work of its push", "[gas][transmission]") {
    const double push = GENERATE(0.0, 0.4, 1.0), speed = GENERATE(0.0, 20.0);
    Sheet sheet(100, 1.0, false, push, speed);
    sheet.fly_through();
    double carried = 0.0, given = 0.0;
    Vec3 impulse = Vec3::Zero();
    for (const auto& chunk : sheet.flight.arrivals)
        for (const Arrival& arrival : chunk) carried += arrival.energy;
    for (const auto& chunk : sheet.flight.hits)
        for (const Hit& hit : chunk) {
            impulse += hit.impulse;
            given += hit.energy;
        }
    const double before = 100.0 * (0.5 * 2.0 * (9.0 + 1e4) + 7.0);
    CHECK(carried + given == Approx(before).epsilon(1e-12));
    CHECK(impulse.z() == Approx(100.0 * push * 2.0 * 2.0 * (100.0 - speed)).margin(1e-9));
    CHECK(given == Approx(impulse.z() * speed).margin(1e-9));
}

TEST_CASE("what leaves has as much energy about its opening at any velocity of both",
          "[gas][transmission][galilei]") {
    const double push = GENERATE(0.0, 0.4, 1.0), speed = GENERATE(0.0, -50.0, 80.0);
    Sheet sheet(100, 1.0, false, push, speed);
    for (Vec3& v : sheet.gas.v) v.z() += speed;
    sheet.fly_through();
    REQUIRE(sheet.passed(Transmission::Fate::OUT) == 100);
    for (const auto& chunk : sheet.flight.arrivals)
        for (const Arrival& arrival : chunk)
            CHECK(arrival.energy - arrival.riding ==
                  Approx(0.5 * 2.0 * (9.0 + 1e4) + 7.0).epsilon(1e-12));
}

TEST_CASE("an internal opening lets particles through as if it were not there",
          "[gas][transmission]") {
    Sheet sheet(100, 1.0, true, 0.0);
    const Particles before = sheet.gas;
    sheet.fly_through();
    CHECK(sheet.passed(Transmission::Fate::THROUGH) == 100);
    for (std::size_t i = 0; i < 100; ++i) {
        CHECK(sheet.gas.v[i] == before.v[i]);
        CHECK((sheet.gas.x[i] - (before.x[i] + Sheet::DT * before.v[i])).norm() < 1e-15);
        CHECK(sheet.gas.x[i].z() > 0.1);
    }
    for (const auto& chunk : sheet.flight.hits) CHECK(chunk.empty());
}

TEST_CASE("who comes from the front of internal fabric passes by that side's chance",
          "[gas][transmission]") {
    // The sheet's normal and the particles' way agree, or not
    const bool from_front = GENERATE(false, true);
    const double speed = GENERATE(0.0, 20.0);  // the sheet's, slower than the particles
    Sheet sheet(20000, 0.2, true, 0.0, speed);
    sheet.transmission.all[0].front_chance = {0.7};
    if (from_front)
        for (auto& corners : sheet.shape.triangles) std::swap(corners[1], corners[2]);
    sheet.fly_through();
    const double chance = from_front ? 0.7 : 0.2;
    const auto through = static_cast<double>(sheet.passed(Transmission::Fate::THROUGH));
    CHECK(std::abs(through - 20000.0 * chance) <
          4.0 * std::sqrt(20000.0 * chance * (1.0 - chance)));
    for (const auto& chunk : sheet.flight.arrivals)
        for (const Arrival& arrival : chunk) {
            CHECK(arrival.outcome.from_front == from_front);
            if (arrival.outcome.fate != Transmission::Fate::THROUGH) continue;
            const double u = 100.0 - speed;  // past the sheet
            CHECK(arrival.energy == Approx(0.5 * 2.0 * (9.0 + u * u) + 7.0).epsilon(1e-12));
        }
}

TEST_CASE("a collar draws particles but is pushed like closed fabric", "[gas][transmission]") {
    Sheet sheet(20000, 0.0, false, 0.0);
    sheet.transmission.of_facet = {-1, -1};
    sheet.transmission.collar_of = {0, 0};
    sheet.transmission.all[0].collar_chance = {0.3};
    sheet.fly_through();
    const auto out = static_cast<double>(sheet.passed(Transmission::Fate::OUT));
    CHECK(std::abs(out - 6000.0) < 4.0 * std::sqrt(6000.0 * 0.7));
    double impulse = 0.0;
    for (const auto& chunk : sheet.flight.hits)
        for (const Hit& hit : chunk) impulse += hit.impulse.z();
    CHECK(impulse == Approx(20000.0 * 2.0 * 2.0 * 100.0));
}

TEST_CASE("contact that covers a facet closes its opening", "[gas][transmission]") {
    Sheet sheet(1000, 1.0, false, 0.0);
    sheet.transmission.open = {0.0, 0.0};
    sheet.fly_through();
    CHECK(sheet.passed(Transmission::Fate::OUT) == 0);
}

TEST_CASE("rows are taken out in order", "[gas][particles]") {
    Particles gas;
    for (int i = 0; i < 8; ++i) gas.add({1.0 * i, 0, 0}, {0, 1.0 * i, 0}, i, 0, i);
    gas.erase(std::vector<std::size_t>{0, 3, 4, 7});
    CHECK(gas.id == std::vector<std::int32_t>{1, 2, 5, 6});
    REQUIRE(gas.size() == 4);
    CHECK(gas.x[2].x() == 5.0);
    CHECK(gas.v[3].y() == 6.0);
    CHECK(gas.e[0] == 1.0);
    CHECK(gas.species.size() == 4);
    gas.erase(std::vector<std::size_t>{});
    CHECK(gas.size() == 4);
}

TEST_CASE("the isentropic flux is that of a nozzle", "[gas][vents]") {
    const double R = GAS_CONSTANT, M = 0.028, T = 300.0, p = 3e5;
    const double gamma = GENERATE(1.2, 1.4, 5.0 / 3.0);
    const double choked = p * std::pow(2.0 / (gamma + 1.0), gamma / (gamma - 1.0));
    const auto flux = [&](double outside) { return orifice_flow(p, outside, T, gamma, R / M); };
    SECTION("choked flow is sonic and feels nothing of what is outside") {
        const double T_throat = T * 2.0 / (gamma + 1.0);
        const double sonic = choked * M / (R * T_throat) * std::sqrt(gamma * R * T_throat / M);
        CHECK(flux(0.0) == Approx(sonic));
        CHECK(flux(0.99 * choked) == Approx(sonic));
        CHECK(flux(choked * 1.001) == Approx(sonic).epsilon(1e-5));
    }
    SECTION("a small difference of pressure gives Torricelli's sqrt(2 rho dp)") {
        const double dp = 1e-4 * p;
        CHECK(flux(p - dp) == Approx(std::sqrt(2.0 * p * M / (R * T) * dp)).epsilon(1e-3));
    }
    SECTION("none without a difference, nor backward") {
        CHECK(flux(p) == 0.0);
        CHECK(flux(1.5 * p) == 0.0);
    }
    SECTION("effusion of a diatomic gas is 0.58 of it") {
        const double rho = p * M / (R * T);
        CHECK(rho * effusion_speed(T, R, M) / orifice_flow(p, 0.0, T, 1.4, R / M) ==
              Approx(0.5827).epsilon(1e-3));
    }
}
