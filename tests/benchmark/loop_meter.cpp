// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/benchmark/loop_meter.hpp"

#include <algorithm>
#include <ctime>
#include <functional>
#include <numeric>
#include <span>

namespace corpuscle::benchmark {
namespace {

double seconds_of(LoopMeter::Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

/// Least time from one reading to the next.                                                  [s]
double cost_of(LoopMeter::Now clock) {
    auto least = LoopMeter::Clock::duration::max();
    for (int i = 0; i < 1000; ++i) {
        const auto first = clock();
        least = std::min(least, clock() - first);
    }
    return seconds_of(least);
}

/// Chunks of a loop, and what each of them waits for, in compressed rows.
struct Chunks {
    std::span<const double> time;  ///< [s]
    std::span<const std::size_t> first, before;

    /// When the last that a chunk waits for is done.                                          [s]
    [[nodiscard]] double is_free(std::size_t chunk, std::span<const double> done) const {
        double at = 0.0;
        for (std::size_t k = first[chunk]; k < first[chunk + 1]; ++k)
            at = std::max(at, done[before[k]]);
        return at;
    }
};

/// Time until the last of the chunks is done on so many cores, each of which takes the next one
/// when it has done its last, and waits until that may begin.
/// @param free_at  by core: when it is free; a heap, the least in front; then by chunk: its end
double dealt_out(const Chunks& chunks, int cores, std::vector<double>& free_at) {
    const auto n = static_cast<std::ptrdiff_t>(cores);
    free_at.assign(static_cast<std::size_t>(cores) + chunks.time.size(), 0.0);
    const auto begin = free_at.begin(), end = begin + n;
    const auto done = std::span(free_at).subspan(static_cast<std::size_t>(cores));
    double last = 0.0;
    for (std::size_t c = 0; c < chunks.time.size(); ++c) {
        std::pop_heap(begin, end, std::greater<>());
        double& core = *(end - 1);
        core = std::max(core, chunks.is_free(c, done)) + chunks.time[c];
        done[c] = core;
        last = std::max(last, core);
        std::push_heap(begin, end, std::greater<>());
    }
    return last;
}

}  // namespace

LoopMeter::Site& LoopMeter::Site::operator+=(const Site& other) {
    calls += other.calls;
    waits += other.waits;
    time += other.time;
    for (std::size_t k = 0; k < CORES.size(); ++k) dealt[k] += other.dealt[k];
    return *this;
}

LoopMeter::Clock::time_point LoopMeter::thread_time() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return Clock::time_point(std::chrono::seconds(time.tv_sec) +
                             std::chrono::nanoseconds(time.tv_nsec));
}

LoopMeter::LoopMeter(Now now, Now busy)
    : now_(now),
      busy_(busy),
      cost_now_(cost_of(now)),
      cost_busy_(cost_of(busy)),
      last_(now()),
      busy_last_(busy()) {}

double LoopMeter::since_last() const {
    const double all = seconds_of(now_() - last_) - cost_now_;
    const double own = seconds_of(busy_() - busy_last_) - cost_busy_;
    return std::max(0.0, std::min(all, own));
}

void LoopMeter::begin(const parallel::CallSite& where) {
    const double stretch = since_last();
    at_ = where;
    outside_ += stretch;
    Site serial;
    serial.time = stretch;
    serial.dealt.fill(stretch);
    by_call_[{call_of(before_), call_of(at_)}] += serial;
    clear_chunks();
    loop_ = {};
    busy_last_ = busy_();
    last_ = now_();
}

void LoopMeter::clear_chunks() {
    chunks_.clear();
    before_chunk_.clear();
    first_before_.assign(1, 0);
}

void LoopMeter::waits_for(std::size_t chunk) {
    before_chunk_.push_back(chunk);
}

void LoopMeter::end_chunk() {
    const Clock::time_point now = now_();
    chunks_.push_back(std::max(0.0, seconds_of(now - last_) - cost_now_));
    first_before_.push_back(before_chunk_.size());
    last_ = now;
}

/// Deals out the chunks of a loop, or of one of several in turn.
void LoopMeter::deal_stage() {
    if (chunks_.empty()) return;
    const double all = std::accumulate(chunks_.begin(), chunks_.end(), 0.0);
    const double busy = seconds_of(busy_() - busy_last_) - cost_busy_ -
                        cost_now_ * static_cast<double>(chunks_.size());
    const double lost = std::max(0.0, all - busy);
    for (double left = lost; left > 0.0;) {
        double& longest = *std::max_element(chunks_.begin(), chunks_.end());
        const double taken = std::min(longest, left);
        longest -= taken;
        left = taken > 0.0 ? left - taken : 0.0;
    }
    loop_.time += all - lost;
    for (std::size_t k = 0; k < CORES.size(); ++k)
        loop_.dealt[k] += dealt_out({chunks_, first_before_, before_chunk_}, CORES[k], free_at_);
    clear_chunks();
}

void LoopMeter::end_stage() {
    if (!chunks_.empty()) ++loop_.waits;
    deal_stage();
    busy_last_ = busy_();
    last_ = now_();
}

void LoopMeter::end() {
    deal_stage();
    if (loop_.waits > 0) --loop_.waits;  // the last one is that of any loop
    loop_.calls = 1;
    loops_ += loop_;
    by_call_[{Call{}, call_of(at_)}] += loop_;
    before_ = at_;
    busy_last_ = busy_();  // the dealing is none of the run
    last_ = now_();
}

double LoopMeter::outside() const {
    return outside_ + since_last();
}

double LoopMeter::wall(std::size_t k, double call) const {
    const double calls =
        static_cast<double>(loops_.calls) + 0.5 * static_cast<double>(loops_.waits);
    return outside() + loops_.dealt[k] + (CORES[k] > 1 ? call * calls : 0.0);
}

}  // namespace corpuscle::benchmark
