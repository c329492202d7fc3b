// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/materials/own_law.hpp"

#include "fabric/materials/stretch.hpp"

namespace corpuscle::fabric {

double OwnLaw::stiffening(const Strain<double>& e) const {
    return stretch_stiffening(e, moduli());
}

}  // namespace corpuscle::fabric
