// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/enclosure/wetted_surface.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>

#include "gas/enclosure/inside.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Disjoint sets of rows; the lowest row of a set stands for it.
Index find_root(std::vector<Index>& parent, Index i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

void unite(std::vector<Index>& parent, Index a, Index b) {
    a = find_root(parent, a);
    b = find_root(parent, b);
    parent[std::max(a, b)] = std::min(a, b);
}

/// A facet at an edge.
struct Fan {
    Index low, high;  ///< node rows of the edge
    Index facet;
    bool runs_up;  ///< the facet passes the edge from low to high
};

/// Angle round the edge from one facet's plane to another's, 0 to 2 pi, right-handed about
/// low -> high.
double angle_between(const Vec3& axis, const Vec3& from, const Vec3& to) {
    const double angle = std::atan2(axis.dot(from.cross(to)), from.dot(to) * axis.norm());
    return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

/// All facets at their edges, edge by edge.
std::vector<Fan> fans_of(const std::vector<Triangle>& triangles) {
    std::vector<Fan> fans;
    fans.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Index a = triangles[t][c], b = triangles[t][(c + 1) % 3];
            fans.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(t), a < b});
        }
    std::sort(fans.begin(), fans.end(), [](const Fan& l, const Fan& r) {
        return std::tie(l.low, l.high, l.facet) < std::tie(r.low, r.high, r.facet);
    });
    return fans;
}

/// Puts the facets at an edge in the order of their angles round it.
void put_in_turn(std::vector<Fan>& ring, const std::vector<Triangle>& triangles,
                 std::size_t closing, std::span<const Vec3> x) {
    const auto closes = [&](const Fan& fan) {
        return static_cast<std::size_t>(fan.facet) < closing;
    };
    // Begin behind the outside, if the edge is on it: its order needs no angle.
    const auto first = std::find_if(ring.begin(), ring.end(),
                                    [&](const Fan& fan) { return closes(fan) && !fan.runs_up; });
    if (first != ring.end()) std::iter_swap(ring.begin(), first);
    const auto last = std::find_if(ring.begin() + 1, ring.end(), closes);
    const bool is_rim = first != ring.end() && last != ring.end();
    if (is_rim) std::iter_swap(ring.end() - 1, last);
    const Vec3 axis = x[ring[0].high] - x[ring[0].low];
    const auto plane = [&](const Fan& fan) {
        const Triangle& t = triangles[fan.facet];
        const Index tip = t[0] + t[1] + t[2] - fan.low - fan.high;
        const Vec3 d = x[tip] - x[fan.low];
        return Vec3(axis.squaredNorm() * d - d.dot(axis) * axis);
    };
    const Vec3 from = plane(ring[0]);
    std::sort(ring.begin() + 1, ring.end() - (is_rim ? 1 : 0), [&](const Fan& l, const Fan& r) {
        return angle_between(axis, from, plane(l)) < angle_between(axis, from, plane(r));
    });
}

/// Numbers sets in the order of their lowest rows; returns how many there are.
std::size_t number_sets(std::vector<Index>& parent, std::vector<Index>& number) {
    number.assign(parent.size(), -1);
    std::size_t count = 0;
    for (std::size_t i = 0; i < parent.size(); ++i) {
        const Index root = find_root(parent, static_cast<Index>(i));
        if (root == static_cast<Index>(i)) number[i] = static_cast<Index>(count++);
        number[i] = number[root];
    }
    return count;
}

/// Rows by number, compressed: start has count + 1 entries.
void list_by(std::span<const Index> number, std::size_t count, std::vector<Index>& start,
             std::vector<Index>& rows, Index each) {
    start.assign(count + 1, 0);
    for (const Index n : number) ++start[n + 1];
    for (std::size_t n = 0; n < count; ++n) start[n + 1] += start[n];
    rows.resize(number.size());
    std::vector<Index> fill(start.begin(), start.end() - 1);
    for (std::size_t i = 0; i < number.size(); ++i)
        rows[fill[number[i]]++] = static_cast<Index>(i) / each;
}

}  // namespace

WettedSurface::WettedSurface(std::span<const Triangle> triangles, std::size_t closing,
                             std::span<const Vec3> x)
    : closing_(closing), triangles_(triangles.begin(), triangles.end()) {
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (int k = 0; k < (f < closing ? 1 : 2); ++k) facet_.push_back(static_cast<Index>(f));
    join_sides(x);
    connect_points();
}

Triangle WettedSurface::turned(std::size_t side) const {
    Triangle t = triangles_[facet_[side]];
    if (is_front(side)) std::swap(t[1], t[2]);
    return t;
}

