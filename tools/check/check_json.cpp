// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/check/check_json.hpp"

#include <fmt/format.h>

#include <optional>

#include "io/text/json.hpp"
#include "io/text/text.hpp"
#include "solver/model.hpp"

namespace corpuscle::tools {
namespace {

/// "file:line: text" in its parts.
std::string message(const std::string& line) {
    for (std::size_t at = line.find(':'); at != std::string::npos; at = line.find(':', at + 1)) {
        const std::size_t end = line.find(':', at + 1);
        if (end == std::string::npos) break;
        const std::string_view number = std::string_view(line).substr(at + 1, end - at - 1);
        const std::optional<int> row = io::parse_integer(number);
        if (!row || number.find_first_not_of("0123456789") != std::string_view::npos) continue;
        return fmt::format("{{\"file\": {}, \"line\": {}, \"text\": {}}}",
                           io::json(line.substr(0, at)), *row,
                           io::json(std::string(io::trim(line.substr(end + 1)))));
    }
    return fmt::format("{{\"text\": {}}}", io::json(line));
}

std::string list(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "\n  " : ",\n  ") + message(line);
    return "[" + text + "]";
}

}  // namespace

std::string check_json(const std::string& deck, const Model* model,
                       const std::vector<std::string>& errors) {
    const Model none;
    const Model& scene = model != nullptr ? *model : none;
    return fmt::format(
        "{{\"deck\": {},\n\"accepted\": {},\n\"errors\": {},\n\"warnings\": {},\n"
        "\"notes\": {},\n\"mended\": {}}}\n",
        io::json(deck), model != nullptr ? "true" : "false", list(errors), list(scene.warnings),
        list(scene.notes), list(scene.mendings));
}

}  // namespace corpuscle::tools
