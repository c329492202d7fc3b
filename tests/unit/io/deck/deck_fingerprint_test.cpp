// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: decks that say different things of a scene have different fingerprints; comments, when the
// run ends and how often it writes make none.

#include <algorithm>
#include <catch2/catch.hpp>

#include "deck_scene.hpp"
#include "solver/simulation.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

std::uint64_t of_scene(const std::string& more, const io::DeckOptions& options = {}) {
    const DeckFolder folder;
    return Simulation(folder.read(small_deck(more), options)).fingerprint();
}

std::uint64_t of_deck(const std::string& more, const io::DeckOptions& options = {}) {
    const DeckFolder folder;
    return folder.read(small_deck(more), options).fingerprint;
}

}  // namespace

TEST_CASE("walls, loads, supports, contacts and materials tell scenes apart", "[io]") {
    const std::string plain = "*RIGIDWALL_PLANAR\n\n0,0,-1,0,0,1,0.3\n";
    const std::string cards[] = {plain,
                                 "*RIGIDWALL_PLANAR\n\n0,0,-1,0,0,1,0.4\n",
                                 "*RIGIDWALL_PLANAR\n\n0,0,-2,0,0,1,0.3\n",
                                 "*LOAD_BODY_Z\n7,9.81\n",
                                 "*LOAD_BODY_Z\n7,9.82\n",
                                 "*BOUNDARY_SPC_NODE\n1,0,1,1,1\n",
                                 "*BOUNDARY_SPC_NODE\n2,0,1,1,1\n",
                                 "*CONTACT_AIRBAG_SINGLE_SURFACE\n0,0,5,0\n0.2,0.2\n\n",
                                 "*CONTACT_AIRBAG_SINGLE_SURFACE\n0,0,5,0\n0.3,0.2\n\n",
                                 "*INITIAL_VELOCITY\n\n1.,2.,3.\n",
                                 "*DAMPING_GLOBAL\n0,100.\n",
                                 "*MAT_ELASTIC\n2,701.,1.e8,0.3\n",
                                 "*DATABASE_HISTORY_NODE\n1\n"};
    std::vector<std::uint64_t> all{of_scene("")};
    for (const std::string& card : cards) {
        INFO(card);
        const std::uint64_t own = of_scene(card);
        CHECK(own == of_scene(card));
        CHECK(std::find(all.begin(), all.end(), own) == all.end());
        all.push_back(own);
    }
}

TEST_CASE("comments, blanks at the end, the end time and intervals of output make no other scene",
          "[io]") {
    const std::string wall = "*RIGIDWALL_PLANAR\n\n0,0,-1,0,0,1,0.3\n";
    const std::uint64_t scene = of_scene(wall);
    CHECK(of_scene("$ a wall\n*RIGIDWALL_PLANAR\n\n$ of what\n0,0,-1,0,0,1,0.3   \n") == scene);
    CHECK(of_scene(wall + "*DATABASE_GLSTAT\n0.25\n*DATABASE_BINARY_D3PLOT\n0.5\n") == scene);
    CHECK(of_scene(wall + "*TITLE\nthe same\n") == scene);
    const DeckFolder folder;
    std::string longer = small_deck(wall);
    longer.replace(longer.find("TERMINATION\n1.0"), 15, "TERMINATION\n2.0");
    CHECK(Simulation(folder.read(longer)).fingerprint() == scene);
}

TEST_CASE("parameters count where a card names them, by *PARAMETER or -D", "[io]") {
    const std::string define = "*PARAMETER\nR mu,0.3\nR other,1\n";
    const std::string wall = define + "*RIGIDWALL_PLANAR\n\n0,0,-1,0,0,1,&mu\n";
    const std::string product = define + "*RIGIDWALL_PLANAR\n\n0,0,-1,0,0,1,<mu*2>\n";
    CHECK(of_deck(wall) == of_deck(wall, {{{"MU", "0.3"}}}));
    CHECK(of_deck(wall) != of_deck(wall, {{{"MU", "0.4"}}}));
    CHECK(of_deck(product) != of_deck(product, {{{"MU", "0.4"}}}));
    CHECK(of_deck(wall) == of_deck(wall, {{{"OTHER", "2"}}}));
    CHECK(of_deck(wall) != of_deck(wall, {{{"UNITS", "SI"}}}));
    CHECK(of_deck(wall, {{{"CLOSE", "no"}}}) != of_deck(wall, {{{"CLOSE", "0.1"}}}));
}
