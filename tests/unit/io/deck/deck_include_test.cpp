// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("includes nest, each relative to the file that includes", "[io]") {
    const DeckFolder folder;
    folder.write("mesh/all.k", "*INCLUDE\nparts/cloth.k\n\"../more.k\"\n*END\nafter the end\n");
    folder.write("mesh/parts/cloth.k", SMALL_MESH);
    folder.write("more.k", "*TITLE\nfrom more.k\n");
    const Model model =
        folder.read("*KEYWORD\n*INCLUDE\nmesh/all.k\n*DATABASE_GLSTAT\n0.25\n*END\n");
    CHECK(model.x.size() == 6);
    CHECK(model.title == "from more.k");
    CHECK(model.output.glstat == 0.25);
}

TEST_CASE("the name of an include may go on over lines, or lie along a path", "[io]") {
    const DeckFolder folder;
    folder.write("far/away/mesh.k", SMALL_MESH);
    CHECK(folder.read("*INCLUDE\nfar/ +\naway/mesh.k\n*END\n").x.size() == 6);
    CHECK(folder.read("*INCLUDE_PATH\nfar/away\n*INCLUDE\nmesh.k\n*END\n").x.size() == 6);
    CHECK(folder.read("*INCLUDE\nfar\\away\\mesh.k\n*END\n").x.size() == 6);
}

TEST_CASE("a deck behind a link finds its includes where it lies, and beside the link first",
          "[io]") {
    const DeckFolder folder;
    folder.write("far/mesh.k", SMALL_MESH);
    folder.write("far/title.k", "*TITLE\nfrom far\n");
    const auto deck = folder.write("far/deck.k", "*INCLUDE\nmesh.k\ntitle.k\n*END\n");
    const auto link = folder.write("near/title.k", "*TITLE\nfrom near\n").parent_path() / "deck.k";
    std::filesystem::create_symlink(deck, link);
    CHECK(io::read_deck(deck).title == "from far");
    CHECK(io::read_deck(link).title == "from near");
}

TEST_CASE("two dots behind a linked folder lead to the folder around its target", "[io]") {
    const DeckFolder folder;
    folder.write("other.k", "*TITLE\nbeside the link\n");
    folder.write("far/other.k", "*TITLE\naround the target\n");
    const auto target = folder.write("far/away/mesh.k", SMALL_MESH).parent_path();
    const auto link = target.parent_path().parent_path() / "link";
    std::filesystem::create_directory_symlink(target, link);
    CHECK(folder.read(small_deck("*INCLUDE\nlink/../other.k\n")).title == "around the target");
    std::filesystem::remove(link.parent_path() / "other.k");
    CHECK(folder.read(small_deck("*INCLUDE\nlink/../other.k\n")).title == "around the target");
}

TEST_CASE("a cycle of includes is found, and named", "[io]") {
    const DeckFolder folder;
    folder.write("a.k", "*INCLUDE\nb.k\n");
    folder.write("b.k", "$ back again\n*INCLUDE\na.k\n");
    const auto faults = folder.faults(small_deck("*INCLUDE\na.k\n"));
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0], "b.k:3: *INCLUDE"));
    CHECK(contains(faults[0], "a.k -> b.k -> a.k"));
    const auto itself = folder.faults(small_deck("*INCLUDE\ndeck.k\n"));
    REQUIRE(itself.size() == 1);
    CHECK(contains(itself[0], "deck.k -> deck.k"));
}

TEST_CASE("includes go a hundred files deep, no further", "[io]") {
    const DeckFolder folder;
    const auto name = [](int i) { return "deep_" + std::to_string(i) + ".k"; };
    for (int i = 1; i < 200; ++i) folder.write(name(i), "*INCLUDE\n" + name(i + 1) + "\n");
    folder.write(name(100), SMALL_MESH);
    CHECK(folder.read("*INCLUDE\n" + name(1) + "\n*END\n").x.size() == 6);
    folder.write(name(100), "*INCLUDE\n" + name(101) + "\n");
    const auto faults = folder.faults(small_deck("*INCLUDE\n" + name(1) + "\n"));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0] ==
          "deep_100.k:2: *INCLUDE card 1, field 1 (FILENAME) = deep_101.k, expected at most 100 "
          "files within each other");
}

TEST_CASE("an include that is not there is a fault with its place", "[io]") {
    const DeckFolder folder;
    const auto faults = folder.faults(small_deck("*INCLUDE\nnowhere.k\n*INCLUDE\n.\n"));
    REQUIRE(faults.size() == 2);
    CHECK(contains(faults[0],
                   "deck.k:31: *INCLUDE card 1, field 1 (FILENAME) = nowhere.k, expected a file"));
    CHECK(contains(faults[1], "deck.k:33:"));
    CHECK_THROWS_AS(io::read_deck("/no/such/deck.k"), InputError);
}

