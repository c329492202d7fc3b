// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <vector>

#include "damaged_deck.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr int MUTANTS = 3000;
constexpr std::uint64_t SEED = 2007;

/// A deck with some of everything.
const std::string RICH = small_deck(
    "*PARAMETER\nR dt, 0.25\nI np, 500\n*PARAMETER_EXPRESSION\nR half, dt/2.0\n"
    "*SET_PART_LIST_TITLE\nbag\n5\n1,2\n*SET_NODE_LIST_GENERATE\n5\n1,3\n"
    "*SET_NODE_GENERAL\n6\nALL\nDPART,2\n*SET_SEGMENT\n5\n1,2,3,3\n*SET_PART_ADD\n6\n5\n"
    "*MAT_FABRIC\n         2  7.00E-07       0.4       0.3                 0.2\n"
    "      0.01                             1      0.05       0.3       0.1      0.05\n"
    "         0        -7       1.5\n\n       0.0       0.0       1.0\n"
    "*MAT_RIGID\n3,1000.,1.e9,0.3\n1,7,7\n\n*PART\nblock\n3,1,3\n*DEFINE_VECTOR\n3,0,0,0,0,0,5\n"
    "*AIRBAG_PARTICLE_MPP_ID_TIME\n1,1,1\n9,bag\n0,0\n5,1\n&np,1\n+1e11,,,,,,,0.5\n1,1,1\n0,0,0."
    "029,29.0\n"
    "7,7,0.028,28.0\n5,1.0,3,<15.0*2>,1,0,1\n"
    "*AIRBAG_REFERENCE_GEOMETRY_ID\n1,2.0\n1,0,0,0\n"
    "*BOUNDARY_SPC_SET\n5,0,1,1,1\n*BOUNDARY_PRESCRIBED_MOTION_RIGID\n3,1,0,7\n"
    "*INITIAL_VELOCITY_GENERATION\n1,2,2.0\n0,0,0,0,0,1\n*LOAD_SEGMENT_SET\n5,7\n"
    "*CONTACT_AIRBAG_SINGLE_SURFACE_ID\n1,self\n5,0,2\n0.2\n0\n2\n*RIGIDWALL_PLANAR\n\n0,0,0,0,0,"
    "1\n"
    "*CONTROL_TIMESTEP\n0,0.9\n*DATABASE_ABSTAT\n&dt\n*DATABASE_HISTORY_NODE +\n"
    "                   1                   2\n");

}  // namespace

TEST_CASE("a damaged deck is read or refused, nothing else", "[io]") {
    const DeckFolder folder;
    REQUIRE(is_read(folder, RICH));
    int good = 0;
    for (int i = 0; i < MUTANTS; ++i) {
        Random draw(SEED, Stream::INITIAL, 0, static_cast<std::uint64_t>(i));
        const std::string text = mutate(RICH, draw);
        CAPTURE(i);
        good += is_read(folder, text) ? 1 : 0;
    }
    CHECK(good > 0);
    CHECK(good < MUTANTS);
}

TEST_CASE("bytes at random are refused", "[io]") {
    const DeckFolder folder;
    for (int i = 0; i < 300; ++i) {
        Random draw(SEED, Stream::WALL, 0, static_cast<std::uint64_t>(i));
        std::string text = i % 2 == 0 ? "*NODE\n" : "";
        for (std::uint32_t n = draw.below(2000); n > 0; --n)
            text += static_cast<char>(draw.below(i % 3 == 0 ? 256 : 64));
        CAPTURE(i);
        CHECK_FALSE(is_read(folder, text));
    }
}
