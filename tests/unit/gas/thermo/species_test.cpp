// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "gas/thermo/species.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

const SpeciesCard NITROGEN{0.028, 26.1, 8.18e-3, -1.98e-6};
const SpeciesCard PROPANE{0.0441, 10.1, 0.239, -7.4e-5};

Species make(const SpeciesCard& card) {
    return {card, GAS_CONSTANT, "gas"};
}

}  // namespace

TEST_CASE("temperature_of undoes u to rounding, whatever the heat capacity", "[gas]") {
    const Species gas = make(GENERATE(NITROGEN, CARBON_DIOXIDE, HELIUM));
    for (double T : {1e-3, 1.0, 49.0, 300.0, 333.3, 650.0, 800.0})
        CHECK(gas.temperature_of(gas.u(T)) == Approx(T).epsilon(4e-15));
}

TEST_CASE("the heat capacities are the slopes of energy and enthalpy", "[gas]") {
    const Species gas = make(GENERATE(NITROGEN, CARBON_DIOXIDE, HELIUM));
    const double T = GENERATE(80.0, 300.0, 700.0), dT = 1e-3;
    CHECK((gas.u(T + dT) - gas.u(T - dT)) / (2 * dT) == Approx(gas.cv(T)).epsilon(1e-7));
    CHECK((gas.h(T + dT) - gas.h(T - dT)) / (2 * dT) == Approx(gas.cp(T)).epsilon(1e-7));
    CHECK(gas.cp(T) - gas.cv(T) == Approx(GAS_CONSTANT / gas.molar_mass()).epsilon(1e-14));
    CHECK(gas.internal(T) + 1.5 * GAS_CONSTANT * T / gas.molar_mass() ==
          Approx(gas.u(T)).epsilon(1e-14));
}

TEST_CASE("with constant heat capacity stagnation is gamma times static temperature", "[gas]") {
    const Species air = make({0.028, 28.0, 0.0, 0.0});
    CHECK(air.stagnation_temperature(210.9) == Approx(air.gamma(1.0) * 210.9).epsilon(1e-14));
}

TEST_CASE("no temperature is invented for an energy that no gas can hold", "[gas]") {
    const Species gas = make(CARBON_DIOXIDE);
    CHECK(std::isnan(gas.temperature_of(-1.0)));
    CHECK(std::isnan(gas.temperature_of(1e9)));  // above the fit's maximum
    CHECK(std::isnan(gas.temperature_of(NaN)));
    CHECK(gas.temperature_of(0.0) == 0.0);
}

TEST_CASE("an energy that first falls with temperature is still inverted on its rise", "[gas]") {
    const EnergyPolynomial E{-10.0, 0.2, -1e-5};
    for (double T : {51.0, 100.0, 1000.0, 5000.0})
        CHECK(E.temperature(E(T), GENERATE(1.0, 300.0, 1e5)) == Approx(T).epsilon(1e-13));
}

TEST_CASE("a gas is rejected where its heat capacity is none, with the temperature", "[gas]") {
    SECTION("good gases pass, a monatomic one with a rounded heat capacity too") {
        CHECK(make(NITROGEN).fault_between(50, 2000).empty());
        CHECK(make(CARBON_DIOXIDE).fault_between(50, 900).empty());
        CHECK(make(HELIUM).fault_between(50, 5000).empty());
        CHECK(make({0.004, 20.78, 0, 0}).fault_between(50, 5000).empty());
    }
    SECTION("too stiff: more than all energy would be translation") {
        const std::string fault = make({0.004, 20.7, 0, 0}).fault_between(50, 300);
        CHECK_THAT(fault, Catch::Contains("5/3") && Catch::Contains("50 K"));
    }
    SECTION("Cv falls below zero at the hot end") {
        const std::string fault = make(CARBON_DIOXIDE).fault_between(50, 2500);
        CHECK_THAT(fault, Catch::Contains("Cv") && Catch::Contains("at 2500 K"));
    }
    SECTION("the dip lies inside the range") {
        const Species gas = make({0.03, 40.0, -0.1, 1e-4});  // Cv least at 500 K
        CHECK_THAT(gas.fault_between(50, 2000), Catch::Contains("at 500 K"));
        CHECK(gas.fault_between(50, 120).empty());
    }
    SECTION("propane's fit is a gas from 50 K on") {
        CHECK(make(PROPANE).fault_between(50, 300).empty());
    }
}

TEST_CASE("numbers that are missing are named", "[gas]") {
    CHECK_THROWS_WITH(make({NaN, 28, 0, 0}), Catch::Contains("molar mass"));
    CHECK_THROWS_WITH(make({0.028, NaN, 0, 0}), Catch::Contains("A, B, C"));
    CHECK_THROWS_WITH(Species(NITROGEN, 0.0, "air"), Catch::Contains("air: gas constant"));
}

TEST_CASE("a mixture at one temperature holds the sum of its parts", "[gas]") {
    const std::vector<Species> species = {make(NITROGEN), make(HELIUM), make(CARBON_DIOXIDE)};
    const std::vector<double> moles = {2.0, 0.5, 1.25};
    const double T = GENERATE(60.0, 300.0, 700.0);
    double energy = 0.0;
    for (std::size_t s = 0; s < 3; ++s)
        energy += moles[s] * species[s].molar_mass() * species[s].u(T);
    CHECK(mixture_temperature(species, moles, energy) == Approx(T).epsilon(1e-13));
}

TEST_CASE("a particle has the temperature of what it holds, or of its speed if it holds nothing",
          "[gas]") {
    const Mixture gas({make(NITROGEN), make(HELIUM)}, 1e-6);
    const double T = GENERATE(60.0, 300.0, 700.0);
    CHECK(gas.particle_temperature(0, gas.particle_internal(0)(T), 1e9) ==
          Approx(T).epsilon(1e-13));
    const double speed_squared = 3.0 * GAS_CONSTANT * T / HELIUM.molar_mass;
    CHECK(gas.particle_temperature(1, 0.0, speed_squared) == Approx(T).epsilon(1e-13));
    CHECK(gas.particle_temperature(1, gas.particle_internal(1)(T), speed_squared) ==
          Approx(T).epsilon(1e-13));  // 20.79 is a trifle more than 5/2 R
}
