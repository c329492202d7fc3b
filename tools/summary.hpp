// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

#include "solver/base/loop_observer.hpp"
#include "solver/simulation.hpp"

namespace corpuscle::tools {

/// Pairs of shells that began crossing, or nearer than contact lets them be, by ids; nothing where
/// there are none.
void print_bad_starts(const Simulation& simulation);

/// What residuals are measured by: energy that came with the gas, by loads and supports and as
/// motion at the start; at least a millionth of all there is, where nothing came. [J]
[[nodiscard]] double brought_in(const EnergyBooks& now, double start_kinetic);

/// What a run ends with: wall time by phase, speeds, ledger, what was left out.
class Summary {
public:
    /// @param worst_residual  of all samples                                            [J]
    /// @param brought         brought_in() at the end                                   [J]
    void print(Simulation& simulation, const std::string& folder, double worst_residual,
               double brought) const;
    /// FOLDER/run.json: wall time, phases, steps, what contact had to stop, warnings; for the
    /// report.
    void write(const Simulation& simulation, const std::string& folder) const;

private:
    [[nodiscard]] double wall() const;
    parallel::LoopClock loops_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace corpuscle::tools
