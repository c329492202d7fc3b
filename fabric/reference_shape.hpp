// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "fabric/materials/fabric_card.hpp"
#include "fabric/mesh.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// A shell without stress, laid flat on its mean plane: the first axis along the warp.
struct ReferenceShape {
    int corners = 0;                     ///< 3 or 4
    std::array<int, 4> corner{};         ///< which of the shell's four places each corner is
    std::array<Eigen::Vector2d, 4> x{};  ///< corners in the axes of warp and weft              [m]
    double area = 0.0;  ///< of the flat shape                                 [m^2]
    double warp = 0.0;  ///< height of corners 0 and 2 above it (1 and 3 below) [m]
};

/// The distinct corners of a shell: a quad of which two neighbours are one node is a triangle.
/// `corners` is below 3 when too few are left.
ReferenceShape distinct_corners(const Shell& shell);

/// |d1 × d2|/2 of the diagonals; of a triangle its area. [m^2]
double reference_area(const Shell& shell, const std::array<Vec3, 4>& x);

/// Lays a shell flat on axes that turn by AOPT and BETA of its material (side 0-1 for any other
/// card).
///
/// @param fault  what is wrong with the shape, in the user's words: no area, a corner that points
/// inward,
///               material axes that are normal to it; empty when nothing is
ReferenceShape lay_flat(const Shell& shell, const std::array<Vec3, 4>& x, const MaterialCard& card,
                        std::string& fault);

}  // namespace corpuscle::fabric
