// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/verify/measured_run.hpp"

namespace corpuscle::verify {

/// What compares the runs of a level with the exact answer: one of the functions in
/// tools/verify/cases, by the card's `method`. @throws InputError where there is none
using Method = Findings (*)(const Runs&);
[[nodiscard]] Method method_of(const Card& card);

/// cases/boxes.cpp
Findings box_at_rest(const Runs&);
Findings helium_air(const Runs&);
Findings slow_piston(const Runs&);
Findings closed_membrane(const Runs&);
Findings two_inflators(const Runs&);
Findings tank_test(const Runs&);
Findings cooling(const Runs&);
/// cases/balloon.cpp
Findings vented_bag(const Runs&);
/// cases/bodies.cpp
Findings pendulum(const Runs&);
Findings sliding_block(const Runs&);
Findings tennis_racket(const Runs&);
/// cases/cloth.cpp
Findings taut_string(const Runs&);
Findings plane_wave(const Runs&);
Findings shear_wave(const Runs&);
Findings damped_sheet(const Runs&);
/// cases/contact.cpp
Findings stack(const Runs&);
Findings sliding_sheet(const Runs&);
Findings rubbing_sheet(const Runs&);
Findings rebound(const Runs&);
Findings folded_bag(const Runs&);
Findings capstan(const Runs&);
/// cases/flows.cpp
Findings sod(const Runs&);
Findings vacuum(const Runs&);
Findings fast_piston(const Runs&);
Findings piston_wave(const Runs&);
/// cases/leaks.cpp
Findings porous_tube(const Runs&);
/// cases/momenta.cpp
Findings spinning_bag(const Runs&);
Findings spinning_box(const Runs&);
Findings jet_on_plate(const Runs&);
Findings free_jet(const Runs&);
/// cases/oscillations.cpp
Findings plate_on_gas(const Runs&);
Findings standing_wave(const Runs&);
/// cases/outflow.cpp
Findings vented_tank(const Runs&);
Findings flying_box(const Runs&);
Findings effusion(const Runs&);
Findings porous_tank(const Runs&);
Findings vent_by_chamber(const Runs&);
Findings uniform_tank(const Runs&);
Findings far_vent(const Runs&);
Findings mixing_chambers(const Runs&);
/// cases/rooms.cpp
Findings seeping_wall(const Runs&);
Findings air_in_rooms(const Runs&);
/// cases/vessels.cpp
Findings hencky(const Runs&);
Findings ball_on_disc(const Runs&);
Findings mylar(const Runs&);
Findings square_bag(const Runs&);
Findings tube_vessel(const Runs&);
Findings sphere_vessel(const Runs&);
Findings patch(const Runs&);

}  // namespace corpuscle::verify
