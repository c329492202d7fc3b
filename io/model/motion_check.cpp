// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/motion_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/keywords/bodies/rigid_parts.hpp"

namespace corpuscle::io {
namespace {

constexpr double SAME_AXIS = 1e-9;

bool are_along(const Vec3& a, const Vec3& b) {
    return a.cross(b).norm() < SAME_AXIS;
}

bool overlap(const PrescribedMotion& a, const PrescribedMotion& b) {
    return a.birth < b.death && b.birth < a.death;
}

/// Of two motions of the same.
bool collide(const PrescribedMotion& a, const PrescribedMotion& b) {
    return a.rotation == b.rotation && overlap(a, b) && are_along(a.axis, b.axis);
}

/// Of mask, bits 0-2.
bool is_held(unsigned mask, const Vec3& axis) {
    for (int k = 0; k < 3; ++k)
        if ((mask >> k & 1U) != 0 && are_along(axis, Vec3::Unit(k))) return true;
    return false;
}

/// Motions of a node or a body, by row, against each other.
class Meetings {
public:
    Meetings(const Draft& draft, Faults& faults) : draft_(draft), faults_(faults) {}

    /// @param what  "node 3"
    void meet(Index row, std::size_t motion, const std::string& what) {
        for (const std::size_t other : of_[row])
            if (collide(at(motion), at(other))) {
                faults_.fault(draft_.motion_places[motion],
                              fmt::format("moves {}, which {} moves along the same axis at the "
                                          "same time, expected one of them",
                                          what, faults_.where(draft_.motion_places[other])),
                              "two motions");
                return;
            }
        of_[row].push_back(motion);
    }

private:
    [[nodiscard]] const PrescribedMotion& at(std::size_t motion) const {
        return draft_.model.motions[motion];
    }
    const Draft& draft_;
    Faults& faults_;
    std::map<Index, std::vector<std::size_t>> of_;
};

void check_body(const Draft& draft, std::size_t k, Faults& faults) {
    const Model& model = draft.model;
    const PrescribedMotion& motion = model.motions[k];
    const Part& part = model.parts[static_cast<std::size_t>(motion.rigid_part)];
    const auto& card =
        std::get<fabric::RigidCard>(model.materials[static_cast<std::size_t>(part.material)].card);
    if (is_held(motion.rotation ? card.fixed_turns : card.fixed_moves, motion.axis))
        faults.warn(draft.motion_places[k],
                    fmt::format("*PART {} is held {} that axis: this motion counts, as long as it "
                                "acts",
                                part.id, motion.rotation ? "about" : "along"));
}

}  // namespace

void check_motions(Draft& draft, Faults& faults) {
    const Model& model = draft.model;
    const std::vector<Index>& owner = keywords::rigid_owners(draft);
    std::vector<DofMask> held(model.x.size(), 0);
    for (const Support& support : model.supports)
        if (support.node >= 0) held[static_cast<std::size_t>(support.node)] |= support.fixed & 7U;
    Meetings bodies(draft, faults), nodes(draft, faults);
    for (std::size_t k = 0; k < model.motions.size(); ++k) {
        const PrescribedMotion& motion = model.motions[k];
        if (motion.rigid_part >= 0) {
            bodies.meet(motion.rigid_part, k,
                        fmt::format("part {}",
                                    model.parts[static_cast<std::size_t>(motion.rigid_part)].id));
            check_body(draft, k, faults);
        }
        for (const Index node : motion.nodes) {
            const auto n = static_cast<std::size_t>(node);
            const std::string name = fmt::format("node {}", model.node_id[n]);
            if (owner[n] >= 0)
                faults.fault(draft.motion_places[k],
                             fmt::format("moves {} of rigid part {}, expected "
                                         "*BOUNDARY_PRESCRIBED_MOTION_RIGID of the part",
                                         name, model.parts[static_cast<std::size_t>(owner[n])].id),
                             "motion of rigid nodes");
            if (is_held(held[n], motion.axis))
                faults.warn(draft.motion_places[k],
                            fmt::format("{} is held along that axis: this motion counts, as long "
                                        "as it acts",
                                        name),
                            "motion of held nodes");
            nodes.meet(node, k, name);
        }
    }
}

void check_curves(const Draft& draft, Faults& faults) {
    constexpr double OF_TIMES = 1e-9;  // rounding of those in decks
    const Model& model = draft.model;
    for (const CurveUse& use : draft.curve_uses) {
        if (use.curve < 0) continue;
        const Curve& curve = model.curves[static_cast<std::size_t>(use.curve)];
        if (curve.empty()) continue;
        const double end = std::min(use.to, model.end_time), slack = OF_TIMES * model.end_time;
        const auto tell = [&](const char* which, double at, double value) {
            const std::string text =
                fmt::format("curve {} {} at {:g} and keeps its value {:g} {} it (LS-DYNA: 0)",
                            curve.id, which, at, value, *which == 'b' ? "before" : "after");
            faults.warn(use.place, text, text);
        };
        if (curve.x.front() > use.from + slack && curve.y.front() != 0.0)
            tell("begins", curve.x.front(), curve.y.front());
        if (curve.x.back() < end - slack && curve.y.back() != 0.0)
            tell("ends", curve.x.back(), curve.y.back());
    }
}

}  // namespace corpuscle::io
