// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

/// *MAT_ADD_AIRBAG_POROSITY_LEAKAGE: FLC, FAC, ELA, FVOPT, X0, X1 of any material, instead of its
/// own; with X0 the fields FLC and FAC are X2 and X3.
void mat_add_leakage(Cards& cards, Draft& draft) {
    static const Layout layout("MID FLC FAC=1 ELA FVOPT X0 X1 -");
    while (cards.rows()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next(layout);
        const Index row = c.row("MID", draft.materials);
        fabric::FabricCard leak;
        value_or_curve(c, "FLC", draft.curves, leak.leak_area, leak.leak_area_curve);
        value_or_curve(c, "FAC", draft.curves, leak.leak_velocity, leak.leak_velocity_curve);
        leak.leak_when_blocked = c.real("ELA", within(0.0, 1.0));
        leak.leak_option = c.integer("FVOPT", within(0.0, 8.0));
        leak.leak_by_component = draft.dialect == Dialect::NOTES_2007;
        const double X0 = c.real("X0"), X1 = c.real("X1");
        if (X0 == 0.0 && X1 != 0.0) c.fault("X1", "0 or blank without X0");
        if (X0 != 0.0 && (leak.leak_area_curve >= 0 || leak.leak_velocity_curve >= 0))
            c.fault("X0", "0 or blank, or FLC and FAC as numbers: they are X2 and X3 then");
        if (X0 != 0.0) {
            const double X3 = c.given("FAC") ? leak.leak_velocity : 0.0;
            leak.leak_growth = {X0, X1, leak.leak_area, X3};
            leak.leak_area = leak.leak_velocity = 0.0;
        }
        if (row < 0 || !c.good()) continue;
        draft.model.added_leaks.push_back({row, leak});
        draft.added_leaks.emplace_back(row, c.place());
    }
}

}  // namespace corpuscle::io::keywords
