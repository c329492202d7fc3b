// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/export/history_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <sstream>

#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

void gather(const Hdf5Reader& results, const std::string& group, const std::string& below,
            std::size_t rows, std::vector<History>& all) {
    for (const std::string& name : results.names(group + below)) {
        const std::string path = below + "/" + name, full = group + path;
        if (results.is_group(full)) {
            gather(results, group, path, rows, all);
            continue;
        }
        const Shape shape = results.shape(full);
        if (shape.empty() || shape[0] != rows) continue;  // a body's mass is no history
        all.push_back({path.substr(1), results.text(full, "unit"),
                       shape.size() == 2 ? static_cast<std::size_t>(shape[1]) : 1,
                       results.read<double>(full)});
    }
}

/// A name or unit in a heading never holds a comma or a quote.
std::string heading(const History& history, std::size_t column) {
    constexpr std::array COMPONENTS{"x", "y", "z"};
    return history.columns == 1
               ? fmt::format("{} [{}]", history.path, history.unit)
               : fmt::format("{}.{} [{}]", history.path, COMPONENTS.at(column), history.unit);
}

}  // namespace

std::vector<History> read_histories(const Hdf5Reader& results, const std::string& group) {
    if (!results.has(group + "/time"))
        throw SystemError(fmt::format("the results hold no {}/time", group));
    std::vector<History> all;
    gather(results, group, "", static_cast<std::size_t>(results.shape(group + "/time").at(0)), all);
    std::stable_partition(all.begin(), all.end(),
                          [](const History& history) { return history.path == "time"; });
    return all;
}

std::map<int, std::string> part_titles(const Hdf5Reader& results) {
    std::map<int, std::string> titles;
    if (!results.has_attribute("/", "part_titles")) return titles;
    std::istringstream lines(results.text("/", "part_titles"));
    for (std::string line; std::getline(lines, line);) {
        const std::size_t blank = std::min(line.find(' '), line.size());
        titles[std::atoi(line.substr(0, blank).c_str())] =
            blank < line.size() ? line.substr(blank + 1) : "";
    }
    return titles;
}

std::string csv_text(const std::vector<History>& histories) {
    std::string text;
    const auto cells = [&](auto&& cell) {
        const std::size_t line = text.size();
        for (const History& history : histories)
            for (std::size_t c = 0; c < history.columns; ++c) {
                if (text.size() > line) text += ',';
                cell(history, c);
            }
        text += '\n';
    };
    cells([&](const History& history, std::size_t c) { text += heading(history, c); });
    const std::size_t rows = histories.empty() ? 0 : histories.front().values.size();
    for (std::size_t row = 0; row < rows; ++row)
        cells([&](const History& history, std::size_t c) {
            fmt::format_to(std::back_inserter(text), "{}",
                           history.values[row * history.columns + c]);
        });
    return text;
}

bool is_own_csv(std::string_view beginning) {
    const std::string_view line = beginning.substr(0, beginning.find('\n'));
    const std::size_t second = std::min(line.find(','), line.size());
    return line.starts_with("time [") && line.find('/', second) != std::string_view::npos;
}

}  // namespace corpuscle::io
