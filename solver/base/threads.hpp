// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <sched.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace corpuscle::parallel {

/// Hardware threads that this program may use, by their numbers; empty: not known.
[[nodiscard]] inline std::vector<int> allowed_cpus() {
    cpu_set_t set;
    CPU_ZERO(&set);
    std::vector<int> cpus;
    if (sched_getaffinity(0, sizeof(set), &set) != 0) return cpus;
    for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
        if (CPU_ISSET(cpu, &set)) cpus.push_back(cpu);
    return cpus;
}

/// Hardware threads that this program may use, 1 at least; built without threads it uses one.
[[nodiscard]] inline int processors() {
#ifdef CORPUSCLE_THREADS
    static const int count = std::max(1, static_cast<int>(allowed_cpus().size()));
    return count;
#else
    return 1;
#endif
}

/// As OMP_NUM_THREADS says; 0 where it says nothing.
[[nodiscard]] inline int threads_of_environment() {
    const char* const text = std::getenv("OMP_NUM_THREADS");
    const std::string_view digits = text == nullptr ? "" : text;
    int n = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), n);
    return std::max(0, n);
}

namespace wanted {
inline int threads = threads_of_environment();  ///< 0: one a processor
}

/// Threads that the next loop may use.
[[nodiscard]] inline int threads() {
    return wanted::threads > 0 ? wanted::threads : processors();
}

/// Threads of all loops from now on, n >= 1; built without threads there is one.
inline void set_threads([[maybe_unused]] int n) {
#ifdef CORPUSCLE_THREADS
    wanted::threads = n;
#endif
}

}  // namespace corpuscle::parallel
