// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Verification of the program that users run: decks, through files, against exact answers.
namespace corpuscle::verify {

enum class Mode { QUICK, FULL };

/// What is held to an exact answer.
struct Quantity {
    std::string name;           ///< as the case's code calls it
    std::string what;           ///< in words
    std::string unit;           ///< "%": shown times 100; else as it is
    double budget_quick = 0.0;  ///< error that may be on the finest level
    double budget_full = 0.0;
    double order = 0.0;   ///< least observed order of convergence; 0: any
    bool refines = true;  ///< else it is not expected to fall with the size: rounding, a test
};

/// One resolution of a case.
struct LevelCard {
    std::filesystem::path deck;
    double size = 0.0;  ///< what the order is against; 0: nothing
    int seeds = 1;
    std::vector<std::pair<std::string, double>> parameters;  ///< -D of the deck
};

/// A case, as its case.toml tells.
struct Card {
    std::string name;  ///< of its folder
    std::string title, family;
    std::string source;  ///< of the exact answer
    std::string method;  ///< name of the code that compares; default: the case's
    std::string size;    ///< what a level's size is: "particles", "elements along an edge"
    std::vector<Quantity> quantities;
    std::vector<LevelCard> quick, full;  ///< coarse to fine

    [[nodiscard]] const std::vector<LevelCard>& levels(Mode mode) const {
        return mode == Mode::QUICK ? quick : full;
    }
};

/// @throws InputError with every fault: file:line: [table] key = value, expected ...
[[nodiscard]] Card read_card(const std::filesystem::path& file);

/// All cases of a folder by name, or those that are asked for.
/// @throws InputError also for names that no case has
[[nodiscard]] std::vector<Card> read_cards(const std::filesystem::path& folder,
                                           const std::vector<std::string>& names);

/// models/verification of the source tree or of an installation that `program` is in.
/// @throws InputError where there is none
[[nodiscard]] std::filesystem::path find_cases(const std::filesystem::path& program);

}  // namespace corpuscle::verify
