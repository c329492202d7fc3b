// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/summary.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string_view>

#include "gas/outflow/openings.hpp"
#include "gas/particles.hpp"
#include "io/system/atomic_file.hpp"
#include "io/text/json.hpp"
#include "solver/base/cores.hpp"
#include "tools/everyday.hpp"

namespace corpuscle::tools {
namespace {

/// A lap of the step (solver/step.cpp) in the words of somebody who has not read it.
std::string said(std::string_view lap) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 14> WORDS{
        {{"membranes", "cloth: strains and stresses"},
         {"gas load", "gas: pressure on the cloth"},
         {"contact search", "contact: what is near what"},
         {"contact", "contact: forces"},
         {"loads", "loads and damping"},
         {"motion", "motion"},
         {"energy balance", "energy balance"},
         {"stable step", "stable step"},
         {"output", "writing results"},
         {"facet lists", "gas: cloth near particles"},
         {"collisions", "gas: collisions"},
         {"inflators", "gas: inflators"},
         {"flight", "gas: flight, vents, leaks"},
         {"uniform bags", "gas: bags of uniform pressure"}}};
    for (const auto& [name, words] : WORDS)
        if (lap == name) return std::string(words);
    return std::string(lap);
}

void print_phases(const Timings& timings, double wall) {
    fmt::print("\n  {:<28} wall [s]   share\n", "phase");
    for (const auto& [phase, seconds] : timings.phases())
        if (seconds > 0.0005 * wall)
            fmt::print("  {:<28} {:>8.3f}  {:>5.1f} %\n", said(phase), seconds,
                       100.0 * seconds / wall);
    fmt::print("  {:<28} {:>8.3f}\n", "all", wall);
}

/// Gauge pressure with the absolute one beside it.
void print_state(int id, double volume, double p, double p_atm, double T, const Everyday& unit) {
    fmt::print("\n  airbag {}: volume {}, pressure {} gauge ({} absolute), temperature {:.5g} K\n",
               id, unit.volume(volume), unit.pressure(p - p_atm), unit.pressure(p), T);
}

void print_bag(const gas::BagGas& bag, const Points& x, const Everyday& unit) {
    const gas::GasState gas = bag.state(x);
    print_state(bag.card().id, gas.volume, gas.pressure, bag.card().p_atm, gas.temperature, unit);
    fmt::print("    gas {} in of {} inside, {} particles, {} wall hits, {} facet list builds\n",
               unit.mass(gas.mass_in), unit.mass(gas.mass), bag.particles().size(), bag.hits(),
               bag.list_builds());
    if (bag.hits() > 0)
        fmt::print("    what particles push reaches the fabric {} late\n",
                   unit.time(bag.load_delay()));
    if (!bag.openings().empty())
        fmt::print("    out through vents {}, through fabric {}, {} particles\n",
                   unit.mass(gas.mass_out_vent), unit.mass(gas.mass_out_fabric),
                   bag.openings().particles_out());
    for (const std::string& shortage : bag.openings().shortages()) fmt::print("    {}\n", shortage);
    fmt::print("    lost particles: {}\n", bag.lost());
    for (const std::string& loss : bag.losses()) fmt::print("      {}\n", loss);
}

void print_bag(const gas::UniformBag& bag, const Everyday& unit) {
    const gas::ControlVolume& gas = bag.gas();
    if (bag.card().law) return;  // no gas: its pressure is the deck's
    print_state(bag.card().id, gas.volume(), gas.pressure(), bag.card().p_atm, gas.temperature(),
                unit);
    fmt::print("    gas {} in, {} out, {} inside\n", unit.mass(bag.mass_in()),
               unit.mass(bag.mass_out()), unit.mass(gas.mass()));
}

/// The first few pairs, by ids.
std::string listed(const std::vector<std::pair<int, int>>& pairs) {
    constexpr std::size_t FEW = 10;
    std::string text;
    for (std::size_t i = 0; i < std::min(FEW, pairs.size()); ++i)
        text += fmt::format("{}{}-{}", i == 0 ? " " : ", ", pairs[i].first, pairs[i].second);
    return pairs.size() > FEW ? text + ", ..." : text;
}

void print_contact(const Simulation& simulation, const contact::SurfaceContact& contact) {
    const contact::ContactCounts& counts = contact.counts();
    fmt::print(
        "\n  contact: {} list builds; {} facets searched, {} candidates, {} near and {} touching "
        "at "
        "the end; {} pairs stopped at the last moment, least gap {:.3g} of its rest value\n",
        counts.builds, counts.searched, counts.candidates, counts.near, counts.touching,
        counts.impacts, counts.least_gap);
    if (counts.impact_zones > 0)
        fmt::print("    {} tangles moved as one for a step\n", counts.impact_zones);
    if (counts.sweeps > 0.0)
        fmt::print(
            "    {:.1f} sweeps a step leave {:.2g} of its impulses in the mean, {:.2g} at worst\n",
            counts.sweeps, counts.residual, counts.worst_residual);
    if (counts.unstopped > 0)
        fmt::print("    {} times held surfaces drove others through each other\n",
                   counts.unstopped);
    print_bad_starts(simulation);
}

void print_ledger(EnergyBooks e, double worst, double brought, const Everyday& unit) {
    const double share = brought > 0.0 ? worst / brought : 0.0;
    if (unit.is_known()) {
        for (double* energy :
             {&e.kinetic, &e.strain, &e.gas, &e.contact, &e.friction, &e.damping, &e.ambient,
              &e.inflow, &e.external, &e.residual, &e.smoothing, &worst})
            *energy *= unit.joule();
    }
    fmt::print("\n  energy{}: inflow {:.6g}, external {:.6g}\n", unit.is_known() ? " [J]" : "",
               e.inflow, e.external);
    fmt::print(
        "    kinetic {:.6g}, strain {:.6g}, gas {:.6g}, ambient {:.6g}, contact {:.6g}, friction "
        "{:.6g}, damping {:.6g}, in transit to the fabric {:.6g}\n",
        e.kinetic, e.strain, e.gas, e.ambient, e.contact, e.friction, e.damping, e.smoothing);
    fmt::print("    residual {:.3g} at the end, {:.3g} at worst", e.residual, worst);
    if (brought > 0.0) fmt::print(" ({:.2g} % of what was brought in)", 100.0 * share);
    fmt::print("\n");
}

}  // namespace