/// Joins, edge by edge, the sides that face the same wedge.
///
/// Seen along an edge from low to high, the front of a facet that runs up faces the turn of the
/// right hand, its back the other way; of one that runs down they are exchanged. Facets that follow
/// each other in that turn enclose a wedge.
void WettedSurface::join_sides(std::span<const Vec3> x) {
    const std::vector<Fan> fans = fans_of(triangles_);
    std::vector<Index> piece(sides()), corner(3 * sides());
    std::iota(piece.begin(), piece.end(), 0);
    std::iota(corner.begin(), corner.end(), 0);
    const auto closes = [&](const Fan& fan) {
        return static_cast<std::size_t>(fan.facet) < closing_;
    };
    // The side that faces the turn, or the other way; -1: outside.
    const auto facing = [&](const Fan& fan, bool ahead) -> Index {
        const bool front = fan.runs_up == ahead;
        if (closes(fan)) return front ? -1 : fan.facet;
        return static_cast<Index>(side(static_cast<std::size_t>(fan.facet), front));
    };
    const auto corner_of = [&](Index side, Index node) {
        const Triangle& t = triangles_[facet_[side]];
        return 3 * side + static_cast<Index>(std::find(t.begin(), t.end(), node) - t.begin());
    };
    const auto join = [&](const Fan& one, const Fan& next) {
        const Index a = facing(one, true), b = facing(next, false);
        if (a < 0 || b < 0) return;
        unite(piece, a, b);
        if (one.facet == next.facet) return;  // round a free edge: one room, but two points
        for (const Index node : {one.low, one.high})
            unite(corner, corner_of(a, node), corner_of(b, node));
    };

    std::vector<Fan> ring;
    for (std::size_t e = 0; e < fans.size();) {
        ring.clear();
        for (; ring.empty() ||
               (e < fans.size() && fans[e].low == ring[0].low && fans[e].high == ring[0].high);
             ++e)
            ring.push_back(fans[e]);
        if (ring.size() > 2) put_in_turn(ring, triangles_, closing_, x);
        for (std::size_t i = 0; i < ring.size(); ++i) join(ring[i], ring[(i + 1) % ring.size()]);
    }
    number_points(corner);
    number_rooms(piece, x);
}

void WettedSurface::number_points(std::vector<Index>& corner) {
    std::vector<Index> number;
    const std::size_t count = number_sets(corner, number);
    node_.resize(count);
    points_.resize(sides());
    for (std::size_t s = 0; s < sides(); ++s)
        for (std::size_t c = 0; c < 3; ++c) {
            points_[s][c] = number[3 * s + c];
            node_[points_[s][c]] = triangles_[facet_[s]][c];
        }
    list_by(number, count, start_, around_, 3);
}

/// A piece that closes the bag, or holds volume of its own, is the wall of a room; any other stands
/// in one: in the smallest that holds it.
void WettedSurface::number_rooms(std::vector<Index>& piece, std::span<const Vec3> x) {
    std::vector<Index> number;
    const std::size_t pieces = number_sets(piece, number);
    std::vector<double> volume(pieces, 0.0);
    std::vector<char> closes(pieces, 0);
    const Vec3 origin = x[triangles_[0][0]];
    for (std::size_t s = 0; s < sides(); ++s) {
        const Triangle t = turned(s);
        volume[number[s]] += signed_volume(x[t[0]] - origin, x[t[1]] - origin, x[t[2]] - origin);
        closes[number[s]] |= static_cast<std::size_t>(facet_[s]) < closing_;
    }
    double whole = 0.0;
    for (std::size_t p = 0; p < pieces; ++p)
        if (closes[p]) whole += std::abs(volume[p]);
    constexpr double NOTHING = 1e-12;  // of the bag's volume: rounding of a sheet's two sides
    std::vector<Index> room(pieces, -1);
    for (std::size_t p = 0; p < pieces; ++p)
        if (closes[p] || volume[p] > NOTHING * whole) room[p] = static_cast<Index>(rooms_++);
    if (rooms_ < pieces) find_homes(number, volume, x, room);
    room_.resize(sides());
    for (std::size_t s = 0; s < sides(); ++s) room_[s] = room[number[s]];
    room_of_point_.resize(points());
    for (std::size_t s = 0; s < sides(); ++s)
        for (const Index p : points_[s]) room_of_point_[p] = room_[s];
}

/// The room of each piece that has none as yet.
void WettedSurface::find_homes(const std::vector<Index>& number, const std::vector<double>& volume,
                               std::span<const Vec3> x, std::vector<Index>& room) {
    room_ = number;
    std::vector<std::vector<Triangle>> walls;  // by room
    std::vector<double> size;
    for (std::size_t p = 0; p < room.size(); ++p) {
        if (room[p] < 0) continue;
        walls.push_back(wall(p));
        size.push_back(volume[p]);
    }
    for (std::size_t p = 0; p < room.size(); ++p) {
        if (room[p] >= 0) continue;
        const auto s = static_cast<std::size_t>(
            std::find(number.begin(), number.end(), static_cast<Index>(p)) - number.begin());
        const Triangle t = triangles_[facet_[s]];
        const Vec3 at = (x[t[0]] + x[t[1]] + x[t[2]]) / 3.0;
        Index home = 0;
        double smallest = INF;
        for (std::size_t r = 0; r < walls.size(); ++r) {
            if (size[r] >= smallest || !holds(walls[r], at, x)) continue;
            home = static_cast<Index>(r);
            smallest = size[r];
        }
        room[p] = home;
    }
}

std::vector<Triangle> WettedSurface::wall(std::size_t room) const {
    std::vector<Triangle> all;
    for (std::size_t s = 0; s < sides(); ++s)
        if (room_[s] == static_cast<Index>(room)) all.push_back(turned(s));
    return all;
}

void WettedSurface::connect_points() {
    for (std::size_t s = 0; s < sides(); ++s)
        for (std::size_t c = 0; c < 3; ++c) {
            const Index a = points_[s][c], b = points_[s][(c + 1) % 3];
            edges_.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    next_.assign(points() + 1, 0);
    for (const auto& [a, b] : edges_) {
        ++next_[a + 1];
        ++next_[b + 1];
    }
    for (std::size_t p = 0; p < points(); ++p) next_[p + 1] += next_[p];
    neighbour_.resize(2 * edges_.size());
    std::vector<Index> fill(next_.begin(), next_.end() - 1);
    for (std::size_t e = 0; e < edges_.size(); ++e) {
        const auto [a, b] = edges_[e];
        neighbour_[fill[a]++] = {b, static_cast<Index>(e)};
        neighbour_[fill[b]++] = {a, static_cast<Index>(e)};
    }
}

}  // namespace corpuscle::gas
