// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "fabric/membranes.hpp"
#include "solver/base/surface.hpp"

/// Membranes at rest under pressure, without the solver: explicit steps that lose all velocity
/// whenever the kinetic energy passes a maximum (kinetic damping [Cundall 1976]).
namespace corpuscle::test {

using Facet = std::array<Index, 4>;  ///< node rows, a triangle repeats its 3rd

/// Both ways to cut a facet into triangles, each with half the weight: exact for the bilinear quad.
template <class Body>
void for_triangles(const Facet& q, Body&& body) {
    if (q[2] == q[3]) return body(q[0], q[1], q[2], 1.0);
    body(q[0], q[1], q[2], 0.5);
    body(q[0], q[2], q[3], 0.5);
    body(q[0], q[1], q[3], 0.5);
    body(q[1], q[2], q[3], 0.5);
}

/// f += p · dV/dx: pressure along the facets' normals.
inline void add_pressure(const std::vector<Facet>& facets, double p, const Points& x, Points& f) {
    for (const Facet& q : facets)
        for_triangles(q, [&](Index a, Index b, Index c, double weight) {
            const Vec3 push = weight * p / 3.0 * vector_area(x[a], x[b], x[c]);
            f[a] += push;
            f[b] += push;
            f[c] += push;
        });
}

/// Volume between the facets and the origin.                                                [m^3]
inline double enclosed_volume(const std::vector<Facet>& facets, const Points& x) {
    double volume = 0.0;
    for (const Facet& q : facets)
        for_triangles(q, [&](Index a, Index b, Index c, double weight) {
            volume += weight * signed_volume(x[a], x[b], x[c]);
        });
    return volume;
}

struct Relaxation {
    std::vector<double> mass;   ///< N                                                    [kg]
    std::vector<Vec3> free;     ///< N × 3: 1 free, 0 held
    std::vector<Facet> facets;  ///< under pressure
    double pressure = 0.0;      ///< [Pa]
    Points load;                ///< N × 3, that does not change, or none                 [N]
    double tolerance = 1e-5;    ///< force that is left, by the greatest at the start or since
    int most_steps = 100000;
};
struct Relaxed {
    int steps;
    double residual;  ///< greatest free force over the greatest internal force
};

/// Moves x to rest.
inline Relaxed relax(const Relaxation& at, fabric::Membranes& membranes, Points& x) {
    const std::size_t count = x.size();
    Points v(count, Vec3::Zero()), f(count), inner(count);
    double before = 0.0;
    Relaxed out{0, INF};
    for (; out.steps < at.most_steps && out.residual > at.tolerance; ++out.steps) {
        std::fill(f.begin(), f.end(), Vec3::Zero());
        if (membranes.add_force(x, v, f) >= 0) return {out.steps, NaN};
        inner = f;
        add_pressure(at.facets, at.pressure, x, f);
        for (std::size_t n = 0; n < at.load.size(); ++n) f[n] += at.load[n];
        // Below 1/sqrt(2) of the limit a reset every other step still descends
        const double dt = 0.65 * membranes.stable_step().dt;
        double kinetic = 0.0, left = 0.0, most = 0.0;
        for (std::size_t n = 0; n < count; ++n) {
            const Vec3 free = f[n].cwiseProduct(at.free[n]);
            left = std::max(left, free.squaredNorm());
            most = std::max(most, inner[n].squaredNorm());
            v[n] += dt / at.mass[n] * free;
            kinetic += 0.5 * at.mass[n] * v[n].squaredNorm();
        }
        if (kinetic < before) {
            std::fill(v.begin(), v.end(), Vec3::Zero());
            kinetic = 0.0;
        }
        before = kinetic;
        for (std::size_t n = 0; n < count; ++n) x[n] += dt * v[n];
        if (most > 0.0 && out.steps > 10) out.residual = std::sqrt(left / most);
    }
    return out;
}

}  // namespace corpuscle::test
