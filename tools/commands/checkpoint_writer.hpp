// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cmath>
#include <future>
#include <string>
#include <utility>

#include "io/results/ascii_files.hpp"
#include "io/results/checkpoint.hpp"
#include "io/results/results_file.hpp"
#include "solver/base/archive.hpp"
#include "solver/simulation.hpp"
#include "tools/commands/run_recorder.hpp"

namespace corpuscle::tools {

/// Keeps the run's checkpoint: after every so many steps if the deck says so (D3DUMP), else by the
/// clock.
class CheckpointWriter {
public:
    CheckpointWriter(const std::string& folder, const Simulation& simulation,
                     io::ResultsFile& results, io::AsciiFiles& ascii, RunRecorder& recorder)
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
    /// Not of a state that the next step stops at: the one before it stays.
    void write(Simulation& simulation) {
        finish();
        if (!simulation.is_finite()) return;
        const auto begin = Clock::now();
        StateWriter state(size_ + size_ / 8);
        state(simulation, results_, ascii_, recorder_);
        size_ = state.bytes().size();
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
    RunRecorder& recorder_;
    Clock::time_point written_at_ = Clock::now();
    Clock::duration cost_{};
    std::size_t size_ = 0;       ///< of the last one's state, bytes
    std::future<void> written_;  ///< by a thread of its own, while the run goes on
};

}  // namespace corpuscle::tools
