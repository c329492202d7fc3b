// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What touching fabric leaves of holes (BLOCK).

#include <algorithm>

#include "gas/outflow/openings.hpp"

namespace corpuscle::gas {

/// Each node that touches takes its share of the shells at it, 1/3 of a triangle, 1/4 of a quad;
/// fabric that is blocked keeps ELA of its leak.
void Openings::block(std::span<const std::uint8_t> touching,
                     std::span<const std::uint8_t> pressed) {
    for (const Opening& opening : openings_) {
        const bool is_vent = opening.vent >= 0;
        const bool counts = !is_vent              ? block_.fabric
                            : opening.is_internal ? block_.internal_vents
                                                  : block_.external_vents;
        const bool by_pressure = is_vent && !opening.is_internal && !counts && block_.by_pressure;
        if (!counts && !by_pressure) continue;
        const auto& closed = by_pressure ? pressed : touching;
        const double kept = is_vent ? 0.0 : leaks_[opening.leak].when_blocked;
        for (std::size_t i = 0; i < opening.facets.size();) {
            // The triangles of one shell follow each other.
            std::size_t end = i + 1;
            while (end < opening.facets.size() &&
                   shell_[opening.facets[end]] == shell_[opening.facets[i]])
                ++end;
            std::array<Index, 6> nodes{};
            std::size_t count = 0;
            for (std::size_t f = i; f < end; ++f)
                for (const Index n : triangles_[opening.facets[f]])
                    if (std::find(nodes.begin(), nodes.begin() + count, n) == nodes.begin() + count)
                        nodes[count++] = n;
            const auto touched = static_cast<double>(std::count_if(
                nodes.begin(), nodes.begin() + count, [&](Index n) { return closed[n] != 0; }));
            const double blocked = touched / static_cast<double>(count);
            for (; i < end; ++i)
                transmission_.open[opening.facets[i]] = 1.0 - blocked * (1.0 - kept);
        }
    }
}

}  // namespace corpuscle::gas
