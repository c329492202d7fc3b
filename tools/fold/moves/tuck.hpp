// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::fold {

/// Pushes a side of the flat bag in between its two panels.
///
/// Coordinates as for an Accordion; the panels lie at z = ±g/2, the seam at z = 0. Beyond line s_1
/// the bag is mirrored and keeps its heights; before it the panels are opened to let it in:
///
///     z' = λ(s) z      λ = 1 | 1 .. 3 | 3   | 3 .. 2 | 2 .. 1 | 1
///     s from           -∞    | r_0    | r_1 | s_1-h  | s_1    | s_1+h       bands of width h
///     s' = s - D up to the band, 2 s_1 - s - D beyond it; t' narrows towards the end of what was
///     pushed in
///
/// so all heights are multiples of the flat bag's, 1 inside 3, and what is sewn at the rim stays
/// sewn. On the ramp from r_0 to r_1, which ends before the edge of what was pushed in, s is drawn
/// together by what the panels climb, D in all; in the band by d as in an Accordion: nothing that
/// lies flat is stretched.
struct Tuck {
    double angle = 0.0;    ///< of the direction s in the plan              [rad]
    bool is_left = false;  ///< pushes what lies towards -s
    double line = 0.0;     ///< s_1                                        [m]
    double band = 0.0;     ///< h; 0 until it is chosen                    [m]
    double ramp = 0.0;     ///< r_1 - r_0                                  [m]
    double top = 0.0;      ///< r_1                                        [m]
    double room = -INF;    ///< the ramp begins beyond this place          [m]
    std::string name;      ///< for messages: "fold 2 (tuck)"
};

/// Chooses band and ramp for cloth that lies at x.
/// @throws InputError if the line misses the cloth, what it turns is too narrow or too deep for the
/// bag, or there are more than two layers
void choose_bands(Tuck& tuck, const Points& x, double gap, double size);

/// Folds: moves all nodes. @throws InputError if there are more than two layers
void apply(const Tuck& tuck, double gap, Points& x);

[[nodiscard]] std::vector<double> distance(const Tuck& tuck, double at, const Points& x);
[[nodiscard]] std::vector<double> borders(const Tuck& tuck, int parts);
[[nodiscard]] bool is_turned(const Tuck& tuck, const Vec3& x);
[[nodiscard]] std::vector<double> before(const Tuck& tuck, double gap, double after);

}  // namespace corpuscle::fold
