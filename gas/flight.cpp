// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight.hpp"

#include <algorithm>
#include <cmath>

#include "gas/crossing.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Share of the step by which a particle stops short of a facet, so that it stays on its side
/// whatever the rounding: far above the error of tau (some 1e-13), far below anything that matters.
constexpr double SHORT_OF = 1e-7;

/// More bounces than this in one step: the particle is caught between closing facets.
constexpr int MOST_HITS = 1000;

struct Meeting {
    Index facet = -1;
    Crossing where{};
};

/// Everything that a flight reads.
struct Scene {
    const FacetLists& lists;
    const FacetBounds& bounds;
    const Triangle* triangles;
    const Vec3 *x_0, *x_1;
    double dt;
    const Gates* gates;
};

/// Who flies, as gates want to know it.
struct Flyer {
    std::size_t row;
    std::int32_t species, id;
    std::vector<Arrival>& arrivals;
};

/// Cells that the box from one point to another overlaps.
struct CellRange {
    std::array<int, 3> first, last;

    CellRange(const Grid& grid, const Vec3& from, const Vec3& to) {
        for (int a = 0; a < 3; ++a) {
            first[a] = grid.along(a, std::min(from[a], to[a]));
            last[a] = grid.along(a, std::max(from[a], to[a]));
        }
    }
    /// visit(cell) until it returns true; did it?
    template <class Visit>
    bool any(const Grid& grid, Visit&& visit) const {
        for (int k = first[2]; k <= last[2]; ++k)
            for (int j = first[1]; j <= last[1]; ++j)
                for (int i = first[0]; i <= last[0]; ++i)
                    if (visit(grid.row(i, j, k))) return true;
        return false;
    }
};

/// Keeps the facet in `first` if the path crosses it earlier.
void meet(const Scene& scene, const Path& path, Index facet, double after, const Meeting& last,
          Meeting& first) {
    if (facet == first.facet) return;  // entered in several cells
    const auto hit = cross(path, scene.triangles[facet], scene.x_0, scene.x_1, after,
                           facet == last.facet ? last.where.piece : -1);
    if (hit && (first.facet < 0 || hit->tau < first.where.tau)) first = {facet, *hit};
}

/// May a path that starts at `from` and ends at `to` meet a facet of this cell?
bool may_meet(const FacetLists& lists, std::size_t cell, const Vec3& from, const Vec3& to) {
    return lists.clear(cell) == 0 && !lists.slab(cell).is_missed_by(from, to);
}

/// First facet that the path crosses after `after`; `last` is the meeting it has just left.
Meeting first_meeting(const Scene& scene, const Path& path, const Vec3& from, double after,
                      const Meeting& last) {
    const Grid& grid = scene.lists.grid();
    const SmallPath small = scene.bounds.small(path, from);
    Meeting first;
    CellRange(grid, from, path.at_1).any(grid, [&](std::size_t cell) {
        if (may_meet(scene.lists, cell, from, path.at_1))
            for (const Index facet : scene.lists.in(cell))
                if (scene.bounds[facet].may_meet(small))
                    meet(scene, path, facet, after, last, first);
        return false;
    });
    return first;
}

/// Velocity of the point of the facet where it was met.
Vec3 velocity_at(const Scene& scene, const Meeting& meeting) {
    Vec3 velocity = Vec3::Zero();
    for (int c = 0; c < 3; ++c) {
        const Index n = scene.triangles[meeting.facet][c];
        velocity += meeting.where.at[c] / scene.dt * (scene.x_1[n] - scene.x_0[n]);
    }
    return velocity;
}

/// Velocity after the bounce.
Vec3 reflect(const Scene& scene, const Meeting& meeting, const Vec3& v) {
    const Triangle& nodes = scene.triangles[meeting.facet];
    const Vec3 wall = velocity_at(scene, meeting);
    std::array<Vec3, 3> x;
    for (int c = 0; c < 3; ++c)
        x[c] = scene.x_0[nodes[c]] +
               meeting.where.tau * (scene.x_1[nodes[c]] - scene.x_0[nodes[c]]);
    const MovingPlane plane = plane_of(meeting.where.piece, nodes, scene.x_0, scene.x_1);
    const double approach = plane.normal.dot(v) - plane.speed / scene.dt;

    const Vec3 normal = (x[1] - x[0]).cross(x[2] - x[0]);
    if (const double square = normal.squaredNorm(); square > 0.0) {
        const Vec3 away = v - 2.0 * (v - wall).dot(normal) / square * normal;
        const double after = plane.normal.dot(away) - plane.speed / scene.dt;
        if (approach * after < 0.0) return away;
    }
    // Grazing, on a facet that turns or shrinks within the step: the plane of the swept piece
    // decides.
    return v - 2.0 * approach / plane.normal.squaredNorm() * plane.normal;
}

