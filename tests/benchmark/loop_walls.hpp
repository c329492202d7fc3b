// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

#include "solver/base/loop_observer.hpp"
#include "tests/benchmark/loop_sites.hpp"

namespace corpuscle::benchmark {

/// Wall time of a run on the threads that it has, by the call sites of its loops and by the
/// stretches between two of them, as LoopMeter names them.
class LoopWalls final : public parallel::LoopObserver {
public:
    void begin(const parallel::CallSite& where) override;
    void end() override;
    void end_chunk() override {}

    [[nodiscard]] double seconds() const;  ///< so far [s]
    /// By call site, file:line, of the loop, or of both ends of a stretch.                    [s]
    [[nodiscard]] std::map<std::string, double> sites() const { return by_text(by_call_); }

private:
    using Clock = std::chrono::steady_clock;

    double lap();  ///< since the last one [s]

    Clock::time_point start_ = Clock::now(), last_ = start_;
    parallel::CallSite at_, before_;  ///< calls of this loop and the last
    std::map<std::pair<Call, Call>, double> by_call_;
};

}  // namespace corpuscle::benchmark
