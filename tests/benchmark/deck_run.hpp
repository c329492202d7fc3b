// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "solver/base/constants.hpp"
#include "solver/simulation.hpp"

namespace corpuscle::benchmark {

/// A deck that a benchmark runs on one thread.
struct DeckRun {
    std::string deck;
    std::vector<std::string> definitions{};  ///< NAME=VALUE
    double until = INF;                      ///< in the deck's unit of time

    /// At its start. Throws what reading the deck throws.
    [[nodiscard]] Simulation begin() const;
    /// The deck, and what of it is set.
    [[nodiscard]] std::string name() const;
};

/// DECK [--until T] [NAME=VALUE ...]
void add_options(CLI::App& app, DeckRun& run);

}  // namespace corpuscle::benchmark
