// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/flight.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "gas/flight/bounce.hpp"
#include "gas/flight/crossing.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t PARTICLES_A_CHUNK = 64;  ///< some ten microseconds; blocks of safe distances

/// Share of the step by which a particle stops short of a facet, so that it stays on its side
/// whatever the rounding: far above the error of tau (some 1e-13), far below anything that matters.
constexpr double SHORT_OF = 1e-7;

/// More bounces than this in one step: the particle is caught between closing facets.
constexpr int MOST_HITS = 1000;

/// A particle in flight, and what is written down about it.
struct Flyer {
    std::size_t row;
    std::int32_t species, id;
    double mass, internal;
    Vec3 x, v;
    std::vector<Hit>& hits;
    std::vector<Arrival>& arrivals;
    int bounces = 0;  ///< so far in this step: tells a gate's draws apart
};

/// BROKEN: not finite, at the start or after a bounce.
enum class End : std::uint8_t { FLOWN, CAUGHT, GONE, BROKEN };

bool is_finite(const Flyer& who) {
    return who.x.squaredNorm() + who.v.squaredNorm() < INF;
}

/// Keeps the facet in `first` if the path crosses it earlier.
void meet(const FlightScene& scene, const Path& path, Index facet, double after,
          const Meeting& last, Meeting& first) {
    if (facet == first.facet) return;  // entered in several cells
    const auto hit = cross(path, scene.triangles[facet], scene.x_0, scene.x_1, after,
                           facet == last.facet ? last.where.piece : -1);
    if (hit && (first.facet < 0 || hit->tau < first.where.tau)) first = {facet, *hit};
}

/// As first_meeting(), of all facets in the cells on the path.
[[gnu::noinline]] Meeting first_of_all(const FlightScene& scene, const Path& path, const Vec3& from,
                                       double now, double after, const Meeting& last) {
    Meeting first;
    scene.lists.any_slab(from, path.at_1, [&](const Slab& slab, double, double leaves) {
        scene.lists.for_each_in(slab,
                                [&](Index facet) { meet(scene, path, facet, after, last, first); });
        return first.facet >= 0 && first.where.tau <= now + leaves * (1.0 - now);
    });
    return first;
}

/// First facet that the path crosses after `after`; `last` is the meeting it has just left. The
/// path is at `from` at the share `now` of the step.
Meeting first_meeting(const FlightScene& scene, const Path& path, const Vec3& from, double now,
                      double after, const Meeting& last) {
    if (!scene.bounds) return first_of_all(scene, path, from, now, after, last);
    Meeting first;
    // A meeting later than where the path leaves the cell may yet be preceded by another.
    const auto is_settled = [&](double leaves) {
        return first.facet >= 0 && first.where.tau <= now + leaves * (1.0 - now);
    };
    const FacetBounds& bounds = *scene.bounds;
    NearFacets near;
    scene.lists.any_slab(from, path.at_1, [&](const Slab& slab, double enters, double leaves) {
        const bool is_part = leaves > enters;  // else nothing is known of the order
        const SmallPath small =
            bounds.small(from, path.at_1, now, is_part ? enters : 0.0, is_part ? leaves : 1.0);
        // Of a share: more than single precision can be wrong.
        constexpr double ROUNDING = 1e-6;
        bounds.for_some_near(scene.lists, slab, small, near, [&](NearFacets& some) {
            while (!some.is_empty()) {
                const auto [facet, share] = some.take_nearest();
                const double met_after = small.after + (share - ROUNDING) * small.length;
                if (first.facet >= 0 && first.where.tau < met_after) break;
                meet(scene, path, facet, after, last, first);
            }
            some.clear();
        });
        return is_settled(leaves);
    });
    return first;
}

