// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "io/results/hdf5.hpp"

namespace corpuscle::study {

/// A response that one number of a history is: "max:/history/rigidwall/5/force.z".
struct HistoryResponse {
    enum class Which { MAX, MIN, END };
    /// Of a vector: one of its numbers, or its length; of a history of one number that.
    enum class Part { ALL, X, Y, Z, NORM };

    Which which = Which::MAX;
    std::string path;
    Part part = Part::ALL;
};

/// "max:", "min:", "end:" or "last:", then the path of a history, then of a vector ".x", ".y", ".z"
/// or ".norm". Nothing if it has not that form.
[[nodiscard]] std::optional<HistoryResponse> history_response(const std::string& text);

/// What is wrong with the part that is asked for, by the name of the history: a vector without one,
/// one number with one. Empty: nothing.
[[nodiscard]] std::string wrong_part(const HistoryResponse& response);

/// The number, in the results' own unit.
/// @throws SystemError  where the results have no such history, or no such part of it
[[nodiscard]] double value_of(const HistoryResponse& response, const io::Hdf5Reader& results);

}  // namespace corpuscle::study
