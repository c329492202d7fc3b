// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <catch2/catch.hpp>

#include "tests/unit/io/deck/damaged_deck.hpp"
#include "tests/unit/io/deck/included/inclusion_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr int DAMAGES = 1500;
constexpr std::uint64_t DAMAGE_SEED = 1965;

/// A body, a wall, a bag's cloth and sets, for whatever offsets.
const std::string MODULE =
    SMALL_MESH +
    "*MAT_FABRIC\n9,800,4e8,0,0,0.3\n\n2,-7,0.5,0,0,0,7\n0,0,0,1\n\n*MAT_RIGID\n5,2.0,1e9,0.3\n1,5,"
    "7\n"
    "\n*PART_INERTIA\nhead\n50,1,5\n1,2,3,4.0\n2,0.1,0.2,3,0.3,4\n1,2,3,4,5,6\n*NODE\n21,5,0,0,7\n"
    "22,6\n23,5,1\n*ELEMENT_SHELL\n91,50,21,22,23,23\n*SET_NODE_GENERAL\n6\nALL\nDPART,2\n"
    "*SET_PART_ADD\n6\n7\n*SET_PART_LIST_GENERATE\n7\n1,2\n*SET_SEGMENT\n5\n1,2,3,3\n"
    "*BOUNDARY_SPC_SET\n6,0,1,1,1\n*LOAD_SEGMENT_SET\n5,7\n*DEFINE_VECTOR\n3,0,0,0,0,0,5\n"
    "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n50,5,0,7\n*DEFINE_BOX\n4,0,1,0,1,0,1\n"
    "*RIGIDWALL_GEOMETRIC_FLAT_MOTION\n0,0,4\n0,0,-1,0,0,1\n2,0,-1,2,1\n7,0,0,0,1\n";

const std::string ROWS_OF_ALL =
    "*DEFINE_TRANSFORMATION_TITLE\nwhere the module "
    "lies\n7\nPOINT,1,1\nPOINT,2,0,1\nPOINT,3,0,0,1\n"
    "TRANSL,1,2,3\nROTATE,1,1,1,0,0,0,120\nROTATE,1,2,0\nMIRROR,0,0,0,1\nSCALE,1,2\nPOS6P,1,2,3,3,"
    "1,2\n"
    "*DEFINE_TRANSFORMATION\n8\nPOS6N,101,102,104,301,302,304\nTRANSL2ND,301,302,4\n"
    "ROTATE3NA,301,302,304,120\n";

const std::string PLACED_TWICE =
    "*KEYWORD\n" + inclusion("module.k", "100,100,100,100,100,100,100\n100\n", 8) +
    inclusion("nested.k", "300,300,300,300,300,300,0\n300\n", 0) + ROWS_OF_ALL;

const std::string NESTED = inclusion("module.k", "0\n0\n", 7) + "*NODE\n81,0\n";

/// Status of a deck in which one of its files is damaged.
bool is_read_with(const DeckFolder& folder, const std::string& deck, const std::string& nested,
                  const std::string& module) {
    folder.write("nested.k", nested);
    folder.write("module.k", module);
    return is_read(folder, deck);
}

}  // namespace

TEST_CASE("a deck with included files, one of them damaged, is read or refused, nothing else",
          "[io]") {
    const DeckFolder folder;
    REQUIRE(is_read_with(folder, PLACED_TWICE, NESTED, MODULE));
    int good = 0;
    for (int i = 0; i < DAMAGES; ++i) {
        Random draw(DAMAGE_SEED, Stream::INITIAL, 0, static_cast<std::uint64_t>(i));
        CAPTURE(i);
        const std::string deck = i % 3 != 0 ? mutate(PLACED_TWICE, draw) : PLACED_TWICE,
                          nested = i % 3 == 1 ? mutate(NESTED, draw) : NESTED,
                          module = i % 3 == 0 ? mutate(MODULE, draw) : MODULE;
        good += is_read_with(folder, deck, nested, module) ? 1 : 0;
    }
    CHECK(good > 0);
    CHECK(good < DAMAGES);
}

TEST_CASE("a deck that is cut off anywhere is read or refused", "[io]") {
    const DeckFolder folder;
    for (std::size_t end = 0; end < PLACED_TWICE.size(); ++end) {
        CAPTURE(end);
        static_cast<void>(is_read_with(folder, PLACED_TWICE.substr(0, end), NESTED, MODULE));
    }
}
