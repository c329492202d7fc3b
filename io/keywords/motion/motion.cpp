// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

const Vec3 AXES[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

/// DOF 1-3 x y z, 4 along VID, 5-7 about x y z, 8 about VID.
void direction(Card& c, const Draft& draft, PrescribedMotion& motion, bool of_rigid_part) {
    const int dof = of_rigid_part ? c.choice("DOF", {1, 2, 3, 4, 5, 6, 7, 8}, {-4, -8, 9, 10, 11})
                                  : c.choice("DOF", {1, 2, 3, 4}, {-4, -8, 9, 10, 11});
    motion.rotation = dof > 4;
    if (dof % 4 != 0) {
        const Vec3& axis = AXES[dof % 4 - 1];
        motion.axis = motion.rotation ? c.file().spin(axis) : c.file().direction(axis);
        return c.harmless("VID");
    }
    const Index vector = c.row("VID", draft.vectors);
    if (vector >= 0) motion.axis = draft.vector[static_cast<std::size_t>(vector)].normalized();
    if (motion.rotation && c.file().mirrors()) motion.axis = -motion.axis;
}

/// The card, but for its first field.
PrescribedMotion motion_card(Card& c, const Draft& draft, bool of_rigid_part) {
    PrescribedMotion motion;
    direction(c, draft, motion, of_rigid_part);
    motion.kind = static_cast<MotionKind>(c.choice("VAD", {0, 1, 2}, {3, 4}));
    motion.curve = c.row("LCID", draft.curves);
    motion.scale = c.real("SF");
    motion.death = c.real("DEATH", POSITIVE);
    motion.birth = c.real("BIRTH", NON_NEGATIVE);
    return motion;
}

template <class Take>
void motions(Cards& cards, Draft& draft, const Layout& layout, bool of_rigid_part, Take&& take) {
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        PrescribedMotion motion = motion_card(c, draft, of_rigid_part);
        take(c, motion);
        draft.model.motions.push_back(std::move(motion));
        draft.motion_places.push_back(c.place());
        draft.curve_uses.push_back({draft.model.motions.back().curve, c.place(),
                                    draft.model.motions.back().birth,
                                    draft.model.motions.back().death});
    }
}

}  // namespace

void motion_node(Cards& cards, Draft& draft) {
    motions(cards, draft, "NID DOF VAD LCID SF=1 VID DEATH=1e28 BIRTH", false,
            [&](Card& c, PrescribedMotion& motion) {
                if (const Index node = c.row("NID", draft.nodes); node >= 0) motion.nodes = {node};
            });
}

void motion_set(Cards& cards, Draft& draft) {
    motions(cards, draft, "NSID DOF VAD LCID SF=1 VID DEATH=1e28 BIRTH", false,
            [&](Card& c, PrescribedMotion& motion) {
                if (const Index set = c.row("NSID", draft.node_sets); set >= 0)
                    motion.nodes = draft.node_set[static_cast<std::size_t>(set)];
            });
}

void motion_rigid(Cards& cards, Draft& draft) {
    motions(cards, draft, "PID DOF VAD LCID SF=1 VID DEATH=1e28 BIRTH", true,
            [&](Card& c, PrescribedMotion& motion) {
                motion.rigid_part = c.row("PID", draft.parts);
                if (motion.rigid_part >= 0 && !is_rigid(draft, motion.rigid_part))
                    c.fault("PID", "a part with *MAT_RIGID");
                expect_lead(c, draft, "PID", motion.rigid_part);
            });
}

}  // namespace corpuscle::io::keywords