double brought_in(const EnergyBooks& now, double start_kinetic) {
    constexpr double OF_ALL = 1e-6;  // far above rounding, far below what a run is about
    return std::max(now.inflow + std::abs(now.external) + start_kinetic, OF_ALL * now.total);
}

void print_bad_starts(const Simulation& simulation) {
    const BadStarts bad = simulation.bad_starts();
    if (!bad.close.empty())
        fmt::print("    {} pairs of shells began nearer than the contact thickness:{}\n",
                   bad.close.size(), listed(bad.close));
    if (!bad.crossing.empty())
        fmt::print("    {} pairs of shells have crossed since the start:{}\n", bad.crossing.size(),
                   listed(bad.crossing));
}

void Summary::print(Simulation& simulation, const std::string& folder, double worst_residual,
                    double brought) const {
    const double wall = this->wall();
    const Everyday unit(simulation.model().unit_system);
    std::size_t flights = 0;
    for (const gas::BagGas& bag : simulation.bags()) flights += bag.flights();
    const double elements =
        static_cast<double>(simulation.active_shells()) * static_cast<double>(simulation.steps());

    fmt::print("\nnormal termination at t = {} after {} steps\n", unit.time(simulation.time()),
               simulation.steps());
    print_phases(simulation.timings(), wall);
    fmt::print(
        "\n  {} threads ({} cores, {} hardware threads); {:.0f} % of the time in loops that "
        "they share\n",
        parallel::threads(), parallel::cores(), parallel::processors(),
        100.0 * loops_.seconds() / wall);
    fmt::print(
        "\n  {:.3g} particle-steps ({:.3g} a second), {:.3g} element-steps ({:.3g} a second)\n",
        static_cast<double>(flights), static_cast<double>(flights) / wall, elements,
        elements / wall);
    for (const gas::BagGas& bag : simulation.bags()) print_bag(bag, simulation.nodes().x, unit);
    for (const gas::UniformBag& bag : simulation.uniform_bags()) print_bag(bag, unit);
    if (simulation.contact()) print_contact(simulation, *simulation.contact());
    for (const std::string& mending : simulation.model().mendings)
        fmt::print("\n  mended: {}\n", mending);
    print_ledger(simulation.books(), worst_residual, brought, unit);
    fmt::print("\nresults: {0}/results.h5, {0}/results.xdmf (ParaView)\n", folder);
}

double Summary::wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Summary::write(const Simulation& simulation, const std::string& folder) const {
    std::vector<std::string> warnings, phases;
    for (const std::string& warning : simulation.model().warnings)
        warnings.push_back(io::json(warning));
    std::vector<std::string> mended;
    for (const std::string& mending : simulation.model().mendings)
        mended.push_back(io::json(mending));
    for (const auto& [phase, seconds] : simulation.timings().phases())
        phases.push_back(io::json(said(phase)) + ": " + io::json(seconds));
    std::string contact;
    if (simulation.contact()) {
        const contact::ContactCounts& counts = simulation.contact()->counts();
        contact = fmt::format(
            "\"pairs_stopped\": {}, \"tangles\": {}, \"unstopped\": {}, \"sweeps\": {}, "
            "\"residual\": {}, \"worst_residual\": {}",
            counts.impacts, counts.impact_zones, counts.unstopped, io::json(counts.sweeps),
            io::json(counts.residual), io::json(counts.worst_residual));
    }
    io::replace_text(std::filesystem::path(folder) / "run.json",
                     fmt::format("{{\"wall\": {}, \"steps\": {}, \"threads\": {},\n"
                                 "\"parallel\": {},\n"
                                 "\"phases\": {{{}}},\n\"contact\": {{{}}},\n"
                                 "\"warnings\": [{}],\n\"mended\": [{}]}}\n",
                                 io::json(wall()), simulation.steps(), parallel::threads(),
                                 io::json(loops_.seconds()), fmt::join(phases, ", "), contact,
                                 fmt::join(warnings, ", "), fmt::join(mended, ", ")));
}

}  // namespace corpuscle::tools
