// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <cmath>
#include <csignal>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "gas/particles.hpp"
#include "io/results/ascii_files.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/results_file.hpp"
#include "io/system/folder_lock.hpp"
#include "io/text/progress.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tools/check/bad_starts.hpp"
#include "tools/commands/checkpoint_writer.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/run_recorder.hpp"
#include "tools/run_folder.hpp"
#include "tools/summary.hpp"
#include "tools/version.hpp"

namespace corpuscle::tools {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// Signals that end a run behind a checkpoint; under nohup it goes on without its terminal.
void heed_signals() {
    const auto interrupt = [](int) { interrupted = 1; };
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    if (std::signal(SIGHUP, interrupt) == SIG_IGN) std::signal(SIGHUP, SIG_IGN);
}

std::string folder_of(const RunArguments& arguments) {
    if (!arguments.folder.empty()) return arguments.folder;
    return std::filesystem::path(arguments.deck.file).filename().replace_extension("").string() +
           ".out";
}

/// Stops a run that would never reach its end, for its steps have become next to nothing.
class StepWatch {
public:
    explicit StepWatch(double end_time) : least_(LEAST_STEP * end_time) {}

    void see(const StepReport& step) {
        const bool is_asked =
            step.limit.who == StepLimit::Who::END || step.limit.who == StepLimit::Who::START;
        tiny_ = step.dt < least_ && !is_asked ? tiny_ + 1 : 0;
        if (tiny_ < PATIENCE) return;
        throw PhysicsError(
            step.t, fmt::format("the step is down to {:.4g}, set by {}: the end time is more than "
                                "{:g} such steps away",
                                step.dt, step.limit.text(), 1.0 / LEAST_STEP));
    }

private:
    static constexpr double LEAST_STEP = 1e-12;  ///< of the end time
    static constexpr int PATIENCE = 100;         ///< steps on end: a single one may be that short

    double least_;  ///< [s]
    int tiny_ = 0;  ///< steps on end that were shorter
};

void advance_to_end(Simulation& simulation, RunRecorder& recorder, CheckpointWriter& checkpoints,
                    io::Progress& progress) {
    const auto observe = [&](Simulation& at_t) { recorder.observe(at_t, false); };
    StepWatch watch(simulation.model().end_time);
    while (!simulation.is_over()) {
        const StepReport step = simulation.step(observe);
        if (simulation.steps() == 1)
            for (const std::string& warning : crossings_at_start(simulation))
                fmt::print(stderr, "warning: {}\n", warning);
        watch.see(step);
        const double share =
            recorder.brought > 0.0 ? std::abs(recorder.residual) / recorder.brought : 0.0;
        progress.step(simulation.time(), step.dt, step.limit.text(), simulation.particles(), share,
                      simulation.steps());
        if (interrupted || checkpoints.is_due(simulation.steps())) checkpoints.write(simulation);
        if (!interrupted) continue;
        checkpoints.finish();
        throw SystemError("interrupted; --restart goes on from here");
    }
    checkpoints.finish();
    simulation.close([&](Simulation& at_end) { recorder.observe(at_end, true); });
}

/// What a broken run leaves: its last state and why it ended, as far as the disk takes them.
void leave(Simulation& simulation, io::ResultsFile& results, const char* why) {
    const auto attempt = [](auto&& write) {
        try {
            write();
        } catch (const std::exception& error) {
            fmt::print(stderr, "corpuscle: {}\n", error.what());
        }
    };
    if (!results.has_frame_at(simulation.time()))
        attempt([&] {
            results.write(simulation.frame());
            results.settle();
        });
    attempt([&] { results.finish(fmt::format("error: {}", why)); });
}

/// Results whole, and the run's numbers beside them.
void finish(const Simulation& simulation, io::ResultsFile& results, const Summary& summary,
            const std::string& folder) {
    try {
        summary.write(simulation, folder);  // first: nobody goes on once results are finished
        results.finish("normal");
    } catch (const SystemError&) {
        fmt::print(stderr, "results so far: {}/results.h5, results.parts; --restart ends it\n",
                   folder);
        throw;
    }
}

/// The checkpoint that a restart goes on from; none: from the beginning.
std::optional<io::Checkpoint> checkpoint_for(const Simulation& simulation,
                                             const std::string& folder) {
    auto found = io::read_checkpoint(folder);
    if (!found) {
        fmt::print("no checkpoint in {}: the run starts from the beginning\n", folder);
        return found;
    }
    if (found->scene != simulation.fingerprint())
        throw InputError(
            fmt::format("--restart: the checkpoint in {} is of another scene; expected "
                        "the same deck, -D values and seed",
                        folder));
    if (const double end = simulation.model().end_time; found->t > end)
        throw InputError(
            fmt::format("--restart: end time = {:.6g}, expected {:.6g} or later: the checkpoint in "
                        "{} is of that time",
                        end, found->t, folder));
    fmt::print("going on from t = {:.6g}, step {}\n", found->t, found->step);
    return found;
}

/// Brings the scene to where the checkpoint is.
void go_to(StateReader& state, Simulation& simulation) {
    state(simulation);
    if (!simulation.is_finite())
        throw SystemError("the checkpoint holds a number that is not finite");
}

/// Likewise the files: once all of the checkpoint is read, for one that does not fit leaves them be.
void go_on(StateReader& state, RunRecorder& recorder, io::AsciiFiles& ascii,
           io::ResultsFile& results) {
    state(recorder);
    if (!state.is_at_end()) throw SystemError("the checkpoint holds more than the scene asks for");
    ascii.go_on();
    results.go_on();
}

/// Did a run of this scene come to its end in the folder before?
bool is_finished(const Simulation& simulation, const std::string& folder) {
    const auto run = io::finished_run(folder);
    if (!run) return false;
    if (run->scene != 0 && run->scene != simulation.fingerprint())
        throw InputError(fmt::format(
            "--restart: {}/results.h5 is of another scene; expected the same deck, -D values and "
            "seed",
            folder));
    const double end = simulation.model().end_time;
    if (run->end < end * (1.0 - 1e-9))
        throw InputError(
            fmt::format("--restart: the run in {} came to its end at {:.6g}, and left no "
                        "checkpoint to go on from to {:.6g}; start anew, without --restart",
                        folder, run->end, end));
    fmt::print("{}/results.h5 is of a run that came to its end: nothing is left to do\n", folder);
    return true;
}

}  // namespace