TEST_CASE("long format of an include stays in it", "[io]") {
    const DeckFolder folder;
    folder.write("long.k", "*KEYWORD LONG=Y\n*DATABASE_GLSTAT\n                0.25\n*END\n");
    const Model model =
        folder.read(small_deck("*INCLUDE\nlong.k\n*DATABASE_ABSTAT\n      0.25         1\n"));
    CHECK(model.output.glstat == 0.25);
    CHECK(model.output.abstat == 0.25);
}

namespace {

const std::string WITH_PARAMETERS = small_deck(
    "*PARAMETER\n"
    "R  period      0.125I  rows            2\n"
    "C name, driver bag\n"
    "*PARAMETER_EXPRESSION\n"
    "R   twice  2*period\n"
    "R largest, max(period, twice,\n"
    "           &twice + 0.25)\n"
    "*DATABASE_ABSTAT\n"
    "   &PERIOD\n"
    "*DATABASE_GLSTAT\n"
    "&twice,&rows\n"
    "*DATABASE_RCFORC\n"
    "<1.0/(2.0*&rows)>, 1\n"
    "*DATABASE_NODOUT\n"
    "<min(3.0, largest)>, 1\n"
    "*LOAD_BODY_Z\n"
    "7,-&period\n");

}  // namespace

TEST_CASE("parameters and expressions stand for numbers", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(WITH_PARAMETERS);
    CHECK(model.output.abstat == 0.125);
    CHECK(model.output.glstat == 0.25);
    CHECK(model.output.rcforc == 0.25);
    CHECK(model.output.nodout == 0.5);
    CHECK(model.body_loads.at(0).scale == -0.125);
}

TEST_CASE("an override with -D goes before *PARAMETER, and expressions see it", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(WITH_PARAMETERS, {{{"PERIOD", "0.5"}}});
    CHECK(model.output.abstat == 0.5);
    CHECK(model.output.glstat == 1.0);
    CHECK(model.output.nodout == 1.25);
}

TEST_CASE("a fault of a field that names a parameter shows its value too", "[io]") {
    const DeckFolder folder;
    const std::string deck = small_deck(
        "*PARAMETER\nR dt, 0.5\n*CONTROL_TIMESTEP\n0,&DT\n*DATABASE_ABSTAT\n-&dt\n"
        "*DATABASE_GLSTAT\n<&dt-2.0>\n");
    const auto by_deck = folder.faults(deck);
    REQUIRE(by_deck.size() == 2);
    CHECK(by_deck[0] ==
          "deck.k:35: *DATABASE_ABSTAT card 1, field 1 (DT) = -0.5 (-&dt), expected >= 0");
    CHECK(contains(by_deck[1], "(DT) = -1.5 (<&dt-2.0>), expected >= 0"));
    const auto by_user = folder.faults(deck, {{{"DT", "5"}}});
    REQUIRE(by_user.size() == 2);
    CHECK(contains(by_user[0], "(TSSFAC) = 5 (&DT), expected > 0 and <= 1"));
    CHECK(contains(by_user[1], "(DT) = -5 (-&dt), expected >= 0"));
}

TEST_CASE("an override with -D of a name that the deck does not have names the nearest", "[io]") {
    const DeckFolder folder;
    const auto faults = folder.faults(WITH_PARAMETERS, {{{"PEROID", "0.5"}}});
    REQUIRE(faults.size() == 1);
    CHECK(faults[0] ==
          "-D PEROID=0.5: the deck has no *PARAMETER of that name; did you mean PERIOD?");
    CHECK(folder.faults(WITH_PARAMETERS, {{{"ROWS", "2.5"}}}).size() == 1);
    CHECK(folder.faults(WITH_PARAMETERS, {{{"PERIOD", "soon"}}}).size() == 1);
}

TEST_CASE("the first definition of a parameter stays, and the second is a warning", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(
        small_deck("*PARAMETER\nR dt, 0.5\n*PARAMETER\nR dt, 0.25\n*DATABASE_GLSTAT\n&dt\n"));
    CHECK(model.output.glstat == 0.5);
    REQUIRE(model.warnings.size() == 1);
    CHECK(contains(model.warnings[0], "deck.k:33: *PARAMETER DT is ignored"));
}

