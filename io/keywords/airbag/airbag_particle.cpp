// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "gas/cards/collision_model.hpp"
#include "io/keywords/airbag/airbag_gas.hpp"
#include "io/keywords/airbag/airbag_vents.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

constexpr Range COUNT{0.0, 10000.0};  ///< rows of a kind in one keyword

/// Part rows of SID: a part (0) or a part set (1).
std::vector<Index> parts_of(Card& c, const char* sid, int type, const Draft& draft) {
    const Index row = c.row(sid, type == 0 ? draft.parts : draft.part_sets);
    if (row < 0) return {};
    return type == 0 ? std::vector<Index>{row} : draft.part_set[static_cast<std::size_t>(row)];
}

/// One *AIRBAG_PARTICLE, card after card as the manual prints them.
class Reading {
public:
    Reading(Cards& cards, Draft& draft) : cards_(cards), draft_(draft) {}

    gas::BagCard read() {
        bag_.kind = "*AIRBAG_PARTICLE";
        bag_.smoothing = draft_.force_decay;
        if (cards_.has("MPP")) cards_.next("SX SY SZ").harmless("SX SY SZ");
        if (cards_.has("ID") || cards_.has("TITLE")) name();
        if (cards_.has("TIME")) window();
        surface();
        if (cards_.has("SEGMENT")) cards_.next("SEGSID");
        particles();
        if (cards_.has("JET")) cards_.next("JNODE");
        if (cards_.plus()) fine_points();
        if (cards_.plus()) front_tracking();
        if (unit_ == 3) unit_ = system_of_factors();
        bag_.gas_constant = GAS_CONSTANT * unit().energy;
        bag_.second = unit().second;
        if (bag_.p_atm == 0.0) bag_.p_atm = ATMOSPHERE_PRESSURE * unit().pressure;
        counts();
        skip(inner_rows_, "SIDUP STYUP PFRAC LINKING");
        for (int i = 0; i < part_rows_; ++i) part_data(cards_, draft_, bag_);
        for (int i = 0; i < vent_rows_; ++i) vent(cards_, draft_, bag_);
        gas();
        return bag_;
    }

    [[nodiscard]] const char* unit_name() const { return unit().name; }

private:
    void name() {
        Card c = cards_.next("ID TITLE:70");
        bag_.id = c.id("ID", IdKind::OTHER, NON_NEGATIVE);
        bag_.title = c.text("TITLE");
    }

    /// Bags act from the start to the end.
    void window() {
        constexpr double NEVER = 1e10;  // as TEND and TSW have it
        Card c = cards_.next("BIRTH DEATH");
        if (const double death = c.real("DEATH"); death != 0.0 && death < NEVER)
            c.fault("DEATH", "0, or 1e10 and later: the end of a bag is not acted on yet");
    }

    void surface() {
        const bool notes = draft_.dialect == Dialect::NOTES_2007;
        Card c = cards_.next(notes ? "SID1 STYPE1 SID2 STYPE2 BLOCK HCONV"
                                   : "SID1 STYPE1 SID2 STYPE2 BLOCK NPDATA FRIC IRDP");
        const int type = c.choice("STYPE1", {0, 1});
        const std::vector<Index> all = parts_of(c, "SID1", type, draft_);
        const int inner_type = c.choice("STYPE2", {0, 1}, {2});
        if (c.given("STYPE2") && c.integer("STYPE2") == 2)
            inner_rows_ = c.integer("SID2", COUNT);
        else if (c.integer("SID2") != 0)
            bag_.internal_parts = parts_of(c, "SID2", inner_type, draft_);
        for (const Index part : all)
            if (std::find(bag_.internal_parts.begin(), bag_.internal_parts.end(), part) ==
                bag_.internal_parts.end())
                bag_.external_parts.push_back(part);
        if (c.good() && bag_.external_parts.empty())
            c.fault("SID2", "internal parts that leave some part of SID1 to close the bag");
        if (c.good() && !has_shells() && !draft_.is_incomplete)
            c.fault("SID1", "parts with shells in them");
        block(c, bag_);
        if (notes) {
            if (const double h = c.real("HCONV", NON_NEGATIVE); h > 0.0) bag_.heat = {{all, h, -1}};
            return;
        }
        part_rows_ = c.integer("NPDATA", COUNT);
        if (gas::FrictionCard rough; friction(c, "FRIC", draft_, rough))
            bag_.friction.push_back(rough);
        c.noted("IRDP", "particles have no radius here");
    }

    [[nodiscard]] bool has_shells() const {
        const auto& parts = bag_.external_parts;
        return std::any_of(draft_.model.shells.begin(), draft_.model.shells.end(),
                           [&](const Shell& s) {
                               return std::find(parts.begin(), parts.end(), s.part) != parts.end();
                           });
    }

