// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/history_response.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "io/results/history_table.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::study {
namespace {

using VectorPart = HistoryResponse::Part;
using HistoryRow = HistoryResponse::Which;

constexpr std::array<std::pair<const char*, HistoryRow>, 4> PREFIXES{{{"max:", HistoryRow::MAX},
                                                                      {"min:", HistoryRow::MIN},
                                                                      {"end:", HistoryRow::END},
                                                                      {"last:", HistoryRow::END}}};
constexpr std::array<std::pair<const char*, VectorPart>, 4> SUFFIXES{{{".x", VectorPart::X},
                                                                      {".y", VectorPart::Y},
                                                                      {".z", VectorPart::Z},
                                                                      {".norm", VectorPart::NORM}}};

std::string needs_part(const std::string& path) {
    return fmt::format("{} is a vector, expected {}.x, .y, .z or .norm", path, path);
}

std::string has_no_part(const std::string& path) {
    return fmt::format("{} is one number a row, expected it without .x, .y, .z or .norm", path);
}

/// One number a row.
std::vector<double> picked(const std::vector<double>& rows, VectorPart part) {
    std::vector<double> all;
    for (std::size_t at = 0; at + 2 < rows.size(); at += 3)
        all.push_back(part == VectorPart::NORM ? std::hypot(rows[at], rows[at + 1], rows[at + 2])
                                               : rows[at + static_cast<std::size_t>(part) -
                                                      static_cast<std::size_t>(VectorPart::X)]);
    return all;
}

}  // namespace

std::optional<HistoryResponse> history_response(const std::string& text) {
    HistoryResponse response;
    for (const auto& [prefix, which] : PREFIXES)
        if (text.starts_with(prefix)) {
            response.which = which;
            response.path = text.substr(text.find(':') + 1);
        }
    for (const auto& [suffix, part] : SUFFIXES)
        if (response.path.ends_with(suffix)) {
            response.part = part;
            response.path.resize(response.path.rfind('.'));
            break;
        }
    if (response.path.empty()) return {};
    return response;
}

std::string wrong_part(const HistoryResponse& response) {
    const std::string& path = response.path;
    if (!path.starts_with("/history")) return {};
    const bool is_vector = io::vector_histories().contains(path.substr(path.find_last_of('/') + 1));
    if (is_vector == (response.part != VectorPart::ALL)) return {};
    return is_vector ? needs_part(path) : has_no_part(path);
}

double value_of(const HistoryResponse& response, const io::Hdf5Reader& results) {
    const std::string& path = response.path;
    if (!results.has(path) || results.is_group(path))
        throw SystemError(fmt::format("the results hold no {}", path));
    std::vector<double> values = results.read<double>(path);
    const io::Shape shape = results.shape(path);
    const bool is_vector = shape.size() == 2 && shape[1] == 3;
    if (is_vector && response.part == VectorPart::ALL) throw SystemError(needs_part(path));
    if (!is_vector && response.part != VectorPart::ALL) throw SystemError(has_no_part(path));
    if (is_vector) values = picked(values, response.part);
    if (values.empty()) throw SystemError(fmt::format("{} is empty", path));
    switch (response.which) {
        case HistoryRow::MAX:
            return *std::max_element(values.begin(), values.end());
        case HistoryRow::MIN:
            return *std::min_element(values.begin(), values.end());
        case HistoryRow::END:
            break;
    }
    return values.back();
}

}  // namespace corpuscle::study
