// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <tuple>

#include "fabric/elements/frequency_bound.hpp"
#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {

/// Three corners, one strain: the constant-strain membrane triangle, total Lagrangian.
///
///     g1 = Σ B_a1 x_a,  g2 = Σ B_a2 x_a    deformed yarns
///     E11 = (g1·g1 - 1)/2,  E22 = (g2·g2 - 1)/2,  2·E12 = g1·g2
///     f_a = -V (B_a1 (S11 g1 + S12 g2) + B_a2 (S12 g1 + S22 g2)),  V = A0 h
///
/// Force is -dW/dx exactly; the corners' forces add up to nothing because B_0 = -B_1 - B_2.
///
/// Every element offers the same names: CORNERS, POINTS, fields, volume_at, motion, elastic,
/// viscous, spread.
template <class Real>
struct Triangle {
    static constexpr int CORNERS = 3;
    static constexpr int POINTS = 1;  ///< where strain is taken

    Real b11, b12, b21, b22;  ///< gradients of the corners 1 and 2: B_11 B_12 B_21 B_22    [1/m]
    Real volume;              ///< V                                                        [m^3]

    static auto fields(auto& t) { return std::tie(t.b11, t.b12, t.b21, t.b22, t.volume); }

    /// Neither stores nor pushes.
    void empty() { volume = Real{}; }

    /// What point k stands for.                                                            [m^3]
    Real volume_at(int /*k*/) const { return volume; }

    using Corners = std::array<Vector<Real>, CORNERS>;
    struct Motion {
        Vector<Real> g1, g2;
    };
    struct Load {
        Stress<Real> stress;
    };

    /// The deformed yarns; of velocities: their rates.
    Motion motion(const Corners& x) const {
        const Vector<Real> side_1 = x[1] - x[0], side_2 = x[2] - x[0];
        return {b11 * side_1 + b21 * side_2, b12 * side_1 + b22 * side_2};
    }

    std::array<Strain<Real>, POINTS> strain(const Motion& m) const {
        return {Strain<Real>{0.5 * (dot(m.g1, m.g1) - 1.0), 0.5 * (dot(m.g2, m.g2) - 1.0),
                             dot(m.g1, m.g2)}};
    }

    template <class Law>
    Load elastic(const Law& law, const Motion&, const std::array<Strain<Real>, POINTS>& e,
                 Real& energy) const {
        const Stress<Real> s = stress_at(law, 0, e[0]);
        energy = volume * s.energy;
        return {s};
    }

    /// Stress of the strain rate, before its factor of time.
    Load viscous(const PlaneModuli& d, const Motion& m, const Motion& rate) const {
        return {d.times(Strain<Real>{dot(m.g1, rate.g1), dot(m.g2, rate.g2),
                                     dot(m.g1, rate.g2) + dot(m.g2, rate.g1)})};
    }

    /// Bound of the highest frequency squared of now: nothing in the plane is stiffer than d, and
    /// the stress holds what turns.                                                       [1/s^2]
    Real frequency_bound(const PlaneModuli& d, const Motion& m, const Load& load,
                         const CornerMobility<Real>& a) const {
        const Real c11 = dot(m.g1, m.g1), c12 = dot(m.g1, m.g2), c22 = dot(m.g2, m.g2);
        const RateProducts<Real> r{c11 * a.a11,
                                   c12 * a.a12,
                                   c11 * a.a12 + c12 * a.a11,
                                   c22 * a.a22,
                                   c12 * a.a22 + c22 * a.a12,
                                   c11 * a.a22 + c22 * a.a11 + 2.0 * c12 * a.a12};
        return volume * (material_bound(d, r) + stress_bound(load.stress, a));
    }

    /// -scale·dW/dx at each corner.                                                        [N]
    Corners spread(const Motion& m, const Load& load, const Real& scale) const {
        const Stress<Real>& s = load.stress;
        const Real v = -scale * volume;
        const Vector<Real> p1 = (v * s.warp) * m.g1 + (v * s.shear) * m.g2;
        const Vector<Real> p2 = (v * s.shear) * m.g1 + (v * s.weft) * m.g2;
        const Vector<Real> f1 = b11 * p1 + b12 * p2, f2 = b21 * p1 + b22 * p2;
        return {Vector<Real>{} - (f1 + f2), f1, f2};
    }
};

/// The triangle's numbers from its reference shape and thickness.
inline Triangle<double> make_triangle(const ReferenceShape& r, double thickness) {
    const auto& x = r.x;
    const double twice = 2.0 * r.area;
    return {(x[2].y() - x[0].y()) / twice, (x[0].x() - x[2].x()) / twice,
            (x[0].y() - x[1].y()) / twice, (x[1].x() - x[0].x()) / twice, r.area * thickness};
}

}  // namespace corpuscle::fabric
