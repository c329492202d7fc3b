// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What a card says of its fields to the user.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/deck/card.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io {
namespace {

constexpr std::size_t LONGEST_SHOWN = 60;  ///< characters of a field in a message

}  // namespace

void Card::harmless(std::string_view names) {
    for_each_word(names, [&](std::string_view name) { read_ |= 1U << at(name); });
}

void Card::noted(std::string_view names, std::string_view why) {
    for_each_word(names, [&](std::string_view name) {
        const std::size_t i = at(name);
        const std::uint32_t acted = acted_;
        const Number value = number(i, false);
        acted_ = acted;
        warned_ |= 1U << i;
        if (value.is_good && value.value != 0.0 && value.value != layout_.fields()[i].fallback)
            warn(name, std::string(why));
    });
}

void Card::noted(std::string_view name, double value, std::string_view why) {
    const std::size_t i = at(name);
    const std::uint32_t acted = acted_;
    const Number written = number(i, false);
    acted_ = acted;
    warned_ |= 1U << i;
    if (written.is_good && written.value == value) warn(name, std::string(why));
}

Place Card::place() const {
    return {cards_.block().place.file, line_.number};
}

/// "-5", "-5 (&NP)" of a parameter, "5 (105 by IDNOFF = 100)" of an id, "blank".
std::string Card::written(std::size_t i) const {
    const std::string_view text = field_[i], start = text.substr(0, LONGEST_SHOWN);
    if (text.empty()) return "blank";
    try {
        if (!is_named(text)) return std::string(start) + shift_text(i);
        return fmt::format("{} ({}){}", named_value(text), start, shift_text(i));
    } catch (const ExpressionError&) {
        return std::string(start);  // the fault says why
    }
}

std::string Card::label(std::size_t i) const {
    return fmt::format("*{} card {}, field {} ({}) = {}", cards_.block().keyword, card_number_,
                       i + 1, layout_.fields()[i].name, written(i));
}

/// What messages of one field, value and remark have in common, on whatever card.
std::string Card::cause(std::size_t i, const std::string& remark) const {
    const bool is_shifted = cards_.block().inclusion != nullptr && id_kind_[i] != 0;
    return fmt::format("*{} {} = {}: {}", cards_.block().keyword, layout_.fields()[i].name,
                       is_shifted ? written(i) : std::string(field_[i]), remark);
}

void Card::fault(std::size_t i, const std::string& expected) {
    good_ = false;
    if (is_spoilt_ && i == unread_at_) return;
    if (!is_missing_)
        cards_.faults().fault(place(),
                              fmt::format("{}, expected {}{}", label(i), expected,
                                          i == unread_at_ ? unread_ : std::string()),
                              cause(i, expected));
}

void Card::warn(std::string_view name, const std::string& remark) {
    cards_.faults().warn(place(), fmt::format("{}: {}", label(at(name)), remark),
                         cause(at(name), remark));
}

void Card::note(std::string_view name, const std::string& remark) {
    cards_.faults().note(place(), fmt::format("{}: {}", label(at(name)), remark),
                         cause(at(name), remark));
}

std::vector<std::string_view> Card::set_fields() const {
    std::vector<std::string_view> names;
    const auto fields = layout_.fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto value = parse_real(field_[i]);
        if (fields[i].name != "-" && value && *value != 0.0 && *value != fields[i].fallback)
            names.push_back(fields[i].name);
    }
    return names;
}

bool Card::is_blank() const {
    return std::all_of(field_.begin(), field_.end(), [](std::string_view field) {
        return field.empty() || parse_real(field) == 0.0;
    });
}

void Card::write_log() const {
    FieldLog* const log = cards_.faults().log();
    if (log == nullptr) return;
    const auto fields = layout_.fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (fields[i].name == "-") continue;
        const auto has = [&](std::uint32_t mask) { return (mask >> i & 1U) != 0; };
        const FieldUse use = has(acted_)    ? FieldUse::ACTED_ON
                             : has(warned_) ? FieldUse::WARNED
                             : has(read_)   ? FieldUse::HARMLESS
                                            : FieldUse::REFUSED;
        log->add(fields[i].name, use, id_kind_[i] == 0 ? 0U : 1U << (id_kind_[i] - 1U));
    }
}

void Card::complain_of_unread() {
    const auto fields = layout_.fields();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if ((read_ >> i & 1U) != 0 || fields[i].name == "-" || field_[i].empty()) continue;
        const Number value = number(i, false);
        const double fallback = fields[i].fallback;
        if (value.is_good && value.value != 0.0 && value.value != fallback)
            fault(i, fmt::format("{}: this field is not acted on yet",
                                 fallback == 0.0 ? "0 or blank" : fmt::format("{}", fallback)));
    }
}

void Card::warn_of_rest() {
    if (beyond_.find_first_not_of(" 0.") != std::string_view::npos)
        cards_.faults().warn(
            place(),
            fmt::format("*{} card {}: \"{}\" beyond column {} is ignored; a row of a "
                        "table that is longer goes on in the next line",
                        cards_.block().keyword, card_number_, beyond_.substr(0, LONGEST_SHOWN),
                        cards_.block().columns == Columns::LONG ? LONG_CARD_END : CARD_END));
    if (rest_.find_first_not_of(" ,0.\t") == std::string_view::npos) return;
    cards_.faults().warn(
        place(), fmt::format("*{} card {}: \"{}\" behind the last field is ignored",
                             cards_.block().keyword, card_number_, rest_.substr(0, LONGEST_SHOWN)));
}

}  // namespace corpuscle::io
