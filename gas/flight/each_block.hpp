// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "gas/flight/block_of_cells.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

/// body(number, block) for 0..blocks on all threads; the block is the thread's to work with.
template <class Body>
void for_each_block(std::size_t blocks, Body&& body,
                    parallel::Cut::Where where = parallel::Cut::Where::current()) {
    constexpr std::size_t A_CHUNK = 1;  // some hundred facets each
    parallel::for_chunks(
        blocks,
        [&](std::size_t begin, std::size_t end, std::size_t) {
            BlockOfCells block;
            for (std::size_t b = begin; b < end; ++b) body(b, block);
        },
        parallel::Cut(A_CHUNK, where));
}

}  // namespace corpuscle::gas
