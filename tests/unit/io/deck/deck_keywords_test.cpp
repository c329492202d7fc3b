// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("curves are offset, then scaled", "[io]") {
    const DeckFolder folder;
    const Model model =
        folder.read(small_deck("*DEFINE_CURVE_TITLE\nmass flow\n"
                               "         3         0       2.0      10.0       1.0      -0.5\n"
                               "                 0.0                 1.0\n"
                               "                 1.0                 2.0\n"));
    const Curve& curve = model.curves.at(1);
    CHECK(curve.id == 3);
    CHECK(curve.x == std::vector<double>{2.0, 4.0});   // 2 (x + 1)
    CHECK(curve.y == std::vector<double>{5.0, 15.0});  // 10 (y - 0.5)
    const auto faults =
        folder.faults(small_deck("*DEFINE_CURVE\n3\n0,1\n1,1\n0.5,1\n*DEFINE_CURVE\n4\n0,1\n"));
    REQUIRE(faults.size() == 2);
    CHECK(contains(faults[0],
                   "deck.k:34: *DEFINE_CURVE card 4, field 1 (A) = 0.5, expected abscissae"));
    CHECK(contains(faults[1], "deck.k:35: *DEFINE_CURVE has too few points"));
}

TEST_CASE("a curve function is the same curve whenever the run ends, as long as it lasts", "[io]") {
    const std::string text = "*DEFINE_CURVE_FUNCTION\n3\nsin(3*TIME)*sqrt(1.5-TIME)\n";
    const DeckFolder folder;
    const auto curve = [&](double end, double until) {
        std::string deck = small_deck(text);
        deck.replace(deck.find("\n1.0\n"), 5, "\n" + std::to_string(end) + "\n");
        io::DeckOptions options;
        options.until = until;
        return folder.read(deck, options).curves.at(1);
    };
    const Curve whole = curve(1.5, 0.0);
    for (const auto& [end, until] : {std::pair(1.0, 0.0), {1.0, 1.3}, {0.7, 1.0}, {1e-5, 0.0}}) {
        const double last = std::max(end, until);
        const Curve some = curve(end, until);
        CAPTURE(end, until, some.x.size());
        REQUIRE(some.x.back() >= last);
        CHECK(std::equal(some.x.begin(), some.x.end(), whole.x.begin()));
        CHECK(std::equal(some.y.begin(), some.y.end(), whole.y.begin()));
        CHECK(some(last) == Approx(std::sin(3 * last) * std::sqrt(1.5 - last)).margin(1e-6));
    }
    CHECK(whole.x.back() == 1.5);  // beyond it the function has no value
    CHECK(contains(only_fault("*DEFINE_CURVE_FUNCTION\n3\nsqrt(0.5-TIME)\n"),
                   "expected arithmetic of TIME"));
}

TEST_CASE("DATTYP of a curve is warned of where it is -2", "[io]") {
    const auto warnings = [](const std::string& type) {
        return read_small("*DEFINE_CURVE\n3,0,1,1,0,0," + type + "\n0,0\n1,1\n").warnings;
    };
    REQUIRE(warnings("-2").size() == 1);
    CHECK(contains(warnings("-2")[0],
                   "deck.k:31: *DEFINE_CURVE card 1, field 7 (DATTYP) = -2: this "
                   "meaning of a fabric's curve is not acted on"));
    for (const char* type : {"0", "1", "-100", ""}) CHECK(warnings(type).empty());
}

TEST_CASE("of control cards that stand twice the last holds, with a warning", "[io]") {
    const DeckFolder folder;
    folder.write("more.k", "*CONTROL_TERMINATION\n3.0\n");
    const Model model =
        folder.read(small_deck("*DATABASE_ABSTAT\n0.1\n*CONTROL_TERMINATION\n2.0\n"
                               "*DATABASE_ABSTAT\n0.2\n*INCLUDE\nmore.k\n"));
    CHECK(model.end_time == 3.0);
    CHECK(model.output.abstat == 0.2);
    REQUIRE(model.warnings.size() == 2);
    CHECK(folder.bare(model.warnings[0]) ==
          "deck.k:34: *DATABASE_ABSTAT again: this one holds, not that of deck.k:30");
    CHECK(folder.bare(model.warnings[1]) ==
          "more.k:1: *CONTROL_TERMINATION again: this one holds, not that of deck.k:24, deck.k:32");
    for (const char* twice : {"*TITLE\nname\n", "*CONTROL_TIMESTEP\n0,0.5\n", "*CONTROL_CPM\n11\n",
                              "*DATABASE_GLSTAT\n0.1\n", "*DATABASE_BINARY_D3PLOT\n0.1\n"}) {
        CAPTURE(twice);
        CHECK(read_small(twice).warnings.empty());
        CHECK(any_contains(read_small(std::string(twice) + twice).warnings,
                           "again: this one holds, not that of"));
    }
    CHECK(read_small("*LOAD_BODY_Z\n7,1.0\n*LOAD_BODY_Z\n7,1.0\n").warnings.empty());
}

