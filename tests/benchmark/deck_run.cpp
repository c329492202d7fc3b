// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/benchmark/deck_run.hpp"

#include <algorithm>
#include <utility>

#include "io/deck.hpp"
#include "solver/scene/closing.hpp"

namespace corpuscle::benchmark {

Simulation DeckRun::begin() const {
    io::DeckOptions options;
    for (const std::string& text : definitions) {
        const std::size_t equals = text.find('=');
        options.overrides.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    Model model = io::read_deck(deck, options);
    close_bags(model);
    model.end_time = std::min(model.end_time, until);
    return Simulation(std::move(model), 1);
}

std::string DeckRun::name() const {
    std::string all = deck;
    for (const std::string& text : definitions) all += ' ' + text;
    return all;
}

void add_options(CLI::App& app, DeckRun& run) {
    app.add_option("deck", run.deck, "without one: the benchmark's own");
    app.add_option("--until", run.until, "end time, in the deck's unit");
    app.add_option("definitions", run.definitions, "parameters of the deck, NAME=VALUE")
        ->check([](const std::string& text) {
            const std::size_t equals = text.find('=');
            const bool is_good = equals != std::string::npos && equals > 0;
            return is_good ? std::string() : text + ": expected NAME=VALUE";
        });
}

}  // namespace corpuscle::benchmark
