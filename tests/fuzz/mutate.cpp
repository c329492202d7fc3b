// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/fuzz/mutate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace corpuscle::fuzz {
namespace {

constexpr std::array<std::string_view, 28> ODD = {"",
                                                  "0",
                                                  "-1",
                                                  "1",
                                                  "2",
                                                  "3",
                                                  "1e30",
                                                  "-1e30",
                                                  "1e-30",
                                                  "1e308",
                                                  "nan",
                                                  "inf",
                                                  "1e999",
                                                  "0.5",
                                                  "&x",
                                                  "<1/0>",
                                                  "2147483647",
                                                  "-2147483648",
                                                  "99999999999999999999",
                                                  "-0",
                                                  "1.5-3",
                                                  "*",
                                                  "$",
                                                  "1,2,3,4,5,6,7,8,9,10",
                                                  "\"",
                                                  "[]",
                                                  "{",
                                                  "true"};

std::size_t within(Random& draw, std::size_t n) {
    return draw.below(static_cast<std::uint32_t>(std::max<std::size_t>(n, 1)));
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) (text += line) += '\n';
    return text;
}

/// Begin and size of a field: ten columns of a fixed card, else what lies between separators.
std::pair<std::size_t, std::size_t> field_of(const std::string& line, Random& draw) {
    if (line.find_first_of(",=[") == std::string::npos) {
        const std::size_t begin = 10 * within(draw, (line.size() + 9) / 10);
        return {begin, std::min<std::size_t>(10, line.size() - std::min(begin, line.size()))};
    }
    const std::size_t from = line.find('=') == std::string::npos ? 0 : line.find('=') + 1;
    const std::size_t at = from + within(draw, line.size() - from);
    const std::size_t before = line.find_last_of(",=[ ", at);
    const std::size_t begin = before == std::string::npos || before >= at ? at : before + 1;
    const std::size_t end = std::min(line.find_first_of(",] #", begin), line.size());
    return {begin, end - std::min(begin, end)};
}

/// A number near the one that is there, or that nobody expects.
std::string instead_of(const std::string& field, Random& draw) {
    char* end = nullptr;
    const double number = std::strtod(field.c_str(), &end);
    if (end == field.c_str() || draw.below(2) == 0)
        return std::string(ODD[within(draw, ODD.size())]);
    constexpr std::array FACTORS{0.1, 0.5, 0.9, 1.1, 2.0, 10.0, -1.0};
    return fmt::format("{:.4g}", number * FACTORS[within(draw, FACTORS.size())]);
}

void change_field(std::string& line, Random& draw) {
    const auto [begin, size] = field_of(line, draw);
    if (begin > line.size()) return;
    std::string with = instead_of(line.substr(begin, size), draw);
    if (size == 10 && with.size() < 10) with.insert(0, 10 - with.size(), ' ');
    line.replace(begin, size, with);
}

/// A line of any block alike: what begins with a star or a bracket begins one. Meshes are long, and
/// cards are not.
std::size_t some_line(const std::vector<std::string>& lines, Random& draw) {
    std::vector<std::size_t> begins{0};
    for (std::size_t i = 1; i < lines.size(); ++i)
        if (lines[i].rfind('*', 0) == 0 || lines[i].rfind('[', 0) == 0) begins.push_back(i);
    begins.push_back(lines.size());
    const std::size_t block = within(draw, begins.size() - 1);
    return begins[block] + within(draw, begins[block + 1] - begins[block]);
}

void change_lines(std::vector<std::string>& lines, const std::vector<std::string>& other,
                  Random& draw) {
    const std::size_t i = some_line(lines, draw), j = some_line(lines, draw);
    const auto at = [&](std::size_t k) { return lines.begin() + static_cast<std::ptrdiff_t>(k); };
    switch (draw.below(16)) {
        case 0:
            lines.insert(at(j), std::string(lines[i]));
            break;
        case 1:
            lines.erase(at(i));
            break;
        case 2:
            std::swap(lines[i], lines[j]);
            break;
        case 3:
            if (!other.empty()) {
                const std::size_t from = some_line(other, draw);
                const std::size_t count =
                    std::min<std::size_t>(1 + draw.below(8), other.size() - from);
                const auto begin = other.begin() + static_cast<std::ptrdiff_t>(from);
                lines.insert(at(i), begin, begin + static_cast<std::ptrdiff_t>(count));
            }
            break;
        case 4:
            if (!lines[i].empty())
                lines[i][within(draw, lines[i].size())] = static_cast<char>(draw.below(256));
            break;
        default:
            change_field(lines[i], draw);
            break;
    }
}

}  // namespace

std::string damaged_text(std::string text, const std::string& other, Random& draw) {
    std::vector<std::string> lines = lines_of(text);
    const std::vector<std::string> more = lines_of(other);
    for (std::uint32_t k = 1 + draw.below(3); k > 0 && !lines.empty(); --k)
        change_lines(lines, more, draw);
    return joined(lines);
}

std::string damaged_bytes(std::string bytes, Random& draw) {
    for (std::uint32_t k = 1 + draw.below(4); k > 0 && bytes.size() > 16; --k) {
        const std::size_t at = within(draw, bytes.size() - 8),
                          from = within(draw, bytes.size() - 8);
        const std::uint64_t extremes[] = {0, ~std::uint64_t{0}, 1, std::uint64_t{1} << 31,
                                          std::uint64_t{1} << 62};
        const std::uint64_t number = extremes[draw.below(5)];
        switch (draw.below(6)) {
            case 0:
                bytes.resize(at);
                break;
            case 1:
                std::memcpy(&bytes[at], &number, 4);
                break;
            case 2:
                std::memcpy(&bytes[at], &number, 8);
                break;
            case 3:
                bytes.replace(at, std::min<std::size_t>(64, bytes.size() - at),
                              bytes.substr(from, 64));
                break;
            default:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << draw.below(8)));
                break;
        }
    }
    return bytes;
}

}  // namespace corpuscle::fuzz
