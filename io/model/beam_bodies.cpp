// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rigid beams as bodies.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/model/loose_ends.hpp"

namespace corpuscle::io {
namespace {

using keywords::is_rigid;

/// Mass and inertia of thin rods.
RigidInertia inertia_of_rods(const Draft& draft, const std::vector<const Link*>& rods,
                             double line_density) {
    RigidInertia all;
    all.mass = 0.0;
    const auto end = [&](const Link& rod, std::size_t k) -> const Vec3& {
        return draft.model.x[static_cast<std::size_t>(rod.nodes[k])];
    };
    for (const Link* rod : rods) {
        const double m = line_density * (end(*rod, 1) - end(*rod, 0)).norm();
        all.mass += m;
        all.centre += 0.5 * m * (end(*rod, 0) + end(*rod, 1));
    }
    all.centre /= all.mass;
    for (const Link* rod : rods) {
        const Vec3 along = end(*rod, 1) - end(*rod, 0),
                   r = 0.5 * (end(*rod, 0) + end(*rod, 1)) - all.centre;
        const double m = line_density * along.norm();
        const auto moment = [](const Vec3& d) {
            return Mat3(d.squaredNorm() * Mat3::Identity() - d * d.transpose());
        };
        all.inertia += m / 12.0 * moment(along) + m * moment(r);
    }
    return all;
}

void make_beam_body(Draft& draft, Faults& faults, Index part,
                    const std::vector<const Link*>& beams) {
    Model& model = draft.model;
    std::vector<Index> nodes;
    for (const Link* beam : beams)
        nodes.insert(nodes.end(), beam->nodes.begin(), beam->nodes.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const Index node : nodes) model.rigid_extra_nodes.push_back({part, node});
    const bool is_given = std::any_of(model.rigid_inertia.begin(), model.rigid_inertia.end(),
                                      [&](const RigidInertia& body) { return body.part == part; });
    if (is_given) return;
    const Part& p = model.parts[static_cast<std::size_t>(part)];
    const Index section = draft.part_section[static_cast<std::size_t>(part)];
    const double area = section >= 0 ? draft.section[static_cast<std::size_t>(section)].area : NaN;
    const double density =
        std::get<fabric::RigidCard>(model.materials[static_cast<std::size_t>(p.material)].card)
            .density;
    if (!(area * density > 0.0))
        return faults.fault(place_of(draft, part),
                            fmt::format("*PART {} has {} rigid beams, expected a *SECTION_BEAM "
                                        "with a cross section > 0, or _INERTIA",
                                        p.id, beams.size()));
    RigidInertia body = inertia_of_rods(draft, beams, density * area);
    body.part = part;
    model.rigid_inertia.push_back(body);
}

}  // namespace

void make_beam_bodies(Draft& draft, Faults& faults) {
    std::map<Index, std::vector<const Link*>> rigid;
    for (const Link& link : draft.links)
        if (is_rigid(draft, link.part)) rigid[link.part].push_back(&link);
    for (const auto& [part, beams] : rigid) make_beam_body(draft, faults, part, beams);
    std::erase_if(draft.links, [&](const Link& link) { return rigid.contains(link.part); });
}

}  // namespace corpuscle::io
