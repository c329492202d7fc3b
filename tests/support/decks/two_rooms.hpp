// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tests/support/decks/box_deck.hpp"
#include "tests/support/gas/air.hpp"
#include "tools/verify/exact/stirred_tank.hpp"

/// Decks of a rigid box of 0.1 m that a closed membrane at x = 0.05 m parts into rooms A and B of
/// air: A from x = 0, with a vent of 11.1 cm² in the middle of its far wall.
namespace corpuscle::test::rooms {

using namespace air;

constexpr double T_ATM = 300.0;
constexpr double ROOM = 5e-4;          ///< volume of a room                           [m^3]
constexpr double VENT = 0.01 / 9.0;    ///< its area                                   [m^2]
constexpr double WALLS = 0.03 - VENT;  ///< A's hull without vent and membrane         [m^2]
constexpr double FULL = 1e-3;          ///< all gas is in                              [s]
enum Part { WALL_A = 1, WALL_B = 2, MEMBRANE = 3, HOLE = 4 };

/// A room's gas as an oracle's tank.
inline oracle::StirredTank tank(double p, double T) {
    const double mass = density(p, T) * ROOM;
    return {{{MOLAR_MASS, MOLAR_CP, mass}}, mass * energy(T), ROOM};
}

/// kg/s through the vent of a tank.
inline double vent_flow(const oracle::StirredTank& tank, double C23) {
    return C23 * VENT *
           oracle::nozzle_flux(tank.pressure(), tank.temperature(), MOLAR_MASS, MOLAR_CP, P_ATM);
}

struct Gas {
    double p, T;
};

struct Scene {
    int particles = 20000;
    bool is_air_there = false;  ///< both rooms have particles at A's state from the start (IAIR 2)
    Gas a{5.0 * P_ATM, 300.0}, b{5.0 * P_ATM, 300.0};
    double C23 = 0.6, opens = 1.0;  ///< the vent's                                     [-], [s]
    double hconv_a = 0.0, hconv_b = 0.0;  ///< of the hulls                        [W/(m^2 K)]
    bool has_chambers = false;            ///< *DEFINE_CPM_CHAMBER 1 and 2
    double end = 10e-3;
};

/// What a room must take in, at h(T) = u(T0) a mass, to hold `full` where `start` is.
struct Filling {
    double mass, T0;
};
inline Filling filling(const Gas& start, const Gas& full) {
    const double there = start.p > 0.0 ? density(start.p, start.T) : 0.0;
    const double mass = density(full.p, full.T) - there;
    const double energy =
        density(full.p, full.T) * full.T - (start.p > 0.0 ? there * start.T : 0.0);
    return {mass * ROOM, mass > 0.0 ? energy / mass : T_ATM};
}

inline std::string deck(const Scene& scene) {
    BoxDeck box;
    box.size = {0.1, 0.1, 0.1};
    box.cells = {6, 6, 6};
    box.membranes = {{3, MEMBRANE}};
    box.part = [](const Vec3& x) {
        const bool is_hole =
            x.x() < 1e-9 && std::abs(x.y() - 0.05) < 0.0166 && std::abs(x.z() - 0.05) < 0.0166;
        return is_hole ? HOLE : x.x() < 0.05 ? WALL_A : WALL_B;
    };
    std::string cards;
    for (const int part : {WALL_A, WALL_B, MEMBRANE, HOLE}) cards += part_card(part, 1);
    cards += section_card(1, 1e-3) + "*MAT_NULL\n1, 1000.0\n";
    cards += set_card(12, {WALL_A, WALL_B, MEMBRANE, HOLE});
    cards += node_card(100001, {0.025, 0.05, 0.05}) + node_card(100002, {0.075, 0.05, 0.05});
    if (scene.has_chambers)
        cards += set_card(21, {WALL_A, HOLE, MEMBRANE}) + set_card(22, {WALL_B, MEMBRANE}) +
                 "*DEFINE_CPM_CHAMBER\n5, 2\n21, 0, 0, 1\n22, 0, 0, 2\n";

    const Gas none{0.0, 0.0};
    const Filling a = filling(scene.is_air_there ? scene.a : none, scene.a);
    const Filling b = filling(scene.is_air_there ? scene.a : none, scene.b);
    std::string gases, nozzles;
    int count = 0;
    const auto inflow = [&](int room, const Filling& in) {
        if (in.mass <= 0.0) return;
        ++count;
        gases += fmt::format("{0}, {1}, {2}, {3}, 0, 0, {4}\n", 30 + room, 40 + room, MOLAR_MASS,
                             MOLAR_CP, room);
        nozzles += fmt::format("{}, 1.0, 0, 0, {}\n", 100000 + room, room);
        cards += curve_card(30 + room, {{0.0, in.mass / FULL}, {FULL, in.mass / FULL}});
        cards += curve_card(40 + room, {{0.0, in.T0 / GAMMA}, {1.0, in.T0 / GAMMA}});
    };
    inflow(1, a);
    inflow(2, b);
    cards += step_card(3, scene.opens, 1.0);
    std::string heat;
    int heated = 0;
    for (const auto& [part, h] :
         {std::pair(WALL_A, scene.hconv_a), std::pair(WALL_B, scene.hconv_b)})
        if (h > 0.0) {
            ++heated;
            heat += fmt::format("{}, 0, {}\n", static_cast<int>(part), h);
        }
    cards += fmt::format(
        "*AIRBAG_PARTICLE\n12, 1, 3, 0, 0, {}\n{}, 1, 3, {}, {}, 1\n{}, {}, {}, 0, 0, 0, {}\n{}"
        "{}, 0, {}, 3, 0, 1\n",
        heated, scene.particles, T_ATM, P_ATM, scene.is_air_there ? 2 : 0, count, count,
        scene.has_chambers ? 5 : 0, heat, static_cast<int>(HOLE), scene.C23);
    if (scene.is_air_there)
        cards += fmt::format("{}, {}, {}, {}\n", scene.a.p, scene.a.T, MOLAR_MASS, MOLAR_CP);
    return box_deck("two rooms", box, cards + gases + nozzles, scene.end, 5e-5);
}

}  // namespace corpuscle::test::rooms
