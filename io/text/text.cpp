// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/text/text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace corpuscle::io {

std::string_view trim(std::string_view text) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

std::string upper(std::string_view text) {
    std::string result(text);
    for (char& c : result)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return result;
}

namespace {

std::optional<double> plain_real(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

/// D exponents become E; an exponent without a letter gets one.
std::optional<double> fortran_real(std::string_view text) {
    std::array<char, 64> plain{};
    std::size_t n = 0;
    bool has_exponent = false;
    for (const char c : text) {
        if (n + 2 > plain.size()) return {};
        const bool is_sign = c == '+' || c == '-';
        const bool is_letter = c == 'd' || c == 'D' || c == 'e' || c == 'E';
        const bool after_digit =
            n > 0 && (plain[n - 1] == '.' || (plain[n - 1] >= '0' && plain[n - 1] <= '9'));
        if (is_letter || (is_sign && after_digit)) {
            if (has_exponent || !after_digit) return {};
            has_exponent = true;
            plain[n++] = 'e';
            if (is_letter) continue;
        }
        plain[n++] = c;
    }
    return plain_real({plain.data(), n});
}

}  // namespace

std::optional<double> parse_real(std::string_view text) {
    text = trim(text);
    if (!text.empty() && text.front() == '+') {
        text.remove_prefix(1);
        if (text.empty() || text.front() == '-' || text.front() == '+') return {};
    }
    if (text.empty()) return {};
    if (const auto value = plain_real(text)) return value;
    return fortran_real(text);
}

std::optional<int> parse_integer(std::string_view text) {
    text = trim(text);
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc{} && end == text.data() + text.size() && !text.empty()) return value;
    const auto real = parse_real(text);
    if (!real || std::abs(*real) > std::numeric_limits<int>::max() || *real != std::round(*real))
        return {};
    return static_cast<int>(*real);
}

std::string shown(const std::string& text) {
    constexpr std::size_t END = MOST_SHOWN / 4;  // holds what was expected
    if (text.size() <= MOST_SHOWN) return text;
    const auto is_inside_letter = [&](std::size_t at) {  // of UTF-8
        return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
    };
    std::size_t begin = MOST_SHOWN - 2 * END, end = text.size() - END;
    for (int i = 0; i < 3 && is_inside_letter(begin); ++i) --begin;
    for (int i = 0; i < 3 && is_inside_letter(end); ++i) ++end;
    return text.substr(0, begin) + " [... " + std::to_string(end - begin) + " bytes ...] " +
           text.substr(end);
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        std::swap(before, last);
        std::swap(last, row);
    }
    return last[b.size()];
}

std::string_view nearest(std::string_view text, std::span<const std::string_view> known) {
    constexpr std::size_t LONGEST_NAME = 100;  // no keyword is longer: rubbish has no neighbour
    if (text.size() > LONGEST_NAME) return {};
    std::string_view best;
    std::size_t least = std::max<std::size_t>(2, text.size() / 5) + 1;
    for (const std::string_view name : known)
        if (const std::size_t d = edit_distance(text, name); d < least) {
            least = d;
            best = name;
        }
    return best;
}

}  // namespace corpuscle::io
