// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/benchmark/loop_meter.hpp"

#include <algorithm>
#include <functional>

namespace corpuscle::benchmark {
namespace {

double seconds_of(LoopMeter::Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

/// Time until the last of the chunks is done on so many cores.
/// @param free_at  by core: when it is free; a heap, the least in front
double dealt_out(const std::vector<double>& chunks, int cores, std::vector<double>& free_at) {
    free_at.assign(static_cast<std::size_t>(cores), 0.0);
    double end = 0.0;
    for (const double chunk : chunks) {
        std::pop_heap(free_at.begin(), free_at.end(), std::greater<>());
        free_at.back() += chunk;
        end = std::max(end, free_at.back());
        std::push_heap(free_at.begin(), free_at.end(), std::greater<>());
    }
    return end;
}

}  // namespace

void LoopMeter::begin() {
    chunks_.clear();
    begin_ = last_ = now_();
}

void LoopMeter::end_chunk() {
    chunks_.push_back(seconds_of(now_() - last_));
    last_ = now_();
}

void LoopMeter::end() {
    const Clock::time_point end = now_();
    ++loops_;
    inside_ += seconds_of(end - begin_);
    for (std::size_t k = 0; k < CORES.size(); ++k)
        dealt_[k] += dealt_out(chunks_, CORES[k], free_at_);
    start_ += now_() - end;  // the dealing is none of the run
}

double LoopMeter::seconds() const {
    return seconds_of(now_() - start_);
}

double LoopMeter::wall(std::size_t k, double call) const {
    const double calls = CORES[k] > 1 ? call * static_cast<double>(loops_) : 0.0;
    return outside() + dealt_[k] + calls;
}

}  // namespace corpuscle::benchmark
