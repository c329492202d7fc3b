// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/base/parallel.hpp"
#include "solver/base/vec.hpp"

/// Membrane finite elements of fabric: meshes, materials, internal force, stable step.
namespace corpuscle::fabric {

/// Nodes of the whole scene. Leapfrog: x live at t, v at t - dt/2 before the kick, t + dt/2 after
/// it.
struct Nodes {
    Points x;                  ///< position at t          N × 3    [m]
    Points x_1;                ///< position at t + dt     N × 3    [m]
    Points v;                  ///< velocity               N × 3    [m/s]
    Points f;                  ///< force at t             N × 3    [N]
    std::vector<double> mass;  ///< lumped; 0: a place without matter, moves as it started   N [kg]

    /// N.
    [[nodiscard]] std::size_t size() const { return x.size(); }

    /// f += more; an empty `more` is no force.
    void add(const Points& more) {
        if (!more.empty()) parallel::for_each(size(), [&](std::size_t n) { f[n] += more[n]; });
    }
    /// v += span f / m.
    /// @param before  gets v as it was, if it is not null
    void kick(double span, Points* before = nullptr) {
        if (before != nullptr) before->resize(size());
        parallel::for_each(size(), [&](std::size_t n) {
            if (before != nullptr) (*before)[n] = v[n];
            if (mass[n] > 0.0) v[n] += span / mass[n] * f[n];
        });
    }
    /// x_1 = x + dt v.
    void drift(double dt) {
        parallel::for_each(size(), [&](std::size_t n) { x_1[n] = x[n] + dt * v[n]; });
    }
    [[nodiscard]] double kinetic_energy() const {  ///< sum of m v² / 2                      [J]
        return parallel::sum(size(), 0.0,
                             [&](std::size_t n) { return 0.5 * mass[n] * v[n].squaredNorm(); });
    }
};

}  // namespace corpuscle::fabric
