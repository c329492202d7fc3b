// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <numbers>

#include "deck_scene.hpp"
#include "gas/collisions/collide.hpp"
#include "solver/base/constants.hpp"
#include "tests/unit/io/deck/deck_airbag_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using namespace deck_airbag_setup;

TEST_CASE("AIRBAG_PARTICLE: the notes' simple cards", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(Bag{}.deck());
    CHECK(model.unit_system == "SI");
    const gas::BagCard& bag = model.bags.at(0);
    CHECK(bag.id == 1);
    CHECK(bag.external_parts == std::vector<Index>{0});
    CHECK(bag.internal_parts.empty());
    CHECK(bag.particles == 10000);
    CHECK(bag.show_particles);
    CHECK(bag.gas_constant == GAS_CONSTANT);
    CHECK(bag.p_atm == ATMOSPHERE_PRESSURE);
    CHECK(bag.T_atm == ATMOSPHERE_TEMPERATURE);
    CHECK(bag.all_in == 1e10);
    CHECK_FALSE(bag.air);
    CHECK(bag.smoothing == 1.0);
    REQUIRE(bag.inflow.size() == 1);
    CHECK(bag.inflow[0].mass_rate == 0);
    CHECK(bag.inflow[0].species.molar_mass == 0.028);
    CHECK(bag.inflow[0].species.A == 28.0);
    REQUIRE(bag.orifices.size() == 1);
    CHECK(bag.orifices[0].node == 4);
    CHECK_FALSE(bag.orifices[0].direction);
    CHECK(bag.orifices[0].cone == Approx(30.0 * DEGREE));
    CHECK(model.warnings.empty());
}

TEST_CASE("CONTROL_CPM: its SFFDC is that of bags which have none of their own", "[io]") {
    const DeckFolder folder;
    const auto deck = [](const std::string& plus, const std::string& control) {
        Bag bag;
        bag.behind_2 = plus;
        bag.orifice += "\n*CONTROL_CPM\n" + control;
        return bag.deck();
    };
    const auto smoothing = [&](const std::string& plus) {
        return folder.read(deck(plus, "11,5,0,1,2.5")).bags.at(0).smoothing;
    };
    CHECK(smoothing("") == 2.5);
    CHECK(smoothing("+\n") == 2.5);
    CHECK(smoothing("+,,,,,,,4.0\n") == 4.0);
    CHECK(any_contains(folder.faults(deck("", "11,5,0,0,1,0,0,3")),
                       "field 8 (P2PMIX) = 3, expected 0 or blank"));
}

TEST_CASE("AIRBAG_PARTICLE_TIME: a bag that never dies is read, one that does is refused", "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.suffix = "_TIME";
    bag.before_1 = "0,1e20\n";
    CHECK(folder.faults(bag.deck()).empty());
    bag.before_1 = "0,0.01\n";
    CHECK_THAT(only_fault(folder, bag), Catch::Contains("field 2 (DEATH) = 0.01"));
}

TEST_CASE("AIRBAG_PARTICLE: UNIT sets R and the atmosphere", "[io]") {
    const DeckFolder folder;
    Bag cards;
    cards.card_3 = "1,1,1";
    cards.rows = "0,0\n";
    cards.card_2 = "10000,0";
    const Model ms = folder.read(cards.deck());
    CHECK(ms.unit_system == "kg-mm-ms-K");
    CHECK(ms.bags[0].gas_constant == GAS_CONSTANT);
    CHECK(ms.bags[0].p_atm == Approx(1.01325e-4));
    REQUIRE(ms.bags[0].air);
    CHECK(ms.bags[0].air->pressure == ms.bags[0].p_atm);
    CHECK(ms.bags[0].air->temperature == 293.0);
    CHECK(ms.bags[0].air->species.molar_mass == Approx(0.02897).epsilon(1e-3));
    CHECK(any_contains(ms.warnings, "dry air is taken"));

    cards.card_2 = "10000,2,1,300.0,0.2";
    cards.gas = "7,7,2.8e-5,2.8e4";
    const Model ton = folder.read(cards.deck());
    CHECK(ton.unit_system == "ton-mm-s-K");
    CHECK(ton.bags[0].gas_constant == Approx(1e3 * GAS_CONSTANT));
    CHECK(ton.bags[0].p_atm == 0.2);
    CHECK(ton.bags[0].T_atm == 300.0);
    CHECK(ton.bags[0].air->temperature == 300.0);
    CHECK(ton.bags[0].air->species.A == Approx(3.5e3 * GAS_CONSTANT));

    cards.gas = "7,7,0.028,28.0";
    const auto faults = folder.faults(cards.deck());
    REQUIRE(faults.size() == 2);
    CHECK(contains(faults[0], "(XM) = 0.028, expected tonnes per mole"));
    CHECK(contains(faults[1], "(A) = 28.0, expected millijoules"));
}

