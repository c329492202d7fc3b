// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/faults.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/text/text.hpp"

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

/// A field that is read twice counts once.
bool Faults::List::repeats(Place at, const std::string& cause) {
    const auto found = by_cause_.find(cause);
    if (found == by_cause_.end()) return false;
    Message& message = messages_[found->second];
    if (message.last != at) ++message.count;
    message.last = at;
    return true;
}

void Faults::List::add(Place at, const std::string& text, const std::string& cause) {
    const std::string& key = cause.empty() ? text : cause;
    if (repeats(at, key)) return;
    by_cause_.emplace(key, messages_.size());
    messages_.push_back({at, text, at});
}

void Faults::fault(Place at, const std::string& text, const std::string& cause) {
    if (faults_.repeats(at, cause.empty() ? text : cause)) {
        in_block_ = std::max<std::size_t>(in_block_, 1);
        return;
    }
    if (++in_block_ > SHOWN_FAULTS)
        ++hidden_;
    else
        faults_.add(at, text, cause);
}

void Faults::end_block(Place keyword_at, const std::string& keyword) {
    const std::size_t more = hidden_;
    begin_block();
    if (more > 0)
        fault(keyword_at, fmt::format("*{} has {} more faults that are not shown", keyword, more));
    begin_block();
}

std::vector<std::string> Faults::told(const List& list) const {
    std::vector<Message> messages = list.messages();
    std::stable_sort(messages.begin(), messages.end(),
                     [](const Message& a, const Message& b) { return a.at < b.at; });
    std::vector<std::string> lines;
    for (const Message& m : messages)
        lines.push_back(
            fmt::format("{}: {}{}", where(m.at), shown(m.text),
                        m.count > 1 ? fmt::format(" (and {} more like it)", m.count - 1) : ""));
    return lines;
}

}  // namespace corpuscle::io
