// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/text/units.hpp"

#include <catch2/catch.hpp>

using namespace corpuscle;
using io::Quantity;

TEST_CASE("pounds and inches become kPa, kN, litres and grams by their definitions", "[io]") {
    const std::string_view pounds = io::unit_system_named("LBF-in-s");
    CHECK(pounds == "lbf-in-s-K");
    CHECK(io::unit_of(Quantity::PRESSURE, pounds) == "psi");
    CHECK(io::spoken(Quantity::PRESSURE, pounds).factor == Approx(6.894757293168).epsilon(1e-12));
    CHECK(io::spoken(Quantity::FORCE, pounds).factor == Approx(4.4482216152605e-3).epsilon(1e-13));
    CHECK(io::spoken(Quantity::VOLUME, pounds).factor == Approx(0.016387064).epsilon(1e-13));
    CHECK(io::spoken(Quantity::MASS, pounds).factor == Approx(175126.83524649).epsilon(1e-12));
    CHECK(io::spoken(Quantity::DENSITY, pounds).factor == Approx(10686895.1782).epsilon(1e-11));
    CHECK(io::scale_of(pounds)->gravity() == Approx(386.0885826772).epsilon(1e-12));
}

TEST_CASE("in every system force is mass times acceleration, and the names say so", "[io]") {
    for (const std::string_view name : io::unit_system_names()) {
        CAPTURE(name);
        const auto factor = [&](Quantity quantity) { return io::spoken(quantity, name).factor; };
        // kN of g m/s^2, J of kN mm, kPa of kN over cm^2
        CHECK(factor(Quantity::FORCE) ==
              Approx(1e-6 * factor(Quantity::MASS) * factor(Quantity::ACCELERATION)));
        CHECK(factor(Quantity::ENERGY) ==
              Approx(factor(Quantity::FORCE) * factor(Quantity::LENGTH)));
        CHECK(factor(Quantity::PRESSURE) ==
              Approx(1e4 * factor(Quantity::FORCE) / factor(Quantity::AREA)));
        CHECK(io::unit_system_named(name) == name);
        CHECK(io::spoken(io::unit_of(Quantity::PRESSURE, name), name).unit == "kPa");
    }
    CHECK(io::unit_of(Quantity::FORCE, "g-mm-ms-K") == "N");
    CHECK(io::unit_of(Quantity::PRESSURE, "g-mm-ms-K") == "MPa");
    CHECK(io::unit_system_named("furlong").empty());
    CHECK_FALSE(io::scale_of("consistent"));
}
