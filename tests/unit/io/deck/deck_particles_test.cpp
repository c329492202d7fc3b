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

TEST_CASE("the collision model is chosen by -D or by *PARAMETER", "[io]") {
    const DeckFolder folder;
    const std::string deck = Bag{}.deck();
    CHECK_FALSE(folder.read(deck).bags.at(0).collision);
    CHECK(folder.read(deck, {{{"collision", "pairs"}}}).bags.at(0).collision ==
          gas::CollisionModel::PAIRS);
    CHECK(folder.read("*PARAMETER\nC COLLISION, Pairs\n" + deck).bags.at(0).collision ==
          gas::CollisionModel::PAIRS);
    CHECK(folder.read("*PARAMETER\nC COLLISION, Pairs\n" + deck, {{{"COLLISION", "lin"}}})
              .bags.at(0)
              .collision == gas::CollisionModel::LIN);
    CHECK(any_contains(folder.read(deck, {{{"collision", "pairs"}}}).notes, "collide by pairs"));
    const auto faults = folder.faults(deck, {{{"COLLISION", "sph"}}});
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0], "COLLISION = sph, expected one of lin"));
}

TEST_CASE("a mean free path is for collision models that have one", "[io]") {
    const DeckFolder folder;
    const std::string deck = Bag{}.deck();
    const auto bag =
        folder.read(deck, {{{"COLLISION", "ntc"}, {"MEAN_FREE_PATH", "5e-3"}}}).bags.at(0);
    CHECK(bag.collision == gas::CollisionModel::NTC);
    CHECK(bag.mean_free_path == 5e-3);
    CHECK(std::isnan(folder.read(deck, {{{"COLLISION", "spheres"}}}).bags.at(0).mean_free_path));
    CHECK(
        contains(folder.faults(deck, {{{"MEAN_FREE_PATH", "5e-3"}}}).at(0), "expected COLLISION"));
    CHECK(contains(folder.faults(deck, {{{"COLLISION", "ntc"}, {"MEAN_FREE_PATH", "0"}}}).at(0),
                   "expected a length > 0"));
}

TEST_CASE("AIRBAG_PARTICLE: inner parts do not close the bag", "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.card_1 = "12,1,2,0";
    const std::string set = "*SET_PART_LIST\n12\n1,2\n";
    std::string deck = bag.deck();
    deck.insert(deck.find("*AIRBAG"), set);
    const Model model = folder.read(deck);
    CHECK(model.bags.at(0).external_parts == std::vector<Index>{0});
    CHECK(model.bags.at(0).internal_parts == std::vector<Index>{1});
    bag.card_1 = "1,0,1";
    CHECK(contains(only_fault(folder, bag), "expected internal parts that leave some part"));
}

TEST_CASE("AIRBAG_PARTICLE: orifices at nodes and shells, with vectors and cones", "[io]") {
    const DeckFolder folder;
    const std::string vector = "*DEFINE_VECTOR\n3,0,0,0,0,0,5\n";
    const auto read = [&](const std::string& row, const io::DeckOptions& options = {}) {
        Bag bag;
        bag.orifice = row;
        return folder.read(bag.deck().insert(bag.deck().find("*AIRBAG"), vector), options);
    };
    const auto orifice = [&](const std::string& row) {
        return read(row).bags.at(0).orifices.at(0);
    };
    CHECK(orifice("5,2.5,3").direction == Vec3::UnitZ());
    CHECK(orifice("5,2.5,3").weight == 2.5);
    CHECK(orifice("13,1.0,-1").shell == 2);
    CHECK(orifice("13,1.0,-1").normal_sign == 1.0);
    CHECK(orifice("13,1.0,-2").normal_sign == -1.0);
    CHECK(orifice("13,1.0,-3\n0").normal_sign == 1.0);
    CHECK(orifice("5,1.0,3,20.0,1,0,1").cone == Approx(20.0 * DEGREE));
    CHECK(orifice("5,1.0,3,20.0").cone == Approx(30.0 * DEGREE));
    CHECK(any_contains(read("5,1.0,3,20.0").warnings, "does not count without IANG = 1"));
    CHECK(any_contains(read("5,1.0,3,20.0,1,0,1").warnings,
                       "read in degrees, as the cone's half angle"));
    CHECK(any_contains(read("5,1.0,3,0.5,1,0,1").warnings, "looks like radians"));
    const Model notes = read("5,1.0,3,0.5", {{{"DIALECT", "2007"}}});
    CHECK(notes.bags.at(0).orifices.at(0).cone == 0.5);
    CHECK(any_contains(notes.warnings, "read in radians"));
}

