// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <tuple>

#include "fabric/elements/frequency_bound.hpp"
#include "fabric/elements/quad_modes.hpp"
#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {

/// Share of a fully integrated quad's resistance that in-plane hourglassing keeps. Measured on a
/// strip cut at 45° to the yarns (E/G = 300, ten quads wide): 0.01 makes it 1 % too stiff, 0.05 5
/// %, 1 (2 × 2 points) 48 %; 0.001 leaves coarse strips 4 % too soft. Inflated bags do not feel the
/// difference.
inline constexpr double HOURGLASS = 0.01;

/// Four corners, one stress: the mean of the strain over a bilinear quad, hourglass part included.
///
/// With g1, g2 the yarns at the middle and q = Σ γ_a x_a the hourglass vector [Flanagan &
/// Belytschko 1981], the yarns elsewhere are g_i + q (η ξ,i + ξ η,i), and the means over the quad
/// are
///
///     2·E_ij = g_i·g_j - δ_ij + m_ij (|q|² - Q²),   m_ij = (ξ,i ξ,j + η,i η,j)/3
///
/// Q is the warp of the reference shape. The |q|² term is what resists a quad's warping under
/// tension, without which pressurised one-point quads checkerboard. In-plane hourglassing leaves
/// the mean as it is, and is held by a part of what the fluctuation g_i·q would store:
///
///     W = V [ w(E) + κ/2 (D11 m11 (g1·q)² + D22 m22 (g2·q)²) ]
///
/// Force is -dW/dx exactly; linear fields leave q = 0 (patch test).
template <class Real>
struct QuadOnePoint {
    static constexpr int CORNERS = 4;
    static constexpr int POINTS = 1;

    Real xi_1, xi_2, eta_1, eta_2;  ///< ξ,1 ξ,2 η,1 η,2 at the middle                      [1/m]
    Real t1, t2;                    ///< γ = h/4 - t1·B_1 - t2·B_2                          [m]
    Real warp;                      ///< Q²                                                 [m^2]
    Real volume;                    ///< V                                                  [m^3]

    static auto fields(auto& q) {
        return std::tie(q.xi_1, q.xi_2, q.eta_1, q.eta_2, q.t1, q.t2, q.warp, q.volume);
    }

    /// Neither stores nor pushes.
    void empty() { volume = Real{}; }

    /// What point k stands for.                                                            [m^3]
    Real volume_at(int /*k*/) const { return volume; }

    using Corners = std::array<Vector<Real>, CORNERS>;
    struct Motion {
        Vector<Real> g1, g2, q;
    };
    struct Load {
        Stress<Real> stress;
        Real hold_1, hold_2;  ///< κ D11 m11 (g1·q), κ D22 m22 (g2·q)
    };

    Motion motion(const Corners& x) const {
        const QuadModes<Real> u = quad_modes(x);
        const Vector<Real> g1 = xi_1 * u.a + eta_1 * u.b, g2 = xi_2 * u.a + eta_2 * u.b;
        return {g1, g2, u.q - t1 * g1 - t2 * g2};
    }

    std::array<Strain<Real>, POINTS> strain(const Motion& m) const {
        const Real bow = dot(m.q, m.q) - warp;
        return {Strain<Real>{0.5 * (dot(m.g1, m.g1) - 1.0 + m11() * bow),
                             0.5 * (dot(m.g2, m.g2) - 1.0 + m22() * bow),
                             dot(m.g1, m.g2) + m12() * bow}};
    }

    template <class Law>
    Load elastic(const Law& law, const Motion& m, const std::array<Strain<Real>, POINTS>& e,
                 Real& energy) const {
        const Stress<Real> s = stress_at(law, 0, e[0]);
        const Real along_1 = dot(m.g1, m.q), along_2 = dot(m.g2, m.q);
        const PlaneModuli d = law.moduli();
        const Real hold_1 = (HOURGLASS * d.warp) * m11() * along_1;
        const Real hold_2 = (HOURGLASS * d.weft) * m22() * along_2;
        energy = volume * (s.energy + 0.5 * (hold_1 * along_1 + hold_2 * along_2));
        return {s, hold_1, hold_2};
    }

    Load viscous(const PlaneModuli& d, const Motion& m, const Motion& rate) const {
        const Real bow = 2.0 * dot(m.q, rate.q);
        const Strain<Real> e{dot(m.g1, rate.g1) + 0.5 * m11() * bow,
                             dot(m.g2, rate.g2) + 0.5 * m22() * bow,
                             dot(m.g1, rate.g2) + dot(m.g2, rate.g1) + m12() * bow};
        return {d.times(e), (HOURGLASS * d.warp) * m11() * (dot(m.g1, rate.q) + dot(rate.g1, m.q)),
                (HOURGLASS * d.weft) * m22() * (dot(m.g2, rate.q) + dot(rate.g2, m.q))};
    }

