// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gas/flight/crossing.hpp"
#include "gas/flight/flight.hpp"
#include "gas/flight/rough_wall.hpp"
#include "solver/base/surface.hpp"

/// A particle's way through a step: what it needs, and its bounces off facets.
namespace corpuscle::gas {

/// Where a path meets a facet.
struct Meeting {
    Index facet = -1;
    Crossing where{};
};

/// Input of a flight.
struct FlightScene {
    const FacetLists& lists;
    const FacetBounds* bounds;  ///< nullptr: none, every facet of a cell is looked at
    const Triangle* triangles;
    const Vec3 *x_0, *x_1;
    double dt;
    const Transmission* transmission;  ///< nullptr: none
    const WallFriction& friction;
};

/// Velocity of the point of the facet where it was met.
inline Vec3 velocity_at(const FlightScene& scene, const Meeting& meeting) {
    Vec3 velocity = Vec3::Zero();
    for (int c = 0; c < 3; ++c) {
        const Index n = scene.triangles[meeting.facet][c];
        velocity += meeting.where.at[c] / scene.dt * (scene.x_1[n] - scene.x_0[n]);
    }
    return velocity;
}

/// Energy of a leaving particle less that in the facet's frame: P·w - m w²/2, with the momentum
/// P = m v - impulse that it takes along. 0 for one that stays.                                 [J]
inline double riding(const FlightScene& scene, const Meeting& meeting,
                     const Transmission::Outcome& outcome, double mass, const Vec3& v,
                     const Vec3& impulse) {
    if (outcome.fate != Transmission::Fate::OUT) return 0.0;
    const Vec3 w = velocity_at(scene, meeting);
    return w.dot(mass * (v - 0.5 * w) - outcome.push * impulse);
}

/// Velocity after the bounce.
inline Vec3 reflect(const FlightScene& scene, const Meeting& meeting, const Vec3& v) {
    const Triangle& nodes = scene.triangles[meeting.facet];
    const Vec3 wall = velocity_at(scene, meeting);
    std::array<Vec3, 3> x;
    for (int c = 0; c < 3; ++c)
        x[c] =
            scene.x_0[nodes[c]] + meeting.where.tau * (scene.x_1[nodes[c]] - scene.x_0[nodes[c]]);
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

/// Does the velocity lead away from the swept facet, as `v` leads towards it?
inline bool leads_away(const FlightScene& scene, const Meeting& meeting, const Vec3& v,
                       const Vec3& away) {
    const MovingPlane plane =
        plane_of(meeting.where.piece, scene.triangles[meeting.facet], scene.x_0, scene.x_1);
    const double speed = plane.speed / scene.dt;
    return (plane.normal.dot(v) - speed) * (plane.normal.dot(away) - speed) < 0.0;
}

/// Whether what goes to the facet along `way` comes from its front, that its normal leads to: the
/// impulse of a hit, or a velocity past the facet's.
inline bool is_on_front(const FlightScene& scene, const Meeting& meeting, const Vec3& way) {
    const Triangle& nodes = scene.triangles[meeting.facet];
    std::array<Vec3, 3> x;
    for (int c = 0; c < 3; ++c) x[c] = 0.5 * (scene.x_0[nodes[c]] + scene.x_1[nodes[c]]);
    return way.dot(vector_area(x[0], x[1], x[2])) < 0.0;
}

/// What a facet's opening does with a particle.
inline Transmission::Outcome outcome_at(const FlightScene& scene, const Meeting& meeting,
                                        std::int32_t species, std::int32_t id, int hit,
                                        const Vec3& v) {
    const Transmission& openings = *scene.transmission;
    const bool from_front = openings.has_sides(meeting.facet) &&
                            is_on_front(scene, meeting, v - velocity_at(scene, meeting));
    return openings.outcome(meeting.facet, species, id, hit, from_front);
}

/// Specular, but for friction; never through the facet, not even where it turns within the step.
inline Bounce bounce(const FlightScene& scene, const Meeting& meeting, double mass, const Vec3& v) {
    Bounce mirrored{reflect(scene, meeting, v)};
    mirrored.impulse = mass * (v - mirrored.away);
    const WallFriction& friction = scene.friction;
    if (!friction.any()) return mirrored;
    const double f = friction.on(meeting.facet, friction.has_sides(meeting.facet) &&
                                                    is_on_front(scene, meeting, mirrored.impulse));
    if (f == 0.0) return mirrored;
    const Bounce rough = bounce_off_rough(f, friction.pushes_along, mass, v, mirrored.away,
                                          velocity_at(scene, meeting));
    return leads_away(scene, meeting, v, rough.away) ? rough : mirrored;
}

/// More bounces than this in one step: the particle is caught between closing facets.
inline constexpr int MOST_HITS = 1000;

/// A particle in flight, and what is written down about it.
struct Flyer {
    std::size_t row;                 ///< in Particles
    std::int32_t species, id;        ///< as there
    double mass, internal;           ///< [kg], [J]
    Vec3 x, v;                       ///< [m], [m/s]
    std::vector<Hit>& hits;          ///< its own are added
    std::vector<Arrival>& arrivals;  ///< its own are added
    int bounces = 0;                 ///< so far in this step: tells a gate's draws apart
    int left = MOST_HITS;            ///< facets that it may still meet in this step
};

/// Of a flight. BROKEN: not finite, at the start or after a bounce.
enum class End : std::uint8_t { FLOWN, CAUGHT, GONE, BROKEN };

/// Flies a particle from the share `born` of the step to its end; or until it is caught between
/// facets, or gone through a gate: then x is where it was at first.
End fly_one(const FlightScene& scene, double born, Flyer& who);

/// Whether place and velocity are numbers.
inline bool is_finite(const Vec3& x, const Vec3& v) {
    return x.squaredNorm() + v.squaredNorm() < INF;
}

/// Particles that are caught between facets when they fly the step as a whole, a row each.
struct CaughtFlights {
    /// Empty lists of `count`, to which their rows of `who` and `born` are added.
    explicit CaughtFlights(std::size_t count) : hits(count), arrivals(count) {}

    std::vector<Flyer> who;                      ///< at first as they come, then as they end
    std::vector<std::vector<Hit>> hits;          ///< of each
    std::vector<std::vector<Arrival>> arrivals;  ///< of each
    std::vector<double> born;                    ///< share of the step at which it starts  [-]
    std::vector<End> end;                        ///< CAUGHT: it stays so
};

/// Flies them in more and more parts of the step, until each has come to an end or has met too many
/// facets: its share of 400 thousand, 20 thousand at least. What failed leaves no trace.
void fly_in_parts(const FlightScene& scene, CaughtFlights& caught);

}  // namespace corpuscle::gas
