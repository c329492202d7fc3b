// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "io/deck/registry.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {

/// Where a deck has the things that faults of a whole scene name by kind and id: "shell 17 has a
/// reference area of 0" becomes "bag.k:57: *ELEMENT_SHELL: shell 17 has a reference area of 0".
class DeckPlaces {
public:
    /// A thing that a keyword has made: "bag", 1, of *AIRBAG_PARTICLE.
    void add(std::string_view kind, int id, Place at, const std::string& keyword);
    /// Things that have a registry: "shell", ...; one kind is added once.
    void add(std::string_view kind, Registry registry);
    void take(Faults faults) { faults_ = std::move(faults); }

    /// The fault behind file, line and keyword of the first thing in it that the deck has; as it is
    /// where there is none.
    [[nodiscard]] std::string told(const std::string& fault) const;
    /// All of them; what is said of many shells or nodes alike is one line with a count.
    [[nodiscard]] std::vector<std::string> told(const std::vector<std::string>& faults) const;

    /// A scene's faults in the deck's words (deck_words.hpp), each behind its file, line and keyword.
    [[nodiscard]] InputError told(const InputError& error) const;

private:
    struct KeywordPlace {
        Place place;
        std::string keyword;  ///< with its star
    };
    [[nodiscard]] bool find(std::string_view kind, int id, KeywordPlace& found) const;

    Faults faults_;  ///< knows the names of files
    std::map<std::pair<std::string, int>, KeywordPlace> things_;
    std::map<std::string, Registry, std::less<>> registries_;
};

}  // namespace corpuscle::io
