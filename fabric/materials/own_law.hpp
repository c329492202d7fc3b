// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "fabric/materials/plane_stress.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// A law that the library does not have: derive from it, and give a material an OwnCard.
///
///     S = stress(E),   S = dw/dE,   w(0) = 0
///
/// Called once a point and step, by several threads at once: a pure function, NaN in gives NaN
/// out. A law that is called millions of times a second is better written as Linear is, in the
/// library, for several elements at once.
class OwnLaw {
public:
    virtual ~OwnLaw() = default;

    /// Stiffness at rest; from it come time step, damping and hourglass control.             [Pa]
    [[nodiscard]] virtual PlaneModuli moduli() const = 0;

    /// Stress and stored energy of the reference volume, by Green strain on warp and weft.
    [[nodiscard]] virtual Stress<double> stress(const Strain<double>& e) const = 0;

    /// How much stiffer than moduli() the sheet may be in space at this strain, >= 1: the stable
    /// step shrinks with its root. By default that of a linear law (stretch.hpp).               [-]
    [[nodiscard]] virtual double stiffening(const Strain<double>& e) const;
};

/// Material of an OwnLaw; warp runs along the shell's first side.
struct OwnCard {
    double density = NaN;               ///< [kg/m^3]
    std::shared_ptr<const OwnLaw> law;  ///< shared by all that copies the card
    double damping = 0.0;               ///< share of critical, on the strain rate            [-]
};

}  // namespace corpuscle::fabric
