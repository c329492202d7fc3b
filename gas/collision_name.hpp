// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gas/collide.hpp"

namespace corpuscle::gas {

/// The model that a user calls `name` ("lin", "pairs", ...; case does not count); none: unknown.
std::optional<CollisionModel> collision_model(std::string_view name);

/// What a user calls the model.
std::string_view name_of(CollisionModel model);

/// All names, for messages: "lin, pairs, ...".
std::string collision_names();

}  // namespace corpuscle::gas
