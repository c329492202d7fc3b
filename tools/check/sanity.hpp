// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace corpuscle {
class Simulation;
}

namespace corpuscle::tools {

/// What a person can judge of a scene, in everyday units where the deck's are known.
struct Sanity {
    std::vector<std::string> lines;     ///< cloth, volumes, gas, pressure, strain
    std::vector<std::string> warnings;  ///< numbers that are absurd for their unit system
};

/// Cloth: mass and area, without stress. Of each bag: volume now and, by an estimate, full; gas, its energy and the
/// pressure that it would have in that volume; strain of the cloth by that pressure.
///
///     V_full = 0.0774 A^(3/2)   two flat discs of area A in all, inflated (Mylar balloon)
///     p      = (g - 1) (H - p_atm (V_full - V)) / V_full,   H: what flows in, and what is inside
///     strain = p r / (2 E h),   4/3 pi r³ = V_full
///
/// Cloth that starts stretched beyond what it bears, or whose reference geometry is far larger than
/// the mesh, is warned of. Nothing leaves here, so p is what vents are there to keep away. Cloth that
/// folds have brought below 0.95 of its flat area is named if it resists compression: then what the
/// bag exerts as it unfolds depends on the mesh.
Sanity sanity_of(const Simulation& simulation);

}  // namespace corpuscle::tools