TEST_CASE("AIRBAG_PARTICLE: every suffix inserts its card", "[io]") {
    const DeckFolder folder;
    const std::string mpp = "1.,1.,1.\n", time = "0,0\n";
    Bag bag;
    bag.card_2 = "777";
    const auto check = [&] {
        CAPTURE(bag.suffix);
        const Model model = folder.read(bag.deck());
        REQUIRE(model.bags.size() == 1);
        CHECK(model.bags[0].particles == 777);
        CHECK(model.bags[0].inflow.at(0).species.A == 28.0);
        CHECK(model.bags[0].orifices.at(0).node == 4);
        return model.bags[0];
    };
    SECTION("one by one") {
        bag.suffix = "_MPP", bag.before_1 = mpp, check();
        bag.suffix = "_TIME", bag.before_1 = time, check();
        bag.suffix = "_DECOMPOSITION", bag.before_1 = "", check();
        bag.suffix = "_SEGMENT", bag.before_2 = "0\n", check();
        bag.suffix = "_JET", bag.before_2 = "", bag.behind_2 = "0\n", check();
    }
    SECTION("_ID and _TITLE are one card") {
        bag.before_1 = "9,driver bag\n";
        for (const char* suffix : {"_ID", "_TITLE", "_ID_TITLE"}) {
            bag.suffix = suffix;
            CHECK(check().id == 9);
            CHECK(check().title == "driver bag");
        }
        bag.before_1 = "         9driver, left\n";  // this comma belongs to the title
        CHECK(check().id == 9);
        CHECK(check().title == "driver, left");
        bag.before_1 = "9, driver, left\n";
        CHECK(check().title == "driver, left");
    }
    SECTION("all together, in any order") {
        bag.before_1 = mpp + "9,left\n" + time;
        bag.before_2 = "0\n";
        bag.behind_2 = "0\n";
        for (const char* suffix :
             {"_MPP_DECOMPOSITION_JET_SEGMENT_TIME_ID", "_ID_TIME_SEGMENT_JET_MPP"}) {
            bag.suffix = suffix;
            CHECK(check().title == "left");
        }
    }
    SECTION("lines with a + in column 1") {
        bag.behind_2 =
            "+   1.E11       1.0       0.1         0         0         0       0.0       2.5\n"
            "+     1.0\n";
        CHECK(check().smoothing == 2.5);
        bag.behind_2 = "+1e11,,,,,,,0.5\n";
        CHECK(check().smoothing == 0.5);
        bag.behind_2 = "+,,0.05\n";
        check();
        CHECK(
            any_contains(folder.read(bag.deck()).warnings, "(OCCUP) = 0.05: particles are points"));
        bag.behind_2 = "+0.02,,,1,,7\n+1.0,,,,,0.05,0.1,1\n";
        check();
        for (const char* field : {"(TSTOP)", "(REBL)", "(JETLEN)", "(JETEND)", "(SHLOFF)"})
            CHECK(any_contains(folder.read(bag.deck()).warnings, field));
    }
}

TEST_CASE("AIRBAG_PARTICLE: what nothing acts on yet is one fault, its rows are read over",
          "[io]") {
    const DeckFolder folder;
    Bag bag;
    SECTION("card 1") {
        bag.card_1 = "1,0,0,0,31";
        CHECK(contains(only_fault(folder, bag), "card 1, field 5 (BLOCK) = 31, expected 0 or 1"));
        bag.card_1 = "1,0,0,0,0,0,1.5";
        CHECK(contains(only_fault(folder, bag), "(FRIC) = 1.5, expected above -1 to 1"));
        bag.card_1 = "1,0,2,2";
        bag.rows = "1,0,10.0\n2,0,10.0\n";
        CHECK(contains(only_fault(folder, bag), "(STYPE2) = 2, expected 0 or 1: this choice"));
    }
    SECTION("card 2") {
        bag.card_2 = "100,1,1,0,0,0,0,0.5", bag.rows = "";
        CHECK(folder.read(bag.deck()).bags.at(0).switch_at == 0.5);
        bag.card_2 = "100,3", bag.behind_2 = ",1,,1,,1\n";
        CHECK(folder.read(bag.deck()).unit_system == "SI");
        bag.behind_2 = ",1,,.001,,.001\n";
        const Model factors = folder.read(bag.deck());
        CHECK(factors.unit_system == "kg-mm-ms-K");
        CHECK(factors.bags.at(0).p_atm == Approx(1.01325e-4).epsilon(1e-3));
        CHECK(factors.bags.at(0).second == 1e3);
        bag.behind_2 = ",2,,.001,,.001\n";
        CHECK(contains(only_fault(folder, bag), "(MASS) = 2, expected with TIME and LENGTH"));
        bag.card_2 = "0,1", bag.behind_2 = "";  // blank or zero is the default
        CHECK(folder.read(bag.deck()).bags.at(0).particles == 200000);
        bag.card_2 = "-5,1";
        CHECK(contains(only_fault(folder, bag), "(NP) = -5, expected 1 to"));
    }
    SECTION("card 3 and the rows") {
        bag.card_3 = "4,1,1", bag.rows = "0,0,0.029,29.\n";
        const Model front = folder.read(bag.deck());
        CHECK(front.bags.at(0).air->is_particles);
        CHECK(any_contains(front.warnings, "(IAIR) = 4: taken as 2"));
        bag.card_3 = "3,1,1";
        CHECK(contains(only_fault(folder, bag), "(IAIR) = 3, expected 0 or 1 or -1 or 2 or 4"));
        bag.card_3 = "0,1,1,3", bag.rows = "";
        CHECK(folder.faults(bag.deck()).size() == 2);  // NID2 and NID3 are missing
        bag.card_3 = "0,1,1,1,2,5";
        CHECK(contains(only_fault(folder, bag), "(NID3) = 5, expected a node that is not in line"));
        bag.card_3 = "0,1,1,0,0,0,0,0.1";
        CHECK(contains(only_fault(folder, bag), "(CD_EXT) = 0.1"));
        bag.card_3 = "0,1,1", bag.orifice = "5,1.0,0,0,1,2";
        CHECK(contains(only_fault(folder, bag), "(IMOM) = 2, expected 0 or 1"));
    }
    SECTION("suffixes and + lines") {
        bag.suffix = "_INFLATION", bag.rows = "";
        CHECK(contains(only_fault(folder, bag), "has _INFLATION"));
        bag.suffix = "_SEGMENT", bag.before_2 = "4\n";
        CHECK(contains(only_fault(folder, bag), "(SEGSID) = 4"));
        bag.suffix = "", bag.before_2 = "", bag.behind_2 = "+,,,,,,0.01\n";
        CHECK(contains(only_fault(folder, bag), "(TSPLIT) = 0.01"));
    }
}

