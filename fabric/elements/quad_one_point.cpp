// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/elements/quad_one_point.hpp"

#include "fabric/elements/make_block.hpp"

namespace corpuscle::fabric {

std::unique_ptr<MembraneBlock> make_one_point_quads(const BlockInput& in) {
    return make_block<QuadOnePoint>(in, make_quad_one_point);
}

}  // namespace corpuscle::fabric
