// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tools/verify/verdict.hpp"

namespace corpuscle::verify {

/// What shall be run, and where.
struct Plan {
    Mode mode = Mode::QUICK;
    std::filesystem::path folder;   ///< of all runs: one each for case and level in it
    std::filesystem::path program;  ///< corpuscle
    int workers = 1;                ///< runs at a time, one thread each
};

/// Makes all runs of the cases that are not there yet, and judges. A run counts as there for the
/// same program, deck, parameters and seed; what was broken off goes on from its checkpoint.
///
/// @param told  a line for each run that has ended
/// @throws SystemError if it is interrupted
[[nodiscard]] std::vector<Row> verify(const std::vector<Card>& cards, const Plan& plan,
                                      const std::function<void(const std::string&)>& told);

}  // namespace corpuscle::verify
