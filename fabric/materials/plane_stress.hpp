// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle::fabric {

/// Green-Lagrange strain on the warp and weft of the reference shape; shear is the angle's.   [-]
template <class Real>
struct Strain {
    Real warp,   ///< E11
        weft;    ///< E22
    Real shear;  ///< 2·E12
};

/// Second Piola-Kirchhoff stress on warp and weft, and the energy it stores.
template <class Real>
struct Stress {
    Real warp,    ///< S11  [Pa]
        weft;     ///< S22  [Pa]
    Real shear;   ///< S12                                    [Pa]
    Real energy;  ///< of the reference volume                [J/m^3]
};

/// Stiffness of a thin sheet on its warp and weft.                       [Pa]
struct PlaneModuli {
    double warp = 0,   ///< D11  [Pa]
        cross = 0,     ///< D12  [Pa]
        weft = 0;      ///< D22  [Pa]
    double shear = 0;  ///< G                 [Pa]

    /// S = D·E without the energy.
    template <class Real>
    Stress<Real> times(const Strain<Real>& e) const {
        return {warp * e.warp + cross * e.weft, cross * e.warp + weft * e.weft, shear * e.shear,
                Real{}};
    }
    /// Of two layers that share their strain.
    friend PlaneModuli operator+(const PlaneModuli& a, const PlaneModuli& b) {
        return {a.warp + b.warp, a.cross + b.cross, a.weft + b.weft, a.shear + b.shear};
    }
    /// Of a layer s times as thick.
    friend PlaneModuli operator*(double s, const PlaneModuli& a) {
        return {s * a.warp, s * a.cross, s * a.weft, s * a.shear};
    }
};

/// Stress at an element's point k: laws that remember know their points apart.
template <class Law, class Real>
Stress<Real> stress_at(const Law& law, int k, const Strain<Real>& e) {
    if constexpr (requires { law.stress(k, e); })
        return law.stress(k, e);
    else
        return law.stress(e);
}

/// D11 = E1/(1 - nu12·nu21), D12 = nu21·D11, D22 = E2/(1 - nu12·nu21), nu12 = nu21·E1/E2.
/// @param nu_21  strain along 1 from stress along 2 (PRBA), nu_21² E_1 / E_2 < 1               [-]
inline PlaneModuli orthotropic_moduli(double E_1, double E_2, double nu_21, double G) {
    const double scale = 1.0 / (1.0 - nu_21 * nu_21 * E_1 / E_2);
    return {scale * E_1, scale * nu_21 * E_1, scale * E_2, G};
}
/// The same of one modulus and one Poisson's ratio, G = E/2(1 + nu).
inline PlaneModuli isotropic_moduli(double E, double nu) {
    return orthotropic_moduli(E, E, nu, 0.5 * E / (1.0 + nu));
}

}  // namespace corpuscle::fabric
