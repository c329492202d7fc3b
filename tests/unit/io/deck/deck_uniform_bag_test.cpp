// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

const std::string SET = "*SET_PART_LIST\n12\n1,2\n";

std::string only_fault(const DeckFolder& folder, const std::string& text) {
    const auto faults = folder.faults(text);
    CAPTURE(faults);
    REQUIRE(faults.size() == 1);
    return faults[0];
}

}  // namespace

TEST_CASE("AIRBAG_SIMPLE_AIRBAG_MODEL: cards and defaults", "[io]") {
    const DeckFolder folder;
    const auto deck = [](const std::string& first, const std::string& second,
                         const std::string& third = "") {
        return small_deck(SET + "*AIRBAG_SIMPLE_AIRBAG_MODEL\n" + first + "\n" + second + "\n" +
                          third);
    };
    const auto bag =
        folder.read(deck("12,1", "713,1000,780,7,0.7,3e-4,1e5,1.2")).uniform_bags.at(0);
    CHECK(bag.id == 1);
    CHECK(bag.shells == std::vector<Index>{0, 1, 2});
    CHECK(bag.volume_scale == 1.0);
    CHECK(bag.pressure_scale == 1.0);
    CHECK(bag.volume_taken == 0.0);
    CHECK(bag.cv == 713.0);
    CHECK(bag.cp == 1000.0);
    CHECK(bag.temperature.value == 780.0);
    CHECK(bag.mass_rate == 0);
    CHECK(bag.exits.at(0).coefficient.value == 0.7);
    CHECK(bag.exits[0].area.value == 3e-4);
    CHECK(bag.exits[0].area.curve == -1);
    CHECK(bag.exit_rate == -1);
    CHECK(bag.p_atm == 1e5);
    CHECK(bag.density == 1.2);

    const auto curves =
        folder.read(deck("12,1,0,2.0,1.5,0.1", "713,1000,780,7,-7,-7,1e5,1.2", "7\n"))
            .uniform_bags.at(0);
    CHECK(curves.volume_scale == 2.0);
    CHECK(curves.pressure_scale == 1.5);
    CHECK(curves.volume_taken == 0.1);
    CHECK(curves.exits.at(0).coefficient.curve == 0);
    CHECK(curves.exits[0].area.curve == 0);
    CHECK(curves.exit_rate == 0);

    const auto molar =
        folder.read(deck("12,1", "0,0,780,7,0.7,3e-4,1e5,1.2", "0,300,26.0,0.01,0.028,8.314\n"))
            .uniform_bags.at(0);
    CHECK(molar.cp == Approx(29.0 / 0.028));
    CHECK(molar.cp - molar.cv == Approx(8.314 / 0.028));

    CHECK(contains(only_fault(folder, deck("12,1", "713,700,780,7,0.7,3e-4,1e5,1.2")),
                   "(CP) = 700, expected more than CV"));
    CHECK(contains(only_fault(folder, deck("12,1,5", "713,1000,780,7,0.7,3e-4,1e5,1.2")),
                   "(RBID) = 5, expected 0 or blank"));
    CHECK(contains(only_fault(folder, deck("12,1,0,0,0,0,0.1", "713,1000,780,7,0,0,1e5,1.2")),
                   "(MWD) = 0.1, expected 0 or blank"));
    CHECK(contains(only_fault(folder, deck("12,1", "713,1000,780,7,0.7,-99,1e5,1.2")),
                   "(AREA) = -99, expected >= 0, or minus the id"));
}

TEST_CASE("a control volume's segment set names shells, in any order of nodes", "[io]") {
    const DeckFolder folder;
    const std::string cards = "*AIRBAG_SIMPLE_AIRBAG_MODEL\n3\n713,1000,780,7,0.7,3e-4,1e5,1.2\n";
    const std::string set = "*SET_SEGMENT\n3\n3,1,2,2\n6,3,2,5\n";
    CHECK(folder.read(small_deck(set + cards)).uniform_bags.at(0).shells ==
          std::vector<Index>{0, 2});
    const std::string other = "*SET_SEGMENT\n3\n3,1,2,2\n1,2,3,4\n";
    CHECK(contains(only_fault(folder, small_deck(other + cards)),
                   "(SID) = 3, expected segments that lie on shells: 1 of this set do not"));
}

