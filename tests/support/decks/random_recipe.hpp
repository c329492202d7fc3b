// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace corpuscle::support {

/// A recipe for `corpuscle fold` that a user might write: disc or rectangle of some 0.5 m, one to
/// three folds of any kind, along the axes or, with `is_oblique`, in any direction. Units: mm.
[[nodiscard]] std::string random_recipe(unsigned seed, bool is_oblique);

/// The same without holes and tethers: a side or both tucked in, then a fold across.
[[nodiscard]] std::string random_tuck_recipe(unsigned seed);

/// One that can be deployed: coarse, of 0.4 to 0.64 m, with an inflator's dish in the middle, which
/// stays where it is, one to three folds along the axes or one to two in any direction over the
/// front, vents and a tether in some.
[[nodiscard]] std::string random_airbag_recipe(unsigned seed);

}  // namespace corpuscle::support
