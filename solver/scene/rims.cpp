// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/rims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "solver/scene/scene_surface.hpp"

namespace corpuscle {
namespace {

/// What counts as on an edge: this share of its length beside it.
constexpr double ON_EDGE = 0.05;

using Neighbours = std::map<Index, std::vector<Index>>;

Neighbours neighbours(const EdgeSet& edges) {
    Neighbours next;
    for (const auto& [a, b] : edges) {
        next[a].push_back(b);
        next[b].push_back(a);
    }
    return next;
}

/// How far along a-b the node lies, 0 to 1; none beside it or at its ends.
std::optional<double> place_on(const Points& x, Index a, Index b, Index node) {
    const Vec3 edge = x[b] - x[a], from = x[node] - x[a];
    const double length = edge.norm();
    if (!(length > 0.0)) return {};
    const double w = from.dot(edge) / (length * length);
    const double off = (from - w * edge).norm();
    if (w < ON_EDGE || w > 1.0 - ON_EDGE || off > ON_EDGE * length) return {};
    return w;
}

/// Nodes from a to b along other free edges, each farther along a-b than the one before.
std::vector<std::pair<Index, double>> detour(const Points& x, const Neighbours& next, Index a,
                                             Index b) {
    std::vector<std::pair<Index, double>> nodes;
    Index at = a;
    double reached = 0.0;
    for (;;) {
        Index best = -1;
        double nearest = 2.0;
        bool arrives = false;
        for (const Index n : next.at(at)) {
            if (n == b && at != a) arrives = true;
            const auto w = place_on(x, a, b, n);
            if (w && *w > reached && *w < nearest) {
                nearest = *w;
                best = n;
            }
        }
        if (best < 0) {
            if (!arrives) nodes.clear();
            return nodes;
        }
        nodes.emplace_back(best, nearest);
        reached = nearest;
        at = best;
    }
}

}  // namespace

std::vector<Index> shells_of(const Model& model, Index part) {
    std::vector<Index> rows;
    for (std::size_t s = 0; s < model.shells.size(); ++s)
        if (model.shells[s].part == part) rows.push_back(static_cast<Index>(s));
    return rows;
}

EdgeSet free_edges(const Model& model, const std::vector<Index>& shells) {
    const TiedEdges ties(model.tied_nodes);
    std::map<std::pair<Index, Index>, int> count;
    const auto add = [&](const Triangle& whole) {
        ties.cut(whole, [&](const Triangle& t) {
            for (int k = 0; k < 3; ++k) ++count[std::minmax(t[k], t[(k + 1) % 3])];
        });
    };
    for (const Index s : shells) {
        const auto& n = model.shells[s].nodes;
        add({n[0], n[1], n[2]});
        if (!model.shells[s].is_triangle()) add({n[0], n[2], n[3]});
    }
    EdgeSet free;
    for (const auto& [edge, uses] : count)
        if (uses == 1) free.insert(edge);
    return free;
}

std::vector<TiedNode> hanging_nodes(const Model& model, const EdgeSet& free) {
    const Neighbours next = neighbours(free);
    std::set<Index> tied;
    for (const TiedNode& tie : model.tied_nodes) tied.insert(tie.node);
    std::vector<TiedNode> ties;
    for (const auto& [a, b] : free)
        for (const auto& [node, w] : detour(model.x, next, a, b))
            if (tied.insert(node).second) ties.push_back({node, {a, b}, w});
    return ties;
}

namespace {

/// The nodes along a loop, from its lowest row on; a component that is none as it comes.
Hole hole_of(const Model& model, const Neighbours& next, const std::vector<Index>& nodes) {
    Hole hole;
    std::size_t ends = 0;
    hole.is_loop = true;
    for (const Index n : nodes) {
        ends += next.at(n).size();
        hole.is_loop = hole.is_loop && next.at(n).size() == 2;
        hole.centre += model.x[n] / static_cast<double>(nodes.size());
    }
    hole.edges = ends / 2;
    hole.rim = nodes;
    if (hole.is_loop) {
        hole.rim = {nodes.front(), next.at(nodes.front()).front()};
        while (hole.rim.size() < nodes.size()) {
            const auto& beside = next.at(hole.rim.back());
            hole.rim.push_back(beside[0] == hole.rim[hole.rim.size() - 2] ? beside[1] : beside[0]);
        }
        for (const auto& [a, b, c] : lid_over(hole.rim, model.x))
            hole.area += vector_area(model.x[a], model.x[b], model.x[c]).norm();
    }
    for (const Index a : nodes)
        for (const Index b : nodes)
            hole.width = std::max(hole.width, (model.x[a] - model.x[b]).norm());
    return hole;
}

}  // namespace

std::vector<Hole> holes(const Model& model, const std::vector<Index>& shells) {
    const Neighbours next = neighbours(free_edges(model, shells));
    std::set<Index> seen;
    std::vector<Hole> found;
    for (const auto& [start, unused] : next) {
        if (!seen.insert(start).second) continue;
        std::vector<Index> nodes = {start};
        for (std::size_t k = 0; k < nodes.size(); ++k)
            for (const Index n : next.at(nodes[k]))
                if (seen.insert(n).second) nodes.push_back(n);
        found.push_back(hole_of(model, next, nodes));
    }
    return found;
}

std::vector<Triangle> lid_over(const std::vector<Index>& rim, const Points& x) {
    std::vector<Index> left = rim;
    std::vector<Triangle> lid;
    const auto shape = [&](std::size_t i) {  // 1 of an equilateral ear, 0 of a flat one
        const std::size_t n = left.size();
        const Vec3 &a = x[left[(i + n - 1) % n]], &b = x[left[i]], &c = x[left[(i + 1) % n]];
        const double most =
            std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
        return most > 0.0 ? vector_area(a, b, c).norm() / most : 0.0;
    };
    while (left.size() >= 3) {
        std::size_t best = 0;
        for (std::size_t i = 1; i < left.size() && left.size() > 3; ++i)
            if (shape(i) > shape(best)) best = i;
        const std::size_t n = left.size();
        lid.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
        if (n == 3) break;
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    }
    return lid;
}

double area_of(const Model& model, const std::vector<Index>& shells) {
    double area = 0.0;
    for (const Index s : shells) {
        const auto& n = model.shells[s].nodes;
        area += vector_area(model.x[n[0]], model.x[n[1]], model.x[n[2]]).norm();
        if (!model.shells[s].is_triangle())
            area += vector_area(model.x[n[0]], model.x[n[2]], model.x[n[3]]).norm();
    }
    return area;
}

std::string Hole::text(const Model& model) const {
    constexpr std::size_t FEW = 4;
    std::string nodes;
    for (std::size_t k = 0; k < std::min(FEW, rim.size()); ++k)
        nodes += fmt::format("{}{}", k == 0 ? "" : ", ", model.node_id[rim[k]]);
    return fmt::format(
        "a hole of {} edges about ({:.6g}, {:.6g}, {:.6g}), {:.4g} wide{}, at nodes "
        "{}{}",
        edges, centre.x(), centre.y(), centre.z(), width,
        is_loop ? fmt::format(", of area {:.4g}", area) : "", nodes,
        rim.size() > FEW ? ", ..." : "");
}

}  // namespace corpuscle
