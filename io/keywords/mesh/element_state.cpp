// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Shells that would vanish, or begin with stress: read as far as neither happens.

#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

/// *DEFINE_ELEMENT_DEATH_SHELL, _SHELL_SET: no shell vanishes here, and none has to where its time
/// comes after the run.
void element_death(Cards& cards, Draft& draft) {
    const bool is_set = cards.block().keyword.find("SHELL_SET") != std::string::npos;
    const double end = std::max(draft.model.end_time, draft.until);
    while (cards.rows()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next("SID TIME BOXID INOUT IDGRP CID PERCENT");
        c.row("SID", is_set ? draft.shell_sets : draft.shells);
        const double time = c.real("TIME");
        c.harmless("INOUT IDGRP CID PERCENT");  // of boxes, and of groups one of which has failed
        if (c.row_or_none("BOXID", draft.boxes) >= 0)
            c.fault("BOXID", "blank: no shell is taken out of the scene where it goes");
        if (time < end)
            c.fault("TIME", fmt::format("{:g} or above, the end of the run: no shell is taken out "
                                        "of the scene before",
                                        end));
        if (c.good()) c.note("TIME", "is after the run: the shells stay");
    }
}

namespace {

constexpr const char* NO_STRESS =
    "0: shells begin with the stress of their reference geometry alone "
    "(*AIRBAG_REFERENCE_GEOMETRY, "
    "*AIRBAG_SHELL_REFERENCE_GEOMETRY)";

/// How many points, and how they are written.
struct StressPoints {
    int points = 0, history = 0;
    bool is_large = false;
};

StressPoints stress_header(Cards& cards, const Draft& draft, bool is_set) {
    constexpr double MOST = 1000.0;
    Card c = cards.next("EID NPLANE NTHICK NHISV NTENSR LARGE NTHINT NTHHSV");
    c.row("EID", is_set ? draft.shell_sets : draft.shells);
    const auto count = [&](const char* field, int least) {
        return std::max(least, c.integer(field, within(0, MOST)));
    };
    StressPoints stress;
    stress.points = count("NPLANE", 1) * count("NTHICK", 1);
    stress.history = count("NHISV", 0);
    stress.is_large = c.choice("LARGE", {0, 1}) == 1;
    return stress;
}

void expect_zero(Card& c, std::initializer_list<const char*> fields) {
    for (const char* field : fields)
        if (c.real(field) != 0.0) c.fault(field, NO_STRESS);
}

void expect_no_history(Cards& cards, const StressPoints& stress) {
    static const Layout narrow("HISV1 HISV2 HISV3 HISV4 HISV5 HISV6 HISV7 HISV8");
    static const Layout wide("HISV1:16 HISV2:16 HISV3:16 HISV4:16 HISV5:16");
    const std::size_t on_line = stress.is_large ? 5 : 8;
    for (std::size_t first = 0; first < static_cast<std::size_t>(stress.history);
         first += on_line) {
        Card c = cards.next(stress.is_large ? wide : narrow);
        for (std::size_t i = 0; i < on_line; ++i)
            if (c.real(i) != 0.0) c.fault(i, NO_STRESS);
    }
}

void expect_no_stress(Cards& cards, const StressPoints& stress) {
    static const Layout narrow("T SIGXX SIGYY SIGZZ SIGXY SIGYZ SIGZX EPS");
    static const Layout wide("T:16 SIGXX:16 SIGYY:16 SIGZZ:16 SIGXY:16");
    static const Layout rest("SIGYZ:16 SIGZX:16 EPS:16");
    {
        Card c = cards.next(stress.is_large ? wide : narrow);
        c.harmless("T");  // where the point lies
        expect_zero(c, {"SIGXX", "SIGYY", "SIGZZ", "SIGXY"});
        if (!stress.is_large) expect_zero(c, {"SIGYZ", "SIGZX", "EPS"});
    }
    if (stress.is_large) {
        Card c = cards.next(rest);
        expect_zero(c, {"SIGYZ", "SIGZX", "EPS"});
    }
    expect_no_history(cards, stress);
}

}  // namespace

void initial_stress(Cards& cards, Draft& draft) {
    const bool is_set = cards.block().keyword.ends_with("_SET");
    while (cards.rows()) {
        const StressPoints stress = stress_header(cards, draft, is_set);
        if (!cards.good()) return cards.abandon();  // of rows that are not known
        for (int point = 0; point < stress.points && cards.lines_left() > 0; ++point)
            expect_no_stress(cards, stress);
    }
    if (cards.good()) cards.note("its stresses are all 0: it changes nothing");
}

}  // namespace corpuscle::io::keywords
