// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>

#include "solver/base/random.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

/// Decks that are damaged, each a function of what is drawn alone.
namespace corpuscle::test {

/// A few bytes changed, put in, taken out or moved; whole lines too.
inline std::string mutate(std::string text, Random& draw) {
    static const std::string bytes("0123456789.,+-eE&<>*$_ \n\t\r\0\xff(LONGID", 36);
    const auto within = [&](std::size_t n) { return draw.below(static_cast<std::uint32_t>(n)); };
    for (std::uint32_t changes = 1 + draw.below(8); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = within(text.size());
        const std::size_t line = text.find('\n', at);
        switch (draw.below(6)) {
            case 0:
                text[at] = bytes[within(bytes.size())];
                break;
            case 1:
                text.insert(at, 1, bytes[within(bytes.size())]);
                break;
            case 2:
                text.erase(at, 1 + draw.below(12));
                break;
            case 3:
                text.insert(within(text.size()), text.substr(at, 1 + draw.below(80)));
                break;
            case 4:
                if (line != std::string::npos) text.erase(at, line - at);
                break;
            default:
                text.replace(at, 1, "99999999999999999999");
                break;
        }
    }
    return text;
}

/// True for a model, false for InputError; anything else fails the test.
inline bool is_read(const DeckFolder& folder, const std::string& text) {
    try {
        folder.read(text);
        return true;
    } catch (const InputError& error) {
        REQUIRE_FALSE(error.faults.empty());
        return false;
    }
}

}  // namespace corpuscle::test
