// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/random/random_scene.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

#include "solver/base/vec.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/random/random_plan.hpp"
#include "tests/support/random/random_surroundings.hpp"
#include "tests/support/random/scene_gas.hpp"

namespace corpuscle::support {
namespace {

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
    if (plan.has_chambers) plan.inner_set = 2;
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
    scene.deck += fmt::format("*CONTROL_TERMINATION\n{:.6g},\n", plan.end);
    scene.deck += fmt::format("*CONTROL_TIMESTEP\n0.0, {:.4g}\n", factor);
    const double frames = plan.end / (plan.is_free ? 10.0 : 2.0);
    scene.deck += fmt::format(
        "*DATABASE_ABSTAT\n{0:.6g},\n*DATABASE_GLSTAT\n{0:.6g},\n*DATABASE_BINARY_D3PLOT\n{1:.6g},"
        "\n",
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
