// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <variant>

#include "fabric/membrane_block_of.hpp"

namespace corpuscle::fabric {

/// The block of a kind of element for the law that it is given.
/// @param make  (reference shape, thickness) -> element                                       [m]
template <template <class> class Element, class Make>
std::unique_ptr<MembraneBlock> make_block(const BlockInput& in, const Make& make) {
    return std::visit(
        [&]<class Law>(const Law& law) -> std::unique_ptr<MembraneBlock> {
            return std::make_unique<BlockOf<Element, Law>>(in, law, make);
        },
        in.law.law);
}

}  // namespace corpuscle::fabric
