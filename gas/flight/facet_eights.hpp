// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "contact/surface/patches.hpp"
#include "solver/base/simd.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Facets by eights that lie close together along the cloth: what one instruction looks at.
struct FacetEights {
    std::vector<std::array<Index, EIGHT>> facet;  ///< -1: none, in a patch's last lanes
    std::vector<Index> of;                        ///< by facet: its eight

    [[nodiscard]] std::size_t size() const { return facet.size(); }
};

/// Cuts each patch along the cloth, eight by eight: in a bag that is folded its layers are told
/// apart. The patch's facets are put in the order of their eights.
[[nodiscard]] FacetEights make_eights(std::span<const Vec3> x, std::span<const Triangle> triangles,
                                      contact::Patches& patches);

}  // namespace corpuscle::gas
