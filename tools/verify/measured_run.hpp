// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "solver/base/vec.hpp"
#include "tools/verify/card.hpp"
#include "tools/verify/statistics.hpp"

namespace corpuscle::verify {

/// A finished run of a deck, as its results.h5 tells.
class MeasuredRun {
public:
    /// @param folder  of the results
    MeasuredRun(const std::filesystem::path& folder, const LevelCard& level, double cpu_seconds);

    /// All numbers of a dataset, row after row. @throws SystemError if the results lack it
    [[nodiscard]] std::vector<double> read(const std::string& path) const;
    [[nodiscard]] std::vector<Vec3> vectors(const std::string& path) const;
    [[nodiscard]] bool has(const std::string& path) const { return results_->has(path); }
    [[nodiscard]] std::vector<std::string> names(const std::string& path) const {
        return results_->names(path);
    }
    [[nodiscard]] std::vector<double> time() const { return read("/history/time"); }
    /// A history at `time`, linear between samples.
    [[nodiscard]] double at(const std::string& path, double time) const;
    [[nodiscard]] double last(const std::string& path) const { return read(path).back(); }
    /// Mean of the samples with from < time <= to; those of a part's pressure are means already.
    [[nodiscard]] double mean(const std::string& path, double from, double to) const;
    /// Names of the frames in order, "/frames/00000/" first.
    [[nodiscard]] std::vector<std::string> frames() const;
    /// -D value of the level. @throws SystemError if it sets none
    [[nodiscard]] double parameter(const std::string& name) const;
    [[nodiscard]] std::filesystem::path file() const { return folder_ / "results.h5"; }

    [[nodiscard]] double cpu_seconds() const { return cpu_seconds_; }
    [[nodiscard]] double steps() const;           ///< of run.json
    [[nodiscard]] double particle_steps() const;  ///< steps times particles, their mean in time

private:
    std::filesystem::path folder_;
    const LevelCard* level_;
    double cpu_seconds_;
    std::unique_ptr<io::Hdf5Reader> results_;
};

/// Greatest relative change of a history from its first sample after `from`, until `to`.
[[nodiscard]] double greatest_change(const MeasuredRun& run, const std::string& path, double from,
                                     double to);

/// The runs of a level, which differ in their seeds.
using Runs = std::vector<MeasuredRun>;
/// Kolmogorov and Smirnov's distance of a gas's speeds in the last frames of all runs together from
/// Maxwell's distribution.
/// @param species  as in frames
[[nodiscard]] Estimate maxwell_distance(const Runs& runs, int species, double T, double molar_mass);

/// Errors by the names of quantities; signed where their sign tells.
using Findings = std::map<std::string, Estimate>;

/// Each quantity's mean over the runs, with its interval.
[[nodiscard]] Findings by_run(
    const Runs& runs, const std::function<std::map<std::string, double>(const MeasuredRun&)>& of);

}  // namespace corpuscle::verify
