// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What it costs to know that all numbers are finite, and to write results and checkpoints with
// checksums, as shares of the run that does so: one thread, its own time (not the clock's), each
// check with and without in turn on the run's own numbers (check_costs.hpp).
//
//     benchmark_checks                              a flat bag, a folded bag, a closed box
//     benchmark_checks DECK [--until T] [NAME=VALUE ...]
//
// Status 1 where finite checks take more than 0.5 % of a run, or checksums more than 2 %.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/results/checkpoint.hpp"
#include "io/results/results_content.hpp"
#include "io/results/results_file.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/benchmark/check_costs.hpp"
#include "tests/benchmark/deck_run.hpp"
#include "tests/places.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

constexpr double FINITE_BUDGET = 0.005, CHECKSUM_BUDGET = 0.02;
constexpr int EVERY = 25;         ///< steps, whose checks are timed
constexpr double VERSIONS = 0.5,  ///< results.h5 anew, at the earliest (results_file.cpp)  [s]
    CHECKPOINTS = 2.0,            ///< the same of checkpoints (checkpoint_writer.hpp)      [s]
    PER_COST = 50.0;              ///< and 50 times what one costs

/// Seconds of one thread.
struct Measured {
    double run = 0.0;     ///< all steps and outputs
    double timed = 0.0;   ///< those steps whose checks were timed
    double frames = 0.0;  ///< are the frames' numbers finite?
    double state = 0.0;   ///< the last checkpoint's state is gathered
    double check = 0.0;   ///< its checksum
    std::size_t rows_written = 0, frames_written = 0;
};

double timed(const auto& what) {
    const double begin = benchmark::thread_seconds();
    what();
    return benchmark::thread_seconds() - begin;
}

/// Takes rows and frames as a run does, and times the check of frames.
class Output {
public:
    Output(const Simulation& simulation, io::ResultsFile& results, Measured& measured)
        : results_(results), measured_(measured), layout_(simulation.layout()) {
        const OutputIntervals& output = simulation.model().output;
        rows_ = std::isnan(output.abstat) ? simulation.model().end_time / 1000.0 : output.abstat;
        frames_ = std::isnan(output.frames) ? INF : output.frames;
    }
    void observe(Simulation& at) {
        if (is_due(at.time(), rows_, measured_.rows_written)) results_.append(at.sample());
        if (!is_due(at.time(), frames_, measured_.frames_written)) return;
        Frame frame = at.frame();
        const double cost = timed([&] { io::expect_finite(frame, layout_); });
        measured_.frames += cost;
        measured_.run -= cost;  // write() checks it once more
        results_.write(std::move(frame));
    }

private:
    static bool is_due(double t, double interval, std::size_t& count) {
        if (count > 0 && t < static_cast<double>(count) * interval) return false;
        ++count;
        return true;
    }

    io::ResultsFile& results_;
    Measured& measured_;
    RecordLayout layout_;
    double rows_ = INF, frames_ = INF;
};

/// All of a run, the checks of every so many steps timed beside it.
Measured advance(Simulation& simulation, io::ResultsFile& results, benchmark::FiniteCosts& costs) {
    Measured measured;
    Output output(simulation, results, measured);
    const Simulation::Observer observe = [&](Simulation& at) { output.observe(at); };
    while (!simulation.is_over()) {
        const double step = timed([&] { simulation.step(observe); });
        measured.run += step;
        if (simulation.steps() % EVERY != 0) continue;
        measured.timed += step;
        costs.measure(simulation.scene());
    }
    StateWriter state;
    measured.state = timed([&] { state(simulation, results); });
    volatile std::uint64_t kept = 0;
    measured.check = timed([&] { kept = io::checkpoint_checksum(state.bytes()); });
    return measured;
}

bool tell(const char* what, double share, double budget) {
    fmt::print("  {}: {:.3f} % of the run, budget {:g} %{}\n", what, 100.0 * share, 100.0 * budget,
               share < budget ? "" : ": MISSED");
    return share < budget;
}

/// What a run of this length writes with checksums beyond what it takes without, as a share.
double checksum_share(const Measured& of, const fs::path& file) {
    const double frames = benchmark::cost_of_fletcher(benchmark::dataset_sizes(file, "/frames")),
                 mesh = benchmark::cost_of_fletcher(benchmark::dataset_sizes(file, "/mesh")),
                 rows = benchmark::cost_of_fletcher(benchmark::dataset_sizes(file, "/history"));
    // Versions hold half of the rows, on average, and are as frequent as they can be
    const double versions = 0.5 * rows / VERSIONS + 2.0 * rows / of.run;
    const double checkpoints = of.check / std::max(CHECKPOINTS, PER_COST * of.state);
    fmt::print(
        "  checksums: {} frames {:.2f} ms, mesh {:.2f} ms, all histories {:.2f} ms, a "
        "checkpoint {:.2f} ms\n",
        of.frames_written, 1e3 * frames, 1e3 * mesh, 1e3 * rows, 1e3 * of.check);
    return (frames + mesh) / of.run + versions + checkpoints;
}

bool measure(const benchmark::DeckRun& run) {
    std::string folder = fs::temp_directory_path() / "benchmark_checks.XXXXXX";
    if (mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no directory " + folder);
    Simulation simulation = run.begin();
    benchmark::FiniteCosts costs(simulation.scene());
    io::RunInfo info;
    info.unit_system = simulation.model().unit_system;
    io::ResultsFile results(folder, info, simulation.layout());
    const Measured of = advance(simulation, results, costs);
    results.finish("normal");
    fmt::print("{}\n  {} steps, {} particles, {:.2f} s\n", run.name(), simulation.steps(),
               simulation.particles(), of.run);
    fmt::print(
        "  finite, of a step: displacements {:.3f} %, starts of flight {:.3f} %, nodes "
        "{:.3f} %, accounts {:.3f} %; frames {:.3f} % of the run\n",
        100.0 * costs.bounds / of.timed, 100.0 * costs.starts / of.timed,
        100.0 * costs.nodes / of.timed, 100.0 * costs.stops / of.timed, 100.0 * of.frames / of.run);
    bool holds = tell("finite checks", costs.sum() / of.timed + of.frames / of.run, FINITE_BUDGET);
    holds &=
        tell("checksums", checksum_share(of, fs::path(folder) / "results.h5"), CHECKSUM_BUDGET);
    fs::remove_all(folder);
    return holds;
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app{"What finite checks and checksums cost of a run"};
    benchmark::DeckRun own;
    benchmark::add_options(app, own);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    parallel::set_threads(1);
    std::vector<benchmark::DeckRun> runs{
        {CORPUSCLE_MODELS "/driver_bag_flat/driver_bag_flat.k", {}, 6.0},
        {CORPUSCLE_MODELS "/driver_bag_folded/driver_bag_folded.k", {}, 4.0},
        {CORPUSCLE_MODELS "/verification/box_at_rest/case.k", {"NP=100000"}, 2e-3}};
    if (!own.deck.empty()) runs = {own};
    bool holds = true;
    for (const benchmark::DeckRun& run : runs) holds &= measure(run);
    return holds ? 0 : 1;
} catch (const std::exception& error) {
    fmt::print(stderr, "benchmark_checks: {}\n", error.what());
    return 2;
}