TEST_CASE("a section's thickness is the mean of its corners, blank ones like the first", "[io]") {
    const DeckFolder folder;
    std::string deck = small_deck();
    deck.replace(deck.find("0.3\n*MAT"), 3, "0.3,0.5");
    CHECK(folder.read(deck).parts.at(0).thickness == Approx(0.35));
}

TEST_CASE("a shell's own thickness is that of its section, its own angle 0", "[io]") {
    const DeckFolder folder;
    const std::string head = "*ELEMENT_SHELL_THICKNESS\n14,1,2,5,6,6\n";
    for (const char* same : {"0.3,0.3,0.3,0.3\n", "\n", "0.3,0,0,0\n"})
        CHECK(folder.read(small_deck(head + same)).shells.back().id == 14);
    CHECK(contains(folder.faults(small_deck(head + "0.3,0.3,0.4,0.3\n")).at(0), "(THIC3) = 0.4"));
    CHECK(folder.read(small_deck("*ELEMENT_SHELL_BETA\n14,1,2,5,6,6\n,,,,0.0\n")).shells.size() >
          1);
    const auto turned = folder.faults(small_deck("*ELEMENT_SHELL_BETA\n14,1,2,5,6,6\n,,,,30.0\n"));
    CHECK(contains(turned.at(0), "(BETA) = 30.0"));
}

TEST_CASE("shell forms: membranes, shells taken as membranes, and planes that are faults", "[io]") {
    const DeckFolder folder;
    const auto with_form = [&](const std::string& form) {
        std::string deck = small_deck();
        deck.replace(deck.find("1,5\n0.3"), 3, "1," + form);
        return deck;
    };
    CHECK(folder.read(with_form("9")).warnings.empty());
    CHECK(folder.read(with_form("9")).parts.at(0).element_form == 9);
    const Model shell = folder.read(with_form("16"));
    REQUIRE(shell.warnings.size() == 1);
    CHECK(contains(shell.warnings[0], "(ELFORM) = 16: this shell is taken as a membrane"));
    CHECK(folder.faults(with_form("13")).size() == 1);
    CHECK(folder.faults(with_form("-1")).size() == 1);
}

namespace {

std::string fabric_deck(const std::string& elastic, const std::string& shear,
                        const std::string& leak = "0", const std::string& tail = "") {
    return small_deck("*MAT_FABRIC_TITLE\ncloth\n2,7.e-7," + elastic + "\n" + shear + "\n" + leak +
                      "\n0\n0,0,1,0,0,0,30\n" + tail);
}
const fabric::FabricCard& cloth(const Model& model) {
    return std::get<fabric::FabricCard>(model.materials.at(1).card);
}

}  // namespace

TEST_CASE("MAT_FABRIC: orthotropic as written, isotropic when EB is blank", "[io]") {
    const DeckFolder folder;
    const Model ortho =
        folder.read(fabric_deck("0.4,0.3,,0.2", "0.01,,,1,0.05,0.3,0.1,0.05", "3,-7,1.5,,,2,7"));
    CHECK(ortho.materials.at(1).title == "cloth");
    CHECK(cloth(ortho).E_warp == 0.4);
    CHECK(cloth(ortho).E_weft == 0.3);
    CHECK(cloth(ortho).G == 0.01);
    CHECK(cloth(ortho).no_compression);
    CHECK(cloth(ortho).liner_ratio == 0.1);
    CHECK(cloth(ortho).axes == 3);
    CHECK(cloth(ortho).v == Vec3::UnitZ());
    CHECK(cloth(ortho).beta == Approx(std::numbers::pi / 6.0));
    CHECK(cloth(ortho).leak_area_curve == 0);
    CHECK(cloth(ortho).leak_velocity == 1.5);
    CHECK(cloth(ortho).leak_option == 7);

    const Model iso = folder.read(fabric_deck("0.4,,,0.25", "99."));
    CHECK(cloth(iso).E_weft == 0.4);
    CHECK(cloth(iso).G == Approx(0.4 / 2.5));
}

TEST_CASE("MAT_FABRIC: what cannot be, and what is not acted on yet", "[io]") {
    const DeckFolder folder;
    const auto one = [&](const std::string& deck) {
        const auto faults = folder.faults(deck);
        CAPTURE(faults);
        REQUIRE(faults.size() == 1);
        return faults[0];
    };
    CHECK(contains(one(fabric_deck("0.4,0.3", "0")), "(GAB) = 0, expected > 0, for EB is given"));
    CHECK(contains(one(fabric_deck("0.4,0.1,,0.6", "0.01")),
                   "(PRBA) = 0.6, expected PRBA^2 EA / EB < 1"));
    CHECK(contains(one(fabric_deck("-0.4", "0")), "(EA) = -0.4, expected > 0"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,-9")), "(FLC) = -9, expected"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,,24")), "(FORM) = 24, expected"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,2")), "(LNRC) = 2, expected"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,,4", "7,0\n")),
                   "(LCA) = 7, expected a curve through (0, 0)"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,,4", "8\n")), "(LCA) = 8, expected"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,,2", "7,0\n")),
                   "(LCA) = 7, expected 0 or blank"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,,,,7")), "(TSRFAC) = 7, expected below 1"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,,2,,-9")),
                   "(TSRFAC) = -9, expected 0 to 1, or the id of a *DEFINE_CURVE"));
    CHECK(contains(one(fabric_deck("0.4", "0", "0,,,,,2,,7")),
                   "(TSRFAC) = 7, expected a curve of values from 0 to 1"));
    CHECK(folder.read(fabric_deck("0.4", "0", "0,,,,,14", "0,0\n")).warnings.size() == 1);
}

