// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/threads.hpp"

namespace corpuscle::support {

/// Threads as a test wants them, then as they were.
class Threads {
public:
    explicit Threads(int n) { parallel::set_threads(n); }
    ~Threads() { parallel::set_threads(before_); }
    Threads(const Threads&) = delete;
    Threads& operator=(const Threads&) = delete;

private:
    int before_ = parallel::threads();
};

}  // namespace corpuscle::support
