// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <utility>

#include "solver/base/call_site.hpp"

namespace corpuscle::benchmark {

using Call = std::pair<const char*, unsigned>;  ///< of a loop: file, line

[[nodiscard]] inline Call call_of(const parallel::CallSite& where) {
    return {where.file, where.line};
}

/// file:line, the file from the project's folders on.
[[nodiscard]] inline std::string text_of(const Call& call) {
    std::string name = call.first;
    if (name.empty()) return "start";
    for (const char* folder : {"/contact/", "/gas/", "/fabric/", "/solver/", "/tests/"})
        if (const std::size_t at = name.rfind(folder); at != std::string::npos)
            name.erase(0, at + 1);
    return name + ":" + std::to_string(call.second);
}

/// Of what belongs to call sites: by the loop's own, or by both ends of a stretch between two; the
/// first of a loop's pair is Call{}.
template <class Site>
[[nodiscard]] std::map<std::string, Site> by_text(
    const std::map<std::pair<Call, Call>, Site>& by_call) {
    std::map<std::string, Site> sites;
    for (const auto& [calls, site] : by_call) {
        const auto& [from, to] = calls;
        sites[from == Call{} ? text_of(to) : text_of(from) + " -> " + text_of(to)] += site;
    }
    return sites;
}

}  // namespace corpuscle::benchmark
