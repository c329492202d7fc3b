// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <cmath>
#include <csignal>
#include <filesystem>

#include <fmt/core.h>

#include "io/ascii_files.hpp"
#include "io/deck.hpp"
#include "io/progress.hpp"
#include "io/results_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tools/commands.hpp"
#include "tools/summary.hpp"

namespace corpuscle::tools {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// Times k · interval at which something is due, each met by the first step that reaches it.
class Schedule {
public:
    explicit Schedule(double interval) : interval_(interval) {}
    /// Is one due at t? Marks it as met.
    bool meets(double t) {
        if (std::isnan(interval_) || t < next_ * (1.0 - 1e-12)) return false;
        while (next_ * (1.0 - 1e-12) <= t) next_ = ++count_ * interval_;
        return true;
    }

private:
    double interval_;
    double next_ = 0.0;
    double count_ = 0.0;
};

double history_interval(const Model& model) {
    if (!std::isnan(model.output.abstat)) return model.output.abstat;
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
          histories_(history_interval(simulation.model())),
          frames_(simulation.model().output.frames) {}

    /// `at_end`: the last state of a run, always taken.
    void observe(Simulation& simulation, bool at_end) {
        const double t = simulation.time();
        const bool history = histories_.meets(t), ascii = ascii_.due(t), frame = frames_.meets(t);
        if (history || ascii || at_end) {
            const Sample sample = simulation.sample();
            if (history || at_end) results_.append(sample);
            if (ascii || at_end) ascii_.append(sample);
            residual = sample.energy.residual;
            brought = sample.energy.inflow + std::abs(sample.energy.external);
            worst_residual = std::max(worst_residual, std::abs(residual));
        }
        if (frame || at_end) results_.write(simulation.frame());
    }

    double residual = 0.0, brought = 0.0, worst_residual = 0.0;  ///< [J]

private:
    io::ResultsFile& results_;
    io::AsciiFiles& ascii_;
    Schedule histories_, frames_;
};

void advance_to_end(Simulation& simulation, Recorder& recorder, io::Progress& progress) {
    const auto observe = [&](Simulation& at_t) { recorder.observe(at_t, false); };
    while (!simulation.is_over()) {
        const StepReport step = simulation.step(observe);
        const double share =
            recorder.brought > 0.0 ? std::abs(recorder.residual) / recorder.brought : 0.0;
        progress.step(simulation.time(), step.dt, step.limit.text(), simulation.particles(), share,
                      simulation.steps());
        if (interrupted) throw SystemError("interrupted");
    }
    simulation.close([&](Simulation& at_end) { recorder.observe(at_end, true); });
}

}  // namespace

Model load(const DeckArguments& arguments) {
    if (arguments.threads > 0) parallel::set_threads(arguments.threads);
    io::DeckOptions options;
    for (const std::string& definition : arguments.definitions) {
        const std::size_t equals = definition.find('=');
        if (equals == std::string::npos || equals == 0)
            throw InputError(fmt::format("-D {}: expected NAME=VALUE", definition));
        options.overrides.emplace_back(definition.substr(0, equals), definition.substr(equals + 1));
    }
    Model model = io::read_deck(arguments.file, options);
    if (arguments.until) {
        if (!(*arguments.until > 0.0) || !std::isfinite(*arguments.until))
            throw InputError(fmt::format("--until {}: expected a time above 0", *arguments.until));
        model.end_time = *arguments.until;
    }
    return model;
}

int run(const RunArguments& arguments) {
    if (arguments.restart)
        throw SystemError(
            "--restart: runs write no checkpoints yet; start the run anew without it");
    Simulation simulation(load(arguments.deck), arguments.deck.seed);
    const Model& model = simulation.model();
    if (!arguments.quiet)
        for (const std::string& note : model.notes) fmt::print("{}\n", note);
    for (const std::string& warning : model.warnings) fmt::print(stderr, "warning: {}\n", warning);

    const std::string folder = folder_of(arguments);
    const RecordLayout layout = simulation.layout();
    io::ResultsFile results(folder,
                            {"corpuscle", std::string(VERSION), model.deck, model.unit_system,
                             arguments.deck.seed, parallel::threads()},
                            layout);
    io::AsciiFiles ascii(folder, layout, model.output, model.title);
    io::Progress progress(model.end_time, arguments.quiet);
    Recorder recorder(simulation, results, ascii);
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });

    const Summary summary;
    try {
        advance_to_end(simulation, recorder, progress);
    } catch (const std::exception& error) {
        results.write(simulation.frame());
        results.finish(fmt::format("error: {}", error.what()));
        progress.finish();
        fmt::print(stderr, "results so far: {}/results.h5\n", folder);
        throw;
    }
    results.finish("normal");
    progress.finish();
    if (!arguments.quiet) summary.print(simulation, folder, recorder.worst_residual);
    return 0;
}

}  // namespace corpuscle::tools
