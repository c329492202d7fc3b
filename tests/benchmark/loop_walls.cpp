// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/benchmark/loop_walls.hpp"

namespace corpuscle::benchmark {

double LoopWalls::lap() {
    const Clock::time_point now = Clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
}

double LoopWalls::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void LoopWalls::begin(const parallel::CallSite& where) {
    at_ = where;
    by_call_[{call_of(before_), call_of(at_)}] += lap();
}

void LoopWalls::end() {
    by_call_[{Call{}, call_of(at_)}] += lap();
    before_ = at_;
}

}  // namespace corpuscle::benchmark
