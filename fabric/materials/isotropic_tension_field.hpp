// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// Isotropic sheet that wrinkles instead of taking compression. With principal strains E1 >= E2:
///
///     E1 <= 0         slack      S = 0
///     E2 < -nu·E1     wrinkled   S = E·E1 n1⊗n1,  w = E·E1²/2
///     else            taut       S = D·E
///
/// the relaxed energy of [Pipkin 1986] with Green strain: continuous, convex, S = dw/dE. Departs
/// from cutting off the negative principal stress, which would slacken a wrinkled sheet as it is
/// gathered.
class IsotropicTensionField {
public:
    IsotropicTensionField(double E, double nu) : moduli_(isotropic_moduli(E, nu)), E_(E), nu_(nu) {}

    [[nodiscard]] const PlaneModuli& moduli() const { return moduli_; }

    /// Cost: 1 square root, 1 division.
    template <class Real>
    Stress<Real> stress(const Strain<Real>& e) const {
        const Real mean = 0.5 * (e.warp + e.weft);
        const Real half = 0.5 * (e.warp - e.weft);
        const Real shear = 0.5 * e.shear;
        const Real radius = square_root(half * half + shear * shear);
        const Real major = mean + radius, minor = mean - radius;

        const Real taut_warp = moduli_.warp * e.warp + moduli_.cross * e.weft;
        const Real taut_weft = moduli_.cross * e.warp + moduli_.weft * e.weft;
        const Real taut_shear = moduli_.shear * e.shear;
        const Real taut_energy =
            0.5 * (taut_warp * e.warp + taut_weft * e.weft + taut_shear * e.shear);

        // A single point as Mohr's circle is never wrinkled, so radius = 0 is never picked
        const Real tension = E_ * major;
        const Real cosine = half / radius, sine = shear / radius;
        const auto choose = [&](const Real& taut, const Real& wrinkled) {
            return select(major <= Real{}, Real{}, select(minor >= -nu_ * major, taut, wrinkled));
        };
        return {choose(taut_warp, 0.5 * tension * (1.0 + cosine)),
                choose(taut_weft, 0.5 * tension * (1.0 - cosine)),
                choose(taut_shear, 0.5 * tension * sine),
                choose(taut_energy, 0.5 * tension * major)};
    }

private:
    PlaneModuli moduli_;
    double E_, nu_;
};

}  // namespace corpuscle::fabric
