// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

using Rows = std::vector<Index>;

/// A node set, seen through the supports that it holds.
Rows held(const Model& model) {
    Rows rows;
    for (const Support& s : model.supports) rows.push_back(s.node);
    return rows;
}

const std::string HOLD = "*BOUNDARY_SPC_SET\n5,0,1,1,1\n";

}  // namespace

TEST_CASE("node sets: every way to write one", "[io]") {
    const DeckFolder folder;
    const auto set = [&](const std::string& text) {
        return held(folder.read(small_deck(text + HOLD)));
    };
    CHECK(set("*SET_NODE_LIST\n5\n1,2,6\n3\n") == Rows{0, 1, 5, 2});
    CHECK(set("*SET_NODE\n         5\n         4         4         1\n") == Rows{3, 0});
    CHECK(set("*SET_NODE_LIST_TITLE\nsome nodes, or other\n5\n6\n") == Rows{5});
    CHECK(set("*SET_NODE_LIST_GENERATE\n5\n2,4,6,99\n") == Rows{1, 2, 3, 5});
    CHECK(set("*SET_NODE_LIST_GENERATE_INCREMENT\n5\n1,6,2\n") == Rows{0, 2, 4});
    CHECK(set("*SET_NODE_COLUMN\n5\n3,0.5\n1\n") == Rows{2, 0});
    CHECK(set("*SET_NODE_LIST\n1\n1,2\n*SET_NODE_ADD\n5\n2,1\n*SET_NODE_LIST\n2\n6\n") ==
          Rows{5, 0, 1});
    CHECK(set("*SET_NODE_GENERAL\n5\nALL\nDPART,1\n") == Rows{4, 5});
    CHECK(set("*SET_NODE_GENERAL\n5\nPART,2\nDNODE,5,6\nNODE,1\n") == Rows{1, 2, 0});
    CHECK(set("*SET_SHELL\n3\n13\n*SET_NODE_GENERAL\n5\nSET_SHELL,3\n") == Rows{1, 4, 5, 2});
}

TEST_CASE("generated ids may span all numbers without cost", "[io]") {
    const DeckFolder folder;
    CHECK(
        held(folder.read(small_deck("*SET_NODE_LIST_GENERATE\n5\n1,2147483647\n" + HOLD))).size() ==
        6);
}

TEST_CASE("part sets: list, column, general, sum", "[io]") {
    const DeckFolder folder;
    const auto set = [&](const std::string& text) {
        return folder.read(small_deck(text + "*CONTACT_AIRBAG_SINGLE_SURFACE\n5,0,2\n\n\n"))
            .contacts.at(0)
            .parts;
    };
    CHECK(set("*SET_PART_LIST\n5\n2,1\n") == Rows{1, 0});
    CHECK(set("*SET_PART\n5\n2\n") == Rows{1});
    CHECK(set("*SET_PART_COLUMN\n5\n2\n") == Rows{1});
    CHECK(set("*SET_PART_LIST_GENERATE\n5\n1,2\n") == Rows{0, 1});
    CHECK(set("*SET_PART\n1\n1\n*SET_PART_ADD\n5\n1\n") == Rows{0});
    CHECK(set("*SET_PART_GENERAL\n5\nALL\nDPART,1\n") == Rows{1});
}

