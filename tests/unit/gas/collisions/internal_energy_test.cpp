// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Internal energies of single particles stay above zero, whatever their group's energy does.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "gas/collisions/collide.hpp"
#include "gas/collisions/deviation.hpp"
#include "tests/unit/gas/collisions/collide_setup.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;
using namespace collide_setup;

TEST_CASE("deviations are kept as far as none falls below zero, and the mean is as wanted",
          "[gas]") {
    const std::vector<double> e{1.0, 2.5, 4.0, 0.5, 7.0};
    const double before = 3.0;
    for (const double mean : {0.0, 1e-300, 0.1, 1.0, 2.374, 2.376, 3.0, 40.0}) {
        const auto [lowest, kept] = Deviation<double>::of(mean, before, 0.5, 0.95);
        double sum = 0.0, fewest = INF;
        for (const double each : e) {
            const double after = lowest + kept * (each - 0.5);
            sum += after;
            fewest = std::min(fewest, after);
        }
        INFO("mean " << mean);
        CHECK(sum / 5.0 == Approx(mean).epsilon(1e-14));
        CHECK(fewest >= 0.0);
        CHECK(kept == Approx(std::min(0.95, mean / 2.5)).epsilon(1e-14));
    }
    CHECK(Deviation<double>::of(-0.1, before, 0.5, 0.95).lowest == -0.1);
    CHECK(Deviation<double>::of(-0.1, before, 0.5, 0.95).kept == 0.0);
}

TEST_CASE("no particle is left with less internal energy than nothing where a gas sinks", "[gas]") {
    const auto model = every_model();
    const std::vector<SpeciesCard> cards = GENERATE(values<std::vector<SpeciesCard>>(
        {{AIR}, {CARBON_DIOXIDE}, {AIR, HELIUM}, {AIR, CARBON_DIOXIDE, HELIUM}}));
    const int n = GENERATE(200, 1000, 8000);  // 2, 8, 64 a cell
    const Mixture mixture = mixture_of(cards);
    Particles gas = random_gas(static_cast<std::size_t>(n), BOX, mixture,
                               std::vector<double>(cards.size(), 300.0));
    // Every fourth holds nothing, or has a debt to pay
    for (std::size_t i = 0; i < gas.size(); i += 4) {
        const double motion = 0.5 * mixture.particle_mass(gas.species[i]) * gas.v[i].squaredNorm();
        gas.e[i] = i % 8 == 0 ? 0.0 : -0.1 * motion;
    }
    Collider collider(mixture.species(), mixture.moles_each(), 5, model);
    collider.find_groups(CELLS, {}, gas);
    const double before = Invariants(gas, mixture).energy, thermal = collider.thermal_energy(gas);
    const CollisionReport report = collider.collide(0, DT, 0.7, gas);
    CHECK(Invariants(gas, mixture).energy ==
          Approx(before - 0.3 * thermal + report.refused).epsilon(1e-12));
    double worst = 0.0;
    for (std::size_t i = 0; i < gas.size(); ++i)
        worst = std::min(worst, gas.e[i] / (mixture.half_heat() * 300.0));
    // Lone particles keep their debt
    if (n == 8000) CHECK(worst == 0.0);
    for (std::size_t i = 0; i < gas.size(); ++i)
        if (gas.e[i] < 0.0)
            CHECK(gas.e[i] >= -0.1000001 * 0.5 * mixture.particle_mass(gas.species[i]) *
                                  gas.v[i].squaredNorm());
}

TEST_CASE("groups with more debts than heat keep each particle's motion", "[gas]") {
    const auto model = every_model();
    const Mixture mixture = mixture_of({HELIUM});
    Particles gas = random_gas(40, BOX, mixture, {300});
    // A jet of cold gas that owes a tenth of its motion
    for (std::size_t i = 0; i < gas.size(); ++i) {
        gas.v[i] = 0.1 * gas.v[i] + Vec3(4000.0, 0.0, 0.0);
        gas.e[i] = -0.05 * mixture.particle_mass(0) * gas.v[i].squaredNorm();
    }
    const Particles before = gas;
    Collider collider(mixture.species(), mixture.moles_each(), 5, model);
    collider.find_groups(Grid::over(Vec3::Zero(), BOX, 2.0, 10), {}, gas);
    CHECK(collider.collide(0, DT, 1.0, gas).unrelaxed == 1);
    for (std::size_t i = 0; i < gas.size(); ++i) {
        CHECK((gas.v[i] - before.v[i]).norm() < 1e-9);
        CHECK(gas.e[i] == before.e[i]);
    }
}

TEST_CASE("heat of a room goes to its groups, also where these reach into the next room", "[gas]") {
    const std::vector<SpeciesCard> cards{AIR, HELIUM};
    const Mixture mixture = mixture_of(cards);
    Particles gas = random_gas(1000, BOX, mixture, {300, 500});
    for (std::size_t i = 0; i < gas.size(); ++i)
        gas.room.push_back(static_cast<std::int16_t>(i % 7 == 0));
    Collider collider(mixture.species(), mixture.moles_each(), 5);
    collider.find_groups(CELLS, {}, gas);
    const Invariants before(gas, mixture);
    const std::vector<RoomGroups> rooms = collider.groups_of_rooms(2, cards.size(), gas);
    std::vector<Heat> heat;
    double given = 0.0, all = 0.0;
    for (const RoomGroups& room : rooms) {
        double mass = 0.0;
        for (std::size_t s = 0; s < cards.size(); ++s)
            mass += room.count[s] * mixture.particle_mass(static_cast<std::int32_t>(s));
        all += room.energies.thermal + room.energies.mean_motion;
        const double more = 0.2 * room.energies.thermal;
        heat.push_back({1.0, more / mass});
        given += more;
    }
    CHECK(all == Approx(before.energy).epsilon(1e-13));
    CHECK(rooms[0].groups + rooms[1].groups == collider.groups().lists().size());
    collider.collide(0, DT, heat, gas);
    CHECK(Invariants(gas, mixture).energy == Approx(before.energy + given).epsilon(1e-13));
}
