// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// A bag of parts 1 and 2 with BLOCK, NPDATA, NVENT as given, their rows, and more keywords before.
std::string vented(const std::string& more, const std::string& rows, int vents, int parts = 0,
                   int block = 0, const std::string& inner = "") {
    const std::string set = "*SET_PART_LIST\n12\n1,2\n*SET_PART_LIST\n2\n2\n";
    return small_deck(set + more + "*AIRBAG_PARTICLE\n12,1," + inner +
                      (inner.empty() ? ",," : ",0,") + std::to_string(block) + "," +
                      std::to_string(parts) + "\n1000,1,1,0,0," + std::to_string(vents) +
                      "\n0,1,1\n" + rows + "7,7,0.028,28.0\n5,1.0\n");
}

std::string only(const std::vector<std::string>& faults) {
    CAPTURE(faults);
    REQUIRE(faults.size() == 1);
    return faults[0];
}

std::string cloth(const std::string& leaks, const std::string& card_4 = ",") {
    return "*MAT_FABRIC\n2,700.,1.e8\n,\n" + leaks + "\n" + card_4 + "\n,\n";
}
std::string of_cloth(std::string deck) {
    deck.replace(deck.find("cloth\n1,1,1"), 11, "cloth\n1,1,2");
    return deck;
}

}  // namespace

TEST_CASE("AIRBAG_PARTICLE: a vent row is one vent, or one for each part of its set", "[io]") {
    const DeckFolder folder;
    const auto vents = [&](const std::string& row) {
        return folder.read(vented("", row + "\n", 1)).bags.at(0).vents;
    };
    const auto one = vents("2,0,0.7,7,7,1,5000.");
    REQUIRE(one.size() == 1);
    CHECK(one[0].parts == std::vector<Index>{1});
    CHECK(one[0].coefficient == 0.7);
    CHECK(one[0].time_curve == 0);
    CHECK(one[0].pressure_curve == 0);
    CHECK(one[0].is_isentropic);
    CHECK(one[0].opens_at == 5000.0);

    const auto each = vents("12,1");
    REQUIRE(each.size() == 2);
    CHECK(each[1].parts == std::vector<Index>{1});
    CHECK(each[0].coefficient == 1.0);
    CHECK_FALSE(each[0].is_isentropic);
    CHECK(vents("12,2").at(0).parts == std::vector<Index>{0, 1});
    CHECK(vents("2,0,1.4").at(0).coefficient == 1.4);
}

TEST_CASE("AIRBAG_PARTICLE: vents that make no sense are faults", "[io]") {
    const DeckFolder folder;
    const auto fault = [&](const std::string& row, const std::string& inner = "") {
        return only(folder.faults(vented("", row + "\n", 1, 0, 0, inner)));
    };
    CHECK(contains(fault("3,0"), "(SID3) = 3"));
    CHECK(contains(fault("2,0,1.0,99"), "(LCTC23) = 99"));
    CHECK(contains(fault("2,0,1.0,,-7"), "(LCPC23) = -7"));
    CHECK(contains(fault("2,0,1.0,,,3"), "(ENH_V) = 3, expected 0 or 1 or 2"));
    CHECK(contains(fault("2,0,-5"),
                   "(C23) = -5, expected >= 0, or minus the id of a *DEFINE_CPM_VENT"));
    CHECK(contains(fault("12,1,1.0,,,1", "2"), "(ENH_V) = 1, expected 0, or a set of only"));
}

TEST_CASE("AIRBAG_PARTICLE: an internal vent is a plain hole whatever ENH_V", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(vented("", "2,0,0.8,,,2\n", 1, 0, 0, "2"));
    CHECK_FALSE(model.bags.at(0).vents.at(0).is_isentropic);
    CHECK(any_contains(model.warnings, "(ENH_V) = 2: a vent of internal parts passes gas both"));
}

TEST_CASE("AIRBAG_PARTICLE: friction by number or curve, for all parts or some", "[io]") {
    const DeckFolder folder;
    const std::string curve = "*DEFINE_CURVE\n9\n0.,0.5\n1e5,-0.25\n";
    const auto with = [&](const std::string& fric, const std::string& pfric) {
        std::string deck = vented(curve, "1,0,," + pfric + "\n", 0, 1);
        const std::string card = "12,1,,,0,1\n";
        deck.replace(deck.find(card), card.size(), "12,1,,,0,1," + fric + "\n");
        return deck;
    };
    const gas::BagCard bag = folder.read(with("-0.1", "-9")).bags.at(0);
    REQUIRE(bag.friction.size() == 2);
    CHECK(bag.friction[0].parts.empty());
    CHECK(bag.friction[0].factor == -0.1);
    CHECK(any_contains(folder.read(with("-0.1", "-9")).warnings, "(FRIC) = -0.1: below 0"));
    CHECK_FALSE(any_contains(folder.read(with("0.1", "-9")).warnings, "(FRIC)"));
    CHECK(any_contains(folder.read(with("0.1", "-9")).warnings,
                       "(PFRIC) = -9: a curve down to -0.25: gas at rest begins to move"));
    CHECK(bag.friction[1].parts == std::vector<Index>{0});
    CHECK(bag.friction[1].curve >= 0);
    CHECK(contains(only(folder.faults(with("2", "0"))), "(FRIC) = 2, expected above -1 to 1"));
    CHECK(contains(only(folder.faults(with("-8", "0"))), "(FRIC) = -8"));
    CHECK(contains(only(folder.faults(with("0", "-1.5"))), "(PFRIC) = -1.5"));
    CHECK(folder.read(with("1", "0")).bags.at(0).friction.size() == 1);
}