int run(const RunArguments& arguments) {
    Simulation simulation = load(arguments.deck);
    const Model& model = simulation.model();
    if (!arguments.quiet)
        for (const std::string& note : model.notes) fmt::print("note: {}\n", note);
    for (const std::string& warning : model.warnings) fmt::print(stderr, "warning: {}\n", warning);

    const std::string folder = folder_of(arguments);
    expect_own_results(folder);
    const io::FolderLock lock(folder);
    std::optional<io::Checkpoint> from;
    if (arguments.restart) {
        if (is_finished(simulation, folder)) return 0;
        from = checkpoint_for(simulation, folder);
    }
    if (!from) {
        io::remove_checkpoint(folder);
        remove_old_exports(folder);
    }

    const RecordLayout layout = simulation.layout();
    const io::RunInfo info =
        run_info(model, version(), arguments.deck.seed, simulation.fingerprint());
    StateReader state(from ? std::span<const char>(from->state) : std::span<const char>());
    if (from) go_to(state, simulation);
    io::ResultsFile results =
        from ? io::ResultsFile(folder, info, layout, state) : io::ResultsFile(folder, info, layout);
    io::AsciiFiles ascii =
        from ? io::AsciiFiles(folder, layout, model.output, model.title, simulation.time(), state)
             : io::AsciiFiles(folder, layout, model.output, model.title);
    RunRecorder recorder(simulation, results, ascii);
    if (from) go_on(state, recorder, ascii, results);
    from.reset();

    io::Progress progress(model.end_time, arguments.quiet);
    CheckpointWriter checkpoints(folder, simulation, results, ascii, recorder);
    heed_signals();

    const Summary summary;
    try {
        advance_to_end(simulation, recorder, checkpoints, progress);
    } catch (const std::exception& error) {
        leave(simulation, results, error.what());
        progress.finish();
        fmt::print(stderr, "results so far: {}/results.h5\n", folder);
        throw;
    }
    finish(simulation, results, summary, folder);
    io::remove_checkpoint(folder);
    progress.finish();
    if (!arguments.quiet) {
        summary.print(simulation, folder, recorder.worst_residual, recorder.brought);
        for (const io::BodyTable& table : results.responses())
            fmt::print("\n{}", io::responses_text(table));
    }
    return 0;
}

}  // namespace corpuscle::tools
