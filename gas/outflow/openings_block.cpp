// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What touching fabric leaves of holes (BLOCK).

#include <algorithm>
#include <array>

#include "gas/outflow/openings.hpp"

namespace corpuscle::gas {
namespace {

/// Triangles that one is blocked together with: both of its quad; of a triangle, or of a shell that
/// is cut at hanging nodes, itself alone. Those of one shell follow each other.
std::span<const Triangle> blocked_together(std::span<const Triangle> all,
                                           std::span<const Index> shell, std::size_t one) {
    constexpr std::size_t OF_A_QUAD = 2;
    std::size_t begin = one, end = one + 1;
    while (begin > 0 && shell[begin - 1] == shell[one]) --begin;
    while (end < shell.size() && shell[end] == shell[one]) ++end;
    return end - begin == OF_A_QUAD ? all.subspan(begin, OF_A_QUAD) : all.subspan(one, 1);
}

/// Share of their nodes that are `closed`; of two triangles at most.
double closed_share(std::span<const Triangle> triangles, std::span<const std::uint8_t> closed) {
    std::array<Index, 6> nodes{};
    std::size_t count = 0;
    for (const Triangle& triangle : triangles)
        for (const Index n : triangle)
            if (std::find(nodes.begin(), nodes.begin() + count, n) == nodes.begin() + count)
                nodes[count++] = n;
    const auto touched = static_cast<double>(std::count_if(
        nodes.begin(), nodes.begin() + count, [&](Index n) { return closed[n] != 0; }));
    return touched / static_cast<double>(count);
}

}  // namespace

/// Each node that touches takes its share of the shells at it, 1/3 of a triangle, 1/4 of a quad; of
/// a shell that is cut at hanging nodes 1/3 of each of its triangles. Fabric that is blocked keeps
/// ELA of its leak.
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
        for (const Index f : opening.facets) {
            const auto piece = blocked_together(triangles_, shell_, static_cast<std::size_t>(f));
            transmission_.open[f] = 1.0 - closed_share(piece, closed) * (1.0 - kept);
        }
    }
}

}  // namespace corpuscle::gas
