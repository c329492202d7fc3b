// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// Least fraction of critical damping for a step this near the limit: cloth that alternates between
/// slack and taut gains energy 14-fold in 10 000 steps with 0.003, 1.3-fold with 0.01.
inline constexpr double CALM = 0.01;

/// Gradients weighted by the corners' masses, A_ab = Σ b_a b_b/m over an element's corners; b_1,
/// b_2: along the yarns, b_q: hourglass vector, 0 for a triangle.
template <class Real>
struct CornerMobility {
    Real a11{}, a12{}, a22{};  ///< [1/(kg m²)]
    Real a1q{}, a2q{};         ///< [1/(kg m)]
    Real aqq{};                ///< [1/kg]
};

/// @param per_mass  of each corner                                                        [1/kg]
template <class Element, class Real, std::size_t CORNERS>
CornerMobility<Real> corner_mobility(const Element& shape,
                                     const std::array<Real, CORNERS>& per_mass) {
    CornerMobility<Real> a;
    for (std::size_t c = 0; c < CORNERS; ++c) {
        typename Element::Corners u{};
        u[c].x = Real{} + 1.0;
        const auto moved = shape.motion(u);
        const Real &b1 = moved.g1.x, &b2 = moved.g2.x, &w = per_mass[c];
        a.a11 += w * b1 * b1;
        a.a12 += w * b1 * b2;
        a.a22 += w * b2 * b2;
        if constexpr (requires { moved.q; }) {
            a.a1q += w * b1 * moved.q.x;
            a.a2q += w * b2 * moved.q.x;
            a.aqq += w * moved.q.x * moved.q.x;
        }
    }
    return a;
}

/// Elements with such a bound.
template <class Element>
concept KnowsBound = requires(const Element& element, const typename Element::Motion& motion,
                              const typename Element::Load& load, const CornerMobility<Lanes>& a) {
    element.frequency_bound(PlaneModuli{}, motion, load, a);
};

/// Laws that may be stiffer than their moduli where they are strained.
template <class Law>
concept StiffensBeyond = requires(const Law& law, const Strain<Lanes>& e) {
    law.stiffening(e);
};

/// R = B M⁻¹ Bᵀ of three rates of strain, 11, 22 and the angle's.                      [1/(kg m²)]
template <class Real>
struct RateProducts {
    Real r11, r12, r13, r22, r23, r33;
};

/// Greatest root of λ³ - a λ² + b λ - c, all of whose roots are real, from above and to 1e-3: with
/// 9r² = a² - 3b
///
///     λ = a/3 + r (1 + 2d),   d² (6 + 4d) = 1 + (2a³ - 9ab + 27c)/(2 (3r)³),   0 <= d <= 1/2
///
/// where d comes from above, below, above by turns.
template <class Real>
Real greatest_root(const Real& a, const Real& b, const Real& c) {
    const Real square = greater(a * a - 3.0 * b, Real{}), length = square_root(square);
    const Real cosine = 0.5 * (a * (2.0 * a * a - 9.0 * b) + 27.0 * c) / (square * length);
    const Real above = select(cosine < Real{} + 1.0, greater(1.0 + cosine, Real{}), Real{} + 2.0);
    const Real s = square_root(above);
    Real d = s * (1.0 / std::sqrt(6.0));
    for (int k = 0; k < 2; ++k) d = s / square_root(6.0 + 4.0 * d);
    return (1.0 / 3.0) * (a + length * (1.0 + 2.0 * d));
}

/// Greatest eigenvalue of D·R, which is that of M^-½ Bᵀ D B M^-½ of an element's three rates of strain
/// B, R = B M⁻¹ Bᵀ.                                                               [1/(s² m³)]
///
/// Added to bounds of what else is stiff it bounds the whole [Weyl 1912]: eigenvalues of a sum of
/// symmetric matrices are at most the sum of their greatest ones.
template <class Real>
Real material_bound(const PlaneModuli& d, const RateProducts<Real>& r) {
    const Real p11 = d.warp * r.r11 + d.cross * r.r12, p12 = d.warp * r.r12 + d.cross * r.r22;
    const Real p13 = d.warp * r.r13 + d.cross * r.r23, p21 = d.cross * r.r11 + d.weft * r.r12;
    const Real p22 = d.cross * r.r12 + d.weft * r.r22, p23 = d.cross * r.r13 + d.weft * r.r23;
    const Real p31 = d.shear * r.r13, p32 = d.shear * r.r23, p33 = d.shear * r.r33;
    const Real m3 = p11 * p22 - p12 * p21;
    const Real minors = m3 + (p11 * p33 - p13 * p31) + (p22 * p33 - p23 * p32);
    const Real det = p33 * m3 - p32 * (p11 * p23 - p13 * p21) + p31 * (p12 * p23 - p13 * p22);
    return greatest_root(p11 + p22 + p33, minors, det);
}

/// Greatest eigenvalue, at least 0, of what a stress does on what turns: of S·A.    [1/(s² m³)]
template <class Real>
Real stress_bound(const Stress<Real>& s, const CornerMobility<Real>& a) {
    const Real trace = s.warp * a.a11 + s.weft * a.a22 + 2.0 * s.shear * a.a12;
    const Real det = (s.warp * s.weft - s.shear * s.shear) * (a.a11 * a.a22 - a.a12 * a.a12);
    return greater(0.5 * (trace + square_root(greater(trace * trace - 4.0 * det, Real{}))), Real{});
}

}  // namespace corpuscle::fabric
