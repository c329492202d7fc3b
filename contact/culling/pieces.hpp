// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/culling/patch_motion.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// Two patches p <= q of the cloth, or twice the same.
using PatchPair = std::pair<Index, Index>;

/// Patches, with their nodes and triangles, all ascending.
struct Pieces {
    std::vector<Index> patches, nodes, triangles;

    /// Makes it what some pairs of patches consist of.
    void list(const Cloth& cloth, const PatchMotion& motion, std::span<const PatchPair> pairs);

private:
    std::vector<std::uint8_t> is_met_;  ///< patches, nodes, or triangles
    parallel::Gathered<Index> met_;
};

}  // namespace corpuscle::contact