/// Flies a particle to the end of the step; or until it is caught between facets, or gone through a
/// gate: then x is where it was at first.
End fly_one(const FlightScene& scene, double born, Flyer& who) {
    Vec3 from = who.x;
    double now = born;
    Path path{from - now * scene.dt * who.v, from + (1.0 - now) * scene.dt * who.v};
    if (!(path.at_1.squaredNorm() < INF)) return End::BROKEN;  // its place or its velocity is so
    double after = born > 0.0 ? born : -1.0;  // a full step counts every crossing, exactly
    Meeting last;
    for (int hit = 0; hit < MOST_HITS; ++hit) {
        const Meeting meeting = first_meeting(scene, path, from, now, after, last);
        if (meeting.facet < 0) {
            who.x = path.at_1;
            return End::FLOWN;
        }
        last = meeting;
        Transmission::Outcome outcome;
        if (scene.transmission != nullptr)
            outcome =
                scene.transmission->outcome(meeting.facet, who.species, who.id, who.bounces++);
        if (outcome.fate == Transmission::Fate::THROUGH) {
            who.arrivals.push_back({who.row, meeting.facet, outcome, 0.0});
            after = meeting.where.tau;
            continue;
        }
        const auto [away, impulse, heat] = bounce(scene, meeting, who.mass, who.v);
        const double before = 0.5 * who.mass * who.v.squaredNorm();
        const double given = outcome.push * (before - 0.5 * who.mass * away.squaredNorm() - heat);
        if (!std::isfinite(given)) return End::BROKEN;
        const double stop = std::max(now, meeting.where.tau - SHORT_OF);
        const Vec3 turn = from + (stop - now) * scene.dt * who.v;
        const auto row = static_cast<Index>(who.row);
        who.hits.push_back(
            {meeting.facet, row, meeting.where.at, outcome.push * impulse, given, turn});
        if (outcome.opening >= 0)
            who.arrivals.push_back({who.row, meeting.facet, outcome, before - given + who.internal,
                                    riding(scene, meeting, outcome, who.mass, who.v, impulse)});
        if (outcome.fate == Transmission::Fate::OUT) return End::GONE;
        from = turn;
        who.v = away;
        who.internal += heat;
        now = after = stop;
        path = {from - now * scene.dt * who.v, from + (1.0 - now) * scene.dt * who.v};
    }
    return End::CAUGHT;
}

/// Flies a particle through `parts` equal parts of the step.
///
/// Within a step the swept facets are flat pieces in space and time (crossing.hpp), which may stray
/// from the facets themselves by a quarter of what their nodes move against one another: where
/// layers are closer than that, swept pieces can cut each other and shut a particle in. In parts
/// they stray by 1/parts² of that, and at the step's ends nothing changes for others.
End fly_in_parts(const FlightScene& scene, int parts, double born, Points& y_0, Points& y_1,
                 Flyer& who) {
    const auto place = [&](int part, Points& y) {
        const double tau = static_cast<double>(part) / parts;
        for (const Index n : scene.lists.nodes())
            y[n] = part == 0       ? scene.x_0[n]
                   : part == parts ? scene.x_1[n]
                                   : Vec3(scene.x_0[n] + tau * (scene.x_1[n] - scene.x_0[n]));
    };
    const int first = std::min(static_cast<int>(born * parts), parts - 1);
    place(first, y_1);
    End end = End::FLOWN;
    for (int part = first; part < parts && end == End::FLOWN; ++part) {
        y_0.swap(y_1);
        place(part + 1, y_1);
        const FlightScene within{scene.lists, nullptr,          scene.triangles,    y_0.data(),
                                 y_1.data(),  scene.dt / parts, scene.transmission, scene.friction};
        const double late = part == first ? std::max(0.0, born * parts - first) : 0.0;
        end = fly_one(within, late, who);
    }
    return end;
}

/// Flies a particle that was caught, in more and more parts. What failed leaves no trace.
End fly_caught(const FlightScene& scene, double born, Flyer& who) {
    const auto nodes = static_cast<std::size_t>(scene.lists.nodes().back()) + 1;
    Points y_0(nodes), y_1(nodes);
    const std::size_t hits = who.hits.size(), arrivals = who.arrivals.size();
    const Vec3 x = who.x, v = who.v;
    const double internal = who.internal;
    for (const int parts : {16, 256, 4096}) {
        who.x = x;
        who.v = v;
        who.internal = internal;
        who.bounces = 0;
        const End end = fly_in_parts(scene, parts, born, y_0, y_1, who);
        if (end != End::CAUGHT) return end;
        who.hits.resize(hits);
        who.arrivals.resize(arrivals);
    }
    return End::CAUGHT;
}

/// Of a particle that has left, hits from the one of row `first` on have nobody who answers for
/// them.
void mark_left(const Flyer& who, std::size_t first) {
    for (std::size_t k = first; k < who.hits.size(); ++k)
        who.hits[k].who = -1 - static_cast<Index>(who.row);
}