/// A particle caught where fabric closes begins the step anew and rides with it instead: from where it
/// started it goes straight to where no facet is in the way. Ways that are tried: with the fabric, then
/// faster and faster off it in all directions. Momentum goes to the facet met last; what is left in
/// speed becomes internal energy, and where there is too little of it the facet pays. False when every
/// way is closed.
bool ride(const Scene& scene, double mass, double born, const Meeting& met, Vec3& x, Vec3& v,
          double& internal, std::vector<Hit>& hits) {
    constexpr double SHARES[] = {1e-3, 1e-2, 0.1, 0.5, 1.0};
    const auto is_free = [&](const Vec3& way) {
        const Path path{x - born * scene.dt * way, x + (1.0 - born) * scene.dt * way};
        return first_meeting(scene, path, x, born > 0.0 ? born : -1.0, {}).facet < 0;
    };
    const Vec3 fabric = velocity_at(scene, met);
    const double speed = (v - fabric).norm();
    const auto take = [&](const Vec3& way) {
        const double heat = 0.5 * mass * (v.squaredNorm() - way.squaredNorm());
        const double kept = std::max(heat, -0.5 * internal);
        hits.push_back({met.facet, met.where.at, mass * (v - way), heat - kept});
        internal += kept;
        x += (1.0 - born) * scene.dt * way;
        v = way;
        return true;
    };
    if (is_free(fabric)) return take(fabric);
    for (const double share : SHARES)
        for (int k = -1; k <= 1; ++k)
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) {
                    if (i == 0 && j == 0 && k == 0) continue;
                    const Vec3 way = fabric + share * speed * Vec3(i, j, k).normalized();
                    if (is_free(way)) return take(way);
                }
    return false;
}

enum class End : std::uint8_t { FLOWN, CAUGHT, GONE };

/// Flies one particle to the end of the step, until it is caught for good, or out through a gate.
End fly_one(const Scene& scene, const Flyer& who, double mass, double born, Vec3& x, Vec3& v,
            double& internal, std::vector<Hit>& hits) {
    const std::size_t hits_before = hits.size(), arrivals_before = who.arrivals.size();
    const Vec3 v_before = v;
    Vec3 from = x;
    double now = born;
    Path path{from - now * scene.dt * v, from + (1.0 - now) * scene.dt * v};
    double after = born > 0.0 ? born : -1.0;  // a full step counts every crossing, exactly
    Meeting last;
    for (int hit = 0; hit < MOST_HITS; ++hit) {
        const Meeting meeting = first_meeting(scene, path, from, after, last);
        if (meeting.facet < 0) {
            x = path.at_1;
            return End::FLOWN;
        }
        Gates::Passage passage;
        if (scene.gates != nullptr)
            passage = scene.gates->passage(meeting.facet, who.species, who.id, hit);
        if (passage.way == Gates::Way::THROUGH) {
            who.arrivals.push_back({who.row, meeting.facet, passage, 0.0});
            after = meeting.where.tau;
            last = meeting;
            continue;
        }
        const double stop = std::max(now, meeting.where.tau - SHORT_OF);
        from += (stop - now) * scene.dt * v;
        const Vec3 away = reflect(scene, meeting, v);
        const double given = 0.5 * mass * (v.squaredNorm() - away.squaredNorm());
        hits.push_back({meeting.facet, meeting.where.at, passage.push * mass * (v - away),
                        passage.push * given});
        if (passage.gate >= 0)
            who.arrivals.push_back(
                {who.row, meeting.facet, passage,
                 0.5 * mass * v.squaredNorm() - passage.push * given + internal});
        if (passage.way == Gates::Way::OUT) return End::GONE;
        v = away;
        now = after = stop;
        last = meeting;
        path = {from - now * scene.dt * v, from + (1.0 - now) * scene.dt * v};
    }
    hits.resize(hits_before);
    who.arrivals.resize(arrivals_before);
    v = v_before;
    return ride(scene, mass, born, last, x, v, internal, hits) ? End::FLOWN : End::CAUGHT;
}

/// Is there no facet anywhere near? First by the start's cell alone, then by all that it may touch.
bool meets_nothing(const FacetLists& lists, const Vec3& from, const Vec3& to) {
    const Grid& grid = lists.grid();
    const int clear = lists.clear(grid.cell_of(from));
    if (clear > 1 && (to - from).cwiseAbs().maxCoeff() <= (clear - 1) * grid.edge) return true;
    return !CellRange(grid, from, to).any(
        grid, [&](std::size_t cell) { return may_meet(lists, cell, from, to); });
}

}  // namespace

void fly(const FacetLists& lists, std::span<const Vec3> x_0, std::span<const Vec3> x_1, double dt,
         std::span<const double> mass, std::span<const double> born, Particles& gas,
         FlightResult& result, const Gates* gates) {
    result.bounds.update(lists.triangles(), x_0, x_1);
    const Scene scene{lists, result.bounds, lists.triangles().data(), x_0.data(), x_1.data(),
                      dt,    gates};
    const std::size_t old = gas.size() - born.size();
    const std::size_t chunks = parallel::chunk_count(gas.size());
    if (result.hits.size() < chunks) result.hits.resize(chunks);
    for (auto& hits : result.hits) hits.clear();
    if (result.arrivals.size() < chunks) result.arrivals.resize(chunks);
    for (auto& arrivals : result.arrivals) arrivals.clear();
    std::vector<std::vector<Lost>> lost(chunks);

    parallel::for_chunks(gas.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i) {
            const double start = i < old ? 0.0 : born[i - old];
            const Vec3 to = gas.x[i] + (1.0 - start) * dt * gas.v[i];
            if (meets_nothing(lists, gas.x[i], to))
                gas.x[i] = to;
            else if (fly_one(scene, {i, gas.species[i], gas.id[i], result.arrivals[chunk]},
                             mass[gas.species[i]], start, gas.x[i], gas.v[i], gas.e[i],
                             result.hits[chunk]) == End::CAUGHT)
                lost[chunk].push_back({i, gas.x[i]});
        }
    });
    result.lost.clear();
    for (const auto& some : lost) result.lost.insert(result.lost.end(), some.begin(), some.end());
}

}  // namespace corpuscle::gas
