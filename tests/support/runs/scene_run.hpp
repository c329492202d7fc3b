// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace corpuscle::test {

/// Seeds of scenes, first and last.
struct SceneRange {
    int first = 1, last = 100;

    /// Of CORPUSCLE_SCENES in the environment, "31-93", or "500" for 1 to 500; 1 to 100 without it.
    /// @throws std::runtime_error where it is neither
    [[nodiscard]] static SceneRange asked();
};

/// One run of the program on a deck, in a directory of its own that goes when this does, unless
/// KEEP names a folder that they shall stay in.
class SceneRun {
public:
    /// @param name     of the directory
    /// @param options  of `corpuscle run`, e.g. "--seed 3"
    /// @param how      with one thread; two; or one, killed at its first checkpoint and restarted
    enum class How { ONE_THREAD, TWO_THREADS, RESTARTED };
    SceneRun(const std::string& name, const std::string& deck, const std::string& options,
             How how = How::ONE_THREAD);
    ~SceneRun();
    SceneRun(const SceneRun&) = delete;
    SceneRun& operator=(const SceneRun&) = delete;

    int status = -1;              ///< the program's exit status; 128 + the signal that killed it
    double seconds = 0.0;         ///< by the clock
    std::string end;              ///< the line that says why, of a run that failed
    std::size_t numbers = 0;      ///< in results.h5
    std::uint64_t digest = 0;     ///< of all numbers in results.h5 and their paths
    std::size_t crossings = 0;    ///< of triangles, exactly, in all frames
    std::string not_finite;       ///< the first dataset with a number that is not; empty: all are
    std::string impossible;       ///< the same: a mass below 0, or mass without a temperature
    double worst_residual = 0.0;  ///< of the energies                                       [J]
    double under_way = 0.0;       ///< most that was between particles and fabric            [J]
    double brought_in = 0.0;      ///< by inflators and from outside                         [J]
    double held = 0.0;            ///< by the gas at the start                               [J]
    double strained = 0.0;        ///< the cloth's at the start                              [J]
    int lost = -1;                ///< particles; -1: the log does not say

    [[nodiscard]] std::filesystem::path results() const { return directory_ / "out/results.h5"; }

    /// What it has done wrong, in words; empty: nothing.
    /// @param residual  of the energy books, that may be                                    [J]
    [[nodiscard]] std::string fault(double residual) const;

    /// The same once more in another way: in words, whether the bits are others.
    /// @param steps  between the checkpoints of a run that is killed and restarted
    [[nodiscard]] std::string differences(How how, int steps) const;

private:
    void read();
    std::string name_, deck_, options_;
    std::filesystem::path directory_;
};

}  // namespace corpuscle::test
