// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "solver/base/vec.hpp"
#include "solver/scene/scene_state.hpp"

/// Time of one thread that checks take, by the loops that they are part of: with the check and
/// without it, in turn, on the numbers of a run.
namespace corpuscle::benchmark {

[[nodiscard]] double thread_seconds();   ///< that this thread has run                          [s]
[[nodiscard]] double process_seconds();  ///< that all threads have run                         [s]

/// Of one step of a scene: is all that its phases wrote finite?
class FiniteCosts {
public:
    explicit FiniteCosts(const SceneState& scene);

    /// Adds those of the step that the scene is in.
    void measure(const SceneState& scene);

    double bounds = 0.0;  ///< of displacements, 0 · (v_x + v_y + v_z) added           [s]
    double starts = 0.0;  ///< of flights near fabric, as if all were near it          [s]
    double nodes = 0.0;   ///< forces gathered from shells, added up                   [s]
    double stops = 0.0;   ///< kinetic energy and accounts (solver/stops.hpp)          [s]
    [[nodiscard]] double sum() const { return bounds + starts + nodes + stops; }  ///< [s]

private:
    std::vector<std::size_t> places_, starts_;  ///< corners of each node, in compressed rows
    Points corner_force_, force_;               ///< by corner; by node                    [N]
};

/// Of writing datasets to HDF5 with Fletcher32, beyond what it takes without.                [s]
/// @param sizes  of the datasets, one chunk each                                      [byte]
[[nodiscard]] double cost_of_fletcher(std::span<const std::size_t> sizes);

/// Sizes of all datasets below a group of a results file.                               [byte]
[[nodiscard]] std::vector<std::size_t> dataset_sizes(const std::filesystem::path& results,
                                                     const std::string& group);

}  // namespace corpuscle::benchmark
