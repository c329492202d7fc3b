// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <tuple>

#include "fabric/elements/quad_modes.hpp"
#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {

/// Four corners, four stresses: the bilinear quad at 2 × 2 Gauss points (ELFORM 9). Needs no
/// hourglass control; locks in shear on yarns that lie across it (fabric/README.md has the
/// figures).
///
///     x,i = a ξ,i + b η,i + q w_i,   w_i = η ξ,i + ξ η,i
///     2·E_ij = x,i·x,j - δ_ij - Q² w_i w_j      Q: warp of the reference shape
///
/// Force is -dW/dx of W = Σ V_k w(E_k) exactly.
template <class Real>
struct QuadFourPoint {
    static constexpr int CORNERS = 4;
    static constexpr int POINTS = 4;

    Real a1, a2, b1, b2, q1, q2;  ///< modes of the reference shape in its plane            [m]
    Real warp;                    ///< Q²                                                   [m^2]
    Real thickness;               ///< h                                                    [m]

    static auto fields(auto& q) {
        return std::tie(q.a1, q.a2, q.b1, q.b2, q.q1, q.q2, q.warp, q.thickness);
    }

    /// Neither stores nor pushes.
    void empty() { thickness = Real{}; }

    /// What point k stands for.                                                            [m^3]
    Real volume_at(int k) const { return gradient(k).volume; }

    using Corners = std::array<Vector<Real>, CORNERS>;
    using Motion = QuadModes<Real>;
    struct Load {
        std::array<Stress<Real>, POINTS> stress;
    };

    Motion motion(const Corners& x) const { return quad_modes(x); }

    std::array<Strain<Real>, POINTS> strain(const Motion& m) const {
        std::array<Strain<Real>, POINTS> e;
        for (int k = 0; k < POINTS; ++k) {
            const Gradient g = gradient(k);
            const Yarns y = yarns(g, m);
            e[k] = {0.5 * (dot(y.g1, y.g1) - 1.0 - warp * g.w_1 * g.w_1),
                    0.5 * (dot(y.g2, y.g2) - 1.0 - warp * g.w_2 * g.w_2),
                    dot(y.g1, y.g2) - warp * g.w_1 * g.w_2};
        }
        return e;
    }

    template <class Law>
    Load elastic(const Law& law, const Motion&, const std::array<Strain<Real>, POINTS>& e,
                 Real& energy) const {
        Load load;
        energy = Real{};
        for (int k = 0; k < POINTS; ++k) {
            load.stress[k] = stress_at(law, k, e[k]);
            energy += gradient(k).volume * load.stress[k].energy;
        }
        return load;
    }

    Load viscous(const PlaneModuli& d, const Motion& m, const Motion& rate) const {
        Load load;
        for (int k = 0; k < POINTS; ++k) {
            const Gradient g = gradient(k);
            const Yarns y = yarns(g, m), r = yarns(g, rate);
            load.stress[k] = d.times(
                Strain<Real>{dot(y.g1, r.g1), dot(y.g2, r.g2), dot(y.g1, r.g2) + dot(y.g2, r.g1)});
        }
        return load;
    }

    Corners spread(const Motion& m, const Load& load, const Real& scale) const {
        QuadModes<Real> w{};
        for (int k = 0; k < POINTS; ++k) {
            const Gradient g = gradient(k);
            const Yarns y = yarns(g, m);
            const Stress<Real>& s = load.stress[k];
            const Real v = scale * g.volume;
            const Vector<Real> p1 = (v * s.warp) * y.g1 + (v * s.shear) * y.g2;
            const Vector<Real> p2 = (v * s.shear) * y.g1 + (v * s.weft) * y.g2;
            w.a += g.xi_1 * p1 + g.xi_2 * p2;
            w.b += g.eta_1 * p1 + g.eta_2 * p2;
            w.q += g.w_1 * p1 + g.w_2 * p2;
        }
        return corner_forces(w);
    }

private:
    struct Gradient {
        Real xi_1, xi_2, eta_1, eta_2, w_1, w_2;  ///< [1/m]
        Real volume;                              ///< h·det, Gauss weights are 1     [m^3]
    };
    struct Yarns {
        Vector<Real> g1, g2;
    };

    Gradient gradient(int k) const {
        constexpr double G = 0.57735026918962576;  // 1/sqrt(3)
        const double xi = k == 0 || k == 3 ? -G : G, eta = k < 2 ? -G : G;
        const Real u1 = a1 + eta * q1, u2 = a2 + eta * q2;  // X,ξ
        const Real v1 = b1 + xi * q1, v2 = b2 + xi * q2;    // X,η
        const Real det = u1 * v2 - u2 * v1;
        const Real over = 1.0 / det;
        Gradient g{over * v2, -over * v1, -over * u2, over * u1, {}, {}, thickness * det};
        g.w_1 = eta * g.xi_1 + xi * g.eta_1;
        g.w_2 = eta * g.xi_2 + xi * g.eta_2;
        return g;
    }

    static Yarns yarns(const Gradient& g, const Motion& m) {
        return {g.xi_1 * m.a + g.eta_1 * m.b + g.w_1 * m.q,
                g.xi_2 * m.a + g.eta_2 * m.b + g.w_2 * m.q};
    }
};

inline QuadFourPoint<double> make_quad_four_point(const ReferenceShape& r, double thickness) {
    const PlaneModes u = plane_modes(r);
    return {u.a.x(), u.a.y(), u.b.x(), u.b.y(), u.q.x(), u.q.y(), r.warp * r.warp, thickness};
}

}  // namespace corpuscle::fabric