    void particles() {
        Card c = cards_.next("NP=200000 UNIT VISFLG TATM=293 PATM NVENT TEND=1e10 TSW=1e10");
        constexpr double MOST = 1e8;  // some 10 GB
        bag_.particles = static_cast<std::size_t>(c.integer("NP", within(1.0, MOST)));
        unit_ = c.choice("UNIT", {0, 1, 2, 3});
        const int visible = c.choice("VISFLG", {0, 1, 2, 3});
        const bool blank_shows = draft_.dialect == Dialect::TODAY && !c.given("VISFLG");
        bag_.show_particles = blank_shows || visible == 1 || visible == 2;
        if (!blank_shows && visible == 0 && draft_.dialect == Dialect::TODAY)
            c.note("VISFLG", "no particles are in the frames, as with 3 (LS-DYNA takes 0 as 1)");
        bag_.T_atm = c.real("TATM", TEMPERATURE);
        if (bag_.T_atm == 0.0) bag_.T_atm = ATMOSPHERE_TEMPERATURE;
        bag_.p_atm = c.real("PATM", NON_NEGATIVE);
        vent_rows_ = c.integer("NVENT", COUNT);
        bag_.all_in = c.real("TEND", POSITIVE);
        bag_.switch_at = c.real("TSW", POSITIVE);
    }

    /// UNIT = 3: the row of UNIT_SYSTEMS whose mass, time and length have these many kg, s and m.
    int system_of_factors() {
        constexpr double ROUNDING = 1e-6;
        Card c = cards_.next("- MASS - TIME - LENGTH");
        const Vec3 factors = c.vector("MASS", "TIME", "LENGTH");
        const Vec3 known[] = {{1.0, 1e-3, 1e-3}, {1.0, 1.0, 1.0}, {1e3, 1.0, 1e-3}};
        for (int system = 0; system < 3; ++system)
            if ((factors.cwiseQuotient(known[system]) - Vec3::Ones()).isZero(ROUNDING))
                return system;
        c.fault("MASS",
                "with TIME and LENGTH those of kg-mm-ms (1, 0.001, 0.001), of SI (1, 1, 1) or of "
                "ton-mm-s (1000, 1, 0.001)");
        return 1;
    }

    void fine_points() {
        Card c = cards_.next_plus("TSTOP=1e11 TSMTH OCCUP=0.1 REBL SIDSV PSID1 TSPLIT SFFDC=1");
        c.noted("TSTOP", "there is no front to track");
        c.noted("REBL", "no energy of the gas is lost to damping here");
        c.harmless("TSMTH PSID1");  // ramp of TSTOP; a bag is closed whatever its normals
        c.noted("OCCUP", "particles are points here, collisions need no spheres");
        const double decay = c.real("SFFDC", within(0.01, 100.0));
        if (c.given("SFFDC")) bag_.smoothing = decay;
    }

    void front_tracking() {
        Card c = cards_.next_plus("SFIAIR4=1 IDFRIC IAIRSTAT DPWR=1 VNDAMP JETLEN JETEND SHLOFF");
        c.harmless("SFIAIR4 IAIRSTAT DPWR");  // of IAIR = 4
        c.noted("JETLEN JETEND", "particles collide near nozzles as elsewhere");
        c.noted("SHLOFF", "the volume is that within the middle of the shells");
        bag_.friction_pushes_along = c.choice("IDFRIC", {0, 1}) == 0;
        bag_.normal_damping = c.real("VNDAMP", within(0.0, 1.0));
    }

    void counts() {
        Card c = cards_.next(draft_.dialect == Dialect::NOTES_2007
                                 ? "IAIR NGAS NORIF NID1 NID2 NID3"
                                 : "IAIR NGAS NORIF NID1 NID2 NID3 CHM CD_EXT");
        gases_ = c.integer("NGAS", COUNT);
        nozzles_ = c.integer("NORIF", COUNT);
        frame(c);
        if (draft_.dialect == Dialect::TODAY)
            if (const Index row = c.row_or_none("CHM", draft_.cpm_chambers); row >= 0)
                bag_.chambers = draft_.cpm_chamber[static_cast<std::size_t>(row)];
        if (!c.good()) cards_.abandon();  // nobody can say which row is which
        air_ = c.choice("IAIR", {0, 1, -1, 2, 4});
        if (air_ == 4) {
            c.warn("IAIR",
                   "taken as 2: initial air is particles that press as particles do, from the "
                   "start on; there is no front to track");
        }
        skips_air_ = air_ == 0 && c.integer("IAIR") != 0;
        if (!c.good()) return;
        if (gases_ == 0 && air_ == 0) c.fault("NGAS", ">= 1, or IAIR = 1: this bag has no gas");
        if (gases_ > 0 && nozzles_ == 0) c.fault("NORIF", ">= 1, for the gases of NGAS");
    }

    /// NID1-3: three nodes that are not in line.
    void frame(Card& c) {
        constexpr const char* NAMES[] = {"NID1", "NID2", "NID3"};
        const bool asked = c.given("NID1") && c.integer("NID1") != 0;
        if (!asked) return;
        for (std::size_t i = 0; i < 3; ++i) bag_.frame[i] = c.row(NAMES[i], draft_.nodes);
        if (!c.good()) return;
        const Points& x = draft_.model.x;
        const Vec3 a = x[bag_.frame[1]] - x[bag_.frame[0]], b = x[bag_.frame[2]] - x[bag_.frame[0]];
        constexpr double IN_LINE = 1e-6;  // of a right angle
        if (!(a.cross(b).norm() > IN_LINE * a.norm() * b.norm()))
            c.fault("NID3", "a node that is not in line with NID1 and NID2");
    }

