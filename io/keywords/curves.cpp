// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

void define_curve(Cards& cards, Draft& draft) {
    static const Layout point("A:20 O:20");
    if (cards.has("TITLE")) cards.title();
    Curve curve;
    double x_scale = 1.0, y_scale = 1.0, x_offset = 0.0, y_offset = 0.0;
    {
        Card c = cards.next("LCID SIDR SFA=1 SFO=1 OFFA OFFO DATTYP LCINT");
        curve.id = c.new_id("LCID", draft.curves, draft.model.curves.size());
        c.choice("SIDR", {0, 2}, {1});
        x_scale = c.real("SFA");
        y_scale = c.real("SFO");
        x_offset = c.real("OFFA");
        y_offset = c.real("OFFO");
        c.harmless("DATTYP LCINT");
    }
    while (cards.rows()) {
        Card c = cards.next(point);
        const double x = x_scale * (c.real("A") + x_offset);
        const double y = y_scale * (c.real("O") + y_offset);
        if (!curve.x.empty() && x < curve.x.back())
            c.fault("A", fmt::format("abscissae that do not decrease, but {:g} comes after {:g}", x,
                                     curve.x.back()));
        curve.x.push_back(x);
        curve.y.push_back(y);
    }
    if (curve.x.size() < 2 && cards.good()) cards.fault("has too few points, expected two or more");
    draft.model.curves.push_back(std::move(curve));
}

void define_vector(Cards& cards, Draft& draft) {
    while (cards.more()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next("VID XT YT ZT XH YH ZH CID");
        c.new_id("VID", draft.vectors, draft.vector.size());
        const Vec3 tail = c.vector("XT", "YT", "ZT");
        const Vec3 head = c.vector("XH", "YH", "ZH");
        if (c.good() && head == tail) c.fault("XH", "a head away from the tail");
        draft.vector.push_back(head - tail);
    }
}

}  // namespace corpuscle::io::keywords
