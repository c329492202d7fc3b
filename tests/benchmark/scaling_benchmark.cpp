// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// How runs gain from more cores: predicted on one (loop_meter.hpp), and measured on those that there
// are (loop_walls.hpp):
//
//     benchmark_scaling                      a folded bag, an open bag, a tank
//     benchmark_scaling DECK [--until T] [--sites N] [--measured N,N,...] [NAME=VALUE ...]
//
// Below it, where sixteen cores lose most: loops by their call sites, and what lies between two of
// them.

#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <map>
#include <string>
#include <vector>

#include "solver/base/parallel.hpp"
#include "tests/benchmark/deck_run.hpp"
#include "tests/benchmark/loop_meter.hpp"
#include "tests/benchmark/loop_walls.hpp"
#include "tests/places.hpp"

using namespace corpuscle;

namespace {

using benchmark::DeckRun;
using benchmark::LoopMeter;
using benchmark::LoopWalls;

constexpr double CALL = 2e-6;    ///< of all threads to a loop  [s]
constexpr std::size_t MANY = 4;  ///< CORES of them: 16

/// What a run is asked for beside its prediction.
struct Wanted {
    std::size_t sites = 40;      ///< loops and stretches that are told
    std::vector<int> threads{};  ///< measured on so many
};

using Walls = std::map<std::string, double>;  ///< by call site [s]

double calls_of(const LoopMeter::Site& site) {
    return CALL * (static_cast<double>(site.calls) + 0.5 * static_cast<double>(site.waits));
}

/// Where the most is lost on many cores.
/// @param measured  on as many; empty: not measured
void print_losses(const LoopMeter& meter, const Walls& measured, std::size_t most) {
    struct Row {
        std::string at;
        LoopMeter::Site site;
        double measured;  ///< [s]
        [[nodiscard]] double predicted() const { return site.lost(MANY) + calls_of(site); }
        [[nodiscard]] double most() const { return std::max(predicted(), measured); }
    };
    std::vector<Row> rows;
    for (const auto& [at, site] : meter.sites()) {
        const auto found = measured.find(at);
        const double even = site.time / LoopMeter::CORES[MANY];
        rows.push_back({at, site, found == measured.end() ? 0.0 : found->second - even});
    }
    std::sort(rows.begin(), rows.end(),
              [](const Row& a, const Row& b) { return a.most() > b.most(); });
    fmt::print("  lost on {} cores     [s]: of time  uneven   calls measured  of them    waits\n",
               LoopMeter::CORES[MANY]);
    for (std::size_t r = 0; r < std::min(most, rows.size()); ++r) {
        const auto& [at, site, wall] = rows[r];
        fmt::print("  {:26.3f} {:8.2f} {:7.3f} {:7.3f} {:8.3f} {:8} {:8}  {}\n",
                   rows[r].predicted(), site.time, site.lost(MANY), calls_of(site), wall,
                   site.calls, site.waits, at);
    }
}

void measure(const DeckRun& run, const Wanted& wanted) {
    std::map<int, double> wall;  // by threads [s]
    Walls on_many;
    for (const int n : wanted.threads) {
        parallel::set_threads(n);
        Simulation simulation = run.begin();
        LoopWalls walls;
        while (!simulation.is_over()) simulation.step([](Simulation&) {});
        wall[n] = walls.seconds();
        if (n == LoopMeter::CORES[MANY]) on_many = walls.sites();
    }
    parallel::set_threads(1);
    Simulation simulation = run.begin();
    LoopMeter meter;
    while (!simulation.is_over()) simulation.step([](Simulation&) {});
    const double all = meter.seconds();
    fmt::print("{}\n  {} steps, {:.1f} s on one thread, {:.1f} % outside of loops, {} loops\n",
               run.name(), simulation.steps(), all, 100.0 * meter.outside() / all, meter.loops());
    fmt::print("  cores    gain    with {:g} us a loop    measured [s]\n", 1e6 * CALL);
    for (std::size_t k = 0; k < LoopMeter::CORES.size(); ++k) {
        const auto found = wall.find(LoopMeter::CORES[k]);
        fmt::print("  {:5}  {:6.2f}  {:6.2f}", LoopMeter::CORES[k], all / meter.wall(k),
                   all / meter.wall(k, CALL));
        if (found != wall.end())
            fmt::print("  {:18.2f}  {:6.2f}", all / found->second, found->second);
        fmt::print("\n");
    }
    print_losses(meter, on_many, wanted.sites);
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app{
        "How runs gain from more cores: predicted on one, measured on those that there are"};
    DeckRun own;
    Wanted wanted;
    benchmark::add_options(app, own);
    app.add_option("--sites", wanted.sites, "loops and stretches that are told")
        ->capture_default_str();
    app.add_option("--measured", wanted.threads, "threads that the run is timed on as well")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->check(CLI::PositiveNumber);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    std::vector<DeckRun> runs{
        {CORPUSCLE_MODELS "/driver_bag_folded/driver_bag_folded.k", {"TSW=15"}},
        {CORPUSCLE_MODELS "/driver_bag_flat/driver_bag_flat.k"},
        {CORPUSCLE_MODELS "/helium_air/helium_air.k"}};
    if (!own.deck.empty()) runs = {own};
    for (const DeckRun& run : runs) measure(run, wanted);
    return 0;
} catch (const std::exception& error) {
    fmt::print(stderr, "benchmark_scaling: {}\n", error.what());
    return 2;
}
