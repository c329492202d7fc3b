// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/scene/scene_state.hpp"

/// What stops a run: PhysicsError with the time, the first or worst offender, and the reason.
namespace corpuscle {

/// For a shell whose strain is not finite.
[[noreturn]] void stop_for_strain(const SceneState& scene, Index shell);
/// Where the kinetic energy after the kick is not finite.
void check_finite(const SceneState& scene);
/// Whether time, places, velocities and all of the particles are finite: a state to go on from.
[[nodiscard]] bool is_finite(const SceneState& scene);
/// Where an account of the energy balance is not finite.
void check_accounts(const SceneState& scene);
/// Where gas has given the fabric more energy than it ever had. Once the step's fabric has moved: fabric that goes too far is
/// told first.
void check_given(const SceneState& scene);
/// Where the step has become too long for the fabric. Once in a step, with its forces.
void check_growth(SceneState& scene, double span);

}  // namespace corpuscle
