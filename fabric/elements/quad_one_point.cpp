// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/elements/quad_one_point.hpp"

#include "fabric/membrane_block_of.hpp"

namespace corpuscle::fabric {

std::unique_ptr<MembraneBlock> make_one_point_quads(const BlockInput& in) {
    return make_block<QuadOnePoint>(in, make_quad_one_point);
}

}  // namespace corpuscle::fabric
