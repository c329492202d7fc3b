// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// Bound of the stiffness in space of a sheet whose tangent is nowhere stiffer than D, by that at
/// rest,
///
///     1 + 2·E_1 + min(E_1, max(E11, E22, 0) + sqrt(G/sqrt(D11·D22))·|γ|)
///
/// E_1 >= 0: largest principal strain. K of the stretched sheet is that at rest of corner
/// velocities stretched likewise, longer by sqrt(1 + 2·E_1) at most; the rest is the stress on what
/// turns: S:C:S <= E:D:E, C = D^-1, where compression counts for nothing.                      [-]
template <class Real>
Real stretch_stiffening(const Strain<Real>& e, const PlaneModuli& d) {
    const double share = std::sqrt(d.shear / std::sqrt(d.warp * d.weft));
    const Real half = 0.5 * (e.warp - e.weft), shear = magnitude(e.shear);
    const Real principal =
        greater(0.5 * (e.warp + e.weft) + square_root(half * half + 0.25 * shear * shear), Real{});
    const Real yarns = greater(greater(e.warp, e.weft), Real{}) + share * shear;
    return 1.0 + 2.0 * principal + select(yarns < principal, yarns, principal);
}

}  // namespace corpuscle::fabric
