// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

/// What both ways of computing LIN (collide_lin.cpp, lin_lanes.cpp) share.
namespace corpuscle::gas::lin {

/// Share of the stress that is turned round: less leaves more viscosity, 1 would leave none and be
/// unstable.
inline constexpr double BETA = 0.95;
/// sqrt(1 - β²): keeps thermal fluctuations of the stress.
inline constexpr double NOISE = 0.31224989991991992;
/// The least that a pressure may be turned to, as the cube root of its share in the mean.
inline constexpr double LEAST_TURNED = 0.1;
/// Of a matrix's trace: with smaller pivots its inverse would magnify rounding beyond 1e-10 of a
/// group's energy.
inline constexpr double FLATTEST = 1e-6;
/// Degrees of freedom along each axis that a mean velocity and its gradient take.
inline constexpr double FITTED = 4.0;

}  // namespace corpuscle::gas::lin