/// Free flight of some particles.
void stream(double dt, std::size_t begin, std::size_t count, Particles& gas) {
    double* const x = gas.x[begin].data();
    const double* const v = gas.v[begin].data();
    for (std::size_t i = 0; i < 3 * count; ++i) x[i] += dt * v[i];
}

/// Empties a list, and gives back memory that the last flight has hardly used: a burst's would stay.
template <class T>
void clear(std::vector<T>& list) {
    constexpr std::size_t ALWAYS_KEPT = 32, KEPT = 2;
    const std::size_t used = list.size();
    list.clear();
    if (list.capacity() <= ALWAYS_KEPT + KEPT * used) return;
    list.shrink_to_fit();
    list.reserve(used + used / 4);
}

}  // namespace

void fly(const FacetLists& lists, std::span<const Vec3> x_0, std::span<const Vec3> x_1, double dt,
         std::span<const double> mass, std::span<const double> born, Particles& gas,
         FlightResult& result, const Transmission* transmission, const WallFriction& friction) {
    result.bounds.update(lists, x_0, x_1);
    const FlightScene scene{lists,        &result.bounds, lists.triangles().data(),
                            x_0.data(),   x_1.data(),     dt,
                            transmission, friction};
    const std::size_t chunks = parallel::chunk_count(gas.size(), PARTICLES_A_CHUNK);
    result.hits.resize(chunks + 1);  // a list a chunk, and one for those that are caught
    result.arrivals.resize(chunks + 1);
    result.caught.resize(chunks);
    clear(result.hits[chunks]);
    clear(result.arrivals[chunks]);
    const std::size_t old = gas.size() - born.size();
    const auto start = [&](std::size_t i) { return i < old ? 0.0 : born[i - old]; };
    const auto flyer = [&](std::size_t i, std::size_t list) {
        return Flyer{i,        gas.species[i], gas.id[i],         mass[gas.species[i]], gas.e[i],
                     gas.x[i], gas.v[i],       result.hits[list], result.arrivals[list]};
    };
    const auto land = [&](const Flyer& who) {
        gas.x[who.row] = who.x;
        gas.v[who.row] = who.v;
        gas.e[who.row] = who.internal;
    };

    const auto fly_near = [&](std::size_t i, std::size_t chunk) {
        Flyer who = flyer(i, chunk);
        const std::size_t hits = who.hits.size(), arrivals = who.arrivals.size();
        switch (fly_one(scene, start(i), who)) {
            case End::FLOWN:
                land(who);
                break;
            case End::GONE:
                mark_left(who, hits);
                break;
            case End::CAUGHT:
            case End::BROKEN:
                who.hits.resize(hits);
                who.arrivals.resize(arrivals);
                result.caught[chunk].push_back(i);
        }
    };
    SafeDistances& safe = result.safe;
    safe.begin_flight(lists, x_0, x_1, gas);
    parallel::for_chunks(
        gas.size(),
        [&](std::size_t begin, std::size_t end, std::size_t chunk) {
            clear(result.hits[chunk]);
            clear(result.arrivals[chunk]);
            clear(result.caught[chunk]);
            for (std::size_t i = begin; i < end; i += SafeDistances::BLOCK) {
                const std::size_t count = std::min(end - i, SafeDistances::BLOCK);
                // (Who has just been born flies less than a step.)
                const std::uint32_t unclear = safe.ask(lists, i, count, dt, gas);
                if (unclear == 0 && i + count <= old) {
                    stream(dt, i, count, gas);
                    continue;
                }
                for (std::size_t k = 0; k < count; ++k)
                    if ((unclear >> k & 1U) != 0)
                        fly_near(i + k, chunk);
                    else
                        gas.x[i + k] += (1.0 - start(i + k)) * dt * gas.v[i + k];
            }
        },
        PARTICLES_A_CHUNK);
    result.lost.clear();
    for (const auto& some : result.caught)
        for (const std::size_t i : some) {
            Flyer who = flyer(i, chunks);
            const std::size_t hits = who.hits.size();
            const bool came_so = !is_finite(who);
            const End end = came_so ? End::BROKEN : fly_caught(scene, start(i), who);
            if (end == End::BROKEN) throw BrokenParticle{i, !came_so};
            if (end == End::FLOWN) land(who);
            if (end == End::GONE) mark_left(who, hits);
            if (end == End::CAUGHT) result.lost.push_back({i, gas.x[i]});
        }
}

}  // namespace corpuscle::gas