TEST_CASE("DEFINE_CPM_VENT: C23 < 0 of a vent row names one, wherever it stands", "[io]") {
    const DeckFolder folder;
    const auto read = [&](const std::string& cards, const std::string& suffix = "\n") {
        return vented("*DEFINE_CPM_VENT" + suffix + cards, "2,0,-8\n", 1);
    };
    const gas::VentCard vent = folder.read(read("8,0.9,7,,1,200.,0.5\n")).bags.at(0).vents.at(0);
    CHECK(vent.coefficient == 0.9);
    CHECK(vent.time_curve == 0);
    CHECK(vent.is_isentropic);
    CHECK(vent.opens_at == 200.0);
    CHECK(vent.uniform_factor == 0.5);
    CHECK(vent.parts == std::vector<Index>{1});
    CHECK(folder.read(read("8,0.9\n", "_TITLE\nvent\n")).bags.at(0).vents.at(0).coefficient == 0.9);
    CHECK(contains(only(folder.faults(read("8,0.9,,,1,,,100\n"))), "(IOPT) = 100"));
    CHECK(contains(only(folder.faults(read("8,0.9\n,,,,1\n"))), "(PID1) = 1"));
}

TEST_CASE("AIRBAG_PARTICLE: NPDATA rows cool the gas", "[io]") {
    const DeckFolder folder;
    const auto heat = folder.read(vented("", "1,0,25.0\n12,1,-7\n", 0, 2)).bags.at(0).heat;
    REQUIRE(heat.size() == 2);
    CHECK(heat[0].parts == std::vector<Index>{0});
    CHECK(heat[0].coefficient == 25.0);
    CHECK(heat[1].parts == std::vector<Index>{0, 1});
    CHECK(heat[1].curve == 0);
    const auto fault = [&](const std::string& row) {
        return only(folder.faults(vented("", row + "\n", 0, 1)));
    };
    CHECK(contains(fault("1,0,25.0,1.1"), "(PFRIC) = 1.1"));
    CHECK(contains(fault("1,0,25.0,,,,1"), "(INIP) = 1"));
    CHECK(contains(fault("1,2,25.0"), "(HCONV) = 25.0, expected the id of a *DEFINE_CPM_NPDATA"));
}

TEST_CASE("DEFINE_CPM_NPDATA: STYPEH 2 and 3 name one, wherever it stands", "[io]") {
    const DeckFolder folder;
    const auto read = [&](const std::string& cards, const std::string& rows) {
        return vented("*DEFINE_CPM_NPDATA\n" + cards, rows, 0, 2);
    };
    const gas::BagCard bag = folder.read(read("8,25.0,0.3\n", "1,2,8\n12,3,8\n")).bags.at(0);
    REQUIRE(bag.heat.size() == 2);
    CHECK(bag.heat[0].parts == std::vector<Index>{0});
    CHECK(bag.heat[0].coefficient == 25.0);
    CHECK(bag.heat[1].parts == std::vector<Index>{0, 1});
    REQUIRE(bag.friction.size() == 2);
    CHECK(bag.friction[0].factor == 0.3);
    CHECK(bag.friction[1].parts == std::vector<Index>{0, 1});
    CHECK(folder.read(read("8,25.0\n", "1,0,5.0\n1,0,5.0\n")).bags.at(0).heat.size() == 2);
    CHECK(contains(only(folder.faults(read("8,25.0,,,,1\n", "1,2,8\n1,2,8\n"))), "(INIP) = 1"));
    CHECK(contains(only(folder.faults(read("8,25.0\n,1\n", "1,2,8\n1,2,8\n"))), "(CDEXT) = 1"));
}

TEST_CASE("AIRBAG_PARTICLE: BLOCK says which holes contact closes", "[io]") {
    const DeckFolder folder;
    const auto block = [&](int code) {
        return folder.read(vented("", "", 0, 0, code)).bags.at(0).block;
    };
    CHECK_FALSE(block(0).any());
    CHECK((block(1).fabric && block(1).external_vents && block(1).internal_vents));
    CHECK((block(2).fabric && !block(2).external_vents && block(2).internal_vents));
    CHECK((block(3).fabric && block(3).external_vents && !block(3).internal_vents));
    CHECK((block(4).fabric && !block(4).external_vents && !block(4).internal_vents));
    CHECK_FALSE(block(10).any());
    CHECK((block(20).by_pressure && !block(20).fabric && !block(20).external_vents));
    CHECK((block(21).by_pressure && block(21).fabric && block(21).external_vents));
    CHECK_FALSE(block(14).by_pressure);
}

