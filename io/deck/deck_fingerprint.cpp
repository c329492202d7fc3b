// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/deck_fingerprint.hpp"

#include "io/deck/keyword_reader.hpp"

namespace corpuscle::io {

std::uint64_t deck_fingerprint(const std::filesystem::path& deck) {
    Faults ignored;  // whoever runs the deck hears of them
    Parameters parameters({});
    const DeckText text = read_keywords(deck, parameters, ignored);
    std::uint64_t hash = 14695981039346656037ULL;
    const auto take = [&](unsigned char c) { hash = (hash ^ c) * 1099511628211ULL; };
    for (const DeckText::File& file : text.files) {
        for (const char c : file.text) take(static_cast<unsigned char>(c));
        take(0);  // where a file ends
    }
    return hash;
}

}  // namespace corpuscle::io
