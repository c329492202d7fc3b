// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace corpuscle::gas {

/// How particles of a group trade momentum. All keep the group's mass, momentum and energy to
/// rounding.
enum class CollisionModel {
    PAIRS,  ///< each particle collides with one other, drawn at random: the plain kinetic picture
    LIN,  ///< the group's stress is over-relaxed by one linear map: sharper waves (collide_lin.cpp)
    NTC,  ///< as many pairs, near ones, as molecules of a mean free path make (collide_ntc.cpp)
    SPHERES,  ///< hard spheres that meet on their paths, as in the notes (collide_spheres.cpp)
};

/// Has the model a mean free path that may be chosen? The others' follows from cell and step.
constexpr bool has_mean_free_path(CollisionModel model) {
    return model == CollisionModel::NTC || model == CollisionModel::SPHERES;
}

/// Mean free path where none is asked for, in mean distances n^(-1/3) of particles. Spheres' own
/// volume adds a false pressure of 2 pi/3 n d³ = 0.224 (n^(-1/3) / mean free path)^1.5: 5 % at 2.7.
constexpr double default_free_path(CollisionModel model) {
    return model == CollisionModel::SPHERES ? 2.7 : 1.0;
}

/// The model that a user calls `name` ("lin", "pairs", ...; case does not count); none: unknown.
std::optional<CollisionModel> collision_model(std::string_view name);

/// What a user calls the model.
std::string_view name_of(CollisionModel model);

/// All names, for messages: "lin, pairs, ...".
std::string collision_names();

}  // namespace corpuscle::gas