TEST_CASE("*PARAMETER_DUPLICATION says what becomes of a second definition", "[io]") {
    const DeckFolder folder;
    const auto deck = [](int flag, const char* second = "0.25") {
        return small_deck(
            fmt::format("*PARAMETER_DUPLICATION\n{}\n*PARAMETER\nR dt, 0.5\n"
                        "*PARAMETER\nR dt, {}\n*DATABASE_GLSTAT\n&dt\n",
                        flag, second));
    };
    CHECK(any_contains(folder.read(deck(1)).warnings, "*PARAMETER DT is ignored"));
    const Model silent = folder.read(deck(5));
    CHECK(silent.output.glstat == 0.5);
    CHECK(silent.warnings.empty());
    const auto fault = [&](int flag) {
        const auto faults = folder.faults(deck(flag));
        REQUIRE(faults.size() == 1);
        return faults[0];
    };
    CHECK(fault(3) ==
          "deck.k:35: *PARAMETER DT, expected one definition of a name: deck.k:33 has it already");
    CHECK(folder.read(deck(3, "0.5")).output.glstat == 0.5);
    CHECK(contains(folder.faults(deck(6)).at(0), "(DFLAG) = 6, expected 1 or 2 or 3 or 4 or 5"));
}

TEST_CASE("a second definition that counts does so for the cards behind it", "[io]") {
    const DeckFolder folder;
    const auto deck = [](const std::string& first) {
        return small_deck(first +
                          "R dt, 0.5\n*DATABASE_GLSTAT\n&dt\n*PARAMETER\nR dt, 0.25\n"
                          "*PARAMETER_EXPRESSION\nR half, dt / 2\n*DATABASE_MATSUM\n&dt\n"
                          "*DATABASE_ABSTAT\n&half\n");
    };
    const auto intervals = [](const Model& model) {
        return std::array{model.output.glstat, model.output.matsum, model.output.abstat};
    };
    const std::array in_turn{0.5, 0.25, 0.125};
    const Model warned = folder.read(deck("*PARAMETER_DUPLICATION\n2\n*PARAMETER\n"));
    CHECK(intervals(warned) == in_turn);
    CHECK(any_contains(warned.warnings, "*PARAMETER DT counts for the cards behind it"));
    for (const char* first : {"*PARAMETER_DUPLICATION\n4\n*PARAMETER\n", "*PARAMETER_MUTABLE\n"}) {
        const Model silent = folder.read(deck(first));
        CHECK(intervals(silent) == in_turn);
        CHECK(silent.warnings.empty());
    }
    io::DeckOptions options;
    options.overrides = {{"DT", "2"}};
    CHECK(intervals(folder.read(deck("*PARAMETER_DUPLICATION\n4\n*PARAMETER\n"), options)) ==
          std::array{2.0, 2.0, 1.0});
}

TEST_CASE("a local parameter is seen in its file and below, and hides a global one", "[io]") {
    const DeckFolder folder;
    folder.write("local.k",
                 "*PARAMETER_LOCAL\nR dt, 0.25\n*DATABASE_GLSTAT\n&dt\n*INCLUDE\nbelow.k\n");
    folder.write("below.k", "*DATABASE_RCFORC\n&dt\n");
    const Model model = folder.read(
        small_deck("*PARAMETER\nR dt, 0.5\n*INCLUDE\nlocal.k\n*DATABASE_ABSTAT\n&dt\n"));
    CHECK(model.output.glstat == 0.25);
    CHECK(model.output.rcforc == 0.25);
    CHECK(model.output.abstat == 0.5);
}

TEST_CASE("faults of parameters have a place", "[io]") {
    const DeckFolder folder;
    const auto faults =
        folder.faults(small_deck("*PARAMETER\n"
                                 "X what, 1\n"
                                 "I count, 1.5\n"
                                 "R dt, 0.25\n"
                                 "*PARAMETER_EXPRESSION\n"
                                 "R half, dt/0.0\n"
                                 "R less, nothing+1\n"
                                 "*DATABASE_GLSTAT\n"
                                 "&td\n"
                                 "*DATABASE_ABSTAT\n"
                                 "<1+>, 0\n"));
    REQUIRE(faults.size() == 6);
    CHECK(faults[0] ==
          "deck.k:31: *PARAMETER card 1, field 1 (PRMR1) = X what, expected R, I or C and a name, "
          "in 10 columns or before a comma");
    CHECK(contains(faults[1],
                   "deck.k:32: *PARAMETER card 2, field 2 (VAL1) = 1.5, expected a whole number"));
    CHECK(contains(faults[2],
                   "deck.k:35: *PARAMETER_EXPRESSION HALF = dt/0.0, expected no division by zero"));
    CHECK(contains(faults[3], "expected a *PARAMETER named nothing"));
    CHECK(contains(faults[4], "did you mean &DT?"));
    CHECK(contains(faults[5], "deck.k:40: *DATABASE_ABSTAT card 1, field 1 (DT) = <1+>, expected"));
}