TEST_CASE("AIRBAG_PARTICLE: orifices push back, stand off their shell and turn with a frame",
          "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.card_3 = "0,1,1,1,2,3";
    bag.orifice = "11,1.0,-4,0,1,1\n0.25";
    const gas::BagCard card = folder.read(bag.deck()).bags.at(0);
    CHECK(card.frame == std::array<Index, 3>{0, 1, 2});
    CHECK(card.orifices.at(0).pushes);
    CHECK(card.orifices[0].offset == 0.25);
    CHECK(card.orifices[0].normal_sign == -1.0);
    bag.orifice = "9,1.0,0,0,1,1";
    const std::string lone = "*NODE\n9,0,0,1\n";
    const Model none = folder.read(lone + bag.deck());
    CHECK_FALSE(none.bags.at(0).orifices.at(0).pushes);
    CHECK(any_contains(none.warnings, "(IMOM) = 1: node NID belongs to no shell and has no mass"));
}

TEST_CASE("AIRBAG_PARTICLE_MOLEFRACTION: gases share the mass flow by moles", "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.suffix = "_MOLEFRACTION";
    bag.card_3 = "0,2,1";
    bag.rows = "20\n";
    bag.gas = "21,7,0.028,28.0\n22,7,0.004,20.79";
    const std::string total = "*DEFINE_CURVE\n20\n0,2\n0.5,4\n0.5,1\n1,0\n";
    const auto deck = [&](const char* nitrogen, const char* helium) {
        return total + "*DEFINE_CURVE\n21\n" + nitrogen + "*DEFINE_CURVE\n22\n" + helium +
               bag.deck();
    };
    const Model model = folder.read(deck("0,0.2\n0.4,0.8\n1,0.8\n", "0,0.8\n0.4,0.2\n1,0.2\n"));
    const gas::BagCard& card = model.bags.at(0);
    const Curve& a = model.curves[card.inflow.at(0).mass_rate];
    const Curve& b = model.curves[card.inflow.at(1).mass_rate];
    const Curve all{20, {0.0, 0.5, 0.5, 1.0}, {2.0, 4.0, 1.0, 0.0}};
    for (const double t : {0.0, 0.01, 0.123, 0.3, 0.4, 0.49999, 0.50001, 0.7, 1.0}) {
        CAPTURE(t);
        const double x = 0.2 + 0.6 * std::min(t / 0.4, 1.0);
        const double share = x * 0.028 / (x * 0.028 + (1.0 - x) * 0.004);
        CHECK(a(t) + b(t) == Approx(all(t)).margin(1e-12));
        CHECK(a(t) == Approx(share * all(t)).epsilon(2e-3));
    }
    CHECK(a.integral_to(1.0) + b.integral_to(1.0) == Approx(all.integral_to(1.0)).epsilon(1e-12));

    const auto faults = folder.faults(deck("0,0.2\n1,0.8\n", "0,0.8\n1,0.8\n"));
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0], "has mole fractions that add up to"));
    CHECK(contains(faults[0], "expected 1"));
}
