// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/facet_blocks.hpp"

namespace corpuscle::gas {

contact::Box FacetBlocks::box(std::size_t number, const contact::Box& all, double more) const {
    const auto& count = blocks_.count;
    const auto row = static_cast<int>(number);
    const std::array<int, 3> at{row % count[0], row / count[0] % count[1],
                                row / (count[0] * count[1])};
    contact::Box box;
    for (int a = 0; a < 3; ++a) {
        box.low[a] = blocks_.low[a] + blocks_.edge * at[a] - more;
        box.high[a] = blocks_.low[a] + blocks_.edge * (at[a] + 1) + more;
        if (at[a] == 0) box.low[a] = std::min(box.low[a], all.low[a]);
        if (at[a] + 1 == count[a]) box.high[a] = std::max(box.high[a], all.high[a]);
    }
    return box;
}

}  // namespace corpuscle::gas
