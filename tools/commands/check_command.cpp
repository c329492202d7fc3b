// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "gas/enclosure/enclosure.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tools/check/bad_starts.hpp"
#include "tools/check/check_json.hpp"
#include "tools/check/cost.hpp"
#include "tools/check/sanity.hpp"
#include "tools/commands/commands.hpp"
#include "tools/summary.hpp"

namespace corpuscle::tools {
namespace {

/// Particles a facet of the closed bag that kept the pressure of models/driver_bag_folded at 20 and
/// 30 ms within 2 % of 300 000 (26 a facet): 30 000 of them. With 10 000 it was 3.4 % off.
constexpr double ENOUGH_A_FACET = 2.6;

void print_advice(const gas::BagCard& card, std::size_t facets) {
    const auto closing = static_cast<double>(facets);
    const double a_facet = static_cast<double>(card.particles) / closing;
    fmt::print(
        "    {:.2g} particles a facet: {} for a pressure within 2 %, by the folded driver bag",
        a_facet, a_facet < ENOUGH_A_FACET ? "too few" : "enough");
    if (a_facet < ENOUGH_A_FACET)
        fmt::print(", which wanted {}: NP = {:.2g}", ENOUGH_A_FACET, ENOUGH_A_FACET * closing);
    fmt::print("\n");
}

void print_scene(const Simulation& simulation) {
    const Model& model = simulation.model();
    fmt::print("{}: {}\n", model.deck, model.title.empty() ? "(no title)" : model.title);
    fmt::print("  units: {}\n", model.unit_system);
    fmt::print("  {} nodes, {} shells in {} parts, end time {:g}\n", model.x.size(),
               model.shells.size(), model.parts.size(), model.end_time);
    for (const gas::BagGas& bag : simulation.bags()) {
        const gas::BagCard& card = bag.card();
        fmt::print(
            "  airbag {}: {} facets close {:.6g} of volume, {} internal; {} gases, {} orifices, "
            "{} particles\n",
            card.id, bag.walls().closing, bag.enclosure().volume(model.x),
            bag.walls().triangles.size() - bag.walls().closing, card.inflow.size(),
            card.orifices.size(), card.particles);
        print_advice(card, bag.walls().closing);
        const double share = bag.expected_share_in(model.end_time);
        if (share < 0.999)
            fmt::print("    {:.1f} % of the gas enters before the end time\n", 100.0 * share);
    }
    for (const gas::UniformBag& bag : simulation.uniform_bags())
        fmt::print(
            "  airbag {} ({}): {} facets close {:.6g} of volume, uniform pressure from {:g}\n",
            bag.card().id, bag.card().keyword, bag.walls().closing, bag.enclosure().volume(model.x),
            bag.pressure());
}

void print_needs(const Simulation& simulation) {
    const Model& model = simulation.model();
    fmt::print("needed:\n");
    const auto line = [](bool needed, const std::string& what) {
        if (needed) fmt::print("  {}\n", what);
    };
    line(simulation.active_shells() > 0,
         fmt::format("strains of {} shells", simulation.active_shells()));
    line(!model.bags.empty(),
         "gas: inflow, collisions, flight, pressure on the fabric, atmosphere");
    line(!model.uniform_bags.empty(),
         fmt::format("bags of uniform pressure ({})", model.uniform_bags.size()));
    line(!model.contacts.empty(), fmt::format("fabric contact ({})", model.contacts.size()));
    line(!model.walls.empty(), fmt::format("rigid walls ({})", model.walls.size()));
    line(!model.motions.empty(), fmt::format("prescribed motions ({})", model.motions.size()));
    line(!model.body_loads.empty() || !model.pressure_loads.empty(), "loads");
    fmt::print("left out:\n");
    const std::size_t unstrained = model.shells.size() - simulation.active_shells();
    line(unstrained > 0,
         fmt::format("strains of {} shells (rigid, null, or all nodes supported)", unstrained));
    line(model.contacts.empty(), "contact between fabrics (no *CONTACT_)");
    line(model.walls.empty(), "rigid walls");
    line(model.bags.empty(), "particles (no *AIRBAG_PARTICLE)");
    line(std::isnan(model.output.frames),
         "frames (no *DATABASE_BINARY_D3PLOT): only the first and the last state");
}

void print_estimate(const Simulation& simulation) {
    if (const StepLimit limit = simulation.stable_step(); limit.who == StepLimit::Who::START)
        fmt::print("first step {:.4g}, by DTINIT\n", limit.dt);  // of the first step alone
    const Cost cost = cost_of(simulation);
    const StepLimit shells = simulation.shells_step();
    const std::string by_cloth =
        shells.dt < INF && cost.first.who == StepLimit::Who::GAS
            ? fmt::format(", the cloth allows {:.4g} ({})", shells.dt, shells.text())
            : "";
    fmt::print(
        "estimate: first step {:.4g} (set by {}{}), {:.3g} steps, some {:.2g} s on {} threads\n",
        cost.first.dt, cost.first.text(), by_cloth, cost.steps, cost.seconds, parallel::threads());
}

void print_contacts_at_start(Simulation& simulation) {
    simulation.look_at_contacts();
    if (simulation.contact()) {
        const contact::ContactCounts& counts = simulation.contact()->counts();
        fmt::print(
            "contact at the start: {} facets searched, {} candidates, {} near, {} touching\n",
            counts.searched, counts.candidates, counts.near, counts.touching);
    }
    print_bad_starts(simulation);
}

int check_for_scripts(const DeckArguments& arguments) {
    try {
        Simulation simulation = load(arguments);
        simulation.look_at_contacts();
        Model model = simulation.model();
        for (std::string& warning : crossings_at_start(simulation))
            model.warnings.push_back(std::move(warning));
        for (std::string& warning : sanity_of(simulation).warnings)
            model.warnings.push_back(std::move(warning));
        fmt::print("{}", check_json(arguments.file, &model, {}));
        return 0;
    } catch (const InputError& error) {
        fmt::print("{}", check_json(arguments.file, nullptr, error.faults));
        return 2;
    }
}

}  // namespace

int check(const DeckArguments& arguments, bool as_json) {
    if (as_json) return check_for_scripts(arguments);
    Simulation simulation = load(arguments);
    print_scene(simulation);
    const Sanity sanity = sanity_of(simulation);
    for (const std::string& line : sanity.lines) fmt::print("  {}\n", line);
    print_needs(simulation);
    if (simulation.added_mass() > 0.0)
        fmt::print("mass added by DT2MS: {:.4g}\n", simulation.added_mass());
    print_contacts_at_start(simulation);
    print_estimate(simulation);
    for (const std::string& mending : simulation.model().mendings)
        fmt::print("mended: {}\n", mending);
    for (const std::string& note : simulation.model().notes) fmt::print("note: {}\n", note);
    for (const std::string& warning : simulation.model().warnings)
        fmt::print("warning: {}\n", warning);
    for (const std::string& warning : sanity.warnings) fmt::print("warning: {}\n", warning);
    for (const std::string& warning : crossings_at_start(simulation))
        fmt::print("warning: {}\n", warning);
    return 0;
}

}  // namespace corpuscle::tools
