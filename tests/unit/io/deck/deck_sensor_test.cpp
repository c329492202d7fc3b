// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("DATABASE_CPM_SENSOR: a sphere, a cylinder or a box at every segment", "[io]") {
    using Shape = gas::SensorCard::Shape;
    const DeckFolder folder;
    const std::string set = "*SET_SEGMENT\n3\n1,2,3,3\n2,5,6,3\n";
    const auto deck = [&](const std::string& rows) {
        return small_deck(set + "*DATABASE_CPM_SENSOR\n1e-3\n" + rows);
    };
    const Model model = folder.read(deck("3,-0.1,0.2\n3,0.1,0.2,0.3\n3,0,0.1,0.2,0.4\n"));
    REQUIRE(model.sensors.size() == 6);
    CHECK(model.sensors[0].shape == Shape::SPHERE);
    CHECK(model.sensors[0].offset == -0.1);
    CHECK(model.sensors[1].nodes == std::array<Index, 4>{1, 4, 5, 2});
    CHECK(model.sensors[2].shape == Shape::CYLINDER);
    CHECK(model.sensors[3].size[1] == 0.3);
    CHECK(model.sensors[5].shape == Shape::BOX);
    CHECK(model.output.cpm_sensor == 1e-3);
    CHECK(contains(folder.faults(deck("3,0,0\n")).at(0), "(R/LX)"));
    CHECK(contains(folder.faults(deck("3,0,0.1,0,0.2\n")).at(0), "(LEN/LY) = 0, expected > 0"));
    CHECK(contains(folder.faults(deck("4,0,0.1\n")).at(0), "(SEGSID) = 4"));
    CHECK(contains(folder.faults(deck("")).at(0), "has no sensor"));
}