TEST_CASE("shell and segment sets name the facets of a pressure", "[io]") {
    const DeckFolder folder;
    using Facets = std::vector<std::array<Index, 4>>;
    const auto on_shells = [&](const std::string& text) {
        return folder.read(small_deck(text + "*LOAD_SHELL_SET\n5,7,2.0,0.1\n"))
            .pressure_loads.at(0);
    };
    const auto on_segments = [&](const std::string& text) {
        return folder.read(small_deck(text + "*LOAD_SEGMENT_SET\n5,7\n"))
            .pressure_loads.at(0)
            .facets;
    };
    const Facets first = {{0, 1, 2, 2}}, all = {{0, 1, 2, 2}, {0, 2, 3, 3}, {1, 4, 5, 2}};
    CHECK(on_shells("*SET_SHELL_LIST\n5\n11\n").facets == first);
    CHECK(on_shells("*SET_SHELL_LIST\n5\n11\n").scale == 2.0);
    CHECK(on_shells("*SET_SHELL_LIST\n5\n11\n").arrival == 0.1);
    CHECK(on_shells("*SET_SHELL_LIST_GENERATE\n5\n1,100\n").facets == all);
    CHECK(on_shells("*SET_SHELL_GENERAL\n5\nALL\nDELEM,13,12\n").facets == first);
    CHECK(on_shells("*SET_SHELL_GENERAL\n5\nPART,1,2\n").facets == all);
    CHECK(on_segments("*SET_SEGMENT\n5\n1,2,3\n") == first);
    CHECK(on_segments("*SET_SEGMENT_TITLE\nfirst\n5\n1,2,3,3\n") == first);
    CHECK(on_segments("*SET_SEGMENT_GENERAL\n5\nALL\n") == all);
    CHECK(on_segments("*SET_SEGMENT_GENERAL\n5\nPART,1,2\n") == all);
    CHECK(on_segments("*SET_SEGMENT_GENERAL\n5\nSHELL,11\n") == first);
    CHECK(on_segments("*SET_SHELL\n9\n11\n*SET_SEGMENT_GENERAL\n5\nSET_SHELL,9\n") == first);
    CHECK(on_segments("*SET_SEGMENT\n1\n1,2,3\n*SET_SEGMENT_ADD\n5\n1\n") == first);
}

TEST_CASE("sets of sets are what they are in any order of the deck", "[io]") {
    const DeckFolder folder;
    const auto set = [&](const std::string& text) {
        return held(folder.read(small_deck(text + HOLD)));
    };
    const std::string last = "*SET_NODE_LIST\n2\n6,1\n";
    CHECK(set("*SET_NODE_ADD\n5\n4\n*SET_NODE_ADD_TITLE\nsum\n4\n3,2\n*SET_NODE_ADD\n3\n2\n" +
              last) == Rows{5, 0});
    CHECK(set("*SET_NODE_GENERAL\n5\nALL\nDSET,4\n*SET_NODE_GENERAL\n4\nSET,3\n"
              "*SET_NODE_ADD\n3\n2\n" +
              last) == Rows{1, 2, 3, 4});
    CHECK(set("*SET_NODE_INTERSECT\n5\n4,2\n*SET_NODE_ADD\n4\n3\n*SET_NODE_LIST\n3\n1,2\n" +
              last) == Rows{0});
    CHECK(set("*SET_NODE_GENERAL\n5\nSET_SHELL,8\n*SET_SHELL_ADD\n8\n7\n*SET_SHELL_GENERAL\n7\n"
              "ELEM,11\n") == Rows{0, 1, 2});
    CHECK(set("*PARAMETER\nI four,4\n*SET_NODE_ADD\n5\n&four\n*SET_NODE_ADD\n&four\n2\n" + last) ==
          Rows{5, 0});
    std::string chain;
    for (int i = 0; i < 3000; ++i)
        chain += "*SET_NODE_ADD\n" + std::to_string(5 + i) + "\n" + std::to_string(6 + i) + "\n";
    CHECK(set(chain + "*SET_NODE_LIST\n3005\n4\n") == Rows{3});
}

TEST_CASE("sets of one id with _COLLECT are one set, wherever they stand", "[io]") {
    const DeckFolder folder;
    const auto set = [&](const std::string& text) {
        return held(folder.read(small_deck(text + HOLD)));
    };
    CHECK(set("*SET_NODE_LIST_COLLECT\n5\n1,2\n*SET_NODE_LIST_COLLECT_TITLE\nmore\n5\n6,2\n") ==
          Rows{0, 1, 5});
    CHECK(set("*SET_NODE_GENERATE_COLLECT\n5\n1,2\n*SET_NODE_GENERAL_COLLECT\n5\nNODE,5\n") ==
          Rows{0, 1, 4});
    CHECK(set("*SET_NODE_ADD\n5\n4\n*SET_NODE_GENERAL_COLLECT\n4\nNODE,5\n"
              "*SET_NODE_ADD_COLLECT\n4\n3\n*SET_NODE_LIST\n3\n6\n") == Rows{4, 5});
    const Model shells =
        folder.read(small_deck("*SET_SHELL_LIST_COLLECT\n5\n11\n*SET_SHELL_LIST_COLLECT\n5\n12\n"
                               "*LOAD_SHELL_SET\n5,7\n*SET_SEGMENT_COLLECT\n5\n1,2,3\n"
                               "*SET_SEGMENT_COLLECT\n5\n1,3,4\n*LOAD_SEGMENT_SET\n5,7\n"));
    REQUIRE(shells.pressure_loads.size() == 2);
    for (const PressureLoad& load : shells.pressure_loads) CHECK(load.facets.size() == 2);
    CHECK(folder
              .read(small_deck("*SET_PART_LIST_COLLECT\n5\n2\n*SET_PART_LIST_COLLECT\n5\n1\n"
                               "*CONTACT_AIRBAG_SINGLE_SURFACE\n5,0,2\n\n\n"))
              .contacts.at(0)
              .parts == Rows{1, 0});
}

