// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/random/scene_gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "solver/base/constants.hpp"

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
        if (i == 0 && plan.inflator && draw.chance(0.5)) {
            const Vec3& at = *plan.inflator;
            nodes += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", place, at[0], at[1], at[2]);
        } else if (!plan.is_rigid || draw.chance(0.2)) {
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

}  // namespace

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
    const double with_air = plan.air == 2 ? p * plan.start_volume() / (GAS_CONSTANT * T) : 0.0;
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
        fmt::format("*AIRBAG_PARTICLE\n{}, 1, {}, {}, {}, {}\n", plan.closing_set, plan.inner_set,
                    plan.inner_set > 0 ? 1 : 0, draw.below(2), plan.has_heat ? 1 : 0);
    text += fmt::format("{}, 1, 1, {:.4g}, {}, {}, 1e10, {}\n", scene.particles, T_atm, P_ATM,
                        int{plan.has_vent} + int{plan.has_hole}, when);
    text += fmt::format("{}, {}, {}, 0, 0, 0, {}\n", plan.air, gases,
                        std::count(jets.begin(), jets.end(), '\n'),
                        plan.has_chambers || plan.is_chamber ? 1 : 0);
    if (plan.has_heat)
        text += fmt::format("{}, 1, {:.4g}\n", plan.closing_set, draw.log_in(5.0, 500.0));
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

}  // namespace corpuscle::support
