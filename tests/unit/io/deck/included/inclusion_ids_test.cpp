// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Ids of files that *INCLUDE_TRANSFORM brings in, and what of its cards is refused.

#include <catch2/catch.hpp>

#include "io/deck_mesh.hpp"
#include "tests/unit/io/deck/included/inclusion_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("each kind of id has its offset, those of walls that of parts", "[io]") {
    const Model model =
        read_included(small_deck("*RIGIDWALL_PLANAR_ID\n9\n\n0,0,-1,0,0,1\n"
                                 "*CONTACT_AIRBAG_SINGLE_SURFACE_ID\n9,self\n0\n0.2\n0\n"
                                 "*SET_PART_LIST\n5\n1,2\n*SET_NODE_LIST\n5\n1,2\n"
                                 "*BOUNDARY_SPC_SET\n5,0,1\n*LOAD_GRAVITY_PART_SET\n5,3,7,9.81\n"),
                      inclusion("file.k", EACH_OFFSET));
    CHECK(model.node_id == std::vector<int>{1001, 1002, 1003, 1004, 1005, 1006});
    CHECK(model.shells[2].id == 2013);
    CHECK(model.parts[1].id == 3002);
    CHECK(model.materials[0].id == 4001);
    CHECK(model.curves[0].id == 6007);
    CHECK(model.contacts[0].id == 8009);
    CHECK(model.walls[0].id == 3009);
    CHECK(model.supports.size() == 2);
    CHECK(model.body_loads[0].parts == std::vector<Index>{0, 1});
}

TEST_CASE("an id of zero stays zero, and minus an id of a curve is shifted away from zero",
          "[io]") {
    const std::string cloth =
        "*MAT_FABRIC\n9,700,4e8,0,0,0.3\n\n0,-7,0.5,0,0,0,7\n\n\n"
        "*PART\nleaky\n9,1,9\n*PART\nbare\n8,0,0\n";
    const Model model = read_included(small_deck(cloth), inclusion("file.k", EACH_OFFSET));
    const auto& card = std::get<fabric::FabricCard>(model.materials.at(1).card);
    CHECK(card.leak_area_curve == 0);
    CHECK(card.leak_velocity == 0.5);
    CHECK(model.parts[3].id == 3008);
}

TEST_CASE("ranges of ids are shifted, also one that begins at zero", "[io]") {
    const auto members = [](const std::string& range) {
        const DeckFolder folder;
        folder.write("file.k", "*SET_NODE_LIST_GENERATE\n5\n" + range + "\n*NODE\n1,9\n3,9\n" +
                                   "*BOUNDARY_SPC_SET\n5,0,1\n");
        const Model model = folder.read(small_deck(inclusion("file.k", "100,0,0,0,0,0,0\n0\n")));
        std::vector<int> ids;
        for (const Support& support : model.supports)
            ids.push_back(model.node_id[static_cast<std::size_t>(support.node)]);
        return ids;
    };
    CHECK(members("1,2") == std::vector<int>{101});
    CHECK(members("0,3") == std::vector<int>{101, 103});
}

TEST_CASE("a file without offsets that is included twice collides, told by ids of the deck",
          "[io]") {
    const std::string twice =
        "*INCLUDE\nfile.k\n" + inclusion("file.k", "0,50,50,50,50,50,50\n50\n");
    const auto faults = included_faults(small_deck(), twice);
    REQUIRE_FALSE(faults.empty());
    CHECK(contains(faults[0],
                   "file.k:3: *NODE card 1, field 1 (NID) = 1, expected an id that no "
                   "other *NODE has, but file.k:3 has it"));
    const auto shifted = included_faults(
        "*NODE\n5,0,0,0\n", inclusion("file.k", "-4,0,0,0,0,0,0\n0\n") + "*INCLUDE\nfile.k\n" +
                                inclusion("file.k", "1000,0,0,0,0,0,0\n0\n") +
                                inclusion("file.k", "1000,0,0,0,0,0,0\n0\n"));
    CHECK(any_contains(shifted, "(NID) = 5 (1005 by IDNOFF = 1000), expected an id that no other"));
}

