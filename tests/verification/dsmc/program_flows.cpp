// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// The flows of flows.hpp as decks with default settings, which the program runs.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "io/results/hdf5.hpp"
#include "solver/base/constants.hpp"
#include "tests/support/decks/box_deck.hpp"
#include "tests/support/runs/deck_run.hpp"
#include "tests/verification/dsmc/flows.hpp"

namespace corpuscle::dsmc {
namespace {

using namespace corpuscle::test;

constexpr double P = 101325.0, T = 300.0;      ///< [Pa], [K]
constexpr double AIR = 0.028, HELIUM = 0.004;  ///< [kg/mol]
constexpr double CP = 2.5 * GAS_CONSTANT;      ///< of both                          [J/(mol K)]
constexpr double L = 0.1;                      ///< [m]
constexpr double PARTICLES_A_CELL = 30.0,
                 DEPTH = 4.0;  ///< particles of a cell; depth of the box in cells
constexpr int QUADS = 2;       ///< of the walls, by L
constexpr int BY_CELL = 3;     ///< orifices of a slot along a cell's edge
constexpr int FIRST_ORIFICE = 100001;
constexpr int HULL = 1, OUTLET = 2, OPEN = 3, PLATE = 4;  ///< parts

/// c = sqrt(R T / M) of air.                                                            [m/s]
double thermal() {
    return std::sqrt(GAS_CONSTANT * T / AIR);
}

/// A box of length × height × DEPTH / resolution, in L.
BoxDeck box(double length, double height, double resolution, double outlet) {
    BoxDeck deck{L * Vec3(length, height, DEPTH / resolution),
                 {static_cast<int>(QUADS * length), static_cast<int>(QUADS * height), 1},
                 [=](const Vec3& x) {
                     return x.x() > 0.999 * L * length && x.y() < L * outlet ? OUTLET : HULL;
                 },
                 {},
                 {}};
    return deck;
}

/// Nodes of orifices at `places`, held; cards that name them for an inflator.
struct OrificeList {
    std::string nodes, cards;
    int count = 0;
    void add(const Vec3& x, const std::string& fields) {
        const int id = FIRST_ORIFICE + count++;
        nodes += node_card(id, x);
        cards += fmt::format("{}, 1.0, {}\n", id, fields);
    }
};

std::string gas_card(int curve, double molar_mass, int inflator) {
    return fmt::format("{}, {}, {}, {:.9f}, 0, 0, {}\n", curve, curve + 1, molar_mass, CP,
                       inflator);
}

std::string inflow_curves(int id, double rate, double until, double T_static) {
    return curve_card(id, {{0.0, rate}, {until, rate}, {until, 0.0}, {1.0, 0.0}}) +
           curve_card(id + 1, {{0.0, T_static}, {1.0, T_static}});
}

std::string ending(double end, double frames) {
    return fmt::format(
        "*CONTROL_TERMINATION\n{:.9g},\n*DATABASE_ABSTAT\n{:.9g},\n*DATABASE_BINARY_D3PLOT\n{:.9g},"
        "\n"
        "*END\n",
        end, frames, frames);
}

/// Held walls of `parts`; set 12 is all of them.
std::string walls(const DeckMesh& mesh, const std::vector<int>& parts) {
    std::string text = mesh.cards([](const Vec3&) { return true; }) + section_card(1, 1e-3) +
                       "*MAT_NULL\n1, 1000.0\n" + set_card(12, parts);
    for (const int part : parts) text += part_card(part, 1);
    return text;
}

std::string slot_deck(const SlotFlow& flow, double resolution) {
    const double h = L / resolution, depth = DEPTH * h, time = L / thermal();
    const double at_rest =
        flow.length * flow.height * DEPTH * std::pow(resolution, 2.0) * PARTICLES_A_CELL;
    const double entering = flow.slot * SlotFlow::STREAM * flow.end / (flow.length * flow.height);
    OrificeList slot;
    const int rows = static_cast<int>(std::lround(BY_CELL * flow.slot * resolution)),
              columns = BY_CELL * static_cast<int>(DEPTH);
    for (int j = 0; j < rows; ++j)
        for (int k = 0; k < columns; ++k)
            slot.add({1e-3 * L, (j + 0.5) / rows * flow.slot * L, (k + 0.5) / columns * depth},
                     fmt::format("1, {}, 1, 0, 1", SlotFlow::HALF_ANGLE));
    const double rate =
        P * AIR / (GAS_CONSTANT * T) * SlotFlow::STREAM * thermal() * flow.slot * L * depth;
    // u(T_stag) = h(T): 3/2 R T_stag = 5/2 R T;   speed² = 3 R T_stag / M
    const double T_static = 0.6 * std::pow(SlotFlow::SPEED, 2.0) / 3.0 * T;
    return "*KEYWORD\n*TITLE\nAir enters air at rest through a slot\n" +
           walls(box(flow.length, flow.height, resolution, flow.outlet).mesh(), {HULL, OUTLET}) +
           slot.nodes + "*AIRBAG_PARTICLE\n12, 1\n" +
           fmt::format("{:.0f}, 1, 1, {}, {}, 1\n2, 1, {}\n", at_rest * (1.0 + entering), T, P,
                       slot.count) +
           fmt::format("{}, 0, 1.0, 0, 0, 0\n{}, {}, {}, {:.9f}\n", OUTLET, P, T, AIR, CP) +
           gas_card(1, AIR, 1) + slot.cards + "*DEFINE_VECTOR\n1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0\n" +
           inflow_curves(1, rate, flow.end * time, T_static) + ending(flow.end * time, 0.25 * time);
}

constexpr double OPENS = 2.5;  ///< the plate of a box; its gases enter until 1     [L / c]

std::string slit_deck(const SlitFlow& flow, double resolution) {
    const double h = L / resolution, depth = DEPTH * h, time = L / thermal();
    const double particles =
        SlitFlow::LENGTH * SlitFlow::HEIGHT * DEPTH * std::pow(resolution, 2.0) * PARTICLES_A_CELL;
    BoxDeck hull = box(SlitFlow::LENGTH, SlitFlow::HEIGHT, resolution, 0.0);
    hull.membranes = {{hull.cells[0] / 2, OPEN}};
    DeckMesh mesh = hull.mesh();
    std::vector<int> parts{HULL, OPEN};
    for (DeckMesh::Quad& quad : mesh.quads) {
        double y = 0.0;
        for (const int node : quad.nodes)
            y += 0.25 * mesh.nodes[static_cast<std::size_t>(node - 1)].y();
        if (quad.part == OPEN && y > flow.slit * L) quad.part = PLATE;
    }
    std::string inner = set_card(13, {OPEN});
    if (flow.slit < SlitFlow::HEIGHT) {
        parts.push_back(PLATE);
        inner = set_card(13, {OPEN, PLATE});
    }
    OrificeList places;
    const int along = static_cast<int>(SlitFlow::LENGTH * resolution),
              across = static_cast<int>(SlitFlow::HEIGHT * resolution);
    for (const int half : {0, 1})
        for (int i = half * along / 2; i < (half + 1) * along / 2; ++i)
            for (int j = 0; j < across; ++j)
                for (int k = 0; k < DEPTH; ++k)
                    places.add(h * Vec3(i + 0.5, j + 0.5, k + 0.5),
                               fmt::format("0, 0, {}", half + 1));
    const double moles =
        0.5 * P * SlitFlow::LENGTH * SlitFlow::HEIGHT * L * L * depth / (GAS_CONSTANT * T);
    return "*KEYWORD\n*TITLE\nHelium and air through an opening\n" + walls(mesh, parts) + inner +
           places.nodes + "*AIRBAG_PARTICLE\n12, 1, 13, 1\n" +
           fmt::format("{:.0f}, 1, 1, {}, {}, 1\n0, 2, {}\n{}, 0, 1.0, 5, 0, 0\n", particles, T, P,
                       places.count, OPEN) +
           gas_card(1, AIR, 1) + gas_card(3, HELIUM, 2) + places.cards +
           inflow_curves(1, moles * AIR / time, time, 0.6 * T) +
           inflow_curves(3, moles * HELIUM / time, time, 0.6 * T) +
           step_card(5, OPENS * time, 1.0) +
           ending((OPENS + SlitFlow::TIMES.back()) * time, 0.25 * time);
}

/// Particles of a frame.
struct Frame {
    std::vector<double> x, v, gas;
};

/// What the program makes of a deck; `look` gets each frame with its time in L / c.
template <class Look>
void run(const std::string& deck, std::uint64_t seed, const std::string& options, Look&& look) {
    const DeckRun run("flow", deck, fmt::format("--seed {} {}", seed, options));
    if (run.status() != 0) throw std::runtime_error("the program has not run a flow");
    const io::Hdf5Reader results(run.results());
    const auto time = results.read<double>("/frames/time");
    for (std::size_t f = 0; f < time.size(); ++f) {
        const std::string of = fmt::format("/frames/{:05}/particles/", f);
        if (!results.has(of + "position")) continue;
        look(time[f] * thermal() / L,
             Frame{results.read<double>(of + "position"), results.read<double>(of + "velocity"),
                   results.read<double>(of + "species")});
    }
}

}  // namespace

Findings by_program(const SlotFlow& flow, double resolution, std::uint64_t seed,
                    const std::string& options) {
    PlaneField field(flow);
    std::size_t at_rest = 0;
    run(slot_deck(flow, resolution), seed, options, [&](double t, const Frame& frame) {
        const std::size_t n = frame.gas.size();
        if (at_rest == 0) at_rest = n;
        if (t <= flow.from) return;
        field.begin(at_rest);
        for (std::size_t i = 0; i < n; ++i)
            field.add(frame.x[3 * i] / L, frame.x[3 * i + 1] / L, frame.v[3 * i] / thermal());
    });
    return flow.is_jet ? field.jet() : field.layer();
}

Findings by_program(const SlitFlow& flow, double resolution, std::uint64_t seed,
                    const std::string& options) {
    Findings found;
    run(slit_deck(flow, resolution), seed, options, [&](double t, const Frame& frame) {
        for (const double time : SlitFlow::TIMES) {
            if (std::abs(t - OPENS - time) > 0.1) continue;
            std::array<double, 2> over{}, all{};
            for (std::size_t i = 0; i < frame.gas.size(); ++i) {
                const std::size_t gas = frame.gas[i] == 1.0 ? 0 : 1;
                over[gas] += (frame.x[3 * i] < 0.5 * SlitFlow::LENGTH * L) == (gas == 1);
                all[gas] += 1.0;
            }
            found.merge(crossed({over[0] / all[0], over[1] / all[1]}, time));
        }
    });
    return found;
}

}  // namespace corpuscle::dsmc
