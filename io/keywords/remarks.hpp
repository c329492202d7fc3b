// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

/// What is said to the user of keywords that are not read.
namespace corpuscle::io::keywords {

/// The known name that a keyword is nearly, or nothing.
[[nodiscard]] std::string did_you_mean(std::string_view keyword);

/// Why a suffix of `base` is refused, where its name does not say it.
[[nodiscard]] std::string_view reason(std::string_view base, std::string_view keyword);

/// Whether a keyword begins with one of some words, blanks between.
[[nodiscard]] bool begins_with_any(std::string_view keyword, std::string_view beginnings);

/// Why a keyword is refused that has a reason of its own, or nothing.
[[nodiscard]] std::string_view own_refusal(std::string_view keyword);

/// Why any other one is.
[[nodiscard]] std::string refusal(std::string_view keyword);

/// Of a keyword that is skipped: where it has been answered, or of which name it may be a slip of
/// the pen.
[[nodiscard]] std::string remark_on(std::string_view keyword);

}  // namespace corpuscle::io::keywords
