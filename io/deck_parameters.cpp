// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck_parameters.hpp"

#include <algorithm>

#include "io/deck/keyword_reader.hpp"
#include "io/deck/parameters.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io {

bool DeckParameters::has(const std::string& name) const {
    const std::string wanted = upper(trim(name));
    return std::count(of_deck.begin(), of_deck.end(), wanted) > 0 ||
           std::count(of_program.begin(), of_program.end(), wanted) > 0;
}

DeckParameters read_deck_parameters(const std::filesystem::path& deck) {
    Faults faults;
    Parameters parameters({});
    const DeckText text = read_keywords(deck, parameters, faults);
    return {parameters.names(), {OWN_NAMES.begin(), OWN_NAMES.end()}, !faults.any()};
}

}  // namespace corpuscle::io
