// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "gas/flight/crossing.hpp"
#include "gas/flight/flight.hpp"
#include "gas/flight/rough_wall.hpp"

/// Interaction of a particle with a facet.
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

/// Specular, but for friction; never through the facet, not even where it turns within the step.
inline Bounce bounce(const FlightScene& scene, const Meeting& meeting, double mass, const Vec3& v) {
    Bounce mirrored{reflect(scene, meeting, v)};
    mirrored.impulse = mass * (v - mirrored.away);
    const double f = scene.friction.on(meeting.facet);
    if (f == 0.0) return mirrored;
    const Bounce rough = bounce_off_rough(f, scene.friction.pushes_along, mass, v, mirrored.away,
                                          velocity_at(scene, meeting));
    return leads_away(scene, meeting, v, rough.away) ? rough : mirrored;
}

}  // namespace corpuscle::gas
