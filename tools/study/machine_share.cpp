// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/machine_share.hpp"

#include <algorithm>

namespace corpuscle::study {

void share_machine(Study& study, std::size_t runs, const Machine& machine) {
    const int wanted = static_cast<int>(
        std::clamp<std::size_t>(runs, 1, static_cast<std::size_t>(machine.hardware_threads)));
    if (!study.says_threads) {
        const int at_once = study.says_workers ? std::min(study.workers, wanted) : wanted;
        study.threads = std::clamp(machine.cores / at_once, 1, MOST_THREADS);
    }
    if (study.says_workers) return;
    const int room = study.threads > 1 ? machine.cores : machine.hardware_threads;
    study.workers = std::clamp(room / study.threads, 1, wanted);
}

}  // namespace corpuscle::study
