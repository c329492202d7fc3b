// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/deck/expression.hpp"
#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"

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
        c.noted("DATTYP", -2.0,
                "this meaning of a fabric's curve is not acted on: its points count as they stand");
        c.harmless("LCINT");
    }
    while (cards.lines_left() > 0) {  // a blank one between others is (0, 0)
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

/// *DEFINE_CURVE_SMOOTH: a velocity that rises to VMAX within TRISE, stays, and falls within TRISE,
/// each by half a cosine; over it a way of DIST = VMAX (TEND - TSTART - TRISE).
void define_curve_smooth(Cards& cards, Draft& draft) {
    constexpr int CORNERS = 50;  // of each half cosine
    if (cards.has("TITLE")) cards.title();
    Card c = cards.next("LCID SIDR DIST TSTART TEND TRISE VMAX -");
    Curve curve;
    curve.id = c.new_id("LCID", draft.curves, draft.model.curves.size());
    c.choice("SIDR", {0, 2}, {1});
    const double way = c.real("DIST"), start = c.real("TSTART", NON_NEGATIVE);
    double end = c.real("TEND", NON_NEGATIVE), most = c.real("VMAX");
    const double rise = c.real("TRISE", POSITIVE);
    if (c.good() && end == 0.0 && most == 0.0) c.fault("TEND", "a time, or VMAX");
    if (c.good() && end == 0.0) end = start + rise + way / most;
    if (c.good() && end - start < 2.0 * rise) c.fault("TEND", "at least 2 TRISE after TSTART");
    if (c.good() && most == 0.0) most = way / (end - start - rise);
    curve.x = {0.0};
    curve.y = {0.0};
    const auto add = [&](double x, double y) {
        if (x <= curve.x.back()) return;
        curve.x.push_back(x);
        curve.y.push_back(y);
    };
    add(start, 0.0);
    for (int i = 1; i <= CORNERS; ++i)
        add(start + rise * i / CORNERS,
            0.5 * most * (1.0 - std::cos(std::numbers::pi * i / CORNERS)));
    for (int i = 0; i <= CORNERS; ++i)
        add(end - rise + rise * i / CORNERS,
            0.5 * most * (1.0 + std::cos(std::numbers::pi * i / CORNERS)));
    add(end + rise, 0.0);
    draft.model.curves.push_back(std::move(curve));
}

namespace {

constexpr double KNOTS = 2048.0;         ///< of a curve function, for each doubling of time
constexpr double FIRST_KNOTS = 0x1p-14;  ///< as many lead here from 0                [s]

/// Where a curve function is known next after t; the same whenever the run ends.
double next_knot(double t) {
    return t + (t < FIRST_KNOTS ? FIRST_KNOTS : std::scalbn(1.0, std::ilogb(t))) / KNOTS;
}

/// y of time, from 0 to the first knot that is not before the end; to the end itself where the
/// function has no value at that knot.
template <class Function>
void sample_function(Function&& y, double end, Curve& curve) {
    const auto add = [&](double t) {
        curve.y.push_back(y(t));
        curve.x.push_back(t);
    };
    add(0.0);
    for (double t = next_knot(0.0); t < end; t = next_knot(t)) add(t);
    try {
        add(next_knot(curve.x.back()));
    } catch (const ExpressionError&) {
        add(end);
    }
}

}  // namespace

/// *DEFINE_CURVE_FUNCTION: arithmetic of TIME, straight between knots.
void define_curve_function(Cards& cards, Draft& draft) {
    if (cards.has("TITLE")) cards.title();
    Curve curve;
    {
        Card c = cards.next("LCID SIDR - - - - - -");
        curve.id = c.new_id("LCID", draft.curves, draft.model.curves.size());
        draft.function_curves.push_back(static_cast<Index>(draft.model.curves.size()));
        c.choice("SIDR", {0, 2}, {1});
    }
    std::string text;
    while (cards.rows()) text += cards.title();
    const double end =
        std::max(draft.until, draft.model.end_time > 0.0 ? draft.model.end_time : 1.0);
    const auto value_at = [&](double t) {
        return evaluate(text,
                        [&](std::string_view name) -> std::optional<Value> {
                            if (upper(name) == "TIME") return Value{t, false};
                            return cards.parameters().value(name, cards.block().viewpoint());
                        })
            .number;
    };
    try {
        sample_function(value_at, end, curve);
    } catch (const ExpressionError& error) {
        cards.fault(
            fmt::format("= {}, expected arithmetic of TIME: {}", text.substr(0, 60), error.what()));
        curve.x = {0.0, 1.0};
        curve.y = {0.0, 0.0};
    }
    cards.warn(
        fmt::format("is taken as straight lines, {:g} of them in each doubling of TIME", KNOTS));
    draft.model.curves.push_back(std::move(curve));
}

/// *DEFINE_BOX: along the axes, at the start.
void define_box(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next("BOXID XMN XMX YMN YMX ZMN ZMX");
        c.new_id("BOXID", draft.boxes, draft.box.size());
        const Vec3 low(c.real("XMN"), c.real("YMN"), c.real("ZMN")),
            high(c.real("XMX"), c.real("YMX"), c.real("ZMX"));
        if (c.good() && !(low.array() <= high.array()).all())
            c.fault("XMX", "upper bounds that are not below the lower ones");
        draft.box.push_back({Eigen::AlignedBox3d(low, high), c.file()});
    }
}

void define_vector(Cards& cards, Draft& draft) {
    while (cards.more()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next("VID XT YT ZT XH YH ZH CID");
        c.new_id("VID", draft.vectors, draft.vector.size());
        const Vec3 tail = c.vector("XT", "YT", "ZT");
        const Vec3 head = c.vector("XH", "YH", "ZH");
        if (c.good() && head == tail) c.fault("XH", "a head away from the tail");
        draft.vector.push_back(c.file().direction(head - tail));
    }
}

}  // namespace corpuscle::io::keywords
