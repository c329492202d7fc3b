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

}  // namespace

End fly_one(const FlightScene& scene, double born, Flyer& who) {
    Vec3 from = who.x;
    double now = born;
    Path path{from - now * scene.dt * who.v, from + (1.0 - now) * scene.dt * who.v};
    if (!(path.at_1.squaredNorm() < INF)) return End::BROKEN;  // its place or its velocity is so
    double after = born > 0.0 ? born : -1.0;  // a full step counts every crossing, exactly
    Meeting last;
    for (int hit = 0; hit < MOST_HITS && who.left > 0; ++hit, --who.left) {
        const Meeting meeting = first_meeting(scene, path, from, now, after, last);
        if (meeting.facet < 0) {
            who.x = path.at_1;
            return End::FLOWN;
        }
        last = meeting;
        Transmission::Outcome outcome;
        if (scene.transmission != nullptr)
            outcome = outcome_at(scene, meeting, who.species, who.id, who.bounces++, who.v);
        if (outcome.fate == Transmission::Fate::THROUGH) {
            const double motion = (who.v - velocity_at(scene, meeting)).squaredNorm();
            who.arrivals.push_back(
                {who.row, meeting.facet, outcome, 0.5 * who.mass * motion + who.internal});
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

namespace {

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

template <class T>
void append(const std::vector<T>& some, std::vector<T>& all) {
    all.insert(all.end(), some.begin(), some.end());
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

/// Share of the step at which a particle starts.
double start(std::size_t i, std::span<const double> born, const Particles& gas) {
    const std::size_t old = gas.size() - born.size();
    return i < old ? 0.0 : born[i - old];
}

Flyer flyer(std::size_t i, std::span<const double> mass, const Particles& gas,
            std::vector<Hit>& hits, std::vector<Arrival>& arrivals) {
    return {i,        gas.species[i], gas.id[i], mass[gas.species[i]], gas.e[i], gas.x[i],
            gas.v[i], hits,           arrivals};
}

void land(const Flyer& who, Particles& gas) {
    gas.x[who.row] = who.x;
    gas.v[who.row] = who.v;
    gas.e[who.row] = who.internal;
}

/// Those that are caught, or not finite, fly in parts; their hits are in the last list.
void fly_caught(const FlightScene& scene, std::span<const double> mass,
                std::span<const double> born, Particles& gas, FlightResult& result) {
    result.lost.clear();
    std::vector<std::size_t> rows;
    for (const auto& some : result.caught) append(some, rows);
    if (rows.empty()) return;
    CaughtFlights caught(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        caught.who.push_back(flyer(rows[k], mass, gas, caught.hits[k], caught.arrivals[k]));
        caught.born.push_back(start(rows[k], born, gas));
    }
    fly_in_parts(scene, caught);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Flyer& who = caught.who[k];
        if (caught.end[k] == End::BROKEN)
            throw BrokenParticle{rows[k], is_finite(gas.x[rows[k]], gas.v[rows[k]])};
        if (caught.end[k] == End::FLOWN) land(who, gas);
        if (caught.end[k] == End::GONE) mark_left(who, 0);
        if (caught.end[k] == End::CAUGHT) result.lost.push_back({rows[k], gas.x[rows[k]]});
        append(who.hits, result.hits.back());
        append(who.arrivals, result.arrivals.back());
    }
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
    const auto fly_near = [&](std::size_t i, std::size_t chunk) {
        Flyer who = flyer(i, mass, gas, result.hits[chunk], result.arrivals[chunk]);
        const std::size_t hits = who.hits.size(), arrivals = who.arrivals.size();
        switch (fly_one(scene, start(i, born, gas), who)) {
            case End::FLOWN:
                land(who, gas);
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
                        gas.x[i + k] += (1.0 - start(i + k, born, gas)) * dt * gas.v[i + k];
            }
        },
        PARTICLES_A_CHUNK);
    fly_caught(scene, mass, born, gas, result);
}

}  // namespace corpuscle::gas
