// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tools/study/study.hpp"

namespace corpuscle::study {

/// The runs of share k of n: every n-th, from the k-th on (from 0).
struct Share {
    std::size_t k = 0, n = 1;
};

/// Slurm's MaxArraySize is 1001 by default: an array has this many jobs at most, and each then
/// makes every so-many-th run.
inline constexpr std::size_t MOST_JOBS = 1000;

/// Hands the runs to Slurm: an array of jobs, `study.workers` of them at a time, and a job after
/// it, however it ends, that makes the table. Returns what to tell the user.
/// @param options  of `corpuscle study` that hold for the jobs' runs, such as " --retry-failed"
/// @throws SystemError where there is no sbatch, or where it refuses
[[nodiscard]] std::string submit(const Study& study, std::size_t runs, const std::string& program,
                                 const std::string& options);

}  // namespace corpuscle::study
