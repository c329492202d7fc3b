// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/commands/mesh_inside.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace corpuscle::tools {
namespace {

/// How far along a ray it meets a triangle; INF: it does not [Möller & Trumbore 1997].
double way_to(const Vec3& from, const Vec3& along, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, p = along.cross(ac), to = from - a, q = to.cross(ab);
    const double det = ab.dot(p), u = to.dot(p) / det, v = along.dot(q) / det;
    const double way = ac.dot(q) / det;
    return det != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && way > 0.0 ? way : INF;
}

/// How far along a ray the mesh's facets lie, but for two parts of it: `inner`, and one shell.
std::vector<double> ways(const io::DeckMesh& mesh, int inner, const Vec3& from, const Vec3& along,
                         std::size_t but) {
    std::vector<double> all;
    for (std::size_t s = 0; s < mesh.shells.size(); ++s) {
        if (s == but || mesh.part_id[s] == inner) continue;
        const auto& n = mesh.shells[s];
        const double first = way_to(from, along, mesh.x[n[0]], mesh.x[n[1]], mesh.x[n[2]]);
        if (first < INF) all.push_back(first);
        if (n[2] == n[3]) continue;
        const double second = way_to(from, along, mesh.x[n[0]], mesh.x[n[2]], mesh.x[n[3]]);
        if (second < INF) all.push_back(second);
    }
    return all;
}

bool is_closed_without(const io::DeckMesh& mesh, int part) {
    std::map<std::pair<Index, Index>, int> uses;
    for (std::size_t s = 0; s < mesh.shells.size(); ++s)
        for (std::size_t k = 0; k < 4 && mesh.part_id[s] != part; ++k) {
            const Index a = mesh.shells[s][k], b = mesh.shells[s][(k + 1) % 4];
            if (a != b) ++uses[std::minmax(a, b)];
        }
    return !uses.empty() &&
           std::all_of(uses.begin(), uses.end(), [](const auto& use) { return use.second == 2; });
}

}  // namespace

int inner_part(const io::DeckMesh& mesh) {
    if (is_closed_without(mesh, 0)) return 0;
    for (const int part : std::set<int>(mesh.part_id.begin(), mesh.part_id.end()))
        if (is_closed_without(mesh, part)) return part;
    return 0;
}

Vec3 middle_of(const io::DeckMesh& mesh, std::size_t shell) {
    const auto& n = mesh.shells[shell];
    return 0.25 * (mesh.x[n[0]] + mesh.x[n[1]] + mesh.x[n[2]] + mesh.x[n[3]]);
}

bool is_inside(const io::DeckMesh& mesh, int inner, const Vec3& at) {
    const Vec3 askew = Vec3(0.3127, 0.5411, 0.7813).normalized();  // meets no edge
    return ways(mesh, inner, at, askew, mesh.shells.size()).size() % 2 == 1;
}

std::optional<Vec3> place_over(const io::DeckMesh& mesh, int inner, std::size_t shell) {
    const auto& n = mesh.shells[shell];
    const Vec3 middle = middle_of(mesh, shell);
    const Vec3 normal =
        (mesh.x[n[2]] - mesh.x[n[0]]).cross(mesh.x[n[3]] - mesh.x[n[1]]).normalized();
    for (const Vec3& along : {normal, Vec3(-normal)}) {
        const std::vector<double> found = ways(mesh, inner, middle, along, shell);
        if (found.empty()) continue;
        const double way = *std::min_element(found.begin(), found.end());
        const Vec3 place = middle + 0.5 * way * along;
        if (is_inside(mesh, inner, place)) return place;
    }
    return std::nullopt;
}

}  // namespace corpuscle::tools
