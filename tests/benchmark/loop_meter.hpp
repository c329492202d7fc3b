// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <vector>

#include "solver/base/loop_observer.hpp"

namespace corpuscle::benchmark {

/// How a run would gain from more cores, from one run on one thread: each chunk of each loop that
/// threads would share is timed, then the loop's chunks are dealt out in their order to P ideal
/// cores, each to the first that is free [list scheduling, Graham 1969]. What lies outside of such
/// loops stays as it is. Ideal: caches and memory are shared without a loss.
class LoopMeter final : public parallel::LoopObserver {
public:
    using Clock = std::chrono::steady_clock;
    using Now = Clock::time_point (*)();

    static constexpr std::array<int, 7> CORES{1, 2, 4, 8, 16, 32, 64};

    /// @param now  reads the clock; a test's own is moved by hand
    explicit LoopMeter(Now now = &Clock::now) : now_(now) {}

    void begin() override;
    void end_chunk() override;
    void end() override;

    [[nodiscard]] double seconds() const;                                 ///< since the start [s]
    [[nodiscard]] double outside() const { return seconds() - inside_; }  ///< of loops        [s]
    [[nodiscard]] std::size_t loops() const { return loops_; }
    /// Predicted wall time on CORES[k] cores.                                                  [s]
    /// @param call  what it costs to call the threads to a loop                               [s]
    [[nodiscard]] double wall(std::size_t k, double call = 0.0) const;

private:
    Now now_;
    Clock::time_point start_ = now_(), begin_, last_;
    std::vector<double> chunks_, free_at_;      ///< of the loop that runs                     [s]
    double inside_ = 0.0;                       ///< [s]
    std::array<double, CORES.size()> dealt_{};  ///< all loops, on so many cores               [s]
    std::size_t loops_ = 0;
};

}  // namespace corpuscle::benchmark