TEST_CASE("exits beside a curve of mass flow out are said not to count", "[io]") {
    const DeckFolder folder;
    const std::string words = "has a curve of mass flow out (LOU, LCEFR)";
    const auto is_told = [&](const std::string& text) {
        const auto warnings = folder.read(small_deck(SET + text)).warnings;
        return std::any_of(warnings.begin(), warnings.end(),
                           [&](const std::string& line) { return contains(line, words); });
    };
    const auto simple = [&](const std::string& area, const std::string& curve) {
        return is_told("*AIRBAG_SIMPLE_AIRBAG_MODEL\n12,1\n713,1000,780,7,0.7," + area +
                       ",1e5,1.2\n" + curve + "\n");
    };
    CHECK(simple("3e-4", "7"));
    CHECK_FALSE(simple("0.0", "7"));
    CHECK_FALSE(simple("3e-4", "0"));
    const auto wang_nefske = [&](const std::string& exits, const std::string& curve) {
        return is_told("*AIRBAG_WANG_NEFSKE\n12,1\n713,1000,0,7,7\n" + exits + "\n1e5,1.2,1," +
                       curve + "\n");
    };
    CHECK(wang_nefske("0.6,0,1e-3,0,0,0,0,0", "7"));
    CHECK(wang_nefske("0,0,0,0,0.4,0,2e-3,0", "7"));
    CHECK_FALSE(wang_nefske("0,0,0,0,0,0,0,0", "7"));
    CHECK_FALSE(wang_nefske("0.6,0,1e-3,0,0,0,0,0", "0"));
}

TEST_CASE("AIRBAG_WANG_NEFSKE: cards, and what is not acted on is refused", "[io]") {
    const DeckFolder folder;
    struct {
        std::string a = "713,1000,0,7,7", b = "0.6,7,1e-3,0,0.4,0,2e-3,7",
                    c = "1e5,1.2,1,0,5e3,1e4", d;
        [[nodiscard]] std::string text() const {
            return small_deck(SET + "*AIRBAG_WANG_NEFSKE_ID\n4,left\n12,1\n" + a + "\n" + b + "\n" +
                              c + "\n" + d);
        }
    } deck;
    const auto bag = folder.read(deck.text()).uniform_bags.at(0);
    CHECK(bag.id == 4);
    CHECK(bag.title == "left");
    CHECK(bag.temperature.curve == 0);
    CHECK(bag.exits.at(0).coefficient.curve == 0);
    CHECK(bag.exits[0].area.value == 1e-3);
    CHECK(bag.exits.at(1).coefficient.value == 0.4);
    CHECK(bag.exits[1].area.curve == 0);
    CHECK(bag.overpressure == 5e3);
    CHECK(bag.opens_at == 1e4);

    auto other = deck;
    other.a = "713,1000,300,0,7,2.0";
    CHECK(contains(only_fault(folder, other.text()), "(TVOL) = 2.0, expected 0 or blank"));
    other = deck, other.a = "713,1000,300,0,0";
    CHECK(contains(only_fault(folder, other.text()), "(LCMT)"));
    other = deck, other.b = "0.6,0,-3";
    CHECK(contains(only_fault(folder, other.text()), "(A23) = -3, expected >= 0, or minus the id"));
    other = deck, other.b = "0.6,0,-2";
    CHECK(folder.read(other.text()).uniform_bags.at(0).exits.at(0).facets.size() == 1);
    other = deck, other.c = "1e5,1.2,9.81";
    CHECK(contains(only_fault(folder, other.text()), "(GC) = 9.81, expected 0 or 1"));
    other = deck, other.c = "1e5,1.2,1,0,0,0,9";
    CHECK(contains(only_fault(folder, other.text()), "(OPT) = 9, expected 0 or 1 or 2"));
    other = deck, other.a = "0,0,0,7,7", other.d = "300,26,0.01,0.028,8.314\n";
    CHECK(folder.read(other.text()).uniform_bags.at(0).cp == Approx(29.0 / 0.028));
}
