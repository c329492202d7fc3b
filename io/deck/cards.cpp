// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "io/deck/card.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io {

Cards::Cards(const Block& block, Faults& faults, const Parameters& parameters,
             std::vector<std::string_view> suffixes)
    : block_(block), faults_(faults), parameters_(parameters), suffixes_(std::move(suffixes)) {}

bool Cards::has(std::string_view suffix) const {
    return std::find(suffixes_.begin(), suffixes_.end(), suffix) != suffixes_.end();
}

bool Cards::more() const {
    const auto left = block_.lines.subspan(next_);
    return std::any_of(left.begin(), left.end(),
                       [](const Line& line) { return !trim(line.text).empty(); });
}

std::size_t Cards::lines_left() const {
    std::size_t end = block_.lines.size();
    while (end > next_ && trim(block_.lines[end - 1].text).empty()) --end;
    return end - next_;
}

bool Cards::rows() {
    while (next_ < block_.lines.size() && trim(block_.lines[next_].text).empty()) ++next_;
    return next_ < block_.lines.size();
}

bool Cards::starts_with(char sign) const {
    return next_ < block_.lines.size() && block_.lines[next_].text.starts_with(sign);
}

const Line* Cards::take(std::string_view what) {
    if (next_ < block_.lines.size()) return &block_.lines[next_++];
    if (!told_missing_) {
        told_missing_ = true;
        const Place at{block_.place.file,
                       block_.lines.empty() ? block_.place.line : block_.lines.back().number};
        faults_.fault(at, fmt::format("*{} ends before its card {}, expected {}", block_.keyword,
                                      next_ + 1, what));
    }
    return nullptr;
}

Card Cards::next(const Layout& layout) {
    std::string names;
    if (next_ >= block_.lines.size())
        for (const Layout::Field& field : layout.fields())
            names.append(names.empty() ? "" : " ").append(field.name);
    const Line* line = take(names);
    return {*this, layout, line != nullptr ? *line : Line{}, line == nullptr, false};
}

Card Cards::next_plus(const Layout& layout) {
    const Line* line = take("a line with + in column 1");
    return {*this, layout, line != nullptr ? *line : Line{}, line == nullptr, line != nullptr};
}

std::string Cards::title() {
    const Line* line = take("a title");
    return line != nullptr ? std::string(trim(line->text)) : std::string();
}

void Cards::fault(const std::string& what) {
    faults_.fault(block_.place, fmt::format("*{} {}", block_.keyword, what));
}

void Cards::warn(const std::string& what) {
    faults_.warn(block_.place, fmt::format("*{} {}", block_.keyword, what));
}

void Cards::note(const std::string& what) {
    faults_.note(block_.place, fmt::format("*{} {}", block_.keyword, what));
}

void Cards::abandon() {
    next_ = block_.lines.size();
    told_missing_ = true;
}

void Cards::finish() {
    if (!rows()) return;
    const Line& line = block_.lines[next_];
    faults_.fault({block_.place.file, line.number},
                  fmt::format("*{} card {} = {}, expected no more cards", block_.keyword, next_ + 1,
                              trim(line.text).substr(0, 60)));
}

}  // namespace corpuscle::io
