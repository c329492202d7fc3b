// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// From a deck to its scene: what faults only the scene shows are told with their place in the deck.

#include <fmt/core.h>
#include <unistd.h>

#include <cmath>

#include "io/deck.hpp"
#include "io/deck/deck_places.hpp"
#include "solver/base/cores.hpp"
#include "solver/base/error.hpp"
#include "solver/scene/closing.hpp"
#include "solver/simulation.hpp"
#include "tools/commands/commands.hpp"

namespace corpuscle::tools {
namespace {

/// Refuses particles that this machine's memory does not hold, before it is taken.
void expect_room_for_particles(const Model& model) {
    constexpr double BYTES = 100.0;  ///< of a particle, with its share of lists (io/KEYWORDS.md)
    const double memory =
        static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    double wanted = 0.0;
    for (const gas::BagCard& bag : model.bags) {
        wanted += BYTES * static_cast<double>(bag.particles);
        if (wanted > memory)
            throw InputError(
                fmt::format("bag {}: NP = {}, expected particles that fit into "
                            "{:.3g} GB of memory: up to here they take {:.3g} GB",
                            bag.id, bag.particles, 1e-9 * memory, 1e-9 * wanted));
    }
}

}  // namespace

Simulation load(const DeckArguments& arguments) {
    parallel::set_threads(arguments.threads > 0 ? arguments.threads : parallel::default_threads());
    io::DeckOptions options;
    for (const std::string& definition : arguments.definitions) {
        const std::size_t equals = definition.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError(fmt::format("-D {}: expected NAME=VALUE", definition));
        options.overrides.emplace_back(definition.substr(0, equals), definition.substr(equals + 1));
    }
    if (arguments.until) {
        if (!(*arguments.until > 0.0) || !std::isfinite(*arguments.until))
            throw InputError(fmt::format("--until {}: expected a time above 0", *arguments.until));
        options.until = *arguments.until;
    }
    io::DeckPlaces places;
    Model model = io::read_deck(arguments.file, options, &places);
    if (arguments.until) model.end_time = *arguments.until;
    try {
        expect_room_for_particles(model);
        close_bags(model);
        return Simulation(std::move(model), arguments.seed);
    } catch (const InputError& error) {
        throw places.told(error);
    }
}

}  // namespace corpuscle::tools
