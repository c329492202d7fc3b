// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/text/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

namespace corpuscle::io {
namespace {

constexpr auto RENEWAL = std::chrono::milliseconds(200);
constexpr int PERCENT = 5;  ///< a line each so many

/// Whole percents done; a time that is a rounding error short of one has reached it.
int percent_of(double share) {
    return static_cast<int>(100.0 * share + 1e-9);
}

}  // namespace

Progress::Progress(double end_time, bool quiet, std::FILE* to)
    : Progress(end_time, quiet, to, isatty(fileno(to)) != 0) {}

Progress::Progress(double end_time, bool quiet, std::FILE* to, bool is_terminal)
    : end_time_(end_time), quiet_(quiet), to_(to), is_terminal_(is_terminal) {}

bool Progress::is_due(double share) const {
    if (is_terminal_) return Clock::now() - shown_ >= RENEWAL;
    return percent_of(share) >= percent_shown_ + PERCENT;
}

void Progress::step(double t, double dt, std::string_view limiter, std::size_t particles,
                    double residual_share, std::int64_t step) {
    if (quiet_) return;
    state_.t = t;
    state_.dt = dt;
    state_.limiter = limiter;
    state_.particles = particles;
    state_.residual_share = residual_share;
    state_.step = step;
    has_begun_ = true;
    if (is_due(std::min(1.0, t / end_time_))) show();
}

void Progress::show() {
    const double share = std::min(1.0, state_.t / end_time_);
    const double spent = std::chrono::duration<double>(Clock::now() - start_).count();
    const double left = share > 0.0 ? spent / share - spent : 0.0;
    const std::string line = fmt::format(
        "{:3} %  t {:.5g}  step {}  dt {:.3g} ({})  {} particles  residual {:.2g} %  {}",
        percent_of(share), state_.t, state_.step, state_.dt, state_.limiter, state_.particles,
        100.0 * state_.residual_share,
        share < 1.0 ? "ETA " + duration_text(left) : "took " + duration_text(spent));
    if (is_terminal_) {
        fmt::print(to_, "\r{:<{}}", line, width_);  // blanks over the rest of a longer line
        width_ = line.size();
    } else {
        fmt::print(to_, "{}\n", line);
    }
    std::fflush(to_);
    shown_ = Clock::now();
    percent_shown_ = PERCENT * (percent_of(share) / PERCENT);
}

void Progress::finish() {
    if (!has_begun_ || !is_terminal_) return;
    show();
    fmt::print(to_, "\n");
    std::fflush(to_);
    has_begun_ = false;
}

std::string duration_text(double seconds) {
    const auto whole = static_cast<std::int64_t>(std::llround(seconds));
    if (whole < 60) return fmt::format("{} s", whole);
    if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
    return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace corpuscle::io
