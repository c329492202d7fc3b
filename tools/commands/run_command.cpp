// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <future>
#include <optional>

#include <fmt/format.h>

#include "io/results/ascii_files.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/results_file.hpp"
#include "io/system/folder_lock.hpp"
#include "io/text/progress.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tools/body_tracker.hpp"
#include "tools/check/bad_starts.hpp"
#include "tools/commands/commands.hpp"
#include "tools/run_folder.hpp"
#include "tools/summary.hpp"
#include "tools/version.hpp"

namespace corpuscle::tools {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// Times k · interval at which something is due, each met by the first step that reaches it.
class Schedule {
public:
    explicit Schedule(double interval) : interval_(interval) {}

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(next_, count_);
    }
    /// Is one due at t? Marks it as met.
    bool meets(double t) {
        if (std::isnan(interval_) || t < next_ * (1.0 - ROUNDING)) return false;
        const double gone = t / interval_;
        if (gone * ROUNDING > 1.0) {  // an interval that t does not resolve: every step
            next_ = t;
            return true;
        }
        count_ = std::max(count_, std::floor(gone) - 1.0);
        while (next_ * (1.0 - ROUNDING) <= t) next_ = ++count_ * interval_;
        return true;
    }

private:
    static constexpr double ROUNDING = 1e-12;  ///< of times, which are sums of many steps

    double interval_;
    double next_ = 0.0;
    double count_ = 0.0;
};

double history_interval(const Model& model) {
    if (!std::isnan(model.output.abstat)) return model.output.abstat;
    if (!std::isnan(model.output.abstat_cpm)) return model.output.abstat_cpm;
    if (!std::isnan(model.output.glstat)) return model.output.glstat;
    return model.end_time / 1000.0;
}

std::string folder_of(const RunArguments& arguments) {
    if (!arguments.folder.empty()) return arguments.folder;
    return std::filesystem::path(arguments.deck.file).filename().replace_extension("").string() +
           ".out";
}

/// Takes samples and frames when they are due, and hands them to the files.
class Recorder {
public:
    Recorder(const Simulation& simulation, io::ResultsFile& results, io::AsciiFiles& ascii)
        : results_(results),
          ascii_(ascii),
          bodies_(simulation, results),
          histories_(history_interval(simulation.model())),
          frames_(std::isnan(simulation.model().output.frames) ? INF
                                                               : simulation.model().output.frames) {
    }

    /// `at_end`: the last state of a run. It and the first are always taken.
    void observe(Simulation& simulation, bool at_end) {
        const double t = simulation.time();
        bodies_.observe(simulation, at_end);
        const bool history = histories_.meets(t), ascii = ascii_.due(t), frame = frames_.meets(t);
        if (history || ascii || at_end) {
            const Sample sample = simulation.sample();
            if (history || at_end) results_.append(sample);
            if (ascii || at_end) ascii_.append(sample);
            if (std::isnan(start_kinetic_)) start_kinetic_ = sample.energy.kinetic;
            residual = sample.energy.residual;
            brought = brought_in(sample.energy, start_kinetic_);
            worst_residual = std::max(worst_residual, std::abs(residual));
        }
        if (frame || at_end) results_.write(simulation.frame());
    }

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(residual, brought, worst_residual, start_kinetic_, bodies_, histories_, frames_);
    }

    double residual = 0.0, brought = 0.0, worst_residual = 0.0;  ///< [J]

private:
    io::ResultsFile& results_;
    io::AsciiFiles& ascii_;
    double start_kinetic_ = NaN;  ///< [J]
    BodyTracker bodies_;
    Schedule histories_, frames_;
};

/// Keeps the run's checkpoint: after every so many steps if the deck says so (D3DUMP), else by the
/// clock.
class Keeper {
public:
    Keeper(const std::string& folder, const Simulation& simulation, io::ResultsFile& results,
           io::AsciiFiles& ascii, Recorder& recorder)
        : folder_(folder),
          steps_(simulation.model().output.checkpoint_steps),
          scene_(simulation.fingerprint()),
          results_(results),
          ascii_(ascii),
          recorder_(recorder) {}

