// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/loads.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "solver/base/surface.hpp"
#include "solver/bodies/rigid_body.hpp"
#include "solver/bodies/rigid_parts.hpp"
#include "solver/scene/scene_surface.hpp"

namespace corpuscle {

namespace {

using Facet = std::array<Index, 4>;

/// By which diagonal contact cuts quads.
std::set<std::pair<Index, Index>> cuts_of_contact(const Model& model) {
    std::set<std::pair<Index, Index>> cuts;
    if (model.contacts.empty()) return cuts;
    for (std::size_t s = 0; s < model.shells.size(); ++s)
        if (const auto n = cutting_order(model, s); !model.shells[s].is_triangle())
            cuts.insert(std::minmax(n[0], n[2]));
    return cuts;
}

/// Facets, and in place of quads that contact cuts their triangles.
std::vector<Facet> as_contact_sees(const std::vector<Facet>& facets,
                                   const std::set<std::pair<Index, Index>>& cuts) {
    std::vector<Facet> seen;
    for (const Facet& f : facets) {
        if (f[2] == f[3]) {
            seen.push_back(f);
        } else if (cuts.contains(std::minmax(f[0], f[2]))) {
            seen.push_back({f[0], f[1], f[2], f[2]});
            seen.push_back({f[0], f[2], f[3], f[3]});
        } else if (cuts.contains(std::minmax(f[1], f[3]))) {
            seen.push_back({f[1], f[2], f[3], f[3]});
            seen.push_back({f[1], f[3], f[0], f[0]});
        } else {
            seen.push_back(f);
        }
    }
    return seen;
}

}  // namespace

Loads::Loads(const Model& model) {
    const auto cuts = cuts_of_contact(model);
    for (const BodyLoad& load : model.body_loads)
        body_.push_back({load.axis,
                         load.scale,
                         load.curve >= 0 ? model.curves[load.curve] : Curve{},
                         load.parts,
                         {},
                         {}});
    for (const PressureLoad& load : model.pressure_loads) {
        Pressure pressure{as_contact_sees(load.facets, cuts), load.scale, load.arrival, {}};
        if (load.curve >= 0) pressure.curve = model.curves[load.curve];
        pressure_.push_back(std::move(pressure));
    }
    for (const NodeLoad& load : model.node_loads)
        node_.push_back({load.nodes, load.axis, load.scale, model.curves[load.curve]});
    for (const RigidLoad& load : model.rigid_loads)
        rigid_.push_back({load, model.curves[load.curve]});
}

namespace {

/// Adds what a pressure gives to the corners of a facet.
void press(const Facet& facet, double p, const Points& x, Points& f) {
    const auto area = [&](int i, int j, int k) {
        return vector_area(x[facet[i]], x[facet[j]], x[facet[k]]);
    };
    if (facet[2] == facet[3]) {
        const Vec3 corner = -p / 3.0 * area(0, 1, 2);
        for (int k = 0; k < 3; ++k) f[facet[k]] += corner;
        return;
    }
    const Vec3 all = area(0, 1, 2) + area(0, 2, 3);
    for (int k = 0; k < 4; ++k) f[facet[k]] -= p / 6.0 * (all + area(k, (k + 1) % 4, (k + 3) % 4));
}

/// Direction of a load that goes with nodes; 0 where they are on one line.
Vec3 direction_at(const RigidLoad& load, const Points& x) {
    if (load.nodes[0] < 0) return load.axis;
    const Vec3 along = x[load.nodes[1]] - x[load.nodes[0]];
    const Vec3 z = along.cross(x[load.nodes[2]] - x[load.nodes[0]]).normalized();
    Mat3 axes;
    axes << along.normalized(), z.cross(along).normalized(), z;
    return axes * load.axis;
}

bool holds(const std::vector<Index>& parts, Index part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

}  // namespace

void Loads::share_mass(const Model& model, const std::vector<double>& shell_mass,
                       const TiedNodes& ties) {
    const std::size_t count = model.parts.size();
    for (Body& load : body_) {
        if (load.parts.empty()) continue;
        std::vector<std::uint8_t> is_meant(count, 0);
        for (const Index part : load.parts) is_meant[part] = !is_rigid(model, part);
        load.share = mass_at_nodes(model, shell_mass, ties, is_meant);
        const auto all =
            mass_at_nodes(model, shell_mass, ties, std::vector<std::uint8_t>(count, 1));
        for (std::size_t n = 0; n < all.size(); ++n)
            if (all[n] > 0.0) load.share[n] /= all[n];
    }
}

/// The body's own load counts its cloth too.
void Loads::ride(const std::vector<RidingNode>& riding, const std::vector<RigidBody>& bodies) {
    for (Body& load : body_) {
        if (load.parts.empty()) continue;
        for (const RidingNode& at : riding) {
            const bool is_whole = holds(load.parts, bodies[at.body].part());
            const double felt = load.share[at.node] * at.all - (is_whole ? at.mass : 0.0);
            if (felt != 0.0) load.riding.emplace_back(at.node, felt);
        }
    }
}

Vec3 Loads::acceleration(double t, Index part) const {
    Vec3 all = Vec3::Zero();
    for (const Body& load : body_)
        if (load.parts.empty() || holds(load.parts, part)) all[load.axis] -= load.value(t);
    return all;
}

Loads::Push Loads::push(double t, const Points& x, const std::vector<Index>& parts) const {
    Push all;
    for (const Rigid& rigid : rigid_) {
        if (!holds(parts, rigid.load.part)) continue;
        const Vec3 value = rigid.load.scale * rigid.curve(t) * direction_at(rigid.load, x);
        (rigid.load.is_moment ? all.moment : all.force) += value;
    }
    return all;
}

void Loads::find_force(double t, const Points& x, const std::vector<double>& mass,
                       Points& f) const {
    std::fill(f.begin(), f.end(), Vec3::Zero());
    for (const Body& load : body_) {
        const double a = load.value(t);
        for (std::size_t n = 0; n < f.size(); ++n)
            f[n][load.axis] -= (load.share.empty() ? mass[n] : load.share[n] * mass[n]) * a;
        for (const auto& [node, riding_mass] : load.riding) f[node][load.axis] -= riding_mass * a;
    }
    for (const Pressure& load : pressure_) {
        if (t < load.arrival) continue;
        const double p = load.scale * (load.curve.empty() ? 1.0 : load.curve(t - load.arrival));
        for (const auto& facet : load.facets) press(facet, p, x, f);
    }
    for (const Node& load : node_) {
        const double force = load.scale * load.curve(t);
        for (const Index node : load.nodes) f[node][load.axis] += force;
    }
}

}  // namespace corpuscle
