// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// Woven sheet that wrinkles instead of taking compression: the energy relaxed over all wrinkles.
///
///     w(E) = min over S >= 0 of (S - D·E):C:(S - D·E)/2 subtracted from E:D:E/2,   C = D^-1
///
/// that is the taut S = D·E where it has no compression, nothing where E has no extension, and else
/// the one pull S = (ε/c) n⊗n along the direction that stores most, n = (1, t):
///
///     ε(t) = E11 + 2·E12·t + E22·t²,   c(t) = 1/E1 + B·t² + t⁴/E2,   B = 1/G - 2·nu12/E1,   w =
///     ε²/(2c)
///
/// Continuous and convex, S = dw/dE, tangent never stiffer than D. For nu, G of an isotropic sheet
/// it is IsotropicTensionField. Departs from cutting off the negative principal stress of D·E,
/// which is the gradient of no energy.
class OrthotropicTensionField {
public:
    OrthotropicTensionField(double E_1, double E_2, double nu_21, double G)
        : moduli_(orthotropic_moduli(E_1, E_2, nu_21, G)),
          compliance_1_(1.0 / E_1),
          compliance_2_(1.0 / E_2),
          compliance_12_(1.0 / G - 2.0 * nu_21 / E_2),
          ratio_(std::sqrt(E_2 / E_1)) {}

    [[nodiscard]] const PlaneModuli& moduli() const { return moduli_; }

    /// Cost when nothing wrinkles: 1 square root.
    template <class Real>
    Stress<Real> stress(const Strain<Real>& e) const {
        Stress<Real> s = moduli_.times(e);
        s.energy = 0.5 * (s.warp * e.warp + s.weft * e.weft + s.shear * e.shear);

        const Real half = 0.5 * (e.warp - e.weft);
        const Real major =
            0.5 * (e.warp + e.weft) + square_root(half * half + 0.25 * e.shear * e.shear);
        const auto slack = major <= Real{};
        const auto taut = (s.warp >= Real{}) & (s.weft >= Real{}) &
                          (s.warp * s.weft >= s.shear * s.shear) & (major > Real{});
        if (any(!(taut | slack))) {
            const Stress<Real> pull = wrinkled(e);
            s = {select(taut, s.warp, pull.warp), select(taut, s.weft, pull.weft),
                 select(taut, s.shear, pull.shear), select(taut, s.energy, pull.energy)};
        }
        return {select(slack, Real{}, s.warp), select(slack, Real{}, s.weft),
                select(slack, Real{}, s.shear), select(slack, Real{}, s.energy)};
    }

private:
    /// The pull along the best direction. Turned and mirrored so that the direction lies between
    /// the yarn that holds more energy (τ = 0) and the bisector of both (τ = 1), with a shear >= 0;
    /// scaled by t = τ·(E2/E1)^(1/4) both yarns weigh the same, and the best direction is the one
    /// root in [0, 1] of
    ///
    ///     Q(τ) = s·(1 - τ⁴) + a·τ³ + b·τ,   Q(0) >= 0 >= Q(1)
    template <class Real>
    Stress<Real> wrinkled(const Strain<Real>& e) const {
        const Real scaled_1 = e.warp, scaled_2 = ratio_ * e.weft;
        const auto turned = scaled_2 > scaled_1;
        const double root_ratio = std::sqrt(ratio_);

        const double unit = compliance_1_ / ratio_;  // 1/sqrt(E1·E2)
        const Real first = greater(scaled_1, scaled_2);
        const Real second = scaled_1 + scaled_2 - first;
        const Real s = (2.0 * unit * root_ratio) * magnitude(e.shear);
        const Real a = 2.0 * compliance_12_ * second - 4.0 * unit * first;
        const Real b = 4.0 * unit * second - 2.0 * compliance_12_ * first;
        const Real tau = best_direction(s, a, b);

        // Back to the sheet's own axes: n = (n1, n2), not of unit length
        const Real sign = select(e.shear < Real{}, Real{} - 1.0, Real{} + 1.0);
        const Real n_1 = select(turned, tau, Real{} + 1.0);
        const Real n_2 = sign * root_ratio * select(turned, Real{} + 1.0, tau);
        const Real n_11 = n_1 * n_1, n_22 = n_2 * n_2, n_12 = n_1 * n_2;
        const Real extension = n_11 * e.warp + n_22 * e.weft + n_12 * e.shear;
        const Real compliance = compliance_1_ * n_11 * n_11 + compliance_12_ * n_11 * n_22 +
                                compliance_2_ * n_22 * n_22;
        const Real pull = extension / compliance;
        return {pull * n_11, pull * n_22, pull * n_12, 0.5 * pull * extension};
    }

    /// Newton on Q, kept inside the bracket that it narrows.
    template <class Real>
    static Real best_direction(const Real& s, const Real& a, const Real& b) {
        constexpr int MOST = 60;         // bisection alone gets there in 53
        constexpr double CLOSE = 1e-14;  // of the direction's tangent
        Real low = Real{}, high = Real{} + 1.0;
        Real tau = start(s, a, b);
        for (int i = 0; i < MOST; ++i) {
            const Real square = tau * tau;
            const Real value = s * (1.0 - square * square) + tau * (a * square + b);
            const Real slope = square * (3.0 * a - 4.0 * s * tau) + b;
            low = select(value >= Real{}, tau, low);
            high = select(value >= Real{}, high, tau);
            const Real newton = tau - value / slope;
            const auto inside = (newton >= low) & (newton <= high);
            const Real next = select(inside, newton, 0.5 * (low + high));
            const Real change = magnitude(next - tau);
            tau = next;
            if (!any(change > Real{} + CLOSE)) break;
        }
        return tau;
    }

    /// Root of the tangent at 0 where it falls into [0, 1], the middle elsewhere.
    template <class Real>
    static Real start(const Real& s, const Real& a, const Real& b) {
        const Real linear = -s / (b + select(a < Real{}, a, Real{}));
        return select((linear >= Real{}) & (linear <= Real{} + 1.0), linear, Real{} + 0.5);
    }

    PlaneModuli moduli_;
    double compliance_1_, compliance_2_;  ///< 1/E1, 1/E2                [1/Pa]
    double compliance_12_;                ///< B                         [1/Pa]
    double ratio_;                        ///< sqrt(E2/E1)
};

}  // namespace corpuscle::fabric
