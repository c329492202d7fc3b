// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle::gas {

/// Integral over time of what is told at the end of each step.
struct TimeIntegral {
    double sum = 0.0;    ///< since it was last taken
    double until = 0.0;  ///< time up to which it goes                                          [s]

    /// `value` over the time up to t.
    void add(double t, double value) {
        sum += value * (t - until);
        until = t;
    }
    /// Mean over the time `since` it was last taken; of no time `now`. Begins anew.
    [[nodiscard]] double take_mean(double since, double now) {
        const double mean = since > 0.0 ? sum / since : now;
        sum = 0.0;
        return mean;
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(sum, until);
    }
};

/// Mass and energy that have crossed a bag's boundary so far.
struct GasBalance {
    double load_work = 0.0;      ///< of what hits brought, on the fabric             [J]
    double ambient_work = 0.0;   ///< of the walls against the atmosphere             [J]
    double inflow_energy = 0.0;  ///< [J]
    double lost_energy = 0.0;    ///< with what left, and as heat                     [J]
    double mass_in = 0.0;        ///< [kg]

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(load_work, ambient_work, inflow_energy, lost_energy, mass_in);
    }
};

}  // namespace corpuscle::gas
