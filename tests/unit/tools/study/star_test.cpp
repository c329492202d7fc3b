// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Studies by plan STAR, and decks as values of a factor.
#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/unit/tools/study/desk.hpp"
#include "tools/study/outcome.hpp"

using namespace corpuscle;
using study_test::Desk;

TEST_CASE("a star has its centre, and each factor's other values alone", "[study]") {
    const Desk desk("star");
    desk.put("fine.k", "*KEYWORD\n$ finer\n*END\n");
    const std::string text =
        "responses = [\"20.peak_force\"]\nplan = \"star\"\n[factors]\nNP = [100, 25, 400]\n"
        "[orders]\nMESH = 1\nNP = 0.5\n"
        "[[mesh]]\ndeck = \"bag.k\"\nsize = 60\n[[mesh]]\ndeck = \"fine.k\"\nsize = 90\n";
    const study::Study s = desk.study(text);
    CHECK(study::points(s) ==
          std::vector<std::vector<double>>{{60, 100}, {90, 100}, {60, 25}, {60, 400}});
    const auto rows = study::rows(s);
    CHECK(study::deck_of(s, rows[0]).filename() == "bag.k");
    CHECK(study::deck_of(s, rows[1]).filename() == "fine.k");
    CHECK(study::definitions_of(s, rows[1]) == std::vector<std::string>{"NP=100"});
    CHECK(study::key_of(s, rows[1]).find("fine.k") != std::string::npos);
    CHECK(s.factors[1].order == 0.5);
    const std::string before = study::key_of(s, rows[1]);
    desk.put("fine.k", "*KEYWORD\n$ finer still\n*END\n");
    CHECK(study::key_of(desk.study(text), rows[1]) != before);
    CHECK(study::key_of(desk.study(text), rows[0]) == study::key_of(s, rows[0]));
}

TEST_CASE("faults of meshes and orders are told", "[study]") {
    const Desk desk("star_faults");
    const auto faults = desk.faults(
        "deck = \"bag.k\"\nresponses = [\"20.peak_force\"]\n[factors]\nNP = [100, -1]\n"
        "[orders]\nNP = 1\nTSSFAC = 1\n[[mesh]]\ndeck = \"bag.k\"\nsize = 60\n"
        "[[mesh]]\ndeck = \"none.k\"\nsize = 60\n");
    const auto has = [&](const std::string& words) {
        return std::any_of(faults.begin(), faults.end(), [&](const std::string& fault) {
            return fault.find(words) != std::string::npos;
        });
    };
    CHECK(faults.size() == 6);
    CHECK(has("s.toml:1: the study deck = 'bag.k', expected none beside [[mesh]]"));
    CHECK(has("'none.k', expected a deck beside the study"));
    CHECK(has("a size that no other mesh has"));
    CHECK(has("none but for plan"));
    CHECK(has("an order of a factor that is above 0"));
    CHECK(has("TSSFAC"));
}
