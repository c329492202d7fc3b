// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// How runs would gain from more cores, predicted on one (loop_meter.hpp):
//
//     benchmark_scaling                      a folded bag, an open bag, a tank
//     benchmark_scaling DECK [--until T] [--sites N] [NAME=VALUE ...]
//
// Below it, where sixteen cores would lose most: loops by their call sites, and what lies between
// two of them.

#include <fmt/core.h>

#include <algorithm>
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

using benchmark::LoopMeter;

constexpr double CALL = 2e-6;    ///< of all threads to a loop  [s]
constexpr std::size_t MANY = 4;  ///< CORES of them: 16

struct Run {
    std::string deck;
    std::vector<std::pair<std::string, std::string>> definitions;
    double until = INF;      ///< [s]
    std::size_t sites = 40;  ///< that are told
};

double calls_of(const LoopMeter::Site& site) {
    return CALL * (static_cast<double>(site.calls) + 0.5 * static_cast<double>(site.waits));
}

/// Where the most is lost on many cores.
void print_losses(const LoopMeter& meter, std::size_t most) {
    struct Row {
        std::string at;
        LoopMeter::Site site;
        [[nodiscard]] double lost() const { return site.lost(MANY) + calls_of(site); }
    };
    std::vector<Row> rows;
    for (const auto& [at, site] : meter.sites()) rows.push_back({at, site});
    std::sort(rows.begin(), rows.end(),
              [](const Row& a, const Row& b) { return a.lost() > b.lost(); });
    fmt::print("  lost on {} cores     [s]: of time  uneven   calls  of them    waits\n",
               LoopMeter::CORES[MANY]);
    for (std::size_t r = 0; r < std::min(most, rows.size()); ++r) {
        const auto& [at, site] = rows[r];
        fmt::print("  {:26.3f} {:8.2f} {:7.3f} {:7.3f} {:8} {:8}  {}\n", rows[r].lost(), site.time,
                   site.lost(MANY), calls_of(site), site.calls, site.waits, at);
    }
}

void measure(const Run& run) {
    io::DeckOptions options;
    options.overrides = run.definitions;
    Model model = io::read_deck(run.deck, options);
    close_bags(model);
    model.end_time = std::min(model.end_time, run.until);
    Simulation simulation(std::move(model), 1);
    LoopMeter meter;
    while (!simulation.is_over()) simulation.step([](Simulation&) {});
    const double all = meter.seconds();
    fmt::print("{}", run.deck);
    for (const auto& [name, value] : run.definitions) fmt::print(" {}={}", name, value);
    fmt::print("\n  {} steps, {:.1f} s on one thread, {:.1f} % of it outside of loops, {} loops\n",
               simulation.steps(), all, 100.0 * meter.outside() / all, meter.loops());
    fmt::print("  cores    gain    with {:g} us a loop\n", 1e6 * CALL);
    for (std::size_t k = 0; k < LoopMeter::CORES.size(); ++k)
        fmt::print("  {:5}  {:6.2f}  {:6.2f}\n", LoopMeter::CORES[k], all / meter.wall(k),
                   all / meter.wall(k, CALL));
    print_losses(meter, run.sites);
}

}  // namespace

int main(int argc, char** argv) try {
    parallel::set_threads(1);
    std::vector<Run> runs{
        {CORPUSCLE_MODELS "/driver_bag_folded/driver_bag_folded.k", {{"TSW", "15"}}, INF},
        {CORPUSCLE_MODELS "/driver_bag_flat/driver_bag_flat.k", {}, INF},
        {CORPUSCLE_MODELS "/helium_air/helium_air.k", {}, INF}};
    if (argc > 1) {
        runs = {{argv[1], {}, INF}};
        for (int i = 2; i < argc; ++i) {
            const std::string text = argv[i];
            if (text == "--until" && i + 1 < argc) {
                runs[0].until = std::stod(argv[++i]);
                continue;
            }
            if (text == "--sites" && i + 1 < argc) {
                runs[0].sites = std::stoul(argv[++i]);
                continue;
            }
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