TEST_CASE("MAT_FABRIC: a liner that waits, strains that come back, a birth", "[io]") {
    const DeckFolder folder;
    const Model plain =
        folder.read(fabric_deck("0.4", "0,,,1,0.05,0.3,0.1", "0,,,,1,14,,0.002", ""));
    CHECK(cloth(plain).liner_waits);
    CHECK(cloth(plain).restoration.share == 0.002);
    const std::string curve = "*DEFINE_CURVE\n21\n0,0\n5,1\n";
    const Model by_share = folder.read(fabric_deck("0.4", "0", "0,,,,,2,,-21", curve));
    CHECK(cloth(by_share).restoration.share_curve == 1);
    const Model by_course = folder.read(fabric_deck("0.4", "0", "0,,,,,2,,21", curve));
    CHECK(cloth(by_course).restoration.course_curve == 1);
    CHECK(!cloth(folder.read(fabric_deck("0.4", "0"))).restoration.any());
}

TEST_CASE("MAT_FABRIC: a coat after the curves of forms 4 and 14", "[io]") {
    const DeckFolder folder;
    const auto deck = [&](const std::string& form, const std::string& card) {
        return fabric_deck("0.4", "0", "0,,,,," + form, "0\n" + card + "\n");
    };
    const Model both = folder.read(deck("14", ",,,,,0.05,,0.1"));
    CHECK(cloth(both).coat_E == 0.05);
    CHECK(cloth(both).coat_thickness == 0.1);
    CHECK(cloth(both).coat_stretches);
    const Model bends = folder.read(deck("4", ",,,,,0.05,,-0.1"));
    CHECK(cloth(bends).coat_thickness == 0.1);
    CHECK(!cloth(bends).coat_stretches);
    CHECK(!cloth(folder.read(deck("14", "0"))).has_coat());
    const auto one = [&](const std::string& form, const std::string& card) {
        const auto faults = folder.faults(deck(form, card));
        CAPTURE(faults);
        REQUIRE(faults.size() == 1);
        return faults[0];
    };
    CHECK(contains(one("14", ",,,,,0.05,,0"), "(TCOAT)"));
    CHECK(contains(one("14", ",,,,,0,,0.1"), "(ECOAT)"));
    CHECK(contains(one("14", ",,,,,0.05,0.01,0.1"), "(SCOAT) = 0.01, expected 0 or blank"));
    CHECK(contains(one("14", "7,,,,,0.05,,0.1"), "(LCAA) = 7, expected 0 or blank"));
    const Model same = folder.read(deck("-14", ",,,,,0.05,,0.1"));
    CHECK(cloth(same).form == 14);
    CHECK(cloth(same).coat_E == 0.05);
    CHECK(contains(one("-14", "7,,,,,0.05,,0.1"), "(LCAA) = 7, expected 0 or blank"));
    CHECK(contains(one("24", ""), "(FORM) = 24, expected"));
}

TEST_CASE("MAT_FABRIC: curves of forms 4 and 14, loading and unloading", "[io]") {
    const DeckFolder folder;
    const std::string curves =
        "*DEFINE_CURVE\n21\n0,0\n0.1,0.01\n0.3,0.09\n*DEFINE_CURVE\n22\n0,0\n0.2,0.01\n0.3,0.09\n"
        "*DEFINE_CURVE\n23\n0,0\n0.2,0.06\n0.3,0.09\n"
        "*DEFINE_CURVE\n24\n0,0\n0.1,1e6\n0.4,8e6\n";
    const auto deck = [&](const std::string& form, const std::string& card) {
        return fabric_deck("0.4,0.3,,0.2", "0.01", "0,,,,," + form, card + "\n" + curves);
    };
    const Model model = folder.read(deck("14", "21,,,22,,,0.5"));
    CHECK(cloth(model).curves.load == std::array<Index, 3>{1, -1, -1});
    CHECK(cloth(model).curves.unload == std::array<Index, 3>{2, -1, -1});
    CHECK(cloth(model).curves.reload == 0.5);
    REQUIRE(model.warnings.size() == 1);
    CHECK(contains(model.warnings[0], "PRBA does not count"));
    CHECK(contains(folder.faults(deck("14", "21,,,23")).at(0),
                   "(LCUA) = 23, expected a curve that nowhere exceeds that of loading"));
    CHECK(contains(folder.faults(deck("14", "21,,,22,,,2")).at(0), "(RL) = 2, expected 0 to 1"));
    CHECK(contains(folder.faults(deck("4", "21,,,22,,,0.5")).at(0), "(RL) = 0.5, expected 0"));
    CHECK(folder.faults(deck("14", "24,24,24,24,24,24")).empty());  // a loop loses nothing
}
