// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

#include "io/results/ascii_files.hpp"
#include "io/results/results_file.hpp"
#include "solver/simulation.hpp"
#include "tools/body_tracker.hpp"
#include "tools/summary.hpp"

namespace corpuscle::tools {

/// Times k · interval at which something is due, each met by the first step that reaches it.
class Schedule {
public:
    /// @param t  the first of them is t, or comes after it
    Schedule(double interval, double t)
        : interval_(interval), count_(std::ceil(t / interval * (1.0 - ROUNDING))) {
        next_ = count_ > 0.0 ? count_ * interval : (t > 0.0 ? INF : 0.0);
    }

    /// A checkpoint with another interval changes nothing.
    template <class Archive>
    void visit_state(Archive& archive) {
        Schedule other = *this;
        archive(other.interval_, other.next_, other.count_);
        if (other.interval_ == interval_) *this = other;
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
    double count_;  ///< of the next
    double next_;
};

inline double history_interval(const Model& model) {
    if (!std::isnan(model.output.abstat)) return model.output.abstat;
    if (!std::isnan(model.output.abstat_cpm)) return model.output.abstat_cpm;
    if (!std::isnan(model.output.glstat)) return model.output.glstat;
    return model.end_time / 1000.0;
}

/// Takes samples and frames when they are due, and hands them to the files.
class RunRecorder {
public:
    RunRecorder(const Simulation& simulation, io::ResultsFile& results, io::AsciiFiles& ascii)
        : results_(results),
          ascii_(ascii),
          bodies_(simulation, results),
          histories_(history_interval(simulation.model()), simulation.time()),
          frames_(
              std::isnan(simulation.model().output.frames) ? INF : simulation.model().output.frames,
              simulation.time()) {}

    /// `at_end`: the last state of a run. It and the first are always taken.
    void observe(Simulation& simulation, bool at_end) {
        const double t = simulation.time();
        bodies_.observe(simulation, at_end);
        const bool history = histories_.meets(t), ascii = ascii_.due(t), frame = frames_.meets(t);
        if (history || ascii || at_end) {
            const bool is_row = history || at_end;
            const Sample sample = is_row ? simulation.sample() : simulation.glance();
            if (is_row) results_.append(sample);
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

}  // namespace corpuscle::tools
