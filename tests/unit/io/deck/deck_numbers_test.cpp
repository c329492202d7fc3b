// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Numbers of bags, contacts and walls that a deck leaves open.

#include <catch2/catch.hpp>

#include "deck_airbag_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

template <class Things>
std::vector<int> ids(const Things& things) {
    std::vector<int> all;
    for (const auto& thing : things) all.push_back(thing.id);
    return all;
}

using Ids = std::vector<int>;

const std::string WALL = "0\n0,0,-1,0,0,0\n", SURFACE = "1,0,3\n\n\n";

std::string wall(int id) {
    return "*RIGIDWALL_PLANAR_ID\n" + std::to_string(id) + ",wall\n" + WALL;
}
std::string numbered_contact(int id) {
    return "*CONTACT_AUTOMATIC_SINGLE_SURFACE_ID\n" + std::to_string(id) + ",cloth\n" + SURFACE;
}
const std::string A_WALL = "*RIGIDWALL_PLANAR\n" + WALL,
                  A_CONTACT = "*CONTACT_AUTOMATIC_SINGLE_SURFACE\n" + SURFACE;

/// *AIRBAG_SIMPLE_AIRBAG_MODEL behind its set 12.
std::string uniform(const std::string& id) {
    return "*AIRBAG_SIMPLE_AIRBAG_MODEL" + (id.empty() ? "" : "_ID\n" + id) +
           "\n12,1\n713,1000,780,7,0.7,3e-4,1e5,1.2\n";
}

}  // namespace

TEST_CASE("contacts and walls without a number get their place, or the next that is free", "[io]") {
    CHECK(ids(read_small(A_CONTACT + numbered_contact(5) + A_CONTACT).contacts) == Ids{1, 5, 3});
    CHECK(ids(read_small(A_WALL + wall(5) + A_WALL).walls) == Ids{1, 5, 3});
    CHECK(ids(read_small(A_CONTACT + numbered_contact(1)).contacts) == Ids{2, 1});
    CHECK(ids(read_small(wall(2) + A_WALL).walls) == Ids{2, 3});
    CHECK(ids(read_small(A_WALL + A_WALL + wall(1) + wall(2)).walls) == Ids{3, 4, 1, 2});
    CHECK(ids(read_small(numbered_contact(0) + numbered_contact(1)).contacts) == Ids{2, 1});
    CHECK(contains(only_fault(wall(2) + wall(2)), "has id 2, as another wall has"));
    CHECK(contains(only_fault(numbered_contact(3) + numbered_contact(3)),
                   "has id 3, as another contact has"));
}

TEST_CASE("bags without a number get one that no bag of either kind has", "[io]") {
    const DeckFolder folder;
    const std::string set = "*SET_PART_LIST\n12\n1,2\n";
    const auto read = [&](const std::string& suffix, const std::string& id) {
        deck_airbag_setup::Bag bag;
        bag.suffix = suffix;
        bag.before_1 = id;
        std::string text = bag.deck();
        text.erase(text.rfind("*END"));
        return text + set;
    };
    const Model open = folder.read(read("", "") + uniform("1") + "*END\n");
    CHECK(ids(open.bags) == Ids{2});
    CHECK(ids(open.uniform_bags) == Ids{1});
    CHECK(any_contains(open.notes, "*AIRBAG_PARTICLE 2 is read with"));
    const Model other = folder.read(read("_ID", "2,bag\n") + uniform("") + "*END\n");
    CHECK(ids(other.bags) == Ids{2});
    CHECK(ids(other.uniform_bags) == Ids{3});
    CHECK(folder.faults(read("_ID", "2,bag\n") + uniform("2") + "*END\n").size() == 1);
}
