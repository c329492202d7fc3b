// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "solver/base/threads.hpp"

namespace corpuscle::parallel {

/// Cores that hardware threads are on, by the list of siblings that the kernel has for each
/// (topology/thread_siblings_list). One without a list is a core of its own.
/// @param cpus  numbers of the hardware threads
[[nodiscard]] inline int cores_of(const std::vector<int>& cpus,
                                  const std::filesystem::path& sysfs) {
    std::set<std::string> cores;
    for (const int cpu : cpus) {
        const std::string name = "cpu" + std::to_string(cpu);
        std::ifstream in(sysfs / name / "topology" / "thread_siblings_list");
        std::string siblings;
        cores.insert(std::getline(in, siblings) && !siblings.empty() ? siblings : name);
    }
    return static_cast<int>(cores.size());
}

/// Cores that this program may use.
[[nodiscard]] inline int cores() {
    const std::vector<int> cpus = allowed_cpus();
    if (cpus.empty()) return processors();
    return std::clamp(cores_of(cpus, "/sys/devices/system/cpu"), 1, processors());
}

/// Threads of a run that is not told how many: as OMP_NUM_THREADS says, else one a core. A core's
/// second thread shares its vector units and caches, which loops over particles and elements fill.
[[nodiscard]] inline int default_threads() {
    return threads_of_environment() > 0 ? threads() : cores();
}

}  // namespace corpuscle::parallel
