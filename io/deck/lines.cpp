// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "io/deck/keyword_reader.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io {

namespace {

constexpr std::size_t TAB_STOP = 8;

/// Fixed cards mean what they look like in an editor.
std::string expand_tabs(const std::string& text) {
    std::string plain;
    plain.reserve(text.size() + text.size() / 4);
    std::size_t column = 0;
    for (const char c : text) {
        if (c == '\t') {
            const std::size_t blanks = TAB_STOP - column % TAB_STOP;
            plain.append(blanks, ' ');
            column += blanks;
        } else {
            plain += c;
            column = c == '\n' ? 0 : column + 1;
        }
    }
    return plain;
}

}  // namespace

std::string why_no_lines(std::string_view text) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return "expected text of single bytes (ASCII or UTF-8), but this is UTF-16";
    if (text.find('\r') != std::string_view::npos && text.find('\n') == std::string_view::npos)
        return "expected lines that end with LF, or CR and LF: these end with CR alone";
    return {};
}

std::vector<Line> split_lines(std::string& text) {
    if (text.find('\t') != std::string::npos) text = expand_tabs(text);
    std::vector<Line> lines;
    lines.reserve(static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
    std::string_view rest = without_mark(text);
    for (std::uint32_t number = 1; !rest.empty(); ++number) {
        const std::size_t end = rest.find('\n');
        std::string_view line = rest.substr(0, end);
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
        const std::size_t first = line.find_first_not_of(' ');
        if (first == std::string_view::npos || line[first] != '$') lines.push_back({line, number});
    }
    return lines;
}

}  // namespace corpuscle::io
