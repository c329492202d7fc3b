// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/enclosure/enclosure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

struct Edge {
    Index low, high;  ///< node rows
    Index triangle;
    bool runs_up;  ///< the triangle passes it from low to high
};

std::vector<Edge> sorted_edges(const std::vector<Triangle>& triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Index a = triangles[t][c], b = triangles[t][(c + 1) % 3];
            edges.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(t), a < b});
        }
    std::sort(edges.begin(), edges.end(), [](const Edge& l, const Edge& r) {
        return std::tie(l.low, l.high, l.triangle) < std::tie(r.low, r.high, r.triangle);
    });
    return edges;
}

/// Throws unless edges come in pairs.
void check_closed(const std::vector<Edge>& edges, std::span<const int> node_id,
                  const Fault& fault) {
    std::vector<Fault> faults;
    const auto add = [&](std::string why) {
        faults.push_back(fault);
        faults.back().why = std::move(why);
    };
    std::size_t bad = 0;
    for (std::size_t e = 0; e < edges.size();) {
        std::size_t end = e + 1;
        while (end < edges.size() && edges[end].low == edges[e].low &&
               edges[end].high == edges[e].high)
            ++end;
        if (end - e != 2 && ++bad <= 5)
            add(fmt::format("edge {}-{} belongs to {} facet{}, expected 2: the bag is {}",
                            node_id[edges[e].low], node_id[edges[e].high], end - e,
                            end - e == 1 ? "" : "s",
                            end - e == 1 ? "not closed" : "not a simple surface"));
        e = end;
    }
    if (bad > 5) add(fmt::format("... and {} more such edges", bad - 5));
    if (bad > 0) throw InputError(std::move(faults));
}

/// Turns triangles so that neighbours pass their common edge in opposite directions, and shells of
/// the surface enclose positive volume. Returns how many were turned.
/// @param piece_of  takes the piece of each
std::size_t orient(std::vector<Triangle>& triangles, const std::vector<Edge>& edges,
                   std::span<const Vec3> x, Fault fault, std::vector<Index>& piece_of) {
    std::vector<std::vector<std::pair<Index, bool>>> next(triangles.size());  // neighbour, agrees
    for (std::size_t e = 0; e < edges.size(); e += 2) {
        const bool agrees = edges[e].runs_up != edges[e + 1].runs_up;
        next[edges[e].triangle].emplace_back(edges[e + 1].triangle, agrees);
        next[edges[e + 1].triangle].emplace_back(edges[e].triangle, agrees);
    }
    std::vector<int> turn(triangles.size(), -1);
    std::vector<Index> piece;
    piece_of.assign(triangles.size(), 0);
    Index pieces = 0;
    std::size_t kept_total = 0;
    for (std::size_t seed = 0; seed < triangles.size(); ++seed) {
        if (turn[seed] >= 0) continue;
        piece.assign(1, static_cast<Index>(seed));
        turn[seed] = 0;
        double volume = 0.0;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const Index t = piece[i];
            const auto& c = triangles[t];
            const double part =
                signed_volume(x[c[0]] - x[triangles[seed][0]], x[c[1]] - x[triangles[seed][0]],
                              x[c[2]] - x[triangles[seed][0]]);
            volume += turn[t] ? -part : part;
            for (const auto& [other, agrees] : next[t]) {
                const int wanted = agrees ? turn[t] : 1 - turn[t];
                if (turn[other] < 0) {
                    turn[other] = wanted;
                    piece.push_back(other);
                } else if (turn[other] != wanted) {
                    fault.why = "the surface has one side only, like a Moebius strip";
                    throw InputError(std::move(fault));
                }
            }
        }
        // A surface without volume keeps LS-DYNA's convention: given normals point inward.
        const bool inward = volume <= 0.0;
        for (const Index t : piece) {
            piece_of[t] = pieces;
            if ((turn[t] != 0) != inward) std::swap(triangles[t][1], triangles[t][2]);
        }
        ++pieces;
        const auto flipped = static_cast<std::size_t>(
            std::count_if(piece.begin(), piece.end(), [&](Index t) { return turn[t] != 0; }));
        kept_total += std::min(flipped, piece.size() - flipped);
    }
    return kept_total;
}

}  // namespace

Enclosure::Enclosure(std::vector<Triangle> triangles, std::span<const Vec3> x,
                     std::span<const int> node_id, const std::string& bag_name, Property property)
    : triangles_(std::move(triangles)) {
    const std::vector<Edge> edges = sorted_edges(triangles_);
    const Fault fault{.of = bag_name, .property = property};
    check_closed(edges, node_id, fault);
    turned_ = orient(triangles_, edges, x, fault, piece_);

    for (const Triangle& t : triangles_) nodes_.insert(nodes_.end(), t.begin(), t.end());
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    const auto place = [&](Index node) {
        return static_cast<std::size_t>(std::lower_bound(nodes_.begin(), nodes_.end(), node) -
                                        nodes_.begin());
    };
    start_.assign(nodes_.size() + 1, 0);
    for (const Triangle& t : triangles_)
        for (const Index node : t) ++start_[place(node) + 1];
    for (std::size_t n = 0; n < nodes_.size(); ++n) start_[n + 1] += start_[n];
    around_.resize(3 * triangles_.size());
    std::vector<Index> fill(start_.begin(), start_.end() - 1);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        for (const Index node : triangles_[t]) around_[fill[place(node)]++] = static_cast<Index>(t);
}

void Enclosure::turn(Index piece) {
    for (std::size_t t = 0; t < triangles_.size(); ++t)
        if (piece_[t] == piece) std::swap(triangles_[t][1], triangles_[t][2]);
}

double Enclosure::volume(std::span<const Vec3> x) const {
    const Vec3 origin = x[triangles_[0][0]];  // near the bag: no cancellation far from (0, 0, 0)
    return parallel::sum(triangles_.size(), 0.0, [&](std::size_t t) {
        const Triangle& c = triangles_[t];
        return signed_volume(x[c[0]] - origin, x[c[1]] - origin, x[c[2]] - origin);
    });
}

double Enclosure::area(std::span<const Vec3> x) const {
    return parallel::sum(triangles_.size(), 0.0, [&](std::size_t t) {
        const Triangle& c = triangles_[t];
        return vector_area(x[c[0]], x[c[1]], x[c[2]]).norm();
    });
}

void Enclosure::node_areas(std::span<const Vec3> x, std::span<Vec3> area) const {
    thread_local Points kept;  // no memory is asked for in each step
    Points& facet_area = kept;
    facet_area.resize(triangles_.size());
    const auto measure = [&](std::size_t t) {
        const Triangle& c = triangles_[t];
        facet_area[t] = vector_area(x[c[0]], x[c[1]], x[c[2]]);
    };
    const auto gather = [&](std::size_t n) {
        Vec3 sum = Vec3::Zero();
        for (Index i = start_[n]; i < start_[n + 1]; ++i) sum += facet_area[around_[i]];
        area[nodes_[n]] = sum / 3.0;
    };
    parallel::in_turn(parallel::each(triangles_.size(), measure),
                      parallel::each(nodes_.size(), gather));
}

bool Enclosure::contains(const Vec3& point, std::span<const Vec3> x) const {
    const double angle = parallel::sum(triangles_.size(), 0.0, [&](std::size_t t) {
        const Vec3 a = x[triangles_[t][0]] - point, b = x[triangles_[t][1]] - point,
                   c = x[triangles_[t][2]] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        return 2.0 * std::atan2(a.dot(b.cross(c)),
                                la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    });
    return angle > 2.0 * std::numbers::pi;
}

}  // namespace corpuscle::gas
