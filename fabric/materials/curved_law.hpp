// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "fabric/materials/law.hpp"

namespace corpuscle::fabric {

/// The law of a card with curves for which curve_faults() finds nothing.
/// @param layers  that stretch with the cloth and always take compression
Law curved_law(const FabricCard& card, std::span<const Curve> curves, const PlaneModuli& layers);

}  // namespace corpuscle::fabric
