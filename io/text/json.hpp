// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>

/// The little of JSON that is written here.
namespace corpuscle::io {

/// null for what is not a number.
[[nodiscard]] inline std::string json(double value) {
    return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

/// Quoted; '<' is escaped too, so that the text may stand in a page's script.
[[nodiscard]] inline std::string json(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            out += {'\\', c};
        else if (code < 0x20 || c == '<')
            out += fmt::format("\\u{:04x}", code);
        else
            out += c;
    }
    return out + '"';
}

}  // namespace corpuscle::io
