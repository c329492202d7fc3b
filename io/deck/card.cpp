// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/card.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "io/text/text.hpp"

namespace corpuscle::io {

namespace {
constexpr double LARGEST = 1e100;  ///< squares and cubes must not overflow
constexpr int WIDEST_NUMBER = 20;  ///< columns; a wider field is a title
}  // namespace

bool Range::holds(double value) const {
    return (low_is_out ? value > low : value >= low) &&
           (high_is_out ? value < high : value <= high);
}

std::string Range::text() const {
    const std::string above = fmt::format("{} {}", low_is_out ? ">" : ">=", low);
    const std::string below = fmt::format("{} {}", high_is_out ? "<" : "<=", high);
    if (low == -INF) return high == INF ? "a number" : below;
    if (high == INF) return above;
    if (!low_is_out && !high_is_out) return fmt::format("{} to {}", low, high);
    return above + " and " + below;
}

Layout::Layout(const char* text) {
    for_each_word(text, [&](std::string_view word) {
        assert(size_ < MOST_FIELDS);
        Field& field = fields_[size_++];
        if (const auto at = word.find('='); at != std::string_view::npos) {
            field.fallback = parse_real(word.substr(at + 1)).value();
            word = word.substr(0, at);
        }
        if (const auto at = word.find(':'); at != std::string_view::npos) {
            field.width = parse_integer(word.substr(at + 1)).value();
            word = word.substr(0, at);
        }
        field.name = word;
    });
}

Card::Card(Cards& cards, const Layout& layout, const Line& line, bool is_missing, bool plus)
    : cards_(cards),
      layout_(layout),
      line_(line),
      card_number_(cards.card_number()),
      is_missing_(is_missing) {
    cut(line.text, cards.block().columns, plus);
}

Card::~Card() {
    write_log();
    if (is_missing_) return;
    complain_of_unread();
    warn_of_rest();
}

namespace {

std::size_t width_of(const Layout::Field& field, Columns columns) {
    const auto width = static_cast<std::size_t>(field.width);
    if (columns == Columns::LONG) return std::max<std::size_t>(width, 20);
    return columns == Columns::I10 ? std::max<std::size_t>(width, 10) : width;
}

/// The first comma that parts fields, or the end: those inside <expressions> do not.
std::size_t end_of_field(std::string_view line) {
    std::size_t end = 0;
    for (int depth = 0; end < line.size() && (depth > 0 || line[end] != ','); ++end)
        depth += line[end] == '<' ? 1 : line[end] == '>' ? -1 : 0;
    return end;
}

/// A comma between fields makes a line free format; one in the title behind an id does not.
bool is_free_format(std::string_view line, std::span<const Layout::Field> fields, Columns columns) {
    const std::size_t comma = end_of_field(line);
    const bool has_title = fields.size() > 1 && fields.back().width > WIDEST_NUMBER;
    return comma < line.size() && !(has_title && comma >= width_of(fields.front(), columns));
}

}  // namespace

namespace {

/// The words at the beginning that are numbers: columns beyond a card's last may hold remarks.
std::string_view numbers_at_start(std::string_view text) {
    std::size_t end = 0;
    bool is_number = true;
    for_each_word(text, [&](std::string_view word) {
        is_number = is_number && parse_real(word).has_value();
        if (is_number) end = static_cast<std::size_t>(word.data() - text.data()) + word.size();
    });
    return text.substr(0, end);
}

}  // namespace

void Card::cut(std::string_view line, Columns columns, bool plus) {
    if (plus) line.remove_prefix(1);
    const auto fields = layout_.fields();
    if (is_free_format(line, fields, columns)) {
        for (std::size_t i = 0; i < fields.size() && !line.empty(); ++i) {
            std::size_t end = end_of_field(line);
            if (fields[i].width > WIDEST_NUMBER) end = line.size();
            field_[i] = trim(line.substr(0, end));
            line.remove_prefix(std::min(line.size(), end + 1));
        }
        rest_ = trim(line);
        return;
    }
    std::size_t from = 0;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::size_t width = width_of(fields[i], columns) - (plus && i == 0 ? 1 : 0);
        if (from < line.size()) field_[i] = trim(line.substr(from, width));
        from += width;
    }
    const std::size_t end = columns == Columns::LONG ? LONG_CARD_END : CARD_END;
    if (from < end && from < line.size()) rest_ = trim(line.substr(from, end - from));
    const bool is_title = !fields.empty() && fields.back().width > WIDEST_NUMBER;
    if (end < line.size() && !is_title) beyond_ = numbers_at_start(trim(line.substr(end)));
}

