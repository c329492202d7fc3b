// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/parameter_cards.hpp"

#include <fmt/format.h>

#include <cmath>

#include "io/text/text.hpp"

namespace corpuscle::io {

namespace {

bool has_option(std::string_view keyword, std::string_view option) {
    return keyword.find(option) != std::string_view::npos;
}

constexpr std::string_view DUPLICATION = "PARAMETER_DUPLICATION";

struct Name {
    char type = ' ';  ///< R, I, C
    std::string name;
    [[nodiscard]] bool is_good() const {
        return (type == 'R' || type == 'I' || type == 'C') && !name.empty() &&
               name.find_first_of(" ,<>&()+-*/") == std::string::npos;
    }
};

/// "R  end_time": the type, then the name, with or without blanks between.
Name parse_name(std::string_view text) {
    if (text.empty()) return {};
    return {upper(text.substr(0, 1)).front(), upper(trim(text.substr(1)))};
}

/// The number of a -D, or none with a fault in it.
std::optional<Parameter> overridden(const Name& name, const std::string& text) {
    Parameter p{name.type, {0.0, name.type == 'I'}, text, {}};
    if (name.type == 'C') return p;
    if (name.type == 'I') {
        const auto value = parse_integer(text);
        if (value) p.value.number = *value;
        return value ? std::optional(p) : std::nullopt;
    }
    const auto value = parse_real(text);
    if (value) p.value.number = *value;
    return value ? std::optional(p) : std::nullopt;
}

bool is_same(const Parameter& a, const Parameter& b) {
    return a.type == b.type && a.value.number == b.value.number &&
           (a.type != 'C' || a.text == b.text);
}

class Definitions {
public:
    Definitions(const Block& block, Parameters& parameters, Faults& faults)
        : cards_(block, faults, parameters),
          parameters_(parameters),
          is_local_(has_option(block.keyword, "_LOCAL")),
          is_mutable_(has_option(block.keyword, "_MUTABLE")) {}

    void values() {
        static const Layout layout("PRMR1 VAL1 PRMR2 VAL2 PRMR3 VAL3 PRMR4 VAL4");
        while (cards_.rows()) {
            Card card = cards_.next(layout);
            for (std::size_t i = 0; i < 8; i += 2)
                if (card.given(i)) value(card, i);
        }
    }

    /// _TYPE: one a line, and what it is a number of. Offsets of *INCLUDE_TRANSFORM are those of
    /// the fields that name it.
    void typed_values() {
        static const Layout layout("PRMR1 VAL1 PRTYP1");
        while (cards_.rows()) {
            Card card = cards_.next(layout);
            if (card.given("PRMR1")) value(card, 0);
            card.harmless("PRTYP1");
        }
    }

    void expressions(const Block& block) {
        for (std::size_t i = 0; i < block.lines.size(); ++i) {
            std::string text(block.lines[i].text);
            while (i + 1 < block.lines.size() && continues(block.lines[i + 1].text, block.columns))
                text.append(1, ' ').append(trim(block.lines[++i].text));
            if (!trim(text).empty())
                expression(text, {block.place.file, block.lines[i].number}, block);
        }
    }

    /// DFLAG of *PARAMETER_DUPLICATION: for the definitions behind it.
    void duplication() {
        if (!cards_.more()) return;
        Card card = cards_.next("DFLAG=1");
        parameters_.set_duplication(card.choice("DFLAG", {1, 2, 3, 4, 5}));
    }

private:
    void value(Card& card, std::size_t i) {
        const Name name = parse_name(card.raw(i));
        const std::string_view text = card.raw(i + 1);
        if (!name.is_good())
            return card.fault(i, "R, I or C and a name, in 10 columns or before a comma");
        Parameter p{name.type, {0.0, name.type == 'I'}, {}, card.place()};
        if (name.type == 'C')
            p.text = text;
        else if (!card.given(i + 1))
            return card.fault(i + 1, "a value");
        else
            p.value.number = name.type == 'I' ? card.integer(i + 1) : card.real(i + 1);
        define(name, p);
    }

    /// A line of which the first field is blank continues the expression above it.
    static bool continues(std::string_view line, Columns columns) {
        const std::size_t width = columns == Columns::LONG ? 20 : 10;
        return !trim(line).empty() && trim(line.substr(0, width)).empty();
    }

