// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/pieces.hpp"

#include <atomic>

namespace corpuscle::contact {

void Pieces::list(const Cloth& cloth, const PatchMotion& motion, std::span<const PatchPair> pairs) {
    patches.clear();
    nodes.clear();
    triangles.clear();
    is_met_.assign(motion.size(), 0);
    for (const auto& [p, q] : pairs) is_met_[p] = is_met_[q] = 1;
    for (std::size_t p = 0; p < is_met_.size(); ++p)
        if (is_met_[p]) patches.push_back(static_cast<Index>(p));
    if (patches.empty()) return;
    const auto list_those = [&](std::size_t all, std::size_t rows, auto&& of_patch, auto&& row_of,
                                std::vector<Index>& out) {
        constexpr std::size_t PATCHES = 4, ROWS = 1024;  // a chunk
        is_met_.assign(all, 0);
        parallel::for_each(
            patches.size(),
            [&](std::size_t i) {
                for (const Index n : of_patch(patches[i]))
                    std::atomic_ref(is_met_[n]).store(1, std::memory_order_relaxed);
            },
            PATCHES);
        met_.find(
            rows, out,
            [&](std::size_t i, auto&& take) {
                if (is_met_[row_of(i)] != 0) take(row_of(i));
            },
            ROWS);
    };
    list_those(
        cloth.inverse_mass.size(), cloth.nodes.size(), [&](Index p) { return motion.nodes(p); },
        [&](std::size_t i) { return cloth.nodes[i]; }, nodes);
    list_those(
        cloth.triangles.size(), cloth.triangles.size(), [&](Index p) { return cloth.patches[p]; },
        [](std::size_t i) { return static_cast<Index>(i); }, triangles);
}

}  // namespace corpuscle::contact
