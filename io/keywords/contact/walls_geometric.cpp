// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <cmath>

#include "io/keywords/contact/walls.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

/// _MOTION: along (VX, VY, VZ), by the curve's speed (OPT 0) or way (OPT 1).
contact::WallMotion guided(Cards& cards, Draft& draft) {
    constexpr double UNIT = 1e-3;  // as far as cosines are rounded in decks
    Card c = cards.next("LCID OPT VX VY VZ");
    contact::WallMotion motion;
    motion.curve = c.row("LCID", draft.curves);
    draft.curve_uses.push_back({motion.curve, c.place()});
    motion.is_displacement = c.choice("OPT", {0, 1}) == 1;
    motion.direction = c.direction("VX", "VY", "VZ");
    if (c.good() && std::abs(motion.direction.norm() - 1.0) > UNIT)
        c.fault("VX", "the cosines of a direction, VX² + VY² + VZ² = 1");
    else
        motion.direction.normalize();
    return motion;
}

template <class ReadShape>
void geometric_wall(Cards& cards, Draft& draft, ReadShape&& read_shape) {
    contact::WallCard wall;
    wall_name(cards, wall);
    {
        Card c = cards.next("NSID NSIDEX BOXID BIRTH DEATH=1e20");
        wall.nodes = stopped_nodes(c, draft);
        wall.birth = c.real("BIRTH", NON_NEGATIVE);
        wall.death = c.real("DEATH", POSITIVE);
    }
    wall.shape = read_shape(wall.friction);
    if (cards.has("MOTION")) wall.motion = guided(cards, draft);
    skip_display(cards);
    add_wall(cards, draft, std::move(wall));
}

/// XT YT ZT XH YH ZH FRIC.
Arrow placed(Cards& cards, double& friction) {
    Card c = cards.next("XT YT ZT XH YH ZH FRIC");
    friction = c.real("FRIC", within(0.0, 1.0));
    return arrow(c);
}

contact::WallShape ball(Cards& cards, double& friction) {
    contact::Ball ball;
    {
        Card c = cards.next("XT YT ZT XH YH ZH FRIC");
        ball.centre = c.point("XT", "YT", "ZT");
        friction = c.real("FRIC", within(0.0, 1.0));
        c.harmless("XH YH ZH");  // a ball has no direction
    }
    Card c = cards.next("RADSPH");
    ball.radius = c.real("RADSPH", POSITIVE);
    return ball;
}

contact::WallShape rod(Cards& cards, double& friction) {
    const Arrow axis = placed(cards, friction);
    Card c = cards.next("RADCYL LENCYL NSEGS");
    contact::Rod rod;
    rod.base = axis.tail;
    rod.axis = axis.direction;
    rod.radius = c.real("RADCYL", POSITIVE);
    if (const double length = c.real("LENCYL", NON_NEGATIVE); length > 0.0) {
        rod.low = 0.0;
        rod.high = length;
    }
    if (c.integer("NSEGS", NON_NEGATIVE) > 0)
        c.fault("NSEGS", "0: cylinders in segments are not acted on yet");
    return rod;
}

}  // namespace

void rigidwall_flat(Cards& cards, Draft& draft) {
    do
        geometric_wall(cards, draft, [&](double& friction) {
            const Arrow normal = placed(cards, friction);
            return rectangle(cards, normal, /*has_depth=*/false);
        });
    while (cards.more());
}

void rigidwall_prism(Cards& cards, Draft& draft) {
    do
        geometric_wall(cards, draft, [&](double& friction) {
            const Arrow normal = placed(cards, friction);
            return rectangle(cards, normal, /*has_depth=*/true);
        });
    while (cards.more());
}

void rigidwall_sphere(Cards& cards, Draft& draft) {
    do geometric_wall(cards, draft, [&](double& friction) { return ball(cards, friction); });
    while (cards.more());
}

void rigidwall_cylinder(Cards& cards, Draft& draft) {
    do geometric_wall(cards, draft, [&](double& friction) { return rod(cards, friction); });
    while (cards.more());
}

}  // namespace corpuscle::io::keywords
