// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "io/deck_mesh.hpp"

namespace corpuscle::tools {

/// The one part without which all else is closed: it lies inside, as tethers do. 0: there is none.
[[nodiscard]] int inner_part(const io::DeckMesh& mesh);

/// Middle of a shell.
[[nodiscard]] Vec3 middle_of(const io::DeckMesh& mesh, std::size_t shell);

/// Does a place lie inside of what the mesh closes, `inner` left out?
[[nodiscard]] bool is_inside(const io::DeckMesh& mesh, int inner, const Vec3& at);

/// The place inside over a shell's middle, half the way to what lies opposite; none where the shell
/// has no inside.
[[nodiscard]] std::optional<Vec3> place_over(const io::DeckMesh& mesh, int inner,
                                             std::size_t shell);

}  // namespace corpuscle::tools
