// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// *CONSTRAINED_JOINT_STIFFNESS_GENERALIZED: springs, dampers, stops and friction of two bodies.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"
#include "io/keywords/mesh/coordinates.hpp"

namespace corpuscle::io::keywords {
namespace {

/// Fields of phi, theta, psi.
struct AxisFields {
    const char *spring, *damper, *stiffness, *friction, *low, *high;
};
constexpr std::array<AxisFields, 3> JOINT_FIELDS = {
    {{"LCIDPH", "DLCIDPH", "ESPH", "FMPH", "NSAPH", "PSAPH"},
     {"LCIDT", "DLCIDT", "EST", "FMT", "NSAT", "PSAT"},
     {"LCIDPS", "DLCIDPS", "ESPS", "FMPS", "NSAPS", "PSAPS"}}};

/// The row of a rigid part; -1 with a fault.
Index body(Card& c, const Draft& draft, const char* field) {
    const Index part = c.row(field, draft.parts);
    if (part >= 0 && !is_rigid(draft, part)) c.fault(field, "a part with *MAT_RIGID");
    return part;
}

/// Axes of a body at the start: a system of nodes turns with the body only if it has them.
Mat3 axes_of_body(Card& c, Draft& draft, const char* field, Index system, Index part) {
    const LocalAxes& local = draft.coordinate[static_cast<std::size_t>(system)];
    const std::vector<Index>& owner = rigid_owners(draft);
    const auto is_others = [&](Index node) {
        return node >= 0 && owner[static_cast<std::size_t>(node)] != lead_of(draft, part);
    };
    if (std::any_of(local.nodes.begin(), local.nodes.end(), is_others))
        c.fault(field,
                "a system whose nodes are of its rigid part, or given to it by "
                "*CONSTRAINED_EXTRA_NODES");
    return axes_at_start(draft, system);
}

/// PIDA PIDB CIDA CIDB; CIDB 0: both have the axes of CIDA at the start.
void bodies(Cards& cards, Draft& draft, JointStiffness& joint) {
    Card c = cards.next("JSID PIDA PIDB CIDA CIDB JID");
    joint.id = c.id("JSID", IdKind::OTHER, {1.0});
    joint.parts = {body(c, draft, "PIDA"), body(c, draft, "PIDB")};
    const Index a = c.row("CIDA", draft.coordinates);
    const Index b = c.row_or_none("CIDB", draft.coordinates);
    c.harmless("JID");  // of tables of friction over the joint's force
    if (!c.good()) return;
    if (lead_of(draft, joint.parts[0]) == lead_of(draft, joint.parts[1]))
        c.fault("PIDB", "a part of another body than PIDA");
    for (const Index part : joint.parts) draft.body_uses.emplace_back(part, c.place());
    joint.axes[0] = axes_of_body(c, draft, "CIDA", a, joint.parts[0]);
    joint.axes[1] = b < 0 ? joint.axes[0] : axes_of_body(c, draft, "CIDB", b, joint.parts[1]);
}

/// A curve over an angle or its rate: without jumps, which no step would see the end of.
Index steady(Card& c, const Draft& draft, const char* field) {
    const Index row = c.row_or_none(field, draft.curves);
    if (row < 0) return row;
    const Curve& curve = draft.model.curves[static_cast<std::size_t>(row)];
    if (std::adjacent_find(curve.x.begin(), curve.x.end()) != curve.x.end())
        c.fault(field, "a curve without two points at one angle or rate");
    return row;
}

/// A damper takes energy at every rate, also beyond its ends.
Index damper(Card& c, const Draft& draft, const char* field) {
    const Index row = steady(c, draft, field);
    if (row < 0 || !c.good()) return row;
    const Curve& curve = draft.model.curves[static_cast<std::size_t>(row)];
    bool gives = curve.empty() || curve.y.front() > 0.0 || curve.y.back() < 0.0;
    for (std::size_t i = 0; i < curve.x.size(); ++i) gives |= curve.x[i] * curve.y[i] < 0.0;
    if (gives || curve(0.0) != 0.0)
        c.fault(field,
                "a curve of moments that have the sign of the rate, below 0 too, and are 0 "
                "at 0: others would drive the bodies");
    return row;
}

void curves(Cards& cards, const Draft& draft, JointStiffness& joint) {
    Card c = cards.next("LCIDPH LCIDT LCIDPS DLCIDPH DLCIDT DLCIDPS");
    for (std::size_t k = 0; k < 3; ++k) {
        joint.about[k].spring = steady(c, draft, JOINT_FIELDS[k].spring);
        joint.about[k].damper = damper(c, draft, JOINT_FIELDS[k].damper);
        joint.about[k].is_mirrored = c.file().mirrors() && k < 2;  // of x y and z = x × y
    }
}

void friction(Cards& cards, JointStiffness& joint) {
    Card c = cards.next("ESPH FMPH EST FMT ESPS FMPS");
    for (std::size_t k = 0; k < 3; ++k) {
        joint.about[k].stiffness = c.real(JOINT_FIELDS[k].stiffness, NON_NEGATIVE);
        joint.about[k].friction = c.real(JOINT_FIELDS[k].friction);
        if (joint.about[k].friction < 0.0)
            c.fault(JOINT_FIELDS[k].friction,
                    "0 or above: a curve of friction is not acted on yet");
        if (joint.about[k].friction > 0.0 && joint.about[k].stiffness == 0.0)
            c.warn(JOINT_FIELDS[k].friction,
                   "does not act, for the elastic stiffness before it is 0");
    }
}

/// Stop angles in degrees; that of negative angles may have either sign.
void stops(Cards& cards, JointStiffness& joint) {
    constexpr double DEGREE = std::numbers::pi / 180.0;
    Card c = cards.next("NSAPH PSAPH NSAT PSAT NSAPS PSAPS");
    for (std::size_t k = 0; k < 3; ++k) {
        const double low = std::abs(c.real(JOINT_FIELDS[k].low));
        const double high = c.real(JOINT_FIELDS[k].high, NON_NEGATIVE);
        if (low > 0.0) joint.about[k].low = -low * DEGREE;
        if (high > 0.0) joint.about[k].high = high * DEGREE;
        if ((low > 0.0 || high > 0.0) && joint.about[k].stiffness == 0.0)
            c.warn(low > 0.0 ? JOINT_FIELDS[k].low : JOINT_FIELDS[k].high,
                   "does not act, for the elastic stiffness of its angle is 0");
    }
}

}  // namespace

void joint_stiffness_generalized(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        JointStiffness joint;
        bodies(cards, draft, joint);
        curves(cards, draft, joint);
        friction(cards, joint);
        stops(cards, joint);
        if (cards.good()) draft.model.joint_stiffnesses.push_back(std::move(joint));
    }
}

}  // namespace corpuscle::io::keywords