TEST_CASE("a set with _COLLECT shares its id with no set without it", "[io]") {
    const std::string with = "*SET_NODE_LIST_COLLECT\n5\n1\n", without = "*SET_NODE_LIST\n5\n2\n";
    CHECK(contains(only_fault(with + without),
                   "deck.k:34: *SET_NODE_LIST card 1, field 1 (SID) = 5, expected an id that no "
                   "other *SET_NODE has, but deck.k:31 has it"));
    CHECK(contains(only_fault(without + with),
                   "deck.k:34: *SET_NODE_LIST_COLLECT card 1, field 1 (SID) = 5, expected an id "
                   "that only _COLLECT has, but the *SET_NODE of deck.k:31 has it"));
    CHECK(contains(only_fault(with + "*SET_NODE_LIST_COLLECT\n5\n"), "is empty"));
    CHECK(contains(only_fault("*SET_NODE_GENERAL_COLLECT\n5\nNODE,1\n"
                              "*SET_NODE_GENERAL_COLLECT\n5\nSET,5\n"),
                   "expected no set that contains itself: 5 -> 5"));
}

TEST_CASE("a set that contains itself is a fault that names the circle, and no other", "[io]") {
    CHECK(only_fault("*SET_NODE_ADD\n4\n5\n*SET_NODE_ADD\n5\n6\n*SET_NODE_GENERAL\n6\nNODE,1\n"
                     "SET,5\n" +
                     HOLD) ==
          only_fault("*SET_NODE_ADD\n4\n5\n*SET_NODE_ADD\n5\n6\n*SET_NODE_ADD\n6\n5\n"));
    CHECK(
        contains(only_fault("*SET_NODE_ADD\n4\n5\n*SET_NODE_ADD\n5\n6\n*SET_NODE_ADD\n6\n5\n"),
                 "deck.k:33: *SET_NODE_ADD 5, expected no set that contains itself: 5 -> 6 -> 5"));
    CHECK(contains(only_fault("*SET_PART_ADD\n5\n5\n"), "*SET_PART_ADD 5, expected no set that"));
    CHECK(contains(only_fault("*SET_SEGMENT_GENERAL\n5\nALL\nDSET,5\n"), ": 5 -> 5"));
    CHECK(read_small("*SET_SEGMENT_GENERAL\n5\nPART,1,,,5\n").warnings.empty());
}

TEST_CASE("sets that are empty, double, or name what is not there are faults", "[io]") {
    const DeckFolder folder;
    const auto one = [&](const std::string& text) {
        const auto faults = folder.faults(small_deck(text));
        REQUIRE(faults.size() == 1);
        return faults[0];
    };
    CHECK(contains(one("*SET_NODE_LIST\n5\n"), "deck.k:30: *SET_NODE_LIST is empty"));
    CHECK(contains(
        one("*SET_NODE_LIST\n5\n1\n*SET_NODE_LIST\n5\n2\n"),
        "deck.k:34: *SET_NODE_LIST card 1, field 1 (SID) = 5, expected an id that no other "
        "*SET_NODE has, but deck.k:31 has it"));
    CHECK(contains(
        one("*SET_NODE_LIST\n5\n1,77\n"),
        "deck.k:32: *SET_NODE_LIST card 2, field 2 (ID2) = 77, expected the id of a *NODE"));
    CHECK(contains(one("*SET_NODE_LIST_GENERATE\n5\n4,2\n*SET_NODE_LIST\n6\n1\n").substr(0, 9),
                   "deck.k:3"));
    CHECK(contains(one("*SET_NODE_GENERAL\n5\nALL\nVOL,1\n"), "(OPTION) = VOL, expected one of"));
    CHECK(contains(one("*SET_NODE_LIST_SMOOTH\n5\n1\n"), "is not acted on yet"));
}
