// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

/// Part rows of a set (or, where the deck says so, of a part) are added to those of a chamber.
void add_parts(Card& c, const char* sid, bool is_set, const Draft& draft,
               std::vector<Index>& parts) {
    const Index row = c.row_or_none(sid, is_set ? draft.part_sets : draft.parts);
    if (row < 0) return;
    const std::vector<Index> more =
        is_set ? draft.part_set[static_cast<std::size_t>(row)] : std::vector<Index>{row};
    for (const Index part : more)
        if (std::find(parts.begin(), parts.end(), part) == parts.end()) parts.push_back(part);
}

}  // namespace

/// Chambers close with the parts of SID1 and SID2, and with the holes that lead to others. Normals
/// are found by the surfaces themselves.
void define_cpm_chamber(Cards& cards, Draft& draft) {
    constexpr Range COUNT{0.0, 1000.0};
    int count = 0;
    if (cards.has("TITLE")) cards.title();
    {
        Card c = cards.next("ID NCHM");
        c.new_id("ID", draft.cpm_chambers, draft.cpm_chamber.size());
        count = c.integer("NCHM", within(1.0, COUNT.high));
    }
    std::vector<gas::ChamberCard> chambers;
    std::vector<int> neighbours;
    for (int i = 0; i < count && cards.good(); ++i) {
        gas::ChamberCard chamber;
        int holes = 0;
        {
            Card c = cards.next("SID1 SID2 NINTER CHM_ID");
            add_parts(c, "SID1", true, draft, chamber.parts);
            add_parts(c, "SID2", true, draft, chamber.parts);
            holes = c.integer("NINTER", COUNT);
            chamber.id = c.integer("CHM_ID", {1.0});
            if (c.good() && chamber.parts.empty()) c.fault("SID1", "a part set, or one in SID2");
        }
        for (int h = 0; h < holes && cards.good(); ++h) {
            Card c = cards.next("SID3 ITYPE3 TOCHM");
            add_parts(c, "SID3", c.choice("ITYPE3", {0, 1}) == 1, draft, chamber.parts);
            neighbours.push_back(c.integer("TOCHM", {1.0}));
        }
        chambers.push_back(std::move(chamber));
    }
    const auto is_known = [&](int id) {
        return std::any_of(chambers.begin(), chambers.end(),
                           [&](const gas::ChamberCard& chamber) { return chamber.id == id; });
    };
    for (std::size_t i = 0; i < chambers.size() && cards.good(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (chambers[i].id == chambers[j].id)
                cards.fault(fmt::format("has two chambers with CHM_ID = {}", chambers[i].id));
    for (const int id : neighbours)
        if (cards.good() && !is_known(id))
            cards.fault(
                fmt::format("has TOCHM = {}, expected the CHM_ID of one of its chambers", id));
    draft.cpm_chamber.push_back(std::move(chambers));
}

}  // namespace corpuscle::io::keywords