TEST_CASE("AIRBAG_PARTICLE: fabric that leaks", "[io]") {
    const DeckFolder folder;
    const auto read = [&](const std::string& cloth_cards) {
        return of_cloth(vented(cloth_cards, "", 0));
    };
    const auto card = [&](const std::string& cloth_cards) {
        return std::get<fabric::FabricCard>(folder.read(read(cloth_cards)).materials.back().card);
    };
    SECTION("FLC and FAC, numbers and curves") {
        const auto numbers = card(cloth(",0.1,1.5,0.25,,,7"));
        CHECK(numbers.leaks());
        CHECK(numbers.leak_area == 0.1);
        CHECK(numbers.leak_velocity == 1.5);
        CHECK(numbers.leak_when_blocked == 0.25);
        CHECK_FALSE(numbers.leak_by_component);
        const auto curves = card(cloth(",-7,-7,,,,8", ",,1"));
        CHECK(curves.leak_area_curve == 0);
        CHECK(curves.leak_velocity_curve == 0);
        CHECK(curves.leak_from_reference);
        CHECK_FALSE(card(cloth(",0.1,0,,,,7")).leaks());
    }
    SECTION("other options are refused, a blank one is said to be 7") {
        for (const char* known : {",0.1,1.5,,,,3", ",0.1,-7,,,,4", ",0.1,1.5,,,,6"})
            CHECK(folder.faults(read(cloth(known))).empty());
        CHECK(folder.faults(read(cloth(",0.1,0.02,,,,1"))).empty());
        CHECK(folder.faults(read(cloth(",0.1,-7,,,,2"))).empty());
        CHECK(folder.faults(read(cloth(",0,0,,,,3"))).empty());  // it does not leak
        CHECK(any_contains(folder.read(read(cloth(",0.1,1.5"))).warnings, "FVOPT blank"));
    }
    SECTION("with X0, FLC and FAC are X2 and X3") {
        const auto grown = card(cloth(",0.3,0.4,,,,1", ",,1,,,,0.1,0.2"));
        REQUIRE(grown.leak_growth);
        CHECK(*grown.leak_growth == std::array<double, 4>{0.1, 0.2, 0.3, 0.4});
        CHECK(contains(only(folder.faults(read(cloth(",,,,,,7", ",,,,,,0.1")))), "FVOPT = 7"));
        CHECK(contains(only(folder.faults(read(cloth(",,,,,,1", ",,,,,,-1.0")))), "X0 = -1"));
        CHECK(
            contains(only(folder.faults(read(cloth(",0.1,1,,,,7", ",,,,,,,0.5")))), "(X1) = 0.5"));
    }
}

TEST_CASE("AIRBAG_PARTICLE: in the 2007 dialect a leak curve is over the component's pressure",
          "[io]") {
    const DeckFolder folder;
    const io::DeckOptions notes{{{"DIALECT", "2007"}}};
    std::string deck = of_cloth(vented(cloth(",0.1,-7,,,,7"), "", 0));
    const Model model = folder.read(deck, notes);
    CHECK(std::get<fabric::FabricCard>(model.materials.back().card).leak_by_component);
}

TEST_CASE("DEFINE_CPM_CHAMBER: a chamber closes with its sets and its holes", "[io]") {
    const DeckFolder folder;
    const auto deck = [&](const std::string& cards, const std::string& suffix = "\n") {
        std::string text = vented("*DEFINE_CPM_CHAMBER" + suffix + cards, "", 0);
        const std::string counts = "\n0,1,1\n";
        text.replace(text.find(counts), counts.size(), "\n0,1,1,0,0,0,3\n");
        return text;
    };
    const auto chambers =
        folder.read(deck("3,2\n12,0,0,31\n0,2,1,32\n1,0,31\n")).bags.at(0).chambers;
    REQUIRE(chambers.size() == 2);
    CHECK(chambers[0].id == 31);
    CHECK(chambers[0].parts == std::vector<Index>{0, 1});
    CHECK(chambers[1].parts == std::vector<Index>{1, 0});
    const auto titled = folder.read(deck("3,1\n12,0,0,31\n", "_TITLE\ntwo rooms\n"));
    CHECK(titled.bags.at(0).chambers.at(0).id == 31);
    const auto of_sum = folder.read(deck("3,1\n13,0,0,31\n*SET_PART_ADD\n13\n12\n"));
    CHECK(of_sum.bags.at(0).chambers.at(0).parts == std::vector<Index>{0, 1});
    CHECK(contains(only(folder.faults(deck("3,1\n2,0,1,31\n1,0,33\n"))), "TOCHM = 33"));
    CHECK(contains(only(folder.faults(deck("3,2\n2,0,0,31\n2,0,0,31\n"))), "CHM_ID = 31"));
    CHECK(contains(only(folder.faults(deck("4,1\n2,0,0,31\n"))), "(CHM) = 3"));
}
