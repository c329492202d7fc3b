// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace corpuscle::report {

/// The page's own parts, from tools/report/page, and its libraries, from tools/report/bundle.
extern const std::string_view PAGE_HTML, PAGE_STYLE, PAGE_SCRIPT, PAGE_LIBRARIES,
    PAGE_PICTURES_SCRIPT;

/// One HTML file that asks nothing of the net: runs side by side, or a study's table.
///
/// @param folders  of runs (results.h5), or one of a study (study.csv)
/// @throws InputError for folders that are neither
[[nodiscard]] std::string page(const std::vector<std::filesystem::path>& folders);

}  // namespace corpuscle::report