    Corners spread(const Motion& m, const Load& load, const Real& scale) const {
        const Stress<Real>& s = load.stress;
        const Real v = scale * volume;
        const Real bow = s.warp * m11() + s.weft * m22() + 2.0 * s.shear * m12();
        const Vector<Real> on_q =
            (v * bow) * m.q + (v * load.hold_1) * m.g1 + (v * load.hold_2) * m.g2;
        const Vector<Real> on_1 =
            (v * s.warp) * m.g1 + (v * s.shear) * m.g2 + (v * load.hold_1) * m.q - t1 * on_q;
        const Vector<Real> on_2 =
            (v * s.shear) * m.g1 + (v * s.weft) * m.g2 + (v * load.hold_2) * m.q - t2 * on_q;
        return corner_forces(
            QuadModes<Real>{xi_1 * on_1 + xi_2 * on_2, eta_1 * on_1 + eta_2 * on_2, on_q});
    }

    /// Bound of the highest frequency squared of now: nothing in the plane is stiffer than d, the
    /// stress holds what turns, and hourglassing adds its share.                          [1/s^2]
    Real frequency_bound(const PlaneModuli& d, const Motion& m, const Load& load,
                         const CornerMobility<Real>& a) const {
        const Real c11 = dot(m.g1, m.g1), c12 = dot(m.g1, m.g2), c22 = dot(m.g2, m.g2);
        const Real c1q = dot(m.g1, m.q), c2q = dot(m.g2, m.q), cqq = dot(m.q, m.q);
        const Real k1 = m11(), k2 = m22(), k3 = 2.0 * m12();
        const Real q1 = c1q * a.a1q, q2 = c2q * a.a2q, qq = cqq * a.aqq,
                   mixed = c1q * a.a2q + c2q * a.a1q;
        const RateProducts<Real> r{
            c11 * a.a11 + 2.0 * k1 * q1 + k1 * k1 * qq,
            c12 * a.a12 + k2 * q1 + k1 * q2 + k1 * k2 * qq,
            c11 * a.a12 + c12 * a.a11 + k3 * q1 + k1 * mixed + k1 * k3 * qq,
            c22 * a.a22 + 2.0 * k2 * q2 + k2 * k2 * qq,
            c12 * a.a22 + c22 * a.a12 + k3 * q2 + k2 * mixed + k2 * k3 * qq,
            c11 * a.a22 + c22 * a.a11 + 2.0 * c12 * a.a12 + 2.0 * k3 * mixed + k3 * k3 * qq};
        const Stress<Real>& s = load.stress;
        const Real bow = greater(s.warp * k1 + s.weft * k2 + s.shear * k3, Real{});
        return volume * (material_bound(d, r) + stress_bound(s, a) + bow * a.aqq +
                         hourglass_bound(d, c11, c1q, c22, c2q, cqq, load, a));
    }

private:
    /// Of both fluctuations g_i·q: κ D_ii m_ii |g_i ⊗ b_q + q ⊗ b_i|², and what holds them.
    Real hourglass_bound(const PlaneModuli& d, const Real& c11, const Real& c1q, const Real& c22,
                         const Real& c2q, const Real& cqq, const Load& load,
                         const CornerMobility<Real>& a) const {
        const Real rate_1 = c11 * a.aqq + 2.0 * c1q * a.a1q + cqq * a.a11;
        const Real rate_2 = c22 * a.aqq + 2.0 * c2q * a.a2q + cqq * a.a22;
        const Real held_1 =
            magnitude(load.hold_1) * (square_root(a.a11 * a.aqq) + magnitude(a.a1q));
        const Real held_2 =
            magnitude(load.hold_2) * (square_root(a.a22 * a.aqq) + magnitude(a.a2q));
        return (HOURGLASS * d.warp) * m11() * rate_1 + (HOURGLASS * d.weft) * m22() * rate_2 +
               held_1 + held_2;
    }
    Real m11() const { return (xi_1 * xi_1 + eta_1 * eta_1) * (1.0 / 3.0); }
    Real m22() const { return (xi_2 * xi_2 + eta_2 * eta_2) * (1.0 / 3.0); }
    Real m12() const { return (xi_1 * xi_2 + eta_1 * eta_2) * (1.0 / 3.0); }
};

inline QuadOnePoint<double> make_quad_one_point(const ReferenceShape& r, double thickness) {
    const PlaneModes u = plane_modes(r);
    const double det = u.a.x() * u.b.y() - u.a.y() * u.b.x();
    return {u.b.y() / det, -u.b.x() / det, -u.a.y() / det,  u.a.x() / det,
            u.q.x(),       u.q.y(),        r.warp * r.warp, r.area * thickness};
}

}  // namespace corpuscle::fabric
