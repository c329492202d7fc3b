// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// Linear orthotropic sheet, St. Venant-Kirchhoff in plane stress:
///
///     S = D·E,   w = S:E/2
///
/// This is the law to copy for a new one: `moduli()` is the stiffness at rest, from which come time
/// step, damping and hourglass control; `stress()` is pure and NaN in gives NaN out.
class Linear {
public:
    explicit Linear(const PlaneModuli& moduli) : moduli_(moduli) {}

    [[nodiscard]] const PlaneModuli& moduli() const { return moduli_; }

    template <class Real>
    Stress<Real> stress(const Strain<Real>& e) const {
        Stress<Real> s = moduli_.times(e);
        s.energy = 0.5 * (s.warp * e.warp + s.weft * e.weft + s.shear * e.shear);
        return s;
    }

private:
    PlaneModuli moduli_;
};

}  // namespace corpuscle::fabric
