// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/surface/patches.hpp"
#include "solver/base/sorted.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

namespace corpuscle::contact {
namespace {

/// By triangle: those that share a node with it, ascending.
std::vector<std::vector<Index>> neighbours_of(std::span<const Triangle> triangles,
                                              std::size_t nodes) {
    std::vector<std::vector<Index>> at_node(nodes), met(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const Index node : triangles[t]) at_node[node].push_back(static_cast<Index>(t));
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (const Index node : triangles[t])
            met[t].insert(met[t].end(), at_node[node].begin(), at_node[node].end());
        sort_unique(met[t]);
    }
    return met;
}

/// Bisects the cloth; `set_` tells which triangles belong together so far.
class Bisection {
public:
    Bisection(std::span<const Vec3> x, std::span<const Triangle> triangles, std::size_t size)
        : neighbours_(neighbours_of(triangles, x.size())),
          size_(size),
          set_(triangles.size(), 0),
          distance_(triangles.size(), INF),
          from_a_(triangles.size()) {
        for (const Triangle& t : triangles)
            centroid_.push_back((x[t[0]] + x[t[1]] + x[t[2]]) / 3.0);
        patches_.triangle.resize(triangles.size());
        std::iota(patches_.triangle.begin(), patches_.triangle.end(), 0);
        patches_.start.push_back(0);
    }

    Patches run() && {
        if (!patches_.triangle.empty()) split_pieces(patches_.triangle);
        return std::move(patches_);
    }

private:
    using Part = std::span<Index>;  ///< a stretch of patches_.triangle
    struct Piece {
        std::vector<Index> triangles;
        Vec3 centroid;
    };

    void keep(Part part) {
        std::sort(part.begin(), part.end());
        const Index* const end = part.data() + part.size();
        patches_.start.push_back(static_cast<Index>(end - patches_.triangle.data()));
    }

    /// Tells separate pieces of cloth apart, then halves each.
    void split_pieces(Part part) {
        std::vector<Piece> pieces = pieces_of(part);
        if (pieces.size() == 1) return halve(part);
        if (part.size() <= size_) return keep(part);
        const std::size_t cut = order(part, pieces);
        split_pieces(part.first(cut));
        split_pieces(part.subspan(cut));
    }

    /// Cuts a piece midway between two ends of it, as measured along the cloth.
    void halve(Part part) {
        if (part.size() <= 2 * size_) return keep(part);
        const Index a = walk(part, part.front()), b = walk(part, a);
        const auto straight = [&](Index t, Index end) {  // for what the walk did not reach
            return std::isfinite(distance_[t]) ? distance_[t]
                                               : (centroid_[t] - centroid_[end]).norm();
        };
        for (const Index t : part) from_a_[t] = straight(t, a);
        walk(part, b);
        for (const Index t : part) from_a_[t] -= straight(t, b);
        std::sort(part.begin(), part.end(), [&](Index i, Index j) {
            return from_a_[i] != from_a_[j] ? from_a_[i] < from_a_[j] : i < j;
        });
        const std::size_t cut = part.size() / 2;
        ++sets_;
        for (const Index t : part.first(cut)) set_[t] = sets_;
        halve(part.first(cut));
        halve(part.subspan(cut));
    }

    /// Sets distance_ from a triangle along the cloth within its part [Dijkstra 1959].
    /// @returns the triangle that was reached last
    Index walk(Part part, Index from) {
        for (const Index t : part) distance_[t] = INF;
        distance_[from] = 0.0;
        Index last = from;
        queue_.emplace(0.0, from);
        while (!queue_.empty()) {
            const auto [distance, at] = queue_.top();
            queue_.pop();
            if (distance > distance_[at]) continue;
            last = at;
            for (const Index to : neighbours_[at]) {
                const double through = distance + (centroid_[to] - centroid_[at]).norm();
                if (set_[to] != set_[at] || through >= distance_[to]) continue;
                distance_[to] = through;
                queue_.emplace(through, to);
            }
        }
        return last;
    }

    std::vector<Piece> pieces_of(Part part) {
        std::vector<Piece> pieces;
        for (const Index t : part) distance_[t] = INF;
        for (const Index first : part) {
            if (distance_[first] == 0.0) continue;
            Piece piece{{first}, Vec3::Zero()};
            distance_[first] = 0.0;
            for (std::size_t i = 0; i < piece.triangles.size(); ++i) {
                piece.centroid += centroid_[piece.triangles[i]];
                for (const Index to : neighbours_[piece.triangles[i]]) {
                    if (distance_[to] == 0.0) continue;
                    distance_[to] = 0.0;
                    piece.triangles.push_back(to);
                }
            }
            piece.centroid /= static_cast<double>(piece.triangles.size());
            pieces.push_back(std::move(piece));
        }
        return pieces;
    }

    /// Orders whole pieces along the direction in which they are spread most.
    /// @returns the border between two pieces that is nearest to the middle
    std::size_t order(Part part, std::vector<Piece>& pieces) const {
        Box spread;
        for (const Piece& p : pieces) spread.include(p.centroid);
        Index axis = 0;
        (spread.high - spread.low).maxCoeff(&axis);
        std::stable_sort(pieces.begin(), pieces.end(), [axis](const Piece& a, const Piece& b) {
            return a.centroid[axis] < b.centroid[axis];
        });
        const auto off_middle = [&](std::size_t at) {
            return std::max(2 * at, part.size()) - std::min(2 * at, part.size());
        };
        std::size_t filled = 0, cut = 0;
        for (const Piece& p : pieces) {
            if (filled > 0 && (cut == 0 || off_middle(filled) < off_middle(cut))) cut = filled;
            std::copy(p.triangles.begin(), p.triangles.end(), part.begin() + filled);
            filled += p.triangles.size();
        }
        return cut;
    }

    std::vector<std::vector<Index>> neighbours_;
    std::size_t size_;
    Points centroid_;
    std::vector<Index> set_;
    Index sets_ = 0;
    std::vector<double> distance_, from_a_;  ///< along the cloth; first end's less second end's [m]
    std::priority_queue<std::pair<double, Index>, std::vector<std::pair<double, Index>>,
                        std::greater<>>
        queue_;
    Patches patches_;
};

}  // namespace

Patches make_patches(std::span<const Vec3> reference_x, std::span<const Triangle> triangles,
                     std::size_t size) {
    return Bisection(reference_x, triangles, std::max<std::size_t>(size, 1)).run();
}

Box triangle_box(const Triangle& triangle, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
                 double margin) {
    Box box;
    for (const Index node : triangle) {
        box.include(x_0[node]);
        box.include(x_1[node]);
    }
    box.inflate(margin);
    return box;
}

}  // namespace corpuscle::contact
