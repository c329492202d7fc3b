// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/surface/rules.hpp"

#include <algorithm>
#include <utility>

namespace corpuscle::contact {

Rules::Rules(std::vector<ContactCard> cards, std::span<const Curve> curves, std::size_t parts)
    : cards_(std::move(cards)),
      scene_parts_(static_cast<Index>(parts)),
      parts_(parts),
      side_(2 * cards_.size(), std::vector<bool>(parts, false)) {
    for (std::size_t c = 0; c < cards_.size(); ++c) {
        const ContactCard& card = cards_[c];
        curve_.push_back(card.thickness_curve < 0 ? Curve{} : curves[card.thickness_curve]);
        const bool is_single = card.kind == ContactCard::Kind::SINGLE_SURFACE;
        for (const Index part : card.parts) side_[2 * c][part] = true;
        for (const Index part : is_single ? card.parts : card.other_parts)
            side_[2 * c + 1][part] = true;
    }
}

Index Rules::combine(const std::set<Index>& parts) {
    for (std::vector<bool>& side : side_)
        side.push_back(std::ranges::any_of(parts, [&](Index part) { return side[part]; }));
    return static_cast<Index>(parts_++);
}

bool Rules::are_alike(Index a, Index b) const {
    return std::ranges::all_of(side_,
                               [&](const std::vector<bool>& side) { return side[a] == side[b]; });
}

bool Rules::choose(std::span<const std::uint8_t> is_on) {
    if (std::ranges::equal(is_on, is_on_) && !nodes_.now.empty()) return false;
    for (Table* const table : {&nodes_, &edges_}) {
        table->before = std::exchange(table->now, std::vector<int>(parts_ * parts_, NONE));
        table->before.resize(table->now.size(), NONE);
        for (int& card : table->before)
            if (!holds(card)) card = NONE;
    }
    is_on_.assign(is_on.begin(), is_on.end());
    for (const std::uint8_t on : {1, 0})
        for (std::size_t c = 0; c < cards_.size(); ++c)
            if (is_on_[c] == on) enter(static_cast<int>(c));
    const auto has_new = [this](const Table& table) {
        return !std::ranges::equal(table.now, table.before, [this](int card, int before) {
            return card == before || !holds(card);
        });
    };
    return has_new(nodes_) || has_new(edges_);
}

void Rules::enter(int row) {
    const bool is_two_way = card(row).kind != ContactCard::Kind::NODES_TO_SURFACE;
    const auto claim = [row](int& entry) {
        if (entry == NONE) entry = row;
    };
    const auto parts = static_cast<Index>(parts_);
    for (Index a = 0; a < parts; ++a)
        for (Index b = 0; b < parts; ++b) {
            if (!is_first(row, a, b)) continue;
            claim(nodes_.now[at(a, b)]);
            if (!is_two_way) continue;
            claim(nodes_.now[at(b, a)]);
            claim(edges_.now[at(a, b)]);
            claim(edges_.now[at(b, a)]);
        }
}

double Rules::thickness(int row, Index part, double of_section) const {
    const ContactCard& c = card(row);
    const Curve& curve = curve_[static_cast<std::size_t>(row)];
    if (!curve.empty()) return *std::max_element(curve.y.begin(), curve.y.end());
    if (c.thickness == c.thickness && is_on_side(row, 0, part)) return c.thickness;
    if (c.other_thickness == c.other_thickness && is_on_side(row, 1, part))
        return c.other_thickness;
    return of_section;
}

double Rules::most(int row, double t) const {
    const Curve& curve = curve_[static_cast<std::size_t>(row)];
    return curve.empty() ? INF : curve(t);
}

}  // namespace corpuscle::contact
