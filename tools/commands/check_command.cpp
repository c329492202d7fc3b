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
#include "tools/check/sanity.hpp"
#include "tools/commands/commands.hpp"
#include "tools/summary.hpp"

namespace corpuscle::tools {
namespace {

// Rough costs of one core of a server of 2023, from runs of the models: they only serve the estimate.
constexpr double SECONDS_PER_STEP = 300e-6;  ///< of a scene with next to nothing in it
constexpr double SECONDS_PER_PARTICLE_STEP = 80e-9;
constexpr double SECONDS_PER_ELEMENT_STEP = 150e-9;
constexpr double SECONDS_PER_CONTACT_SHELL_STEP = 600e-9;
/// Of a pair that is near at the start, over the whole run: a folded bag's come apart as it opens.
constexpr double SECONDS_PER_NEAR_PAIR_STEP = 500e-9;
/// Cloth that is stretched and sheared wants smaller steps than at the start: steps of the folded and
/// the flat driver bag over end time / first step.
constexpr double MORE_STEPS = 1.25;
/// Share of a run that one thread does alone, or that is lost to waiting (Amdahl).
constexpr double SERIAL = 0.1;

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
         fmt::format("strains of {} shells (rigid, null, or all nodes held)", unstrained));
    line(model.contacts.empty(), "contact between fabrics (no *CONTACT_)");
    line(model.walls.empty(), "rigid walls");
    line(model.bags.empty(), "particles (no *AIRBAG_PARTICLE)");
    line(std::isnan(model.output.frames),
         "frames (no *DATABASE_BINARY_D3PLOT): only the first and the last state");
}

/// Of one step on one core; particles count until TSW.                                         [s]
double step_seconds(const Simulation& simulation) {
    const Model& model = simulation.model();
    double seconds = static_cast<double>(simulation.active_shells()) * SECONDS_PER_ELEMENT_STEP;
    for (const gas::BagCard& bag : model.bags)
        seconds += static_cast<double>(bag.particles) * SECONDS_PER_PARTICLE_STEP *
                   std::clamp(bag.switch_at / model.end_time, 0.0, 1.0);
    if (!model.contacts.empty())
        seconds += static_cast<double>(model.shells.size()) * SECONDS_PER_CONTACT_SHELL_STEP;
    if (simulation.contact())
        seconds +=
            static_cast<double>(simulation.contact()->counts().near) * SECONDS_PER_NEAR_PAIR_STEP;
    return seconds;
}

void print_estimate(const Simulation& simulation) {
    const Model& model = simulation.model();
    StepLimit limit = simulation.stable_step();
    if (limit.who == StepLimit::Who::START) {  // DTINIT is of the first step alone
        fmt::print("first step {:.4g}, by DTINIT\n", limit.dt);
        limit = simulation.stable_step(/*without_start=*/true);
    }
    const StepLimit first = limit, shells = simulation.shells_step();
    if (limit.who == StepLimit::Who::GAS && shells.dt < INF)
        limit = shells;  // gas soon allows more
    const bool is_by_cloth = limit.who != StepLimit::Who::GAS;
    const double steps = std::ceil((is_by_cloth ? MORE_STEPS : 1.0) * model.end_time / limit.dt);
    const double share = SERIAL + (1.0 - SERIAL) / parallel::threads();  // of one thread's time
    const double seconds = steps * (SECONDS_PER_STEP + share * step_seconds(simulation));
    fmt::print(
        "estimate: first step {:.4g} (set by {}), {:.3g} steps of {:.4g} and less ({}), "
        "some {:.2g} s on {} threads\n",
        first.dt, first.text(), steps, limit.dt, limit.text(), seconds, parallel::threads());
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
        fmt::print("WARNING: {}\n", warning);
    return 0;
}

}  // namespace corpuscle::tools
