// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// The small mesh in the way of one format; the rest of the deck follows.
std::string deck_of(const std::string& nodes, const std::string& shell) {
    return "*KEYWORD\n" + nodes + shell +
           "*PART\ncloth\n1,1,1\n*SECTION_SHELL\n1,5\n0.3\n*MAT_ELASTIC\n1,700.,1.e8,0.3\n"
           "*CONTROL_TERMINATION\n1.0\n*END\n";
}

const std::string FIXED_NODES =
    "*NODE\n"
    "       1             0.0             0.0             0.0\n"
    "       2             2.5             0.0             0.0       0       0\n"
    "       3             2.5            -1.5           1.0-3       7       0\n";
const std::string FIXED_SHELL =
    "*ELEMENT_SHELL\n      10       1       1       2       3       3\n";

void check_mesh(const Model& model) {
    REQUIRE(model.x.size() == 3);
    CHECK(model.node_id == std::vector<int>{1, 2, 3});
    CHECK(model.x[1] == Vec3(2.5, 0.0, 0.0));
    CHECK(model.x[2] == Vec3(2.5, -1.5, 1e-3));
    REQUIRE(model.shells.size() == 1);
    CHECK(model.shells[0].id == 10);
    CHECK(model.shells[0].is_triangle());
    CHECK(model.shells[0].nodes == std::array<Index, 4>{0, 1, 2, 2});
    REQUIRE(model.supports.size() == 1);
    CHECK(model.supports[0].node == 2);
    CHECK(model.supports[0].fixed == 7U);
}

}  // namespace

TEST_CASE("a mesh is the same in fixed, comma, long, I10 and mixed format", "[io]") {
    const DeckFolder folder;
    SECTION("fixed") {
        check_mesh(folder.read(deck_of(FIXED_NODES, FIXED_SHELL)));
    }
    SECTION("comma") {
        check_mesh(folder.read(deck_of("*NODE\n1,0,0,0\n2,2.5,0,0,0,0\n3,2.5,-1.5,1.d-3,7\n",
                                       "*ELEMENT_SHELL\n10,1,1,2,3,3\n")));
    }
    SECTION("a comma line among fixed ones") {
        std::string nodes = FIXED_NODES;
        const auto second = nodes.find("       2");
        nodes.replace(second, nodes.find('\n', second) - second, "2, 2.5, 0.0, 0.0");
        check_mesh(folder.read(deck_of(nodes, FIXED_SHELL)));
    }
    SECTION("a triangle may leave out its fourth node") {
        check_mesh(folder.read(deck_of(FIXED_NODES, "*ELEMENT_SHELL\n10,1,1,2,3\n")));
        check_mesh(folder.read(deck_of(FIXED_NODES, "*ELEMENT_SHELL\n10,1,1,2,3,0\n")));
    }
    const std::string long_nodes =
        "                   1                 0.0                 0.0                 0.0\n"
        "                   2                 2.5                 0.0                 0.0\n"
        "                   3                 2.5                -1.5               1.0-3"
        "                   7\n";
    const std::string long_shell =
        "                  10                   1                   1                   2"
        "                   3                   3\n";
    SECTION("long for one keyword") {
        check_mesh(
            folder.read(deck_of("*NODE +\n" + long_nodes, "*ELEMENT_SHELL+\n" + long_shell)));
    }
    SECTION("long for the deck, standard again for one keyword") {
        std::string deck =
            deck_of("*NODE\n" + long_nodes, "*ELEMENT_SHELL -\n" + FIXED_SHELL.substr(15));
        deck.replace(0, 8, "*KEYWORD LONG=Y");
        check_mesh(folder.read(deck));
    }
    SECTION("LONG=S is read as standard") {
        std::string deck = deck_of(FIXED_NODES, FIXED_SHELL);
        deck.replace(0, 8, "*KEYWORD LONG=S");
        check_mesh(folder.read(deck));
    }
    SECTION("options of *KEYWORD in any case, with blanks and commas, YES for Y") {
        std::string deck = deck_of("*NODE\n" + long_nodes, "*ELEMENT_SHELL\n" + long_shell);
        const auto rest = deck.find("*PART");
        deck.insert(rest, "*KEYWORD LONG = No\n");
        for (const char* options : {"LONG = Y", "long=yes", "200M, Long= k NCPU =2", ", long =Y"}) {
            const Model model = folder.read("*KEYWORD" + std::string(*options == ',' ? "" : " ") +
                                            options + deck.substr(8));
            check_mesh(model);
            CHECK(model.warnings.empty());
        }
    }
    SECTION("ids of ten columns") {
        check_mesh(folder.read(deck_of(
            FIXED_NODES,
            "*ELEMENT_SHELL %\n        10         1         1         2         3         3\n")));
    }
    SECTION("lines that end in CR LF, comments and blank lines in tables, lower case") {
        std::string text =
            deck_of("*node\n$ a comment\n" + FIXED_NODES.substr(6) + "\n  $ another\n",
                    "*Element_Shell\n" + FIXED_SHELL.substr(15));
        std::string crlf;
        for (const char c : text) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
        check_mesh(folder.read(crlf));
        check_mesh(folder.read("\xEF\xBB\xBF" + text));
    }
    SECTION("tabs reach the next eighth column") {
        check_mesh(folder.read(deck_of(FIXED_NODES, "*ELEMENT_SHELL\n10\t1\t1\t2\t3\t3\n")));
    }
}

