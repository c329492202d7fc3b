// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"
#include "io/keywords/mesh/coordinates.hpp"

namespace corpuscle::io::keywords {

namespace {

const Vec3 AXES[] = {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};

/// x, y or z, of the deck or of the coordinate system -VID.
void along_axis(Card& c, const Draft& draft, int k, PrescribedMotion& motion) {
    const double vid = c.real("VID");  // a vector counts for DOF 4 and 8 alone
    if (vid >= 0.0) {
        motion.axis = motion.rotation ? c.file().spin(AXES[k]) : c.file().direction(AXES[k]);
        return;
    }
    const Registry::Entry* system = c.named("VID", -vid, draft.coordinates);
    if (system == nullptr)
        return c.fault("VID", "0, or minus the id of a *DEFINE_COORDINATE_... of the deck");
    if (draft.coordinate[static_cast<std::size_t>(system->row)].moves)
        return c.fault("VID",
                       "a coordinate system that stays as it is, FLAG = 0: axes of a motion that "
                       "go with nodes are not acted on yet");
    motion.axis =
        axes_at_start(draft, system->row) * local_axis(c.file(), k, /*turns=*/motion.rotation);
}

/// DOF 1-3 x y z, 4 along VID, 5-7 about x y z, 8 about VID.
void direction(Card& c, const Draft& draft, PrescribedMotion& motion, bool of_rigid_part) {
    const int dof = of_rigid_part ? c.choice("DOF", {1, 2, 3, 4, 5, 6, 7, 8}, {-4, -8, 9, 10, 11})
                                  : c.choice("DOF", {1, 2, 3, 4}, {-4, -8, 9, 10, 11});
    motion.rotation = dof > 4;
    if (dof % 4 != 0) return along_axis(c, draft, dof % 4 - 1, motion);
    const Index vector = c.row("VID", draft.vectors);
    if (vector >= 0) motion.axis = draft.vector[static_cast<std::size_t>(vector)].normalized();
    if (motion.rotation && c.file().mirrors()) motion.axis = -motion.axis;
}

/// Row of the curve whose abscissae are times since BIRTH, as those of a motion are.
Index late_curve(Draft& draft, Index curve, double birth) {
    auto& curves = draft.model.curves;
    const bool is_reached = birth < std::max(draft.until, draft.model.end_time);
    if (curve < 0 || birth == 0.0 || !is_reached) return curve;
    const auto [late, is_new] = draft.late_curves.try_emplace({curve, birth}, 0);
    if (is_new) {
        late->second = static_cast<Index>(curves.size());
        Curve copy = curves[static_cast<std::size_t>(curve)];
        for (double& t : copy.x) t += birth;
        curves.push_back(std::move(copy));
    }
    return late->second;
}

/// LCID and BIRTH, from which on the curve's time counts.
void curve_of_motion(Card& c, Draft& draft, PrescribedMotion& motion) {
    motion.curve = c.row("LCID", draft.curves);
    motion.birth = c.real("BIRTH", NON_NEGATIVE);
    const auto& functions = draft.function_curves;
    if (std::find(functions.begin(), functions.end(), motion.curve) == functions.end()) {
        motion.curve = late_curve(draft, motion.curve, motion.birth);
    } else if (motion.birth > 0.0) {
        motion.birth = 0.0;
        c.warn("BIRTH",
               "does not count for a *DEFINE_CURVE_FUNCTION: the motion acts from the start on");
    }
}

/// The card, but for its first field.
PrescribedMotion motion_card(Card& c, Draft& draft, bool of_rigid_part) {
    PrescribedMotion motion;
    direction(c, draft, motion, of_rigid_part);
    motion.kind = static_cast<MotionKind>(c.choice("VAD", {0, 1, 2}, {3, 4}));
    curve_of_motion(c, draft, motion);
    motion.scale = c.real("SF");
    motion.death = c.real("DEATH", POSITIVE);
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
