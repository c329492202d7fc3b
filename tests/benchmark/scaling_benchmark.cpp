// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// How runs would gain from more cores, predicted on one (loop_meter.hpp):
//
//     benchmark_scaling                      a folded bag, an open bag, a tank
//     benchmark_scaling DECK [NAME=VALUE ...]

#include <fmt/core.h>

#include <exception>
#include <string>
#include <vector>

#include "io/deck.hpp"
#include "solver/base/parallel.hpp"
#include "solver/scene/closing.hpp"
#include "solver/simulation.hpp"
#include "tests/benchmark/loop_meter.hpp"
#include "tests/places.hpp"

using namespace corpuscle;

namespace {

constexpr double CALL = 2e-6;  ///< of all threads to a loop  [s]

struct Run {
    std::string deck;
    std::vector<std::pair<std::string, std::string>> definitions;
};

void measure(const Run& run) {
    io::DeckOptions options;
    options.overrides = run.definitions;
    Model model = io::read_deck(run.deck, options);
    close_bags(model);
    Simulation simulation(std::move(model), 1);
    benchmark::LoopMeter meter;
    while (!simulation.is_over()) simulation.step([](Simulation&) {});
    const double all = meter.seconds();
    fmt::print("{}", run.deck);
    for (const auto& [name, value] : run.definitions) fmt::print(" {}={}", name, value);
    fmt::print("\n  {} steps, {:.1f} s on one thread, {:.1f} % of it outside of loops, {} loops\n",
               simulation.steps(), all, 100.0 * meter.outside() / all, meter.loops());
    fmt::print("  cores    gain    with {:g} us a loop\n", 1e6 * CALL);
    for (std::size_t k = 0; k < benchmark::LoopMeter::CORES.size(); ++k)
        fmt::print("  {:5}  {:6.2f}  {:6.2f}\n", benchmark::LoopMeter::CORES[k],
                   all / meter.wall(k), all / meter.wall(k, CALL));
}

}  // namespace

int main(int argc, char** argv) try {
    parallel::set_threads(1);
    std::vector<Run> runs{
        {CORPUSCLE_MODELS "/driver_bag_folded/driver_bag_folded.k", {{"TSW", "15"}}},
        {CORPUSCLE_MODELS "/driver_bag_flat/driver_bag_flat.k", {}},
        {CORPUSCLE_MODELS "/helium_air/helium_air.k", {}}};
    if (argc > 1) {
        runs = {{argv[1], {}}};
        for (int i = 2; i < argc; ++i) {
            const std::string text = argv[i];
            const std::size_t equals = text.find('=');
            if (equals == std::string::npos || equals == 0) {
                fmt::print(stderr, "benchmark_scaling: {}: expected NAME=VALUE\n", text);
                return 2;
            }
            runs[0].definitions.emplace_back(text.substr(0, equals), text.substr(equals + 1));
        }
    }
    for (const Run& run : runs) measure(run);
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "benchmark_scaling: {}\n", error.what());
    return 2;
}
