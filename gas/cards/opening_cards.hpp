// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gas/cards/leak_law.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"

/// @file
/// What the deck says of the ways out of a bag, for gas and for heat.

namespace corpuscle::gas {

/// One vent: NVENT row of *AIRBAG_PARTICLE, or *DEFINE_CPM_VENT.
struct VentCard {
    std::vector<Index> parts;     ///< part rows whose shells are the hole
    double coefficient = 1.0;     ///< C23; above 1: a larger area                           [-]
    Index time_curve = -1;        ///< LCTC23: factor over time                              [-]
    Index pressure_curve = -1;    ///< LCPC23: factor over the bag's absolute pressure       [-]
    bool is_isentropic = false;   ///< ENH_V >= 1: Wang-Nefske flow; else free passage
    double opens_at = 0.0;        ///< PPOP: gauge pressure that opens it, for good          [Pa]
    double uniform_factor = 1.0;  ///< C23UP: on C23 once the pressure is uniform (TSW)      [-]
};

/// Fabric that leaks: FLC, FAC, X0-X3 of *MAT_FABRIC, for one part.
struct LeakCard {
    Index part = -1;                  ///< part row
    double area = 0.0;                ///< FLC: share of the area that leaks                     [-]
    Index area_curve = -1;            ///< FLC < 0: over time
    LeakLaw law = LeakLaw::VELOCITY;  ///< what FAC is
    double velocity = 0.0;            ///< FAC                                 [m/s], [-] or [s/m]
    Index velocity_curve = -1;        ///< FAC < 0: over absolute pressure
    bool by_component = false;        ///< that pressure is the gas component's own (2007)
    double when_blocked = 0.0;        ///< ELA: share of the leak that blocked fabric keeps      [-]
    bool from_reference = false;      ///< A0REF = 1: area of the reference shape counts
    /// X0-X3: A_leak = A0 (X0 + X1 rs + X2 rp + X3 rs rp), with Wang-Nefske flow through it.
    std::optional<std::array<double, 4>> growth;
};

/// Heat through a part: HCONV (T - TATM) per area.
struct HeatCard {
    std::vector<Index> parts;  ///< part rows that lose heat
    double coefficient = 0.0;  ///< HCONV: heat transfer coefficient  [W/(m^2 K)]
    Index curve = -1;          ///< HCONV < 0: over time
};

/// BLOCK of *AIRBAG_PARTICLE: what touching does to holes.
struct BlockCard {
    bool fabric = false;          ///< N = 1-4: a touching node takes its share of porous area
    bool external_vents = false;  ///< N = 1, 3: and of external vents
    bool internal_vents = false;  ///< N = 1, 2: and of internal ones

    bool by_pressure = false;  ///< M = 2: external vents, where contact presses more than the gas

    /// Whether touching closes anything.
    [[nodiscard]] bool any() const {
        return fabric || external_vents || internal_vents || by_pressure;
    }
};

}  // namespace corpuscle::gas
