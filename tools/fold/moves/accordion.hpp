// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::fold {

/// Folds about parallel lines, each strip turned over onto the one before: a half fold has one
/// line, a zigzag many, a roll is a half fold after the other.
///
/// Coordinates: s along the fold, t along its lines, z across the pack. Left of the first line
/// nothing moves. A strip keeps its shape: it is mirrored at its line, s' = 2 s_k - s, and lifted
/// onto what lies there. Beside line k two bands of width h_k turn the pack over,
///
///     l  = (1-w) h + w (d + k (u - u_a)),    w = 1 - |s - s_k| / h     distance to the line's
///     place z' = (1-w) (its strip's height at u)  + w M                      M half-way up
///
/// with u the height in the pack. Each band is a convex quadrilateral in (s', z'), of which layers
/// are straight lines that never meet; bands lie within the heights of their strips. So a pack
/// whose layers do not cross is mapped into one whose layers do not, whatever was folded before.
/// The outermost layer keeps its length, d = h - sqrt(h² - R²), those inside become shorter: the
/// fold stretches nothing that lies flat.
struct Accordion {
    double angle = 0.0;         ///< of the direction s in the plan              [rad]
    bool is_left = false;       ///< folds what lies towards -s
    bool is_down = false;       ///< onto the back, -z
    std::vector<double> lines;  ///< s_k, ascending from the middle outwards     [m]
    std::vector<double> bands;  ///< h_k; empty until they are chosen            [m]
    double room = INF;          ///< for the first band, inwards of its line     [m]
    std::size_t needed = 1;     ///< lines that the cloth must reach             [-]
    std::string name;           ///< for messages: "fold 2 (zigzag)"
};

/// Where the strips of an accordion come to lie.
struct Heights {
    std::vector<double> offset;       ///< strip i: z' = offset + (-1)^i z                      [m]
    std::vector<double> middle;       ///< M of line i                                          [m]
    std::vector<double> low, high;    ///< range of u = (-1)^i z in the bands of line i         [m]
    std::vector<double> least, most;  ///< the same in the strips on both sides                 [m]

    /// R: how far the outermost layer climbs at line i. [m]
    [[nodiscard]] double climb(std::size_t i) const { return middle[i] - offset[i] - least[i]; }
};

/// @param x    nodes of the pack, N × 3                                                       [m]
/// @param gap  between layers that come to lie on each other                                  [m]
[[nodiscard]] Heights heights(const Accordion& fold, const Points& x, double gap);

/// Chooses bands: at least `size`, wide enough for the climb, no wider than the strips have room.
/// Lines that the cloth does not reach are dropped.
/// @throws InputError if a strip is too narrow for a pack that thick, or a needed line misses the
/// cloth
void choose_bands(Accordion& fold, const Points& x, double gap, double size);

/// Folds: moves all nodes. @throws InputError as choose_bands()
void apply(const Accordion& fold, double gap, Points& x);

/// Distance of every node from line `at`, positive outwards.                              [m]
[[nodiscard]] std::vector<double> distance(const Accordion& fold, double at, const Points& x);

/// Places across which no cell may reach: the lines and the borders of their bands, each band in
/// `parts` parts. [m]
[[nodiscard]] std::vector<double> borders(const Accordion& fold, int parts);

/// Whether the fold turns over what is at x, and the unit vector along s.
[[nodiscard]] bool is_turned(const Accordion& fold, const Vec3& x);
[[nodiscard]] Vec3 direction(const Accordion& fold);

/// (x, y, z) -> (s, t, z) with s towards the side that is folded and z the way it is folded; its
/// transpose leads back.
[[nodiscard]] Mat3 fold_frame(double angle, bool is_left, bool is_down);

/// Places s outside of all bends that the fold takes to `after`.
[[nodiscard]] std::vector<double> before(const Accordion& fold, double gap, double after);

/// Where the ideal fold, without thickness, takes place `s` of the strip i.
[[nodiscard]] double mirrored(const Accordion& fold, std::size_t strip, double s);

}  // namespace corpuscle::fold
