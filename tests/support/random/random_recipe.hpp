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

/// What a small bag is to have, and the numbers of its parts.
struct SmallBag {
    bool has_cover, has_vents;
    int front, back, module, reinforcement, vent, tether;
};

/// One of a few hundred shells, of 0.22 to 0.34 m, for the place of an inflator in the middle of
/// the back: a dish or a cover of a hole, cloth that the recipe names, or none, in which case some
/// folds go over the back. Units: m.
[[nodiscard]] std::string random_small_recipe(unsigned seed, SmallBag kind);

}  // namespace corpuscle::support