TEST_CASE("an id of the deck itself is none of an included file", "[io]") {
    const DeckFolder folder;
    folder.write("file.k", "*BOUNDARY_SPC_NODE\n2,0,1\n");
    const auto faults = folder.faults(small_deck(inclusion("file.k", "1000,0,0,0,0,0,0\n0\n")));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0] ==
          "file.k:2: *BOUNDARY_SPC_NODE card 1, field 1 (NID) = 2 (1002 by IDNOFF = "
          "1000), expected the id of a *NODE of the deck");
    CHECK(folder.read(small_deck(inclusion("file.k"))).supports.size() == 1);
}

TEST_CASE("offsets of files within each other add up", "[io]") {
    const DeckFolder folder;
    folder.write("inner.k", SMALL_MESH);
    folder.write("outer.k", "*NODE\n1,9,9,9\n*DEFINE_TRANSFORMATION\n7\nTRANSL,0,0,1\n" +
                                inclusion("inner.k", "10,20,30,40,50,60,70\n80\n", 7));
    folder.write("plain.k", "*INCLUDE\ninner.k\n");
    const Model nested = folder.read(inclusion("outer.k", EACH_OFFSET, 7) +
                                     "*DEFINE_TRANSFORMATION\n7\nTRANSL,1,0,0\n*END\n");
    CHECK(nested.node_id[0] == 1001);
    CHECK(nested.node_id[1] == 1011);
    CHECK(nested.shells[0].id == 2031);
    CHECK(nested.parts[0].id == 3031);
    CHECK(nested.x[0] == Vec3(10, 9, 9));
    CHECK(nested.x[1] == Vec3(1, 0, 1));
    const Model below = folder.read(inclusion("plain.k", EACH_OFFSET) + "*END\n");
    CHECK(below.node_id[0] == 1001);
}

TEST_CASE("offsets may be parameters that are defined behind them, and -D goes before", "[io]") {
    const DeckFolder folder;
    folder.write("file.k", small_deck());
    const std::string deck = inclusion("file.k", "&off,&off,&off,&off,&off,&off,&off\n&off\n") +
                             "*PARAMETER\nI off,100\n*END\n";
    CHECK(folder.read(deck).node_id[0] == 101);
    CHECK(folder.read(deck, {{{"OFF", "200"}}}).node_id[0] == 201);
}

TEST_CASE("a parameter of a file that is included twice is no warning, one of another value is",
          "[io]") {
    const DeckFolder folder;
    folder.write("file.k", "*PARAMETER\nR spare,0.5\n");
    const std::string twice = inclusion("file.k") + inclusion("file.k");
    CHECK(folder.read(small_deck(twice)).warnings.empty());
    const Model other = folder.read(small_deck(twice + "*PARAMETER\nR spare,0.25\n"));
    REQUIRE(other.warnings.size() == 1);
    CHECK(contains(other.warnings[0], "*PARAMETER SPARE is ignored"));
}

TEST_CASE("a mesh alone is that of the deck: its ids, its places, its normals", "[io]") {
    const DeckFolder folder;
    folder.write("file.k", small_deck("*SET_PART\n9\n1,2\n"));
    const auto deck = folder.write(
        "deck.k", "*KEYWORD\n" + inclusion("file.k", EACH_OFFSET, 7) +
                      "*DEFINE_TRANSFORMATION_TITLE\nup, mirrored\n7\nTRANSL,0,0,3\nSCALE,-1,1,1\n"
                      "*END\n");
    const io::DeckMesh mesh = io::read_deck_mesh(deck);
    const Model model = io::read_deck(deck);
    CHECK(mesh.x == model.x);
    CHECK(mesh.x[1] == Vec3(-1, 0, 3));
    CHECK(mesh.node_id == model.node_id);
    CHECK(mesh.last_part_set == 5009);
    for (std::size_t s = 0; s < model.shells.size(); ++s) {
        CHECK(mesh.shells[s] == model.shells[s].nodes);
        CHECK(mesh.shell_id[s] == model.shells[s].id);
        CHECK(mesh.part_id[s] == model.parts[static_cast<std::size_t>(model.shells[s].part)].id);
    }
}

