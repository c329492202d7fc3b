// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/loop_observer.hpp"
#include "tests/benchmark/loop_sites.hpp"

namespace corpuscle::benchmark {

/// How a run would gain from more cores, from one run on one thread: each chunk of each loop that
/// threads would share is timed, then the loop's chunks are dealt out in their order to P ideal
/// cores, each to the first that is free [list scheduling, Graham 1969]; that core waits for what
/// the chunk waits for. What lies outside of such loops stays as it is. Ideal: caches and memory are
/// shared without a loss.
///
/// Of a loop that other programs interrupt, what they took is taken off its longest chunks.
class LoopMeter final : public parallel::LoopObserver {
public:
    using Clock = std::chrono::steady_clock;
    using Now = Clock::time_point (*)();

    static constexpr std::array<int, 7> CORES{1, 2, 4, 8, 16, 32, 64};
    using ByCores = std::array<double, CORES.size()>;

    /// What a loop's call site has taken, or the stretch between two loops.                   [s]
    struct Site {
        std::size_t calls = 0, waits = 0;  ///< of the threads; within a call on each other
        double time = 0.0;                 ///< on one thread
        ByCores dealt{};                   ///< on so many cores
        /// Lost on CORES[k] cores: beyond an even share of its time.
        [[nodiscard]] double lost(std::size_t k) const { return dealt[k] - time / CORES[k]; }
        Site& operator+=(const Site& other);
    };

    static Clock::time_point thread_time();  ///< that this thread has run

    /// @param now   reads the clock; a test's own is moved by hand
    /// @param busy  likewise of this thread alone
    explicit LoopMeter(Now now = &Clock::now, Now busy = &thread_time);

    void begin(const parallel::CallSite& where) override;
    void waits_for(std::size_t chunk) override;
    void end_chunk() override;
    void end_stage() override;
    void end() override;

    [[nodiscard]] double seconds() const { return outside() + loops_.time; }  ///< so far [s]
    [[nodiscard]] double outside() const;                                     ///< of loops [s]
    [[nodiscard]] std::size_t loops() const { return loops_.calls; }
    /// Predicted wall time on CORES[k] cores.                                                  [s]
    /// @param call  what it costs to call the threads to a loop; half of it, to wait      [s]
    [[nodiscard]] double wall(std::size_t k, double call = 0.0) const;
    /// By call site, file:line, of the loop, or of both ends of a stretch.
    [[nodiscard]] std::map<std::string, Site> sites() const { return by_text(by_call_); }

private:
    /// By either clock, whichever has less: one counts other programs in, the other is slow to read.
    [[nodiscard]] double since_last() const;  ///< [s]
    void deal_stage();
    void clear_chunks();

    Now now_, busy_;
    double cost_now_, cost_busy_;  ///< of a reading                                           [s]
    Clock::time_point last_, busy_last_;
    parallel::CallSite at_, before_;         ///< calls of this loop and the last
    std::vector<double> chunks_, free_at_;   ///< of the loop that runs                         [s]
    std::vector<std::size_t> before_chunk_;  ///< those that its chunks wait for, chunk by chunk
    std::vector<std::size_t> first_before_;  ///< by chunk: where its own begin
    Site loop_, loops_;                      ///< the one that runs; all
    double outside_ = 0.0;                   ///< up to the last loop                            [s]
    std::map<std::pair<Call, Call>, Site> by_call_;  ///< stretches from the first, or loops
};

}  // namespace corpuscle::benchmark
