// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/random/folded_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <Eigen/Geometry>
#include <numbers>
#include <set>
#include <stdexcept>
#include <vector>

#include "solver/base/error.hpp"
#include "tests/support/draw.hpp"
#include "tests/support/random/random_plan.hpp"
#include "tests/support/random/random_recipe.hpp"
#include "tests/support/random/random_surroundings.hpp"
#include "tests/support/random/scene_gas.hpp"
#include "tools/commands/new_from_recipe.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"

namespace corpuscle::support {
namespace {

constexpr int CLOSING = 11, INNER = 12;  ///< part sets
constexpr int HELD = 21;                 ///< node set

/// A bag that a recipe has folded.
struct Pack {
    std::string text;  ///< of the recipe
    fold::Recipe recipe;
    fold::Bag bag;
    fold::Inspection found;
    std::vector<std::string> refused;  ///< why, recipes before it
};

/// The first recipe of the seed's that can be folded without a crossing.
Pack fold_one(unsigned seed, const SmallBag& kind) {
    constexpr unsigned MOST = 20;
    Pack pack;
    for (unsigned draw = 0; draw < MOST; ++draw) {
        pack.text = random_small_recipe(seed + 100'000U * draw, kind);
        pack.recipe = fold::parse_recipe(pack.text, "random.toml");  // throws: not drawn anew
        try {
            pack.bag = fold::fold(pack.recipe);
        } catch (const InputError& error) {
            pack.refused.emplace_back(error.what());
            continue;
        }
        pack.found = fold::inspect(pack.bag, pack.recipe.pattern.gap);
        if (pack.found.crossings.empty()) return pack;
        pack.refused.emplace_back("crosses");
    }
    throw std::runtime_error(fmt::format("seed {}: {} recipes in turn are refused", seed, MOST));
}

Plan plan_of_pack(Draw& draw) {
    Plan plan{};
    plan.is_free = draw.chance(0.3);
    plan.has_vent = draw.chance(0.5) && !plan.is_free;
    plan.is_porous = draw.chance(0.3) && !plan.is_free;
    plan.has_heat = draw.chance(0.2) && !plan.is_free;
    plan.switches = draw.chance(0.15) && !plan.is_free;
    plan.air = std::array{1, 1, -1, 2}[static_cast<std::size_t>(draw.below(4))];
    plan.particles = static_cast<int>(draw.log_in(1000.0, 20000.0));
    plan.end = draw.in(2e-3, 6e-3);
    plan.inflow_end = plan.is_free ? 0.3 * plan.end : plan.end;
    plan.closing_set = CLOSING;
    return plan;
}

/// Of two discs [Paulsen 1994: 1.2185 a³], of a pillow of two rectangles [Robin 2004, of a paper
/// bag], blown up.                                                                        [m^3]
double blown_up(const fold::Pattern& p) {
    if (p.kind == fold::PatternKind::DISC) return 1.2185 * std::pow(0.5 * p.diameter, 3);
    const double w = std::min(p.length, p.width), h = std::max(p.length, p.width);
    return w * w * w * (h / (std::numbers::pi * w) - 0.142 * (1.0 - std::pow(10.0, -h / w)));
}

int part_of(const fold::Bag& bag, std::size_t cell) {
    return bag.parts[static_cast<std::size_t>(bag.sheet.part[cell])].id;
}

double volume_of(const fold::Bag& bag) {
    double six = 0.0;
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        if (part_of(bag, e) == TETHER) continue;
        const auto& [a, b, c, d] = bag.sheet.cells[e];
        const Points& x = bag.sheet.x;
        six += x[a].dot(x[b].cross(x[c])) + x[a].dot(x[c].cross(x[d]));
    }
    return std::abs(six) / 6.0;
}

/// Row of the panels' shell whose middle is nearest to a place.
std::size_t panel_shell_near(const Pack& pack, const Vec3& at) {
    std::size_t nearest = 0;
    double least = INF;
    for (std::size_t e = 0; e < pack.bag.sheet.cells.size(); ++e) {
        const fold::Cell& cell = pack.bag.sheet.cells[e];
        const int part = part_of(pack.bag, e);
        if (part == TETHER || part == VENT) continue;
        Vec3 middle = Vec3::Zero();
        for (const Index n : cell) middle += pack.bag.sheet.x[n] / double(cell.size());
        if ((middle - at).norm() < least) nearest = e;
        least = std::min(least, (middle - at).norm());
    }
    return nearest;
}

/// Places the gas: numbers of the held nodes, shells all of whose nodes they are, a place before
/// them; of a free bag the cover's shells.
std::vector<int> place_inflator(const Pack& pack, Plan& plan) {
    const tools::RecipeBag start = tools::starting_bag(pack.recipe, pack.bag);
    // no cloth passes over a node that stands in a dish; one of a free bag would stay behind
    const bool is_dish = pack.recipe.hole && pack.recipe.hole->depth > 0.0;
    if (is_dish && !plan.is_free) plan.inflator = start.inflator;
    std::set<int> held(start.held.begin(), start.held.end());
    for (const Index row : pack.bag.module) held.insert(static_cast<int>(row) + 1);
    for (std::size_t e = 0; e < pack.bag.sheet.cells.size(); ++e) {
        const fold::Cell& cell = pack.bag.sheet.cells[e];
        const int part = part_of(pack.bag, e);
        const bool is_held = std::all_of(cell.begin(), cell.end(),
                                         [&](Index n) { return held.contains(int{n} + 1); });
        if (plan.is_free ? part == COVER : is_held && part != TETHER && part != VENT)
            plan.floor[0].push_back(static_cast<int>(e) + 1);
    }
    if (plan.floor[0].empty()) {  // the middle of the back is bent: the shell there is held
        const std::size_t e = panel_shell_near(pack, start.inflator);
        plan.floor[0].push_back(static_cast<int>(e) + 1);
        for (const Index n : pack.bag.sheet.cells[e]) held.insert(static_cast<int>(n) + 1);
    }
    return {held.begin(), held.end()};
}

std::string parts_of_pack(const Pack& pack, Draw& draw, Plan& plan) {
    std::set<int> ids;
    for (std::size_t e = 0; e < pack.bag.sheet.cells.size(); ++e) ids.insert(part_of(pack.bag, e));
    std::string text, closing;
    for (const int id : ids) {
        const bool is_double = id == RING || id == TETHER, is_rigid = plan.is_free && id == COVER;
        const int material = is_rigid ? 3 : plan.is_porous && id == POROUS ? 2 : 1;
        text += fmt::format("*PART\npart {0}\n{0}, {1}, {2}\n", id, is_double ? 2 : 1, material);
        if (id != TETHER) closing += fmt::format("{}{}", closing.empty() ? "" : ", ", id);
    }
    text += fmt::format("*SET_PART_LIST\n{}\n{}\n", CLOSING, closing);
    if (ids.contains(TETHER)) {
        plan.inner_set = INNER;
        text += fmt::format("*SET_PART_LIST\n{}\n{}\n", INNER, int{TETHER});
    }
    const double h = draw.in(2e-4, 4e-4), twice = std::min(2.0 * h, 0.6e-3);
    const int form = draw.chance(0.7) ? 5 : 9;
    text += fmt::format("*SECTION_SHELL\n1, {0}\n{1:.4g}, {1:.4g}, {1:.4g}, {1:.4g}\n", form, h);
    text +=
        fmt::format("*SECTION_SHELL\n2, {0}\n{1:.4g}, {1:.4g}, {1:.4g}, {1:.4g}\n", form, twice);
    const double density = draw.in(600.0, 900.0), modulus = draw.log_in(1e8, 5e8);
    text += cloth(draw, plan, 1, density, modulus, false);
    if (plan.is_porous) text += cloth(draw, plan, 2, density, modulus, true);
    if (plan.is_free) text += "*MAT_RIGID\n3, 7800.0, 2.1e11, 0.3\n,\n,\n";
    return text;
}

std::string node_set(int id, const std::vector<int>& nodes) {
    std::string text = fmt::format("*SET_NODE_LIST\n{}\n", id);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        text += fmt::format("{}{}", nodes[i], i % 8 == 7 || i + 1 == nodes.size() ? "\n" : ", ");
    return text;
}

std::string control(const Plan& plan, Draw& draw, bool has_slivers, double factor) {
    const double frames = plan.end / (plan.is_free ? 10.0 : 4.0);
    const bool scales_mass = draw.chance(0.3) || has_slivers;
    return fmt::format(
        "*CONTROL_TERMINATION\n{:.6g},\n*CONTROL_TIMESTEP\n0.0, {:.4g}, 0, 0.0, {}\n"
        "*DATABASE_ABSTAT\n{:.6g},\n*DATABASE_BINARY_D3PLOT\n{:.6g},\n",
        plan.end, factor, scales_mass ? "-1.0e-6" : "0.0", plan.is_free ? frames : plan.end / 50.0,
        frames);
}

std::string words_of(const Plan& plan, const Pack& pack) {
    std::string words =
        fmt::format("folded, {} shells, {} layers", pack.bag.sheet.cells.size(), pack.found.layers);
    if (plan.is_free) words += ", free";
    if (plan.has_vent) words += ", vent";
    if (plan.is_porous) words += ", porous";
    if (plan.inner_set > 0) words += ", tether";
    if (plan.has_heat) words += ", HCONV";
    if (plan.is_chamber) words += ", a chamber";
    return words;
}

}  // namespace

FoldedScene folded_scene(unsigned seed) {
    Draw draw(seed + 0x7000'0000U);
    Plan plan = plan_of_pack(draw);
    plan.is_chamber = Draw(seed + 0x7800'0000U).chance(0.3) && !(plan.has_heat && plan.switches);
    const Pack pack =
        fold_one(seed, {plan.is_free, plan.has_vent, POROUS, WALL, COVER, RING, VENT, TETHER});
    plan.side = Vec3(1.0, 1.0, blown_up(pack.recipe.pattern));
    plan.start = volume_of(pack.bag);
    const std::vector<int> held = place_inflator(pack, plan);

    FoldedScene scene;
    scene.recipe = pack.text;
    scene.refused = pack.refused;
    scene.is_free = plan.is_free;
    scene.is_rigid = false;
    scene.seed = 1 + static_cast<unsigned>(draw.below(1000));
    const double factor = draw.in(0.2, 0.9);
    const bool is_oblique = pack.text.find("angle = 0\n") == std::string::npos &&
                            pack.text.find("angle = 90\n") == std::string::npos;
    const std::string mesh = fold::bag_deck(pack.bag, pack.recipe, pack.found);
    scene.deck = mesh.substr(0, mesh.rfind("*END"));
    scene.deck += control(plan, draw, is_oblique, factor) + parts_of_pack(pack, draw, plan);
    scene.deck += plan.is_free ? "*INITIAL_VELOCITY_GENERATION\n1, 1, 0, 3.0, -2.0, 1.0\n,\n"
                               : node_set(HELD, held) +
                                     fmt::format("*BOUNDARY_SPC_SET\n{}, 0, 1, 1, 1\n", HELD);
    scene.deck += "*CONTACT_AIRBAG_SINGLE_SURFACE\n0, 0, 5, 0\n0.2, 0.2, 0.0, 0.0, 20.0\n,\n";
    std::string words = words_of(plan, pack);
    scene.deck += surroundings_of_pack(plan, {pack.found.low, pack.found.high}, draw, words);
    scene.summary =
        fmt::format("{}, {:.2g} of {:.2g} l, ", words, 1e3 * plan.start, 1e3 * plan.volume());
    if (plan.is_chamber)
        scene.deck += fmt::format("*DEFINE_CPM_CHAMBER\n1, 1\n{}, 0, 0, 1\n", CLOSING);
    scene.deck += airbag(draw, plan, scene);
    scene.deck += plan.curves + "*END\n";
    scene.summary += fmt::format(", TSSFAC {:.2f}, seed {}", factor, scene.seed);
    return scene;
}

}  // namespace corpuscle::support
