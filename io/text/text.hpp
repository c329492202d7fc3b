// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

/// Small tools for card images. Views never own their text.
namespace corpuscle::io {

[[nodiscard]] std::string_view trim(std::string_view text);
[[nodiscard]] std::string upper(std::string_view text);

/// UTF-8's byte order mark, with which some programs begin a file.
inline constexpr std::string_view BYTE_ORDER_MARK = "\xEF\xBB\xBF";
/// What is behind it, or all.
[[nodiscard]] inline std::string_view without_mark(std::string_view text) {
    return text.starts_with(BYTE_ORDER_MARK) ? text.substr(BYTE_ORDER_MARK.size()) : text;
}

/// Calls word(view) for every blank-separated word.
template <class Word>
void for_each_word(std::string_view text, Word&& word) {
    while (!(text = trim(text)).empty()) {
        const auto end = text.find(' ');
        word(text.substr(0, end));
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end);
    }
}

/// A finite number: 1, -1.5, .5, 1e-4, and as Fortran writes it 1.0-4, 1D3. None if it is anything
/// else.
[[nodiscard]] std::optional<double> parse_real(std::string_view text);
/// A whole number that fits an int; 3.0 is one. None if it is anything else.
[[nodiscard]] std::optional<int> parse_integer(std::string_view text);

/// What a message shows of it: all of it, or of a text over MOST_SHOWN bytes its beginning and its
/// end, with the number of bytes between them.
[[nodiscard]] std::string shown(const std::string& text);
inline constexpr std::size_t MOST_SHOWN = 1000;  ///< [byte]

/// Insertions, deletions, replacements and swaps of neighbours that turn a into b.
[[nodiscard]] std::size_t edit_distance(std::string_view a, std::string_view b);
/// The known name that `text` was meant to be, or "" when none is close.
[[nodiscard]] std::string_view nearest(std::string_view text,
                                       std::span<const std::string_view> known);

}  // namespace corpuscle::io
