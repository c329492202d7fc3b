// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"
#include "tools/study/study.hpp"

namespace corpuscle::study {

struct Cost {
    double seconds = 0.0;      ///< by the clock
    double cpu_seconds = NaN;  ///< of all threads
};

/// How a run of the study ended, as STUDY/run_0001/status tells.
struct Outcome {
    bool is_finished = false;  ///< else it is missing, and the rest means nothing
    int status = 0;            ///< exit status of the run
    Cost cost;
    std::string reason;              ///< of a failure
    std::vector<double> responses;   ///< NaN: none
    std::vector<std::string> units;  ///< of the responses, "" where there is none
};

[[nodiscard]] std::filesystem::path folder_of(const Study& study, const Row& row);

/// The deck of a row: the study's, or that of its mesh.
[[nodiscard]] std::filesystem::path deck_of(const Study& study, const Row& row);

/// All that decides what a run computes, in one line: a finished run of another key is not this
/// one. The deck stands in it by the fingerprint of its text when the study was read.
[[nodiscard]] std::string key_of(const Study& study, const Row& row);

/// NAME=VALUE, the fixed ones first.
[[nodiscard]] std::vector<std::string> definitions_of(const Study& study, const Row& row);

/// "BODY.RESPONSE", or what history_response() knows.
[[nodiscard]] bool has_form_of_response(const std::string& response);

/// Puts the end of a run on the disk, in one stroke.
void write_status(const Study& study, const Row& row, int status, const Cost& cost,
                  const std::string& reason);

/// What the disk knows of a run. A response that the results do not hold makes a normal run one
/// that failed, for that reason.
[[nodiscard]] Outcome read_outcome(const Study& study, const Row& row);

}  // namespace corpuscle::study
