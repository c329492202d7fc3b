// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "solver/model.hpp"

namespace corpuscle {

/// Stress-free corners of every shell: its own reference geometry, or that of its nodes where all
/// of them have one, or where it lies at the start.                                   E × 4 [m]
std::vector<std::array<Vec3, 4>> reference_corners(const Model& model);

/// When the reference geometry of every shell begins to count: RGBRTH of its material, or the
/// latest BIRTH of its nodes' geometry. Until then it is without stress as it lies at the start.
/// Empty when all count from the start. E [s]
std::vector<double> reference_births(const Model& model);

/// @throws InputError  where births meet what they do not go with: DT2MS, TSRFAC
void check_births(const Model& model, const std::vector<double>& births);

/// `corners` of the shells that are born before `next`, the places at the start of all others.
/// @param next  the first birth that does not count yet                                     [s]
std::vector<std::array<Vec3, 4>> corners_before(double next, const std::vector<double>& births,
                                                const std::vector<std::array<Vec3, 4>>& corners,
                                                const Model& model);

/// Does an edge of an `active` shell differ by more than `least` from its length between `corners`?
/// @param active  E
bool is_strained(const Model& model, const std::vector<std::uint8_t>& active,
                 const std::vector<std::array<Vec3, 4>>& corners, double least);

/// The first birth after t; infinite when there is none.                                    [s]
double next_birth(double t, const std::vector<double>& births);

}  // namespace corpuscle
