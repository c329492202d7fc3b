// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "fabric/materials/isotropic_tension_field.hpp"

namespace corpuscle::fabric {

/// Liner that bears no compression until it has once been taut (LNRC = 1): folded cloth is drawn
/// out to its reference shape without resistance. Until then it is a tension field, afterwards S =
/// D·E. It changes over in a state in which both have the same stress and energy, so nothing jumps.
class WaitingLiner {
public:
    /// @param E  times LRATIO [Pa]
    WaitingLiner(double E, double nu) : field_(E, nu), nu_(nu) {}

    [[nodiscard]] const PlaneModuli& moduli() const { return field_.moduli(); }

    /// @param was_taut  1 where it has been taut, else 0; moves on
    template <class Real>
    Stress<Real> move(const Strain<Real>& e, Real& was_taut) const {
        const Real mean = 0.5 * (e.warp + e.weft), half = 0.5 * (e.warp - e.weft);
        const Real radius = square_root(half * half + 0.25 * e.shear * e.shear);
        const auto taut = (mean + radius > Real{}) & (mean - radius >= -nu_ * (mean + radius));
        was_taut = select(taut, Real{} + 1.0, was_taut);
        const Stress<Real> pull = field_.stress(e);
        Stress<Real> full = moduli().times(e);
        full.energy = 0.5 * (full.warp * e.warp + full.weft * e.weft + full.shear * e.shear);
        const auto is_on = was_taut > Real{};
        return {select(is_on, full.warp, pull.warp), select(is_on, full.weft, pull.weft),
                select(is_on, full.shear, pull.shear), select(is_on, full.energy, pull.energy)};
    }

private:
    IsotropicTensionField field_;
    double nu_;
};

}  // namespace corpuscle::fabric
