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

#include "solver/base/parallel.hpp"
#include "tests/benchmark/deck_run.hpp"
#include "tests/benchmark/loop_meter.hpp"
#include "tests/places.hpp"

using namespace corpuscle;

namespace {

using benchmark::DeckRun;
using benchmark::LoopMeter;

constexpr double CALL = 2e-6;    ///< of all threads to a loop  [s]
constexpr std::size_t MANY = 4;  ///< CORES of them: 16

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

void measure(const DeckRun& run, std::size_t sites) {
    Simulation simulation = run.begin();
    LoopMeter meter;
    while (!simulation.is_over()) simulation.step([](Simulation&) {});
    const double all = meter.seconds();
    fmt::print("{}\n  {} steps, {:.1f} s on one thread, {:.1f} % outside of loops, {} loops\n",
               run.name(), simulation.steps(), all, 100.0 * meter.outside() / all, meter.loops());
    fmt::print("  cores    gain    with {:g} us a loop\n", 1e6 * CALL);
    for (std::size_t k = 0; k < LoopMeter::CORES.size(); ++k)
        fmt::print("  {:5}  {:6.2f}  {:6.2f}\n", LoopMeter::CORES[k], all / meter.wall(k),
                   all / meter.wall(k, CALL));
    print_losses(meter, sites);
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app{"How runs would gain from more cores, predicted on one"};
    DeckRun own;
    std::size_t sites = 40;
    benchmark::add_options(app, own);
    app.add_option("--sites", sites, "loops and stretches that are told")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    parallel::set_threads(1);
    std::vector<DeckRun> runs{
        {CORPUSCLE_MODELS "/driver_bag_folded/driver_bag_folded.k", {"TSW=15"}},
        {CORPUSCLE_MODELS "/driver_bag_flat/driver_bag_flat.k"},
        {CORPUSCLE_MODELS "/helium_air/helium_air.k"}};
    if (!own.deck.empty()) runs = {own};
    for (const DeckRun& run : runs) measure(run, sites);
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "benchmark_scaling: {}\n", error.what());
    return 2;
}
