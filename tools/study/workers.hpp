// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/study/study.hpp"

namespace corpuscle::study {

/// A run has ended: its row and its exit status.
using Ended = std::function<void(const Row&, int status)>;

/// A run of one of several studies.
struct Job {
    const Study* study;
    Row row;
};

/// Makes the jobs in order, `workers` at a time; as make_runs.
void make_jobs(const std::vector<Job>& jobs, int workers, const std::string& program,
               const std::function<void(const Job&, int status)>& ended);

/// Makes the runs, `study.workers` at a time, each a process of its own whose words go to
/// run_0001/log.txt, and writes the status of each.
///
/// @param program  path of corpuscle
/// @throws SystemError if this is interrupted (its runs are stopped, and are missing then)
void make_runs(const Study& study, const std::vector<Row>& rows, const std::string& program,
               const Ended& ended);

/// Path of the program that is running.
[[nodiscard]] std::string this_program();

}  // namespace corpuscle::study
