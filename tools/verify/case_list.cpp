// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/case_list.hpp"

#include <fmt/format.h>

#include "solver/base/error.hpp"

namespace corpuscle::verify {

Method method_of(const Card& card) {
    static const std::map<std::string, Method> ALL{
        {"air_in_rooms", air_in_rooms},
        {"box_at_rest", box_at_rest},
        {"closed_membrane", closed_membrane},
        {"effusion", effusion},
        {"far_vent", far_vent},
        {"fast_piston", fast_piston},
        {"flying_box", flying_box},
        {"folded_bag", folded_bag},
        {"helium_air", helium_air},
        {"pendulum", pendulum},
        {"tennis_racket", tennis_racket},
        {"damped_sheet", damped_sheet},
        {"plane_wave", plane_wave},
        {"string", taut_string},
        {"piston_wave", piston_wave},
        {"porous_tank", porous_tank},
        {"porous_tube", porous_tube},
        {"rebound", rebound},
        {"rubbing_sheet", rubbing_sheet},
        {"sliding_sheet", sliding_sheet},
        {"slow_piston", slow_piston},
        {"sliding_block", sliding_block},
        {"sod", sod},
        {"stack", stack},
        {"tank_test", tank_test},
        {"two_inflators", two_inflators},
        {"vacuum", vacuum},
        {"vent_by_chamber", vent_by_chamber},
        {"vented_bag", vented_bag},
        {"vented_tank", vented_tank},
        {"hencky", hencky},
        {"mylar", mylar},
        {"square_bag", square_bag},
        {"tube_vessel", tube_vessel},
        {"sphere_vessel", sphere_vessel},
        {"patch", patch},
        {"seeping_wall", seeping_wall},
        {"shear_wave", shear_wave},
        {"ball_on_disc", ball_on_disc},
        {"capstan", capstan},
        {"cooling", cooling},
        {"free_jet", free_jet},
        {"jet_on_plate", jet_on_plate},
        {"mixing_chambers", mixing_chambers},
        {"plate_on_gas", plate_on_gas},
        {"spinning_bag", spinning_bag},
        {"spinning_box", spinning_box},
        {"standing_wave", standing_wave},
        {"uniform_tank", uniform_tank},
    };
    const auto found = ALL.find(card.method);
    if (found == ALL.end())
        throw InputError(
            fmt::format("{}/case.toml: no code compares by method {}", card.name, card.method));
    return found->second;
}

}  // namespace corpuscle::verify
