// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/deck/included/inclusion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "io/text/text.hpp"

namespace corpuscle::io {

namespace {

constexpr std::size_t CARDS_BEFORE_TRANID = 3;  ///< behind FILENAME

IdOffsets own_offsets(Cards& cards) {
    IdOffsets own{};
    {
        Card c = cards.next("IDNOFF IDEOFF IDPOFF IDMOFF IDSOFF IDFOFF IDDOFF -");
        for (std::size_t kind = 0; kind + 1 < ID_KINDS; ++kind)
            own.at(kind) = c.integer(OFFSET_FIELDS.at(kind));
    }
    Card c = cards.next("IDROFF PREFIX SUFFIX -");
    own.back() = c.integer(OFFSET_FIELDS.back());
    for (const char* name : {"PREFIX", "SUFFIX"})
        if (const std::string text = c.text(name); !text.empty() && text != "0")
            c.warn(name, "titles of the included file stay as they are written");
    return own;
}

/// Fields of other dimensions than places are not told apart here.
void expect_same_units(Cards& cards) {
    static const char* const EXPECTED =
        "1 (or 0, or blank): units of an included file are not converted, it must have those of "
        "the deck";
    Card c = cards.next("FCTMAS=1 FCTTIM=1 FCTLEN=1 FCTTEM INCOUT1");
    for (const char* factor : {"FCTMAS", "FCTTIM", "FCTLEN"})
        if (c.real(factor) != 1.0 && c.good()) c.fault(factor, EXPECTED);
    const std::string temperature = c.text("FCTTEM");
    const auto number = parse_real(temperature);
    if (!temperature.empty() && number != 0.0 && number != 1.0) c.fault("FCTTEM", EXPECTED);
    c.noted("INCOUT1", "the file DYNA.INC is not written");
}

void read_one(Inclusion& inclusion, const Parameters& parameters, Faults& faults) {
    faults.begin_block();
    Cards cards(inclusion.block, faults, parameters);
    for (std::size_t line = 0; line < inclusion.name_lines; ++line) cards.title();
    inclusion.offsets = own_offsets(cards);
    if (const Inclusion* outer = inclusion.block.inclusion; outer != nullptr)
        for (std::size_t kind = 0; kind < ID_KINDS; ++kind)
            inclusion.offsets.at(kind) += outer->offsets.at(kind);
    expect_same_units(cards);
    cards.next("TRANID").harmless("TRANID");  // read once the transformations are known
    cards.finish();
    faults.end_block(inclusion.block.place, inclusion.block.keyword);
}

}  // namespace

void read_offsets(std::deque<Inclusion>& inclusions, const Parameters& parameters, Faults& faults) {
    for (Inclusion& inclusion : inclusions) read_one(inclusion, parameters, faults);
}

Index transformation_of(const Inclusion& inclusion, const Registry& transformations,
                        const Parameters& parameters, Faults& faults) {
    const std::size_t before = inclusion.name_lines + CARDS_BEFORE_TRANID;
    if (inclusion.name_lines == 0 || inclusion.block.lines.size() <= before) return -1;  // told
    faults.begin_block();
    Cards cards(inclusion.block, faults, parameters);
    for (std::size_t line = 0; line < before; ++line) cards.title();
    return cards.next("TRANID").row_or_none("TRANID", transformations);
}

std::optional<int> shifted_id(const Block& block, IdKind kind, double written) {
    constexpr double MOST = std::numeric_limits<int>::max();
    if (block.inclusion == nullptr || written == 0.0) return static_cast<int>(written);
    const auto by =
        static_cast<double>(block.inclusion->offsets.at(static_cast<std::size_t>(kind)));
    const double id = std::abs(written) + by;
    if (!(id >= 1.0 && id <= MOST)) return {};
    return static_cast<int>(written < 0.0 ? -id : id);
}

std::string told(const IdOffsets& offsets) {
    static constexpr std::array<std::string_view, ID_KINDS> THINGS = {
        "nodes",  "elements",          "parts",    "materials", "sets",
        "curves", "other definitions", "other ids"};
    std::string text;
    for (std::size_t kind = 0; kind < ID_KINDS; ++kind)
        if (const auto by = offsets.at(kind); by != 0)
            text += fmt::format("{}{} {} {}", text.empty() ? "" : ", ", THINGS.at(kind),
                                by < 0 ? '-' : '+', std::abs(by));
    return text;
}

}  // namespace corpuscle::io
