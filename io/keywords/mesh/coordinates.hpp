// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/model/draft.hpp"

namespace corpuscle::io::keywords {

/// Local x, y, z of a *DEFINE_COORDINATE_... as columns, by its row; those of nodes as these lie at
/// the start, once *NODE_TRANSFORM has been read. Of a system that is a fault: the deck's axes.
Mat3 axes_at_start(const Draft& draft, Index system);

/// Local axis k as the mirror image of a file has it: its z = x × y is against that of the image,
/// and what turns about it does so the other way.
Vec3 local_axis(const FilePlace& file, int k, bool turns);

/// Gives rigid materials of CMO = -1 their axes, once all nodes are where they start.
void place_local_axes(Draft& draft);

}  // namespace corpuscle::io::keywords
