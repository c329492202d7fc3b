// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// One shell of the deck. A triangle repeats its 3rd node.
struct Shell {
    int id = 0;                    ///< the deck's number, for messages and results
    Index part = -1;               ///< row among the parts
    std::array<Index, 4> nodes{};  ///< node rows, in turn round it; its normal is the right hand's

    /// A triangle repeats its third node.
    [[nodiscard]] bool is_triangle() const { return nodes[2] == nodes[3]; }
};

/// *PART with its *SECTION_SHELL.
struct Part {
    int id = 0;                      ///< the deck's number, for messages and results
    std::string title;               ///< for messages and results
    Index material = -1;             ///< row among the materials
    double thickness = NaN;          ///< mean of T1-T4 [m]
    double contact_thickness = NaN;  ///< OPTT; NaN: the thickness [m]
    int element_form = 5;  ///< ELFORM: 9 fully integrated quads, any other: one-point quads
};

}  // namespace corpuscle
