// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/decks/random_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"
#include "tests/support/decks/random_plan.hpp"
#include "tests/support/decks/random_surroundings.hpp"
#include "tests/support/draw.hpp"

namespace corpuscle::support {
namespace {

constexpr double P_ATM = 101325.0;  // [Pa]

/// Cp = A + B T + C T² [J/(mol K)], 300 to 1500 K [Alberty and Silbey, Physical Chemistry, Table
/// C.3]; argon and helium: 5/2 R; air: 0.78 N2, 0.21 O2, 0.01 Ar.
struct Gas {
    const char* name;
    double M, A, B, C;
};
constexpr std::array GASES{
    Gas{"air", 0.028965, 26.611, 7.468e-3, -1.157e-6},
    Gas{"N2", 0.0280134, 26.984, 5.910e-3, -3.377e-7}, Gas{"He", 0.0040026, 20.786, 0.0, 0.0},
    Gas{"Ar", 0.039948, 20.786, 0.0, 0.0}, Gas{"CO2", 0.0440095, 26.648, 42.262e-3, -142.40e-7}};

Plan plan_of(Draw& draw) {
    Plan plan{};
    plan.is_rigid = draw.chance(0.5);
    plan.has_chambers = draw.chance(0.2);
    plan.has_hole = plan.has_chambers && draw.chance(0.5);
    plan.has_vent = draw.chance(0.4);
    plan.is_porous = draw.chance(0.3);
    plan.has_heat = draw.chance(0.25);
    plan.switches = draw.chance(0.25) && !(plan.has_heat && plan.has_chambers);
    // A bag of cloth with nothing in it is crushed by the atmosphere
    const std::array<int, 5> airs{1, 1, -1, 2, 0};
    plan.air = airs[static_cast<std::size_t>(draw.below(plan.is_rigid ? 5 : 4))];
    const double edge = draw.log_in(0.07, 0.35);
    for (int i = 0; i < 3; ++i) {
        plan.side[i] = edge * draw.in(0.7, 1.3);
        plan.cells[static_cast<std::size_t>(i)] = 2 + draw.below(plan.is_rigid ? 4 : 7);
    }
    if (plan.has_chambers) plan.cells[0] += plan.cells[0] % 2;
    plan.particles = static_cast<int>(draw.log_in(10.0, 20000.0));
    // Many particles in a small box take many steps
    plan.end = !plan.is_rigid          ? draw.in(3e-3, 10e-3)
               : plan.particles < 2000 ? draw.log_in(3e-3, 30e-3)
                                       : draw.in(1e-3, 4e-3);
    plan.inflow_end = plan.end;
    return plan;
}

/// Nothing that holds the bag, no gas that leaves it, and none that comes after 0.4 of the time.
void set_free(Plan& plan) {
    plan.is_free = true;
    plan.has_vent = plan.is_porous = plan.has_heat = plan.switches = false;
    plan.inflow_end = 0.3 * plan.end;
}

/// Cards of *MAT_FABRIC: 470 to 940 dtex polyamide, with what it leaks.
std::string cloth(Draw& draw, Plan& plan, int id, double density, double modulus, bool leaks) {
    std::string text = fmt::format("*MAT_FABRIC\n{}, {:.4g}, {:.4g}, {:.4g}, , 0.2\n", id, density,
                                   modulus, modulus * draw.in(0.8, 1.0));
    const bool has_liner = draw.chance(0.5);
    const int wrinkles = draw.below(2);  // CSE
    const double damping = draw.chance(0.5) ? draw.in(0.0, 0.1) : 0.0;
    text += fmt::format("{:.4g}, , , {}, {:.4g}, 0.3, {}, {:.3g}\n", modulus * 0.02, wrinkles,
                        has_liner ? 0.15 * modulus : 0.0, has_liner ? 0.1 : 0.0, damping);
    std::string area, velocity;
    if (leaks) {
        const double share = draw.in(0.01, 0.2), speed = draw.in(1.0, 60.0);
        area =
            draw.chance(0.5)
                ? fmt::format("{:.4g}", share)
                : fmt::format("-{}", plan.curve({{0.0, 0.0}, {0.5 * plan.end, share}, {1, share}}));
        velocity = draw.chance(0.5)
                       ? fmt::format("{:.4g}", speed)
                       : fmt::format("-{}", plan.curve({{P_ATM, 0.0}, {3.0 * P_ATM, speed}}));
    }
    const int form = draw.chance(0.5) ? 0 : 14, law = leaks ? 7 + draw.below(2) : 0;
    text += fmt::format("0, {}, {}, , , {}, {}\n", area, velocity, form, law);
    return text + ",\n,\n";
}

std::string parts(Draw& draw, Plan& plan) {
    std::string text;
    std::vector<std::pair<PartId, const char*>> all{{WALL, "walls"}};
    if (plan.has_vent) all.emplace_back(VENT, "vent");
    if (plan.is_porous) all.emplace_back(POROUS, "porous");
    if (plan.has_chambers) {
        all.emplace_back(FAR_WALL, "walls of chamber 2");
        all.emplace_back(MEMBRANE, "membrane");
    }
    if (plan.has_hole) all.emplace_back(HOLE, "hole");
    std::string outer, set;
    for (const auto& [id, title] : all) {
        const bool leaks = id == POROUS;
        text += fmt::format("*PART\n{}\n{}, 1, {}\n", title, static_cast<int>(id), leaks ? 2 : 1);
        set += fmt::format("{}{}", set.empty() ? "" : ", ", static_cast<int>(id));
    }
    text += "*SET_PART_LIST\n1\n" + set + "\n";
    if (plan.has_chambers) {
        text += fmt::format(
            "*SET_PART_LIST\n2\n5{}\n*SET_PART_LIST\n3\n1, 5\n*SET_PART_LIST\n4\n4, 5{}{}\n",
            plan.has_hole ? ", 6" : "", plan.has_vent ? ", 2" : "", plan.is_porous ? ", 3" : "");
    }
    const double h = draw.in(2e-4, 4e-4);
    text += fmt::format("*SECTION_SHELL\n1, {}\n{:.4g}, {:.4g}, {:.4g}, {:.4g}\n",
                        draw.chance(0.7) ? 5 : 9, h, h, h, h);
    const double density = draw.in(600.0, 900.0), modulus = draw.log_in(1e8, 5e8);
    text += plan.is_rigid ? std::string("*MAT_NULL\n1, 1000.0\n")
                          : cloth(draw, plan, 1, density, modulus, false);
    if (plan.is_porous) text += cloth(draw, plan, 2, density, modulus, true);
    return text;
}

/// *DEFINE_CPM_CHAMBER: near the origin, and beyond the membrane.
std::string chambers(const Plan& plan) {
    if (!plan.has_chambers) return "";
    const int holes = plan.has_hole ? 1 : 0;
    std::string text = "*DEFINE_CPM_CHAMBER\n1, 2\n";
    text += fmt::format("3, 0, {}, 1\n", holes);
    if (plan.has_hole) text += "6, 0, 2\n";
    text += fmt::format("4, 0, {}, 2\n", holes);
    if (plan.has_hole) text += "6, 0, 1\n";
    return text;
}

/// Mass flow and temperature of a gas that brings `moles` in.
std::string inflow(Draw& draw, Plan& plan, const Gas& gas, double moles, int inflator) {
    const double begin = draw.chance(0.6) ? 0.0 : draw.in(0.0, 0.4) * plan.inflow_end;
    const double span = draw.in(0.3, 1.2) * (plan.inflow_end - begin), mean = moles * gas.M / span;
    const double end = begin + span, peak = begin + draw.in(0.1, 0.6) * span;
    // Even; up and down; few particles for long
    const std::array courses{
        std::vector<std::array<double, 2>>{{begin, mean}, {end, mean}},
        std::vector<std::array<double, 2>>{{begin, 0.0}, {peak, 2.0 * mean}, {end, 0.0}},
        std::vector<std::array<double, 2>>{
            {begin, 0.005 * mean}, {peak, 0.005 * mean}, {end, 2.0 * span / (end - peak) * mean}}};
    const int rate = plan.curve(courses[static_cast<std::size_t>(draw.below(3))]);
    const double T = draw.in(200.0, 900.0);
    const int temperature = plan.curve({{0.0, T}, {1.0, draw.chance(0.5) ? T : 300.0}});
    return fmt::format("{}, {}, {:.6g}, {:.6g}, {:.6g}, {:.6g}, {}\n", rate, temperature, gas.M,
                       gas.A, gas.B, gas.C, inflator);
}

std::string vents(Draw& draw, Plan& plan) {
    std::string text;
    if (plan.has_vent) {
        const double open = draw.in(0.2, 1.2);
        int over_time = 0, over_pressure = 0;
        if (draw.chance(0.4))
            over_time =
                plan.curve({{0.0, 0.0}, {0.3 * plan.end, 0.0}, {0.4 * plan.end, 1.0}, {1, 1}});
        if (draw.chance(0.3))
            over_pressure = plan.curve({{P_ATM, 0.3}, {2.0 * P_ATM, 1.0}, {20 * P_ATM, 1.0}});
        const int law = draw.below(3);  // ENH_V
        const double opens_at = draw.chance(0.2) ? draw.in(0.0, 0.3) * P_ATM : 0.0;
        text += fmt::format("2, 0, {:.3g}, {}, {}, {}, {:.4g}\n", open, over_time, over_pressure,
                            law, opens_at);
    }
    if (plan.has_hole) text += fmt::format("6, 0, {:.3g}\n", draw.in(0.3, 1.0));
    return text;
}

/// Nozzles, in either chamber: nodes from 100 000 on, or shells of the face that is held, where no
/// cloth comes in their way.
std::string nozzles(Draw& draw, const Plan& plan, int inflators, std::string& nodes) {
    const int count = inflators + draw.below(5 - inflators);
    std::string text;
    nodes = "*NODE\n";
    for (int i = 0; i < count; ++i) {
        const int inflator = i < inflators ? i + 1 : 1 + draw.below(inflators);
        const bool is_far = plan.has_chambers && inflator == 2;
        int place = 100000 + i, vector = draw.below(2);  // VD = 0: every direction
        if (!plan.is_rigid || draw.chance(0.2)) {
            const std::vector<int>& floor = plan.floor[is_far ? 1 : 0];
            place = floor[static_cast<std::size_t>(draw.below(static_cast<int>(floor.size())))];
            vector = -1;
        } else {
            std::array at{draw.in(0.2, 0.8), draw.in(0.2, 0.8), draw.in(0.2, 0.8)};
            if (plan.has_chambers) at[0] = 0.5 * (at[0] + (is_far ? 1.0 : 0.0));
            nodes += fmt::format("{}, {:.6g}, {:.6g}, {:.6g}\n", place, plan.side[0] * at[0],
                                 plan.side[1] * at[1], plan.side[2] * at[2]);
        }
        const double area = draw.in(0.5, 2.0), angle = draw.in(5.0, 80.0);
        text += fmt::format("{}, {:.3g}, {}, {:.3g}, {}, {}, {}\n", place, area, vector, angle,
                            inflator, plan.is_free ? 1 : 0, draw.below(2));
    }
    nodes += "*DEFINE_VECTOR\n1, 0.0, 0.0, 0.0, 0.2, -0.1, 1.0\n";
    return text;
}

std::string airbag(Draw& draw, Plan& plan, RandomScene& scene) {
    const int inflators = 1 + draw.below(2), gases = inflators + draw.below(2);
    const double T_atm = draw.in(260.0, 320.0);
    const std::string hole_rows = vents(draw, plan);
    std::string nodes, jets = nozzles(draw, plan, inflators, nodes), rows;
    // Cloth is to bear what comes: 0.1 atm in a millisecond, at most
    const double rise = plan.is_rigid ? draw.log_in(0.1, 5.0) : draw.in(10.0, 100.0) * plan.end;
    const double moles = rise * P_ATM * plan.volume() / (GAS_CONSTANT * 400.0);
    const Gas& air =
        GASES[static_cast<std::size_t>(draw.chance(0.7) ? 0 : draw.below(GASES.size()))];
    const double p = plan.is_rigid && draw.chance(0.3) ? draw.log_in(0.2, 3.0) * P_ATM : P_ATM;
    const double T = draw.in(260.0, 400.0);
    // Particles are shared by moles: each gas has two of them, or the deck is refused
    const double with_air = plan.air == 2 ? p * plan.volume() / (GAS_CONSTANT * T) : 0.0;
    const int least = static_cast<int>(2.0 * gases * (1.0 + with_air / moles)) + 1;
    scene.particles = std::max(least, plan.particles);
    std::string names;
    for (int g = 0; g < gases; ++g) {
        const Gas& gas = GASES[static_cast<std::size_t>(draw.below(GASES.size()))];
        rows += inflow(draw, plan, gas, moles / gases, g < inflators ? g + 1 : 1);
        names += fmt::format(" {}", gas.name);
    }
    const std::string when =
        plan.switches ? fmt::format("{:.6g}", draw.in(0.2, 0.9) * plan.end) : "1e10";
    std::string text =
        fmt::format("*AIRBAG_PARTICLE\n1, 1, {}, {}, {}, {}\n", plan.has_chambers ? 2 : 0,
                    plan.has_chambers ? 1 : 0, draw.below(2), plan.has_heat ? 1 : 0);
    text += fmt::format("{}, 1, 1, {:.4g}, {}, {}, 1e10, {}\n", scene.particles, T_atm, P_ATM,
                        int{plan.has_vent} + int{plan.has_hole}, when);
    text += fmt::format("{}, {}, {}, 0, 0, 0, {}\n", plan.air, gases,
                        std::count(jets.begin(), jets.end(), '\n'), plan.has_chambers ? 1 : 0);
    if (plan.has_heat) text += fmt::format("1, 1, {:.4g}\n", draw.log_in(5.0, 500.0));
    text += hole_rows;
    if (plan.air != 0) {
        text += fmt::format("{:.6g}, {:.4g}, {:.6g}, {:.6g}, {:.6g}, {:.6g}\n", p, T, air.M, air.A,
                            air.B, air.C);
        names = fmt::format(" of {} +", air.name) + names;
    }
    scene.summary +=
        fmt::format("IAIR {}{}, NP {}, TSW {}", plan.air, names, scene.particles, when);
    return nodes + text + rows + jets;
}

}  // namespace

namespace {

RandomScene scene_of(Draw& draw, Plan& plan, unsigned seed) {
    RandomScene scene{};
    scene.is_rigid = plan.is_rigid;
    scene.seed = 1 + static_cast<unsigned>(draw.below(1000));
    const double factor = draw.in(0.2, 0.9);
    std::string words = plan.is_rigid ? "rigid" : "cloth";
    if (plan.has_chambers) words += plan.has_hole ? ", chambers with a hole" : ", chambers";
    if (plan.has_vent) words += ", vent";
    if (plan.is_porous) words += ", porous";
    if (plan.has_heat) words += ", HCONV";
    if (plan.is_free) words += ", free";
    const std::string beside = surroundings(plan, seed, words);
    scene.summary = fmt::format("{}, {:.2g} l, ", words, 1e3 * plan.volume());
    scene.deck = "*KEYWORD\n*TITLE\nrandom scene\n";
    scene.deck += fmt::format("*CONTROL_TERMINATION\n{:.6g}\n", plan.end);
    scene.deck += fmt::format("*CONTROL_TIMESTEP\n0.0, {:.4g}\n", factor);
    const double frames = plan.end / (plan.is_free ? 10.0 : 2.0);
    scene.deck += fmt::format(
        "*DATABASE_ABSTAT\n{0:.6g}\n*DATABASE_GLSTAT\n{0:.6g}\n*DATABASE_BINARY_D3PLOT\n{1:.6g}\n",
        plan.is_free ? frames : plan.end / 50.0, frames);
    scene.deck += mesh_of(plan, draw.chance(0.3));
    scene.deck += parts(draw, plan);
    scene.deck += chambers(plan);
    if (!plan.is_rigid)
        scene.deck += "*CONTACT_AIRBAG_SINGLE_SURFACE\n0, 0, 5, 0\n0.2, 0.2, 0.0, 0.0, 20.0\n,\n";
    scene.deck += beside + airbag(draw, plan, scene);
    scene.deck += plan.curves + "*END\n";
    scene.summary += fmt::format(", TSSFAC {:.2f}, seed {}", factor, scene.seed);
    return scene;
}

}  // namespace

RandomScene random_scene(unsigned seed) {
    Draw draw(seed);
    Plan plan = plan_of(draw);
    return scene_of(draw, plan, seed);
}

RandomScene free_scene(unsigned seed) {
    Draw draw(seed);
    Plan plan = plan_of(draw);
    while (plan.is_rigid) plan = plan_of(draw);
    set_free(plan);
    return scene_of(draw, plan, seed);
}

}  // namespace corpuscle::support
