// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "tests/support/decks/heavy_sheet.hpp"
#include "tests/support/gas/air.hpp"
#include "tools/verify/exact/euler_1d.hpp"

/// Decks of a shock tube 1 x 0.1 x 0.1 m: gas at rest on both sides of a membrane at x = 0.5 m that
/// passes all gas from OPENS on. SI units.
namespace corpuscle::test::shock_tube {

constexpr double FULL = 1e-3, OPENS = 3e-3;  ///< all gas is in; the valve opens             [s]
enum Part { WALL = 1, MEMBRANE = 2, SHEET = 3 };

struct Tube {
    double p_left, T_left, p_right, T_right;  ///< [Pa], [K]
    int particles;
    double lasts;                     ///< after the valve has opened               [s]
    double molar_cp = air::MOLAR_CP;  ///< [J/(mol K)]
    double p_outside = air::P_ATM;
    bool shows_particles = false;
    double frames = 1e-4;  ///< time between them; 0: start and end only
    double sample = 1e-4;  ///< time between rows of histories
};

/// @param has_sheet  the wall at z = 0.1 m is a heavy free sheet
inline BoxDeck box(bool has_sheet) {
    BoxDeck made;
    made.size = {1.0, 0.1, 0.1};
    made.cells = {60, 6, 6};
    made.membranes = {{30, MEMBRANE}};
    made.part = [has_sheet](const Vec3& x) {
        return has_sheet && x.z() > 0.1 - 1e-9 ? SHEET : WALL;
    };
    if (has_sheet) made.is_free = sheet::is_free(made.size, 0.5);
    return made;
}

/// Both gases as a Riemann problem has them.
inline std::pair<oracle::Gas1D, oracle::Gas1D> gases(const Tube& tube) {
    return {{air::density(tube.p_left, tube.T_left), 0.0, tube.p_left},
            {air::density(tube.p_right, tube.T_right), 0.0, tube.p_right}};
}

/// Sensors 1, 2, ... of the gas in slabs of one element's length, right of the membrane in order.
inline std::string sensor_cards(const BoxDeck& box) {
    const DeckMesh mesh = box.mesh();
    const auto id = [&](const Vec3& x) {
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
            if ((mesh.nodes[n] - x).norm() < 1e-9) return n + 1;
        throw std::logic_error("the sheet has no such node");
    };
    std::string segments = "*SET_SEGMENT\n1\n";
    const double edge = box.size.x() / box.cells[0], across = box.size.y() / box.cells[1];
    for (int i = box.cells[0] / 2; i < box.cells[0]; ++i) {
        const double x = edge * i, y = across, end = box.size.y() - across, z = box.size.z();
        segments += fmt::format("{}, {}, {}, {}\n", id({x, y, z}), id({x + edge, y, z}),
                                id({x + edge, end, z}), id({x, end, z}));
    }
    return segments + fmt::format("*DATABASE_CPM_SENSOR\n0,\n1, {}, {:.9g}, {}, {}\n",
                                  -0.5 * box.size.z(), edge, box.size.y(), box.size.z());
}

/// The right gas fills the tube as initial air; what the left has more comes in evenly from 15 x 3
/// x 3 orifices on the left, and has come to rest when the valve opens.
inline std::string deck(const Tube& tube, const BoxDeck& box) {
    const bool has_sheet = static_cast<bool>(box.is_free);
    std::string cards = part_card(WALL, 1) + part_card(MEMBRANE, 3);
    if (has_sheet) cards += part_card(SHEET, 2);
    cards += section_card(1, sheet::THICKNESS);
    cards += set_card(
        12, has_sheet ? std::vector<int>{WALL, MEMBRANE, SHEET} : std::vector<int>{WALL, MEMBRANE});
    cards += "*MAT_NULL\n1, 1000.0\n";
    if (has_sheet) cards += fmt::format("*MAT_NULL\n2, {}\n", sheet::DENSITY);
    cards += "*MAT_FABRIC\n3, 1000.0, 1.0e9\n,\n, -5, -6, , , , 7\n,\n,\n";

    const double R = GAS_CONSTANT, M = air::MOLAR_MASS, cp = tube.molar_cp;
    const double there = tube.p_right / tube.T_right, full = tube.p_left / tube.T_left;
    const double mass = (full - there) * M / R * 0.5 * 0.01;
    const double T0 = (tube.p_left - tube.p_right) / (full - there);
    cards += curve_card(1, {{0.0, mass / FULL}, {FULL, mass / FULL}});
    const double T = T0 * (cp - R) / cp;
    cards += curve_card(2, {{0.0, T}, {1.0, T}});
    cards += step_card(5, OPENS, 1000.0) + curve_card(6, {{0.0, 1000.0}, {1.0, 1000.0}});
    std::string nozzles;
    int count = 0;
    for (int i = 0; i < 15; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) {
                const int id = 100001 + count++;
                cards += node_card(id, {(i + 0.5) / 30.0, (j + 0.5) / 30.0, (k + 0.5) / 30.0});
                nozzles += fmt::format("{}, 1.0\n", id);
            }
    cards += fmt::format(
        "*AIRBAG_PARTICLE\n12, 1, {}, 0\n{}, 1, {}, 300.0, {}\n2, 1, {}\n{}, {:.10g}, {}, {}\n"
        "1, 2, {}, {}\n",
        static_cast<int>(MEMBRANE), tube.particles, tube.shows_particles ? 1 : 3, tube.p_outside,
        count, tube.p_right, tube.T_right, M, cp, M, cp);
    cards += nozzles;
    if (has_sheet) cards += sensor_cards(box);
    if (tube.frames > 0.0) cards += fmt::format("*DATABASE_BINARY_D3PLOT\n{:.10g},\n", tube.frames);
    return box_deck("shock tube", box, cards, OPENS + tube.lasts, tube.sample);
}

}  // namespace corpuscle::test::shock_tube
