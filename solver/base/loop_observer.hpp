// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>

#include "solver/base/call_site.hpp"

namespace corpuscle::parallel {

/// Watches the loops that threads share, from its construction to its end; one at a time.
class LoopObserver {
public:
    LoopObserver() { running = this; }
    virtual ~LoopObserver() { running = nullptr; }
    LoopObserver(const LoopObserver&) = delete;
    LoopObserver& operator=(const LoopObserver&) = delete;

    /// Before a loop, on the thread that calls it; of several side by side the first one's call.
    virtual void begin(const CallSite& where) = 0;
    /// After it, on the same thread, all chunks being done.
    virtual void end() = 0;
    /// After each of its chunks, on the thread that did it.
    virtual void end_chunk() = 0;
    /// Before a chunk that waits for another, which is the so many-th that was begun in the loop.
    virtual void waits_for(std::size_t /*chunk*/) {}
    /// After each of several loops in turn, on one thread.
    virtual void end_stage() {}

    inline static LoopObserver* running = nullptr;  ///< the one that watches now; nullptr: none
};

/// Wall time within loops that threads share.
class LoopClock final : public LoopObserver {
public:
    void begin(const CallSite& /*where*/) override { begin_ = Clock::now(); }
    /// Adds the time since begin().
    void end() override { inside_ += Clock::now() - begin_; }
    void end_chunk() override {}
    [[nodiscard]] double seconds() const {  ///< so far [s]
        return std::chrono::duration<double>(inside_).count();
    }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point begin_;
    Clock::duration inside_{};
};

}  // namespace corpuscle::parallel