    /// "R  area, max(a, b)" is free format, "R     area  max(a, b)" is not.
    void expression(std::string_view line, Place at, const Block& block) {
        const std::size_t comma = line.find(',');
        const std::size_t width = block.columns == Columns::LONG ? 20 : 10;
        Name name = parse_name(trim(line.substr(0, comma)));
        std::string_view formula;
        if (comma != std::string_view::npos && name.is_good()) {
            formula = line.substr(comma + 1);
        } else {
            name = parse_name(trim(line.substr(0, width)));
            formula = line.size() > width ? line.substr(width) : std::string_view{};
        }
        const auto complain = [&](const std::string& expected) {
            cards_.faults().fault(at, fmt::format("*{} {} = {}, expected {}", block.keyword,
                                                  name.name, trim(formula), expected));
        };
        if (!name.is_good()) return complain("R, I or C and a name");
        if (trim(formula).empty()) return complain("an expression");
        define_expression(name, trim(formula), at, complain);
    }

    template <class Complain>
    void define_expression(const Name& name, std::string_view formula, Place at,
                           const Complain& complain) {
        Parameter p{name.type, {}, std::string(formula), at};
        try {
            if (name.type != 'C')
                p.value = evaluate(formula, [&](std::string_view word) {
                    return parameters_.value(word, {at.file});
                });
        } catch (const ExpressionError& error) {
            return complain(error.what());
        }
        p.value.is_integer = name.type == 'I';
        if (name.type == 'I') p.value.number = std::round(p.value.number);
        define(name, p);
    }

    void define(const Name& name, Parameter p) {
        if (const auto text = parameters_.take_override(name.name)) {
            if (const auto by_user = overridden(name, *text)) {
                p.value = by_user->value;
                p.text = by_user->text;
            } else {
                cards_.faults().fault(
                    p.place, fmt::format("*{} {}: -D {}={}, expected {}", cards_.block().keyword,
                                         name.name, name.name, *text,
                                         name.type == 'I' ? "a whole number" : "a number"));
            }
        }
        p.is_mutable = is_mutable_;
        const Parameter* before = parameters_.last(name.name, p.place.file, is_local_);
        if (before != nullptr) {
            if (is_same(*before, p)) return;  // as of a file that is included twice
            p.is_mutable = before->is_mutable;
            if (!before->is_mutable && !replaces(name.name, p.place, before->place)) return;
        }
        parameters_.define(name.name, std::move(p), is_local_);
    }

    /// Whether a second definition counts, by DFLAG, and what is said of it.
    bool replaces(const std::string& name, Place second, Place first) {
        enum Flag { IGNORE_WITH_WARNING = 1, REPLACE_WITH_WARNING, REFUSE, REPLACE };
        const int flag = parameters_.duplication();
        Faults& faults = cards_.faults();
        const std::string what = fmt::format("*{} {}", cards_.block().keyword, name);
        const std::string where = faults.where(first);
        if (flag == IGNORE_WITH_WARNING)
            faults.warn(second, fmt::format("{} is ignored: {} has it already", what, where));
        if (flag == REPLACE_WITH_WARNING)
            faults.warn(second,
                        fmt::format("{} counts for the cards behind it, before it that of {}", what,
                                    where));
        if (flag == REFUSE)
            faults.fault(second,
                         fmt::format("{}, expected one definition of a name: {} has it already",
                                     what, where));
        return flag == REPLACE_WITH_WARNING || flag == REPLACE;
    }

    Cards cards_;
    Parameters& parameters_;
    bool is_local_, is_mutable_;
};

}  // namespace

bool is_parameter_keyword(std::string_view keyword) {
    constexpr std::string_view BASE = "PARAMETER";
    if (!keyword.starts_with(BASE)) return false;
    if (keyword == DUPLICATION) return true;
    std::string_view rest = keyword.substr(BASE.size());
    while (!rest.empty()) {
        const auto end = std::min(rest.find('_', 1), rest.size());
        const std::string_view option = rest.substr(0, end);
        if (option != "_LOCAL" && option != "_EXPRESSION" && option != "_NOECHO" &&
            option != "_MUTABLE" && option != "_TYPE")
            return false;
        rest.remove_prefix(end);
    }
    return true;
}

void read_parameters(const Block& block, Parameters& parameters, Faults& faults) {
    faults.begin_block();
    Definitions definitions(block, parameters, faults);
    if (block.keyword == DUPLICATION)
        definitions.duplication();
    else if (has_option(block.keyword, "_EXPRESSION"))
        definitions.expressions(block);
    else if (has_option(block.keyword, "_TYPE"))
        definitions.typed_values();
    else
        definitions.values();
    faults.end_block(block.place, block.keyword);
}

}  // namespace corpuscle::io
