// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/solid_skin.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace corpuscle::io {

namespace {

using Facet = std::array<Index, 4>;
using Facets = std::vector<Facet>;

constexpr std::array<std::array<std::size_t, 4>, 6> BRICK = {
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};
constexpr std::array<std::array<std::size_t, 3>, 4> TETRAHEDRON = {
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

/// Corners without those that follow themselves; nothing when fewer than three are left.
void add_face(Facets& faces, const std::array<Index, 4>& corners) {
    std::vector<Index> left;
    for (const Index n : corners)
        if (left.empty() || left.back() != n) left.push_back(n);
    if (left.size() > 1 && left.front() == left.back()) left.pop_back();
    if (left.size() < 3) return;
    faces.push_back({left[0], left[1], left[2], left.size() == 4 ? left[3] : left[2]});
}

/// The nodes of a face by themselves, the same from both sides and whichever a triangle repeats.
std::array<Index, 4> key_of(Facet face) {
    if (face[2] == face[3]) face[3] = -1;
    std::sort(face.begin(), face.end());
    return face;
}

/// Faces that one solid of the part has alone.
Facets skin_of(const std::vector<Solid>& solids, Index part) {
    Facets faces;
    for (const Solid& solid : solids)
        if (solid.part == part)
            for (const Facet& face : faces_of(solid.nodes)) faces.push_back(face);
    std::vector<Facet> keys;
    for (const Facet& face : faces) keys.push_back(key_of(face));
    std::sort(keys.begin(), keys.end());
    std::erase_if(faces, [&](const Facet& face) {
        const auto [first, last] = std::equal_range(keys.begin(), keys.end(), key_of(face));
        return last - first > 1;
    });
    return faces;
}

std::set<Index> nodes_of(const Facets& facets) {
    std::set<Index> nodes;
    for (const Facet& facet : facets) nodes.insert(facet.begin(), facet.end());
    return nodes;
}

/// mass = rho V,   I = rho (tr(C) 1 - C),   C the second moment about the centre of mass.
RigidInertia inertia_of(const Bulk& bulk, double density, Index part, const Vec3& origin) {
    RigidInertia body;
    body.part = part;
    body.mass = density * bulk.volume;
    const Vec3 centre = bulk.first / bulk.volume;
    const Mat3 second = bulk.second - bulk.volume * centre * centre.transpose();
    body.inertia = density * (second.trace() * Mat3::Identity() - second);
    body.centre = origin + centre;
    return body;
}

int highest_element_id(const Draft& draft) {
    int id = 0;
    for (const Shell& shell : draft.model.shells) id = std::max(id, shell.id);
    for (const Solid& solid : draft.solid) id = std::max(id, solid.id);
    return id;
}

/// The least thickness of the deck's shells, or what is given.
double thinnest(const Draft& draft, double otherwise) {
    double least = INF;
    for (const Section& section : draft.section)
        if (!section.is_solid) least = std::min(least, section.thickness);
    return std::min(least, otherwise);
}

void make_skin(Draft& draft, Index part, int& id) {
    Model& model = draft.model;
    const Facets skin = skin_of(draft.solid, part);
    if (skin.empty()) return;
    for (const Facet& facet : skin) model.shells.push_back({++id, part, facet});

    const std::set<Index> outer = nodes_of(skin);
    std::set<Index> inner;
    for (const Solid& solid : draft.solid)
        if (solid.part == part)
            for (const Index node : solid.nodes)
                if (!outer.contains(node)) inner.insert(node);
    for (const Index node : inner) model.rigid_extra_nodes.push_back({part, node});

    const Vec3 origin = model.x[static_cast<std::size_t>(skin.front()[0])];
    const Bulk bulk = bulk_of(skin, model.x, origin);
    Part& shells = model.parts[static_cast<std::size_t>(part)];
    shells.thickness = bulk.volume / bulk.area;
    if (std::isnan(shells.contact_thickness))
        shells.contact_thickness = thinnest(draft, shells.thickness);
    const bool is_given = std::any_of(model.rigid_inertia.begin(), model.rigid_inertia.end(),
                                      [&](const RigidInertia& body) { return body.part == part; });
    if (is_given) return;
    const auto& card = model.materials[static_cast<std::size_t>(shells.material)].card;
    const double density = std::get<fabric::RigidCard>(card).density;
    model.rigid_inertia.push_back(inertia_of(bulk, density, part, origin));
}

}  // namespace

Facets faces_of(const std::array<Index, 8>& n) {
    Facets faces;
    if (std::all_of(n.begin() + 4, n.end(), [&](Index node) { return node == n[3]; })) {
        for (const auto& [a, b, c] : TETRAHEDRON) faces.push_back({n[a], n[b], n[c], n[c]});
        return faces;
    }
    for (const auto& [a, b, c, d] : BRICK) add_face(faces, {n[a], n[b], n[c], n[d]});
    return faces;
}

/// Of the tetrahedron that a triangle makes with the origin:
///
///     V = a·(b×c) / 6,   ∫x = V (a + b + c) / 4,
///     ∫x xᵀ = V / 20 ((a + b + c)(a + b + c)ᵀ + a aᵀ + b bᵀ + c cᵀ)
void Bulk::add(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double v = a.dot(b.cross(c)) / 6.0;
    const Vec3 sum = a + b + c;
    area += 0.5 * (b - a).cross(c - a).norm();
    volume += v;
    first += v / 4.0 * sum;
    second += v / 20.0 *
              (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
}

Bulk bulk_of(const Facets& facets, const Points& x, const Vec3& origin) {
    Bulk bulk;
    for (const Facet& facet : facets) {
        const auto corner = [&](std::size_t i) {
            return Vec3(x[static_cast<std::size_t>(facet[i])] - origin);
        };
        bulk.add(corner(0), corner(1), corner(2));
        if (facet[2] != facet[3]) bulk.add(corner(0), corner(2), corner(3));
    }
    return bulk;
}

void make_skins(Draft& draft) {
    if (draft.solid.empty()) return;
    int id = highest_element_id(draft);
    for (std::size_t part = 0; part < draft.model.parts.size(); ++part)
        if (draft.part_has_solids[part]) make_skin(draft, static_cast<Index>(part), id);
}

}  // namespace corpuscle::io
