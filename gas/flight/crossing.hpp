// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// A particle's straight path through one step, by where it would be at the two ends of the step.
struct Path {
    Vec3 at_0;  ///< at t       [m]
    Vec3 at_1;  ///< at t + dt  [m]
};

/// Where a path passes through a moving triangle.
struct Crossing {
    double tau;                ///< share of the step, 0 at t, 1 at t + dt                    [-]
    std::array<double, 3> at;  ///< barycentric coordinates, in the order of the triangle      [-]
    int piece;                 ///< which tetrahedron of the swept triangle, 0-2
};

/// Watertight crossing of a path and a triangle whose nodes move from x_0 to x_1.
///
/// In space and time (4-D) the triangle sweeps a prism, cut into three tetrahedra whose vertices
/// are nodes at t or t + dt. Side walls are cut along the diagonal from the lower node row at t to
/// the higher one at t + dt, so two triangles that share an edge share the walls' pieces, and the
/// swept surface is one closed piecewise-linear manifold. Seen from the particle (positions minus
/// the particle's at the same instant) the path is the origin, and it crosses a piece where the
/// origin lies in that tetrahedron. The signs of the four face determinants decide; a face is
/// always evaluated in the same order of its vertices and its sign is exact, so that neighbours
/// agree: a path never slips through an edge or a corner.
///
/// Returns the earliest crossing later than `after`, not counting piece `ignored` (that the path
/// has just been reflected by: a straight path meets a plane once). Cost: ten determinants, by
/// fours.
std::optional<Crossing> cross(const Path& path, const Triangle& triangle, const Vec3* x_0,
                              const Vec3* x_1, double after = -1.0, int ignored = -1);

/// The plane that a piece moves in: points with normal·x - speed·t constant (not normalised).
struct MovingPlane {
    Vec3 normal;
    double speed;  ///< normal · velocity, per step (not per second)
};
MovingPlane plane_of(int piece, const Triangle& triangle, const Vec3* x_0, const Vec3* x_1);

}  // namespace corpuscle::gas
