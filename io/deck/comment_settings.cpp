// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/comment_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "io/text/text.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::io {
namespace {

constexpr std::string_view MARK = "corpuscle:";
constexpr std::array<std::string_view, 5> NAMES{"CLOSE", "COLLISION", "DIALECT", "MEAN_FREE_PATH",
                                                "UNITS"};

/// What stands behind the mark, where the line is a comment that begins with it.
std::string_view settings_of(std::string_view line) {
    line = without_mark(line);
    if (!line.starts_with('$')) return {};
    line.remove_prefix(std::min(line.find_first_not_of("$#"), line.size()));
    line = trim(line);
    return line.starts_with(MARK) ? line.substr(MARK.size()) : std::string_view();
}

void define(std::string_view setting, Place at, Parameters& parameters, Faults& faults) {
    const std::size_t is = setting.find('=');
    const std::string name = upper(trim(setting.substr(0, is)));
    const std::string_view value =
        is == std::string_view::npos ? std::string_view() : trim(setting.substr(is + 1));
    if (value.empty() || std::find(NAMES.begin(), NAMES.end(), name) == NAMES.end()) {
        faults.fault(at, fmt::format("$ corpuscle: {}, expected NAME = VALUE, NAME one of {}",
                                     trim(setting), fmt::join(NAMES, ", ")));
        return;
    }
    Parameter parameter;
    parameter.type = 'C';
    parameter.text = parameters.take_override(name).value_or(std::string(value));
    parameter.value.number = parse_real(parameter.text).value_or(NaN);
    parameter.place = at;
    if (parameters.last(name, at.file, /*local=*/false) == nullptr)
        parameters.define(name, std::move(parameter), /*local=*/false);
}

}  // namespace

void read_comment_settings(std::string_view text, std::uint32_t file, Parameters& parameters,
                           Faults& faults) {
    std::size_t counted = 0;
    std::uint32_t line = 1;
    for (std::size_t found = text.find(MARK); found != std::string_view::npos;
         found = text.find(MARK, found + 1)) {
        const std::size_t before = text.rfind('\n', found);
        const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
        std::string_view rest = settings_of(
            text.substr(begin, std::min(text.find_first_of("\r\n", found), text.size()) - begin));
        line += static_cast<std::uint32_t>(
            std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                       text.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
        counted = begin;
        while (!trim(rest).empty()) {
            const std::size_t comma = std::min(rest.find(','), rest.size());
            define(rest.substr(0, comma), {file, line}, parameters, faults);
            rest.remove_prefix(std::min(comma + 1, rest.size()));
        }
    }
}

}  // namespace corpuscle::io
