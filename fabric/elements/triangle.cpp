// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/elements/triangle.hpp"

#include "fabric/elements/make_block.hpp"

namespace corpuscle::fabric {

std::unique_ptr<MembraneBlock> make_triangles(const BlockInput& in) {
    return make_block<Triangle>(in, make_triangle);
}

}  // namespace corpuscle::fabric