TEST_CASE("options of *KEYWORD that nothing knows are warned of, those of LS-DYNA are not",
          "[io]") {
    const DeckFolder folder;
    const auto warnings = [&](const std::string& options) {
        return folder.read("*KEYWORD" + options + small_deck().substr(8)).warnings;
    };
    for (const char* known : {"", " 100000000", " 200m NCPU=4", " MEMORY = 200M memory2=20m",
                              " JOBID=a PROJECT=b", " i10=n", "_ID\nproject,2,3"})
        CHECK(warnings(known).empty());
    REQUIRE(warnings(" FROB = 1 ncpu=2").size() == 1);
    CHECK(contains(warnings(" FROB = 1 ncpu=2")[0],
                   "deck.k:1: *KEYWORD FROB=1 is ignored, expected"));
    CHECK(warnings(" LONG=maybe =").size() == 1);
    CHECK(warnings("S").size() == 1);
}

TEST_CASE("numbers may abut in fixed columns", "[io]") {
    const DeckFolder folder;
    const Model model =
        folder.read(small_deck("*SET_PART_LIST\n"
                               "         1\n"
                               "         1         2\n"
                               "*AIRBAG_PARTICLE\n"
                               "         1         1\n"
                               "      2000         0         1     293.01.00000E-4"
                               "         01.00000E101.00000E10\n"
                               "         1         0         0\n"
                               "1.00000E-4     293.0     0.035      26.77.00000E-4"
                               "-1.0000E-6         00\n"));
    REQUIRE(model.bags.size() == 1);
    CHECK(model.bags[0].p_atm == 1e-4);
    CHECK(model.bags[0].all_in == 1e10);
    REQUIRE(model.bags[0].air);
    CHECK(model.bags[0].air->species.A == 26.7);
    CHECK(model.bags[0].air->species.B == 7e-4);
    CHECK(model.bags[0].air->species.C == -1e-6);
}

TEST_CASE("reading stops at *END", "[io]") {
    const DeckFolder folder;
    const Model model = folder.read(SMALL_MESH + "*END\n*RUBBISH\nrubbish\n");
    CHECK(model.x.size() == 6);
}

TEST_CASE("a deck may end without *END and without a last line break", "[io]") {
    const DeckFolder folder;
    CHECK(folder.read(SMALL_MESH + "*TITLE\nno end").title == "no end");
}

TEST_CASE("a comma in an expression leaves a card its columns", "[io]") {
    const Model model =
        read_small("*SET_NODE\n4\n1,2\n*LOAD_NODE_SET\n         4         3         7<max(2,5)>\n");
    REQUIRE(model.node_loads.size() == 1);
    CHECK(model.node_loads[0].scale == 5.0);
    CHECK(read_small("*SET_NODE\n4\n1,2\n*LOAD_NODE_SET\n4,3,7,<max(2,5)>\n")
              .node_loads.at(0)
              .scale == 5.0);
}

TEST_CASE("remarks behind column 80 are no fields", "[io]") {
    const DeckFolder folder;
    const std::string card = "       0.5";
    std::string deck = small_deck();
    const auto at = deck.find("\n1.0\n") + 1;
    deck.replace(at, 3, card + std::string(80 - card.size(), ' ') + " milliseconds");
    const Model model = folder.read(deck);
    CHECK(model.end_time == 0.5);
    CHECK(model.warnings.empty());
}

TEST_CASE("text behind the last field is a warning", "[io]") {
    const DeckFolder folder;
    const Model model =
        folder.read(small_deck("*DATABASE_HISTORY_NODE\n1,2,3,4,5,6,1,2,and more\n"));
    REQUIRE(model.warnings.size() == 1);
    CHECK(contains(model.warnings[0], "\"and more\" behind the last field is ignored"));
}
