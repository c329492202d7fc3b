// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/elements/quad_four_point.hpp"

#include "fabric/elements/make_block.hpp"

namespace corpuscle::fabric {

std::unique_ptr<MembraneBlock> make_four_point_quads(const BlockInput& in) {
    return make_block<QuadFourPoint>(in, make_quad_four_point);
}

}  // namespace corpuscle::fabric
