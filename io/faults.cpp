// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/faults.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corpuscle::io {

namespace {
constexpr std::size_t SHOWN_FAULTS = 20;  ///< of one keyword; more are counted only
}

std::uint32_t Faults::add_file(std::string name) {
    files_.push_back(std::move(name));
    return static_cast<std::uint32_t>(files_.size() - 1);
}

std::string Faults::where(Place at) const {
    return fmt::format("{}:{}", files_[at.file], at.line);
}

/// A field that is read twice is at fault once.
void Faults::fault(Place at, const std::string& text) {
    Message message{at, fmt::format("{}: {}", where(at), text)};
    const std::size_t shown = std::min(in_block_, SHOWN_FAULTS);
    if (std::find(faults_.end() - static_cast<std::ptrdiff_t>(shown), faults_.end(), message) !=
        faults_.end())
        return;
    if (++in_block_ > SHOWN_FAULTS) return;
    faults_.push_back(std::move(message));
}

void Faults::warn(Place at, const std::string& text) {
    warnings_.emplace_back(at, fmt::format("{}: {}", where(at), text));
}

void Faults::end_block(Place keyword_at, const std::string& keyword) {
    if (in_block_ > SHOWN_FAULTS) {
        const std::size_t more = in_block_ - SHOWN_FAULTS;
        in_block_ = 0;
        fault(keyword_at, fmt::format("*{} has {} more faults that are not shown", keyword, more));
    }
    in_block_ = 0;
}

std::vector<std::string> Faults::sorted(std::vector<Message> messages) {
    std::stable_sort(messages.begin(), messages.end(),
                     [](const Message& a, const Message& b) { return a.first < b.first; });
    std::vector<std::string> text;
    for (Message& m : messages) text.push_back(std::move(m.second));
    return text;
}

}  // namespace corpuscle::io