TEST_CASE("units, titles and a file DYNA.INC: refused, or told", "[io]") {
    const std::string named = "*INCLUDE_TRANSFORM\nfile.k\n0\n";
    for (const char* same : {"1,1.0,1,1.0", "0,0,0,0", "", "1.0,1.0,1.0"})
        CHECK(included_faults(small_deck(), named + "0\n" + same + "\n0\n").empty());
    for (const char* field : {"FCTMAS", "FCTTIM", "FCTLEN", "FCTTEM"}) {
        const auto at = std::string(field) == "FCTMAS"   ? "1000"
                        : std::string(field) == "FCTTIM" ? ",0.001"
                        : std::string(field) == "FCTLEN" ? ",,25.4"
                                                         : ",,,CtoK";
        const auto faults = included_faults(small_deck(), named + "0\n" + at + "\n0\n");
        REQUIRE(faults.size() == 1);
        CHECK(contains(faults[0], std::string("deck.k:6: *INCLUDE_TRANSFORM card 4, field ")));
        CHECK(contains(faults[0], std::string("(") + field + ")"));
        CHECK(contains(faults[0], "units of an included file are not converted"));
    }
    const Model model = read_included(small_deck(), named + "0,left,right\n1,1,1,1,1\n0\n");
    CHECK(any_contains(model.warnings, "(PREFIX) = left: titles of the included file stay"));
    CHECK(any_contains(model.warnings, "(SUFFIX) = right: titles"));
    CHECK(any_contains(model.warnings, "(INCOUT1) = 1: the file DYNA.INC is not written"));
}

TEST_CASE("cards of an inclusion that are wrong or missing are told with their place", "[io]") {
    const auto faults_of = [](const std::string& deck) {
        return included_faults(small_deck(), deck);
    };
    CHECK(faults_of("*INCLUDE_TRANSFORM\n")[0] ==
          "deck.k:2: *INCLUDE_TRANSFORM, expected the name of a file");
    CHECK(any_contains(faults_of("*INCLUDE_TRANSFORM\nfile.k\n0\n0\n\n"),
                       "deck.k:6: *INCLUDE_TRANSFORM ends before its card 5, expected TRANID"));
    CHECK(any_contains(faults_of("*INCLUDE_TRANSFORM\nfile.k\n0\n0\n\n0\n7\n"),
                       "card 6 = 7, expected no more cards"));
    CHECK(any_contains(faults_of(inclusion("file.k", "x,0\n0\n")),
                       "*INCLUDE_TRANSFORM card 2, field 1 (IDNOFF) = x, expected a whole number"));
    CHECK(any_contains(faults_of("*INCLUDE_TRANSFORM\nnowhere.k\n0\n0\n\n0\n"),
                       "deck.k:3: *INCLUDE_TRANSFORM card 1, field 1 (FILENAME) = nowhere.k, "
                       "expected a file that can be read"));
    const auto unknown = faults_of(inclusion("file.k", "0\n0\n", 7));
    REQUIRE(unknown.size() == 1);
    CHECK(unknown[0] ==
          "deck.k:7: *INCLUDE_TRANSFORM card 5, field 1 (TRANID) = 7, expected the id "
          "of a *DEFINE_TRANSFORMATION of the deck");
    CHECK(any_contains(faults_of(inclusion("file.k", "2147483647,0\n0\n")),
                       "(NID) = 1 (2147483648 by IDNOFF = 2147483647), expected an id that is 1 to "
                       "2147483647"));
    CHECK(any_contains(faults_of(inclusion("file.k", "-1,0\n0\n")),
                       "(NID) = 1 (0 by IDNOFF = -1), expected an id"));
    CHECK(any_contains(faults_of("*INCLUDE_TRANSFROM\nfile.k\n"), "INCLUDE_TRANSFORM?"));
}

TEST_CASE("what is done with an included file is a note", "[io]") {
    const Model model = read_included(small_deck(), inclusion("file.k", "100,0,30\n0\n", 7) +
                                                        "*DEFINE_TRANSFORMATION\n7\nTRANSL,1\n");
    const auto& notes = model.notes;
    CHECK(any_contains(notes,
                       "deck.k:2: *INCLUDE_TRANSFORM file.k: ids nodes + 100, parts + 30; "
                       "placed by *DEFINE_TRANSFORMATION 7"));
}

TEST_CASE("scenes that are placed apart have fingerprints of their own", "[io]") {
    const auto fingerprint = [](const std::string& offsets) {
        return read_included(small_deck(), inclusion("file.k", offsets)).fingerprint;
    };
    CHECK(fingerprint("0\n0\n") == fingerprint("0\n0\n"));
    CHECK(fingerprint("0\n0\n") != fingerprint("1,0\n0\n"));
}