std::size_t Card::at(std::string_view name) const {
    const auto fields = layout_.fields();
    for (std::size_t i = 0; i < fields.size(); ++i)
        if (fields[i].name == name) return i;
    assert(false && "a handler asks for a field that its layout has");
    return 0;
}

/// &name, -&name, <expression>, -<expression>; @throws ExpressionError
double Card::named_value(std::string_view text) const {
    const double sign = text.front() == '-' ? -1.0 : 1.0;
    if (sign < 0) text = trim(text.substr(1));
    const Parameters& parameters = cards_.parameters();
    const Viewpoint from = cards_.block().viewpoint();
    const auto lookup = [&](std::string_view name) { return parameters.value(name, from); };
    if (text.front() == '<') {
        if (text.back() != '>') throw ExpressionError("> at the end of the expression");
        return sign * evaluate(text.substr(1, text.size() - 2), lookup).number;
    }
    const std::string_view name = trim(text.substr(1));
    if (const auto value = lookup(name)) return sign * value->number;
    const std::string meant = parameters.nearest_name(name);
    throw ExpressionError("a *PARAMETER of that name with a number" +
                          (meant.empty() ? meant : fmt::format("; did you mean &{}?", meant)));
}

Card::Number Card::named_number(std::size_t i) {
    try {
        return {named_value(field_[i]), true};
    } catch (const ExpressionError& error) {
        fault(i, error.what());
    }
    return {};
}

bool Card::is_named(std::string_view text) {
    if (text.starts_with('-')) text.remove_prefix(1);
    return text.starts_with('&') || text.starts_with('<');
}

Card::Number Card::number(std::size_t i, bool whole) {
    read_ |= 1U << i;
    acted_ |= 1U << i;
    const std::string_view text = field_[i];
    if (text.empty()) return {};
    Number result;
    if (is_named(text)) {
        result = named_number(i);
        if (!result.is_good) return {};
        result.is_good = !whole || parse_integer(fmt::format("{}", result.value));
    } else if (whole) {
        if (const auto value = parse_integer(text)) result = {static_cast<double>(*value), true};
    } else if (const auto value = parse_real(text)) {
        result = {*value, true};
    }
    if (result.is_good && std::abs(result.value) <= LARGEST) return result;
    if (result.is_good)
        fault(i, fmt::format("a number of at most {:g}", LARGEST));
    else
        fault(i, whole ? "a whole number" : "a number");
    return {};
}

double Card::in_range(std::size_t i, Number number, const Range& range) {
    const double fallback = layout_.fields()[i].fallback;
    if (!number.is_good && !field_[i].empty()) return fallback;
    const double value = number.is_good && number.value != 0.0 ? number.value : fallback;
    if (range.holds(value)) return value;
    fault(i, range.text());
    return fallback;
}

double Card::real(std::size_t i, const Range& range) {
    return in_range(i, number(i, false), range);
}

int Card::integer(std::size_t i, const Range& range) {
    return static_cast<int>(in_range(i, number(i, true), range));
}

int Card::choice(std::string_view name, std::initializer_list<int> known,
                 std::initializer_list<int> later) {
    const int value = integer(name);
    const auto is_in = [&](auto& list) {
        return std::find(list.begin(), list.end(), value) != list.end();
    };
    if (is_in(known)) return value;
    const std::string expected = fmt::format("{}", fmt::join(known, " or "));
    fault(name,
          is_in(later) ? fmt::format("{}: this choice is not acted on yet", expected) : expected);
    return *known.begin();
}

Vec3 Card::vector(std::string_view x, std::string_view y, std::string_view z) {
    const double a = real(x), b = real(y), c = real(z);
    return {a, b, c};
}

std::string_view Card::raw(std::size_t i) {
    read_ |= 1U << i;
    acted_ |= 1U << i;
    return field_[i];
}

std::string Card::text(std::string_view name) {
    const std::string_view written = raw(at(name));
    if (written.empty() || written.front() != '&') return std::string(written);
    const Parameter* parameter =
        cards_.parameters().find(trim(written.substr(1)), cards_.block().viewpoint());
    return parameter != nullptr && parameter->type == 'C' ? parameter->text : std::string(written);
}

}  // namespace corpuscle::io
