// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

/// @file
/// What the deck says of contact, sets expanded to rows.

namespace corpuscle::contact {

/// *CONTACT_..._SINGLE_SURFACE, _SURFACE_TO_SURFACE, _NODES_TO_SURFACE: pairs of surfaces, and
/// how. Which of several cards holds for a pair of parts is told in rules.hpp.
struct ContactCard {
    /// Which nodes and facets the card checks against each other.
    enum class Kind {
        SINGLE_SURFACE,      ///< the parts against each other and themselves
        SURFACE_TO_SURFACE,  ///< the parts against the other parts
        NODES_TO_SURFACE     ///< the nodes of the parts against the facets of the other parts
    };
    int id = 0;                        ///< CID, else order in the deck from 1
    std::string title;                 ///< from the deck, may be empty
    Kind kind = Kind::SINGLE_SURFACE;  ///< by the keyword
    std::vector<Index> parts;          ///< SURFA: part rows (all: every part)
    std::vector<Index> other_parts;    ///< SURFB: part rows; none for a single surface
    double friction_static = 0.0;      ///< FS  [-]
    double friction_dynamic = 0.0;     ///< FD  [-]
    double friction_decay = 0.0;       ///< DC  [s/m]
    double damping = 20.0;             ///< VDC, of critical; blank in a deck: 0  [%]
    double thickness = NaN;            ///< SAST: contact thickness; NaN: that of the section  [m]
    double other_thickness = NaN;      ///< SBST: likewise, of `other_parts`  [m]
    Index thickness_curve = -1;        ///< LCIDAB: curve row, thickness over time
    double birth = 0.0;                ///< BT  [s]
    double death = INF;                ///< DT  [s]

    /// Friction coefficient at a sliding speed.                                             [-]
    [[nodiscard]] double mu(double speed) const {
        if (friction_static == friction_dynamic) return friction_dynamic;
        return friction_dynamic +
               (friction_static - friction_dynamic) * std::exp(-friction_decay * speed);
    }
    /// Its greatest.                                                                        [-]
    [[nodiscard]] double greatest_mu() const { return std::max(friction_static, friction_dynamic); }
};

}  // namespace corpuscle::contact
