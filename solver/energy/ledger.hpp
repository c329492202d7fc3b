// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"
#include "solver/records.hpp"

namespace corpuscle {

/// Energy that has been moved up to some half step: sums of force · v_mid · span, exact for a
/// leapfrog (the kinetic energy changes by precisely that). [J]
struct Moved {
    double kinetic = 0;    ///< not a sum: kinetic energy at the half step
    double contact = 0;    ///< into contact: stored there or damped away
    double friction = 0,   ///< lost by friction, in contact and at walls
        damping = 0;       ///< lost by damping of materials, parts and the whole scene
    double ambient = 0;    ///< against the atmosphere
    double external = 0;   ///< by loads and prescribed motions, into the scene
    double smoothing = 0;  ///< by gas impulse on the fabric (leaves the smoothing account)
};

/// Energy books of a run.
///
///     start + inflow + external = kinetic + strain + gas + smoothing + contact + friction +
///     damping
///                                 + ambient + outflow + residual
///
/// Positions and forces live at t, velocities half a step before and after: what has been moved up
/// to t is the mean of the two half steps.
class Ledger {
public:
    Moved before,         ///< up to t - dt_last/2
        after;            ///< up to t + dt/2
    double weight = 0.5;  ///< of `after` at t: dt_last / (dt_last + dt)                        [-]

    /// What is where at t: strain, gas, inflow and outflow are the instant's own, of damping what
    /// loops of loading have lost, of friction what joints have.
    [[nodiscard]] EnergyBooks balance(const EnergyBooks& instant) const;

    /// Fixes what there is at the start; everything later is compared with it.
    void open(const EnergyBooks& instant) { start_ = balance(instant).total; }

    /// The next step's kick begins where the last ended.
    void commit() { before = after; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(before, after, weight, start_);
    }

private:
    double start_ = 0.0;
};

}  // namespace corpuscle
