// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// A fabric with a thin isotropic liner that also takes compression (EL, PRL, LRATIO of
/// *MAT_FABRIC): it keeps slack cloth from collapsing. Both share strain and reference volume, so
/// the liner's stiffness counts LRATIO-fold.
template <class Fabric>
class Lined {
public:
    Lined(const Fabric& fabric, const PlaneModuli& liner) : fabric_(fabric), liner_(liner) {}

    [[nodiscard]] PlaneModuli moduli() const { return fabric_.moduli() + liner_; }

    template <class Real>
    Stress<Real> stress(const Strain<Real>& e) const {
        Stress<Real> s = fabric_.stress(e);
        const Stress<Real> l = liner_.times(e);
        s.energy += 0.5 * (l.warp * e.warp + l.weft * e.weft + l.shear * e.shear);
        s.warp += l.warp;
        s.weft += l.weft;
        s.shear += l.shear;
        return s;
    }

private:
    Fabric fabric_;
    PlaneModuli liner_;  ///< times LRATIO
};

}  // namespace corpuscle::fabric
