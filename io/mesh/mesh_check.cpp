// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "io/mesh/mesh_file.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::io {
namespace {

constexpr double SLIVER = 0.02;  ///< height over longest edge [-]

using Facet = std::array<Index, 4>;

int corner_count(const Facet& f) {
    return f[2] == f[3] ? 3 : 4;
}

void turn(Facet& f) {
    if (corner_count(f) == 3)
        std::swap(f[0], f[1]);
    else
        std::swap(f[1], f[3]);
}

/// One facet's passage along an edge: from the lower row to the higher, or back.
struct Side {
    std::size_t facet;
    bool is_forward;
};

/// Every edge by its two rows, ascending, with the facets along it.
using Edges = std::map<std::pair<Index, Index>, std::vector<Side>>;

Edges edges_of(const std::vector<Facet>& facets) {
    Edges edges;
    for (std::size_t e = 0; e < facets.size(); ++e) {
        const int corners = corner_count(facets[e]);
        for (int c = 0; c < corners; ++c) {
            const auto [a, b] = std::pair(facets[e][c], facets[e][(c + 1) % corners]);
            edges[std::minmax(a, b)].push_back({e, a < b});
        }
    }
    return edges;
}

struct Neighbour {
    std::size_t facet;
    bool agrees;    ///< normals on the same side, as the facets are now
    bool is_alone;  ///< the edge has these two facets and no other
};

std::vector<std::vector<Neighbour>> neighbours_of(const Edges& edges, std::size_t facets) {
    std::vector<std::vector<Neighbour>> beside(facets);
    for (const auto& [rows, sides] : edges)
        for (const Side& a : sides)
            for (const Side& b : sides)
                if (a.facet != b.facet)
                    beside[a.facet].push_back(
                        {b.facet, a.is_forward != b.is_forward, sides.size() == 2});
    return beside;
}

/// Facets that hang together by edges, and which of them must turn to agree with the first.
struct Piece {
    std::vector<std::size_t> facets;
    std::vector<bool> turns;
};

/// Breadth first over edges of two facets; more facets on an edge belong together, but do not say
/// which way to look.
std::vector<Piece> pieces_of(const std::vector<Facet>& facets, const Edges& edges) {
    const auto beside = neighbours_of(edges, facets.size());
    std::vector<char> is_taken(facets.size(), 0);
    std::vector<Piece> pieces;
    for (std::size_t first = 0; first < facets.size(); ++first) {
        if (is_taken[first]) continue;
        Piece& piece = pieces.emplace_back();
        const auto take = [&](std::size_t facet, bool turns) {
            is_taken[facet] = 1;
            piece.facets.push_back(facet);
            piece.turns.push_back(turns);
        };
        take(first, false);
        for (std::size_t i = 0; i < piece.facets.size(); ++i)
            for (const Neighbour& n : beside[piece.facets[i]])
                if (!is_taken[n.facet]) take(n.facet, n.is_alone && piece.turns[i] == n.agrees);
    }
    return pieces;
}

double volume_of(const ImportedMesh& mesh, std::size_t facet) {
    const auto& f = mesh.shells[facet];
    const auto x = [&](int c) { return mesh.x[static_cast<std::size_t>(f[c])]; };
    return signed_volume(x(0), x(1), x(2)) + signed_volume(x(0), x(2), x(3));
}

bool is_sliver(const ImportedMesh& mesh, const Facet& f) {
    const auto x = [&](int c) { return mesh.x[static_cast<std::size_t>(f[c])]; };
    const double area = (vector_area(x(0), x(1), x(2)) + vector_area(x(0), x(2), x(3))).norm();
    const int corners = corner_count(f);
    double longest = 0.0;
    for (int c = 0; c < corners; ++c)
        longest = std::max(longest, (x((c + 1) % corners) - x(c)).norm());
    const double height = (corners == 3 ? 2.0 : 1.0) * area;  // times the longest edge
    return height < SLIVER * longest * longest;
}

/// Which facets lie on an edge of their own.
std::vector<char> on_free_edge(const Edges& edges, std::size_t facets) {
    std::vector<char> is_free(facets, 0);
    for (const auto& [rows, sides] : edges)
        if (sides.size() == 1) is_free[sides.front().facet] = 1;
    return is_free;
}

}  // namespace

void orient(ImportedMesh& mesh) {
    const Edges edges = edges_of(mesh.shells);
    const std::vector<char> is_free = on_free_edge(edges, mesh.shells.size());
    for (Piece& piece : pieces_of(mesh.shells, edges)) {
        double volume = 0.0;
        bool is_closed = true;
        for (std::size_t i = 0; i < piece.facets.size(); ++i) {
            const std::size_t e = piece.facets[i];
            volume += (piece.turns[i] ? -1.0 : 1.0) * volume_of(mesh, e);
            is_closed = is_closed && !is_free[e];
        }
        const auto turning = std::count(piece.turns.begin(), piece.turns.end(), true);
        const bool most_turn = 2 * static_cast<std::size_t>(turning) > piece.facets.size();
        if (is_closed ? volume < 0.0 : most_turn) piece.turns.flip();
        for (std::size_t i = 0; i < piece.facets.size(); ++i) {
            if (!piece.turns[i]) continue;
            turn(mesh.shells[piece.facets[i]]);
            ++mesh.mended.turned;
        }
    }
}

MeshReport check_mesh(const ImportedMesh& mesh) {
    MeshReport report;
    report.mended = mesh.mended;
    report.nodes = mesh.x.size();
    for (const Facet& f : mesh.shells) {
        ++(corner_count(f) == 3 ? report.triangles : report.quads);
        if (is_sliver(mesh, f)) ++report.slivers;
    }
    const Edges edges = edges_of(mesh.shells);
    report.components = pieces_of(mesh.shells, edges).size();
    for (const auto& [rows, sides] : edges) {
        if (sides.size() == 1) ++report.free_edges;
        if (sides.size() > 2) ++report.non_manifold_edges;
        if (sides.size() == 2 && sides[0].is_forward == sides[1].is_forward)
            ++report.inconsistent_edges;
    }
    if (report.is_closed() && report.inconsistent_edges == 0) {
        report.volume = 0.0;
        for (std::size_t e = 0; e < mesh.shells.size(); ++e) *report.volume += volume_of(mesh, e);
    }
    return report;
}

std::string text(const MeshReport& r) {
    std::string all = fmt::format("{} nodes, {} triangles, {} quads in {} {}", r.nodes, r.triangles,
                                  r.quads, r.components, r.components == 1 ? "piece" : "pieces");
    const auto say = [&](std::size_t count, const char* what) {
        if (count > 0) all += fmt::format("\n{} {}", count, what);
    };
    say(r.mended.welded, "vertices welded to another");
    say(r.mended.collapsed, "quads became triangles");
    say(r.mended.degenerate, "facets without area dropped");
    say(r.mended.duplicate, "facets that were there twice dropped");
    say(r.mended.loose, "points and lines left out");
    say(r.mended.turned, "facets turned to agree with their neighbours");
    say(r.free_edges, "free edges: the mesh has a rim or a hole");
    say(r.non_manifold_edges, "edges with more than two facets");
    say(r.inconsistent_edges, "edges between facets that face opposite ways, and cannot agree");
    say(r.slivers, "slivers: lower than 1/50 of their longest edge");
    if (r.volume) all += fmt::format("\nclosed, volume {:.6g}", *r.volume);
    return all;
}

}  // namespace corpuscle::io