    [[nodiscard]] bool is_due(std::int64_t step) const {
        if (!std::isnan(steps_)) return std::fmod(static_cast<double>(step), steps_) == 0.0;
        return Clock::now() - written_at_ >= std::max<Clock::duration>(PATIENCE, PER_COST * cost_);
    }
    void write(Simulation& simulation) {
        finish();
        const auto begin = Clock::now();
        StateWriter state;
        state(simulation, results_, ascii_, recorder_);
        written_ = std::async(
            std::launch::async,
            [folder = folder_,
             made = io::Checkpoint{scene_, simulation.time(), simulation.steps(), state.take()}] {
                io::write_checkpoint(folder, made);
            });
        written_at_ = Clock::now();
        cost_ = written_at_ - begin;
    }
    /// Waits until the last one is on the disk.
    void finish() {
        if (written_.valid()) written_.get();
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr auto PATIENCE = std::chrono::seconds(2);
    static constexpr int PER_COST = 50;  ///< 2 % of the run at most

    std::string folder_;
    double steps_;
    std::uint64_t scene_;
    io::ResultsFile& results_;
    io::AsciiFiles& ascii_;
    Recorder& recorder_;
    Clock::time_point written_at_ = Clock::now();
    Clock::duration cost_{};
    std::future<void> written_;  ///< by a thread of its own, while the run goes on
};

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

void advance_to_end(Simulation& simulation, Recorder& recorder, Keeper& keeper,
                    io::Progress& progress) {
    const auto observe = [&](Simulation& at_t) { recorder.observe(at_t, false); };
    StepWatch watch(simulation.model().end_time);
    while (!simulation.is_over()) {
        const StepReport step = simulation.step(observe);
        if (simulation.steps() == 1)
            for (const std::string& warning : crossings_at_start(simulation))
                fmt::print(stderr, "WARNING: {}\n", warning);
        watch.see(step);
        const double share =
            recorder.brought > 0.0 ? std::abs(recorder.residual) / recorder.brought : 0.0;
        progress.step(simulation.time(), step.dt, step.limit.text(), simulation.particles(), share,
                      simulation.steps());
        if (interrupted || keeper.is_due(simulation.steps())) keeper.write(simulation);
        if (!interrupted) continue;
        keeper.finish();
        throw SystemError("interrupted; --restart goes on from here");
    }
    keeper.finish();
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
    fmt::print("going on from t = {:.6g}, step {}\n", found->t, found->step);
    return found;
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
    if (from) state(simulation);
    io::ResultsFile results =
        from ? io::ResultsFile(folder, info, layout, state) : io::ResultsFile(folder, info, layout);
    io::AsciiFiles ascii = from ? io::AsciiFiles(folder, layout, model.output, model.title, state)
                                : io::AsciiFiles(folder, layout, model.output, model.title);
    Recorder recorder(simulation, results, ascii);
    if (from) state(recorder);
    if (!state.is_at_end()) throw SystemError("the checkpoint holds more than the scene asks for");
    from.reset();

    io::Progress progress(model.end_time, arguments.quiet);
    Keeper keeper(folder, simulation, results, ascii, recorder);
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });

    const Summary summary;
    try {
        advance_to_end(simulation, recorder, keeper, progress);
    } catch (const std::exception& error) {
        leave(simulation, results, error.what());
        progress.finish();
        fmt::print(stderr, "results so far: {}/results.h5\n", folder);
        throw;
    }
    try {
        summary.write(simulation, folder);  // first: nobody goes on once results are finished
        results.finish("normal");
    } catch (const SystemError&) {
        fmt::print(stderr, "results so far: {}/results.h5, results.parts; --restart ends it\n",
                   folder);
        throw;
    }
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