TEST_CASE("AIRBAG_PARTICLE: the 2007 dialect, by -D or by *PARAMETER", "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.card_1 = "1,0,0,0,0,0.5";  // HCONV, today NPDATA
    const io::DeckOptions notes{{{"DIALECT", "2007"}}};
    CHECK(folder.read(bag.deck(), notes).bags.at(0).heat.at(0).coefficient == 0.5);
    CHECK(contains(only_fault(folder, bag), "(NPDATA) = 0.5, expected"));
    bag.card_1 = "1";
    bag.card_2 = "10000,1";  // VISFLG blank: no particles in 2007
    CHECK_FALSE(folder.read(bag.deck(), notes).bags.at(0).show_particles);
    CHECK_FALSE(
        folder.read("*PARAMETER\nI DIALECT, 2007\n" + bag.deck()).bags.at(0).show_particles);
    CHECK(folder.read("*PARAMETER\nC DIALECT, 2007\n" + bag.deck()).bags.at(0).is_of_2007);
    CHECK(any_contains(folder.faults("*PARAMETER\nC DIALECT, new\n" + bag.deck()),
                       "DIALECT, expected 2007"));
    CHECK(folder.read(bag.deck()).bags.at(0).show_particles);
    CHECK(folder.read(bag.deck(), notes).bags.at(0).is_of_2007);
    CHECK(any_contains(folder.read(bag.deck(), notes).notes, "2007 course notes"));
    CHECK(any_contains(folder.read(bag.deck()).notes, "today's meaning"));
    CHECK(folder.faults(bag.deck(), {{{"DIALECT", "2008"}}}).size() == 1);
}

TEST_CASE("AIRBAG_PARTICLE: gases and orifices of inflators belong together", "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.card_3 = "0,2,2";
    bag.gas = "7,7,0.028,28.0,0,0,1\n7,7,0.028,28.0,0,0,2";
    bag.orifice = "5,1.0,0,0,1\n6,1.0,0,0,2";
    CHECK(folder.read(bag.deck()).bags.at(0).orifices.at(1).inflator == 2);
    bag.orifice = "5,1.0,0,0,1\n6,1.0,0,0,1";
    CHECK(contains(only_fault(folder, bag), "has a gas of inflator INFG = 2"));
    bag.orifice = "5,1.0,0,0,1\n6,1.0,0,0,2\n";
    bag.gas = "7,7,0.028,28.0\n7,7,0.028,28.0";
    CHECK(contains(only_fault(folder, bag), "has a nozzle of inflator INFO = 2"));
    bag = {};
    bag.card_3 = "0,1,0", bag.orifice = "";
    CHECK(contains(only_fault(folder, bag), "(NORIF) = 0, expected >= 1"));
    bag.card_3 = "0,0,0", bag.gas = "";
    CHECK(contains(only_fault(folder, bag), "this bag has no gas"));
    bag = {};
    bag.card_3 = "0,1,2";
    CHECK(contains(only_fault(folder, bag), "ends before its card 6, expected NID AN VD CA INFO"));
}

TEST_CASE("AIRBAG_PARTICLE: initial air as a gas, as particles, with ambient air behind it",
          "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.rows = "0,0,0.029,29.,0,0,500\n";
    bag.card_3 = "-1,1,1";
    CHECK(folder.read(bag.deck()).bags.at(0).air->flows_in);
    CHECK_FALSE(folder.read(bag.deck()).bags.at(0).air->is_particles);
    bag.card_3 = "2,1,1";
    CHECK(folder.read(bag.deck()).bags.at(0).air->is_particles);
    CHECK(folder.read(bag.deck()).bags.at(0).air->particles == 500);
    bag.rows = "0,0,0.029,29.,0,0,500,-1\n";
    CHECK(contains(only_fault(folder, bag), "(NPRLX) = -1, expected >= 0"));
    bag.card_3 = "4,1,1";
    CHECK(folder.read(bag.deck()).bags.at(0).air->is_particles);
}

TEST_CASE("AIRBAG_PARTICLE: orifices without areas have the same, and VISFLG = 0 is told", "[io]") {
    const DeckFolder folder;
    Bag bag;
    bag.card_3 = "0,1,2";
    const auto weights = [&](const std::string& first, const std::string& second) {
        bag.orifice = "5," + first + "\n4," + second;
        std::vector<double> all;
        const Model model = folder.read(bag.deck());
        for (const gas::OrificeCard& nozzle : model.bags.at(0).orifices)
            all.push_back(nozzle.weight);
        return all;
    };
    CHECK(weights("", "0.0") == std::vector<double>{1.0, 1.0});
    CHECK(weights("2.0", "3.0") == std::vector<double>{2.0, 3.0});
    bag.orifice = "5,1.0\n4,0.0";
    CHECK(contains(only_fault(folder, bag), "(AN) = 0.0, expected > 0, as the first orifice"));
    bag.orifice = "5\n4,1.0";
    CHECK(contains(only_fault(folder, bag), "(AN) = 1.0, expected 0 or blank, as the first"));
    bag = {};
    bag.card_2 = "10000,1,0";
    const Model model = folder.read(bag.deck());
    CHECK_FALSE(model.bags.at(0).show_particles);
    CHECK(any_contains(model.notes, "(VISFLG) = 0: no particles are in the frames"));
}

