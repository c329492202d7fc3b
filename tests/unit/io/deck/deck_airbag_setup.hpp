// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>
#include <numbers>
#include "deck_scene.hpp"
#include "gas/collisions/collide.hpp"
#include "solver/base/constants.hpp"

namespace deck_airbag_setup {

using namespace corpuscle;
using namespace corpuscle::test;

inline constexpr double DEGREE = std::numbers::pi / 180.0;

/// One gas through one orifice; cards 1 and 2, and what goes between the cards, as given.
struct Bag {
    std::string suffix, before_1, card_1 = "1", before_2, card_2 = "10000,1,1", behind_2;
    std::string card_3 = "0,1,1", rows, gas = "7,7,0.028,28.0", orifice = "5,1.0";

    [[nodiscard]] std::string deck() const {
        return small_deck("*AIRBAG_PARTICLE" + suffix + "\n" + before_1 + card_1 + "\n" + before_2 +
                          card_2 + "\n" + behind_2 + card_3 + "\n" + rows + gas + "\n" + orifice +
                          "\n");
    }
};

inline std::string only_fault(const DeckFolder& folder, const Bag& bag) {
    const auto faults = folder.faults(bag.deck());
    CAPTURE(faults);
    REQUIRE(faults.size() == 1);
    return faults[0];
}

}  // namespace deck_airbag_setup
