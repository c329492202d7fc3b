// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace corpuscle::io {

/// Tells a person how far the run is: one line that renews itself at most five times a second on a
/// terminal, a line every 5 % elsewhere.
class Progress {
public:
    /// @param end_time  of the run [s]
    /// @param quiet     says nothing at all
    Progress(double end_time, bool quiet, std::FILE* to = stderr);
    /// The same, to a file that is taken for a terminal or not.
    Progress(double end_time, bool quiet, std::FILE* to, bool is_terminal);

    /// After every step.
    /// @param limiter         what limits dt
    /// @param residual_share  |ledger residual| / energy brought in [-]
    void step(double t, double dt, std::string_view limiter, std::size_t particles,
              double residual_share, std::int64_t step);
    /// After the run, however it ended: leaves the last state in sight.
    void finish();

private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool is_due(double share) const;
    void show();

    double end_time_;
    bool quiet_;
    std::FILE* to_;
    bool is_terminal_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_;
    int percent_shown_ = 0;  ///< multiple of 5
    std::size_t width_ = 0;  ///< of the line on the terminal
    struct State {
        double t = 0, dt = 0, residual_share = 0;
        std::string limiter;
        std::size_t particles = 0;
        std::int64_t step = 0;
    } state_;
    bool has_begun_ = false;
};

/// "42 s", "3 min 20 s", "2 h 05 min".                         @param seconds  not negative [s]
[[nodiscard]] std::string duration_text(double seconds);

}  // namespace corpuscle::io