    void skip(int rows, const char* layout) {
        for (int i = 0; i < rows; ++i) cards_.next(layout).harmless_all();
    }

    void gas() {
        if (air_ != 0) bag_.air = initial_air(cards_, draft_, bag_, unit(), air_);
        if (skips_air_) skip(1, "PAIR TAIR XMAIR AAIR BAIR CAIR NPAIR NPRLX");
        Index mass = -1;
        if (cards_.has("MOLEFRACTION")) mass = cards_.next("LCMASS").row("LCMASS", draft_.curves);
        for (int i = 0; i < gases_; ++i) bag_.inflow.push_back(inflow(cards_, draft_, unit()));
        if (mass >= 0 && cards_.good()) share_by_moles(cards_, draft_, mass, bag_.inflow);
        auto& nozzles = bag_.orifices;
        for (int i = 0; i < nozzles_; ++i)
            nozzles.push_back(orifice(cards_, draft_, i == 0 ? nullptr : &nozzles.front()));
        if (nozzles_ == 0 || nozzles.front().weight > 0.0) return;
        if (nozzles_ > 1) cards_.note("has orifices without areas AN: all have the same");
        for (gas::OrificeCard& nozzle : nozzles) nozzle.weight = 1.0;
    }

    [[nodiscard]] const UnitSystem& unit() const { return UNIT_SYSTEMS[unit_]; }

    Cards& cards_;
    Draft& draft_;
    gas::BagCard bag_;
    int unit_ = 1;
    int inner_rows_ = 0, part_rows_ = 0, vent_rows_ = 0, gases_ = 0, nozzles_ = 0;
    int air_ = 0;             ///< IAIR
    bool skips_air_ = false;  ///< its card is there, though nothing acts on it
};

/// Every gas needs a nozzle of its inflator, and no nozzle stays idle.
void check_inflators(Cards& cards, const gas::BagCard& bag) {
    const auto has_orifice = [&](int inflator) {
        return std::any_of(bag.orifices.begin(), bag.orifices.end(),
                           [&](const gas::OrificeCard& o) { return o.inflator == inflator; });
    };
    const auto has_gas = [&](int inflator) {
        return std::any_of(bag.inflow.begin(), bag.inflow.end(),
                           [&](const gas::InflowCard& g) { return g.inflator == inflator; });
    };
    for (const gas::InflowCard& gas : bag.inflow)
        if (!bag.orifices.empty() && !has_orifice(gas.inflator))
            cards.fault(fmt::format(
                "has a gas of inflator INFG = {}, expected a nozzle with that INFO", gas.inflator));
    for (const gas::OrificeCard& nozzle : bag.orifices)
        if (!bag.inflow.empty() && !has_gas(nozzle.inflator))
            cards.fault(
                fmt::format("has a nozzle of inflator INFO = {}, expected a gas with that INFG",
                            nozzle.inflator));
}

}  // namespace

void airbag_particle(Cards& cards, Draft& draft) {
    if (cards.has("INFLATION")) cards.fault("has _INFLATION, which is not acted on yet");
    Reading reading(cards, draft);
    gas::BagCard bag = reading.read();
    bag.is_of_2007 = draft.dialect == Dialect::NOTES_2007;
    bag.collision = draft.collision;
    bag.mean_free_path = draft.mean_free_path;
    check_inflators(cards, bag);
    check_leaks(cards, draft, bag);
    const auto is_same = [&](const auto& other) { return bag.id != 0 && other.id == bag.id; };
    if (std::any_of(draft.model.bags.begin(), draft.model.bags.end(), is_same) ||
        std::any_of(draft.model.uniform_bags.begin(), draft.model.uniform_bags.end(), is_same))
        cards.fault(fmt::format("has id {}, as another airbag has", bag.id));
    const std::string unit = reading.unit_name();
    if (!draft.model.bags.empty() && unit != draft.model.unit_system)
        cards.fault(
            fmt::format("has units {}, but another airbag has {}", unit, draft.model.unit_system));
    draft.model.unit_system = unit;
    draft.model.bags.push_back(bag);
}

void note_bags(Draft& draft) {
    for (const gas::BagCard& bag : draft.model.bags) {
        draft.model.notes.push_back(
            fmt::format("*AIRBAG_PARTICLE {} is read with {}", bag.id,
                        bag.is_of_2007 ? "the meaning of the 2007 course notes (DIALECT = 2007)"
                                       : "today's meaning (-D DIALECT=2007 for that of 2007)"));
        if (bag.collision)
            draft.model.notes.push_back(fmt::format("*AIRBAG_PARTICLE {}: particles collide by {}",
                                                    bag.id, gas::name_of(*bag.collision)));
    }
}

}  // namespace corpuscle::io::keywords
