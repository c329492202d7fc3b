// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "fabric/materials/curved.hpp"
#include "fabric/materials/each_lane.hpp"
#include "fabric/materials/fabric_card.hpp"
#include "fabric/materials/isotropic_tension_field.hpp"
#include "fabric/materials/linear.hpp"
#include "fabric/materials/lined.hpp"
#include "fabric/materials/orthotropic_tension_field.hpp"
#include "fabric/materials/waiting_liner.hpp"

namespace corpuscle::fabric {

/// Every law that a block of elements can have: chosen once a part, never in a loop.
using Law = std::variant<Linear, IsotropicTensionField, OrthotropicTensionField, Lined<Linear>,
                         Lined<IsotropicTensionField>, Lined<OrthotropicTensionField>, Curved,
                         Looped, EachLane>;

struct PartLaw {
    Law law{Linear(PlaneModuli{})};
    double density = NaN;  ///< [kg/m^3]
    double damping = 0.0;  ///< share of critical at the element's highest frequency [-]
    std::optional<WaitingLiner> liner;  ///< LNRC = 1; any other is part of the law
    StrainRestoration restoration;
};

/// The law that a card asks for. *MAT_NULL and *MAT_RIGID have none: InputError, as for moduli that
/// are not positive or a Poisson's ratio for which the sheet would gain energy; each fault names
/// the material.
/// @param curves     that a card's rows mean
/// @param thickness  of the cloth, for a coat that stretches with it                       [m]
PartLaw make_law(const Material& material, std::span<const Curve> curves = {},
                 double thickness = NaN);

/// Stiffness of the layers that always take compression, over the cloth's thickness: the liner but
/// for one that waits (LNRC), and both coats (TCOAT > 0), of which no Poisson's ratio is known: 0.
PlaneModuli layer_moduli(const FabricCard& card, double thickness);

/// A curve of a card that cannot be, and what was expected of it.
struct CurveFault {
    std::size_t direction;  ///< 0 warp, 1 weft, 2 shear
    bool unloads;           ///< that of unloading, not of loading
    std::string expected;
};
std::vector<CurveFault> curve_faults(const FabricCard& card, std::span<const Curve> curves);

/// Density of any card.                                                  [kg/m^3]
double density(const MaterialCard& card);

}  // namespace corpuscle::fabric
