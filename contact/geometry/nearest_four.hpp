// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/geometry/distance.hpp"
#include "solver/base/simd.hpp"

namespace corpuscle::contact {

/// Nearest places of four pairs: those of `nearest`, up to rounding.
struct NearestFour {
    std::array<Four, 4> weight;
    FourPoints apart;    ///< [m]
    Four gap;            ///< length of that                                               [m]
    unsigned is_inside;  ///< bits
    [[nodiscard]] Nearest operator[](std::size_t l) const {
        return {{weight[0][l], weight[1][l], weight[2][l], weight[3][l]},
                {apart[0][l], apart[1][l], apart[2][l]},
                (is_inside >> l & 1U) != 0};
    }
};

/// Of four pairs that are all edges, or all a node and a triangle.
///
/// cost: 3 or 5 div, 1 sqrt for the four; each that is degenerate as by itself
[[nodiscard]] NearestFour nearest(const std::array<const Pair*, FOUR>& pairs, const Points& x);

}  // namespace corpuscle::contact
