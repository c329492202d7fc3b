// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>
#include <vector>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

void title(Cards& cards, Draft& draft) {
    draft.model.title = cards.title();
}

void control_termination(Cards& cards, Draft& draft) {
    Card c = cards.next("ENDTIM ENDCYC DTMIN ENDENG ENDMAS=1e8 NOSOL");
    draft.model.end_time = c.real("ENDTIM", POSITIVE);
    c.noted("DTMIN ENDENG ENDMAS NOSOL", "this way to stop early is not watched");
}

void control_dynamic_relaxation(Cards& cards, Draft&) {
    Card c = cards.next("NRCYCK DRTOL DRFCTR DRTERM TSSFDR IRELAL EDTTL IDRFLG");
    const int phase = c.integer("IDRFLG");
    if (phase != 0 && phase != -999)
        c.fault("IDRFLG", "0: there is no phase of dynamic relaxation before the run");
    c.harmless("NRCYCK DRTOL DRFCTR DRTERM TSSFDR IRELAL EDTTL");
    cards.abandon();
}

void termination(Cards& cards, Draft&) {
    Card c = cards.next("ID STOP MAXC MINC");
    c.noted("ID", "this does not end the run: it goes on to ENDTIM");
    c.harmless_all();
    cards.abandon();
}

void control_timestep(Cards& cards, Draft& draft) {
    {
        Card c = cards.next("DTINIT TSSFAC=0.9 ISDO TSLIMT DT2MS LCTM ERODE MS1ST");
        draft.model.step_start = c.real("DTINIT", NON_NEGATIVE);
        draft.model.step_factor = c.real("TSSFAC", {0.0, 1.0, true});
        draft.model.step_mass_scaled = c.real("DT2MS");
        c.noted("LCTM", "this upper bound of the step is not kept: fabric and gas set it");
        c.harmless("ISDO TSLIMT ERODE");
    }
    if (cards.more())
        cards.next("DT2MSF DT2MSLC IMSCL - - RMSCL EMSCL IHDO").harmless("EMSCL IHDO");
    if (cards.more()) cards.next("RMAVG IGADO DTUSR DTDYNV").harmless("RMAVG IGADO DTDYNV");
}

void control_contact(Cards& cards, Draft& draft) {
    bool says_more = false;
    {
        Card c = cards.next("SLSFAC=0.1 RWPNAL ISLCHK SHLTHK PENOPT THKCHG ORIEN ENMASS");
        draft.rigid_wall_penalty = c.real("RWPNAL");
        const std::vector<std::string_view> said = c.set_fields();
        says_more = std::any_of(said.begin(), said.end(),
                                [](std::string_view name) { return name != "RWPNAL"; });
        c.harmless_all();
    }
    if (!says_more && !cards.more()) return;
    cards.note(
        "is read for RWPNAL alone: contact here has no penalties, thicknesses do not change, and "
        "friction is that of the contact's own card");
    cards.abandon();
}

void control_cpm(Cards& cards, Draft& draft) {
    {
        Card c = cards.next("CPMOUT=11 NP2P=5 NCPMTS CPMERR SFFDC=1 BLKV CPMMF P2PMIX");
        draft.force_decay = c.real("SFFDC", within(0.01, 100.0));
        c.noted("NCPMTS", "the step is that of fabric and gas");
        c.harmless("CPMOUT NP2P CPMERR");  // a bag with holes is always refused
    }
    if (cards.more()) cards.next("PMIS").harmless("PMIS");  // no particle is misplaced
}

namespace {

void interval(Cards& cards, double& interval) {
    Card c = cards.next("DT BINARY LCUR IOOPT OPTION1 OPTION2 OPTION3 OPTION4");
    interval = c.real("DT", NON_NEGATIVE);
    if (interval == 0.0) interval = NaN;  // DT = 0 asks for nothing
    c.harmless("BINARY IOOPT OPTION1 OPTION2 OPTION3 OPTION4");
    c.noted("LCUR", "output at the times of a curve is not done, DT counts");
}

}  // namespace

void database_d3plot(Cards& cards, Draft& draft) {
    {
        Card c = cards.next("DT LCDT BEAM NPLTC PSETID CID -");
        const double dt = c.real("DT", NON_NEGATIVE);
        draft.frame_count = c.integer("NPLTC", within(0, 1'000'000));
        draft.model.output.frames = dt > 0.0 ? dt : NaN;
        c.harmless("BEAM CID");
        c.noted("LCDT", "output at the times of a curve is not done, DT counts");
        c.noted("PSETID", "all parts are in the frames");
    }
    if (cards.more()) cards.next("IOOPT RATE CUTOFF WINDOW TYPE PSET").harmless_all();
}

void database_d3dump(Cards& cards, Draft& draft) {
    Card c = cards.next("CYCL NR BEAM NPLTC PSETID CID -");
    const int steps = c.integer("CYCL", {0.0});
    if (steps > 0) draft.model.output.checkpoint_steps = steps;
    c.harmless("NR BEAM NPLTC PSETID CID");
}

void database_abstat(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.abstat);
}
void database_abstat_cpm(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.abstat_cpm);
}
void database_matsum(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.matsum);
}
void database_glstat(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.glstat);
}
void database_rcforc(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.rcforc);
}
void database_rwforc(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.rwforc);
}
void database_rbdout(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.rbdout);
}
void database_nodout(Cards& cards, Draft& draft) {
    interval(cards, draft.model.output.nodout);
}

namespace {

/// _LOCAL, one a row, with _ID a heading behind each. @returns rows of what it names
std::vector<Index> local_rows(Cards& cards, const Registry& things) {
    static const Layout layout("ID CID REF HFO - - - -");
    std::vector<Index> rows;
    while (cards.rows()) {
        {
            Card c = cards.next(layout);
            if (const Index row = c.row("ID", things); row >= 0) rows.push_back(row);
            c.noted("CID", "what is written of it is along the axes of the deck");
            c.harmless("REF HFO");
        }
        if (cards.has("ID")) cards.title();
    }
    return rows;
}

}  // namespace

void database_history_node(Cards& cards, Draft& draft) {
    static const Layout ids("NID1 NID2 NID3 NID4 NID5 NID6 NID7 NID8"), named("ID HEADING:70");
    if (cards.has("LOCAL"))
        for (const Index row : local_rows(cards, draft.nodes))
            draft.model.history_nodes.push_back(row);
    while (cards.rows()) {
        Card c = cards.next(cards.has("ID") ? named : ids);
        if (cards.has("ID")) c.harmless("HEADING");
        for (std::size_t i = 0; i < (cards.has("ID") ? 1U : 8U); ++i)
            if (c.given(i) && c.integer(i) != 0)
                if (const Index row = c.row(i, draft.nodes); row >= 0)
                    draft.model.history_nodes.push_back(row);
    }
}

void database_history_node_set(Cards& cards, Draft& draft) {
    static const Layout ids("SID1 SID2 SID3 SID4 SID5 SID6 SID7 SID8");
    const auto add = [&](Index set) {
        for (const Index row : draft.node_set[static_cast<std::size_t>(set)])
            draft.model.history_nodes.push_back(row);
    };
    if (cards.has("LOCAL"))
        for (const Index set : local_rows(cards, draft.node_sets)) add(set);
    while (cards.rows()) {
        Card c = cards.next(ids);
        for (std::size_t i = 0; i < 8; ++i) {
            if (!c.given(i) || c.integer(i) == 0) continue;
            if (const Index set = c.row(i, draft.node_sets); set >= 0) add(set);
        }
    }
}

}  // namespace corpuscle::io::keywords