TEST_CASE("the smallest public CPM block is read", "[io]") {
    const DeckFolder folder;
    const gas::BagCard bag =
        folder
            .read(small_deck(
                "*AIRBAG_PARTICLE\n"
                "         1         0         0         0         0         0       0.0         0\n"
                "      2000         0         2     293.01.00000E-4         01.00000E101.00000E10\n"
                "         2         0         0         0         0         0         0       0.0\n"
                "1.00000E-4     293.0     0.035      26.77.00000E-4-1.0000E-6         00\n"))
            .bags.at(0);
    CHECK(bag.particles == 2000);
    CHECK(bag.inflow.empty());
    REQUIRE(bag.air);
    CHECK(bag.air->is_particles);
    CHECK(bag.air->pressure == 1e-4);
    CHECK(bag.air->species.B == 7e-4);
    CHECK(bag.air->species.C == -1e-6);
}

TEST_CASE("DEFINE_CPM_GAS_PROPERTIES: a molar mass below 0 names one", "[io]") {
    const DeckFolder folder;
    const auto deck = [](const std::string& gas, const std::string& rows = "") {
        return small_deck("*AIRBAG_PARTICLE\n1\n1000,1,1\n1,1,1\n1e5,293,-9\n7,7,-9,1,1\n5,1.0\n" +
                          ("*DEFINE_CPM_GAS_PROPERTIES" + gas) + "\n" + rows);
    };
    const gas::BagCard bag = folder.read(deck("_TITLE\nair\n9,0.029,27.0,7e-3,-1e-6")).bags.at(0);
    for (const gas::SpeciesCard& gas : {bag.inflow.at(0).species, bag.air->species}) {
        CHECK(gas.molar_mass == 0.029);
        CHECK(gas.A == 27.0);
        CHECK(gas.B == 7e-3);
        CHECK(gas.C == -1e-6);
    }
    const Model fitted = folder.read(deck("\n9,0.028,28.9,-1.571e-3,8.081e-6,-2.873e-9"));
    const gas::SpeciesCard& nitrogen = fitted.bags.at(0).inflow.at(0).species;
    for (const double T : {300.0, 600.0, 1000.0}) {
        const double cp = 28.9 - 1.571e-3 * T + 8.081e-6 * T * T - 2.873e-9 * T * T * T;
        CHECK(nitrogen.A + nitrogen.B * T + nitrogen.C * T * T == Approx(cp).epsilon(0.01));
    }
    CHECK(any_contains(fitted.warnings, "(XM) = -9: its Cp of fourth order is taken as"));
    CHECK(any_contains(fitted.warnings, "(XMAIR) = -9: its Cp of fourth order is taken as"));
}

TEST_CASE("DEFINE_CPM_GAS_PROPERTIES: fields that nothing acts on refuse what refers to it",
          "[io]") {
    const DeckFolder folder;
    const auto deck = [](const std::string& mass, const std::string& gas) {
        return small_deck("*AIRBAG_PARTICLE\n1\n1000,1,1\n0,1,1\n7,7," + mass + ",28\n5,1.0\n" +
                          "*DEFINE_CPM_GAS_PROPERTIES\n" + gas + "\n");
    };
    const auto fault = [&](const std::string& mass, const std::string& gas) {
        const auto faults = folder.faults(deck(mass, gas));
        CAPTURE(faults);
        REQUIRE(faults.size() == 1);
        return faults[0];
    };
    CHECK(contains(fault("-8", "9,0.029,27.0"),
                   "deck.k:34: *AIRBAG_PARTICLE card 4, field 3 (XM) = -8, expected > 0, or minus "
                   "the id of a *DEFINE_CPM_GAS_PROPERTIES of the deck"));
    CHECK(contains(fault("-9", "9,0.029,27.0\n1e-3,0,0,0,0,0,2.0"),
                   "a *DEFINE_CPM_GAS_PROPERTIES without MUT0, VINI, on which nothing acts"));
    CHECK(contains(fault("-9", "9,0.029,27.0,0,0,0,1e-9"), "(XM) = -9, expected a Cp of fourth"));
    CHECK(contains(fault("-9", "9,-0.029,27.0"), "(XMM) = -0.029, expected > 0"));
    const Model unused = folder.read(deck("0.028", "9,0.029,27.0\n1e-3"));
    CHECK(any_contains(unused.warnings, "(MUT0) = 1e-3: this is not acted on"));
}
