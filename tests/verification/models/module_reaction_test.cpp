// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what the module of a bag is pushed back with is what gas and fabric carry forward.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <set>

#include "gas/particles.hpp"
#include "io/deck.hpp"
#include "solver/simulation.hpp"
#include "tests/places.hpp"

using namespace corpuscle;

namespace {

/// The scene with a module that is free to fly: a rigid part that carries all nodes that stood
/// still, and the nozzles, whose jets push it (IMOM = 1); vents are shut.
Model with_free_module(const std::string& name, int part_id) {
    Model model = io::read_deck(CORPUSCLE_MODELS "/" + name + "/" + name + ".k",
                                {{{"NP", "10000"}, {"ENDTIM", "1"}}});
    Index part = 0;
    while (model.parts[part].id != part_id) ++part;
    model.parts[part].material = static_cast<Index>(model.materials.size());
    model.materials.push_back({99, "module", fabric::RigidCard{7.8e-6, 210.0, 0.3}});
    std::set<Index> carried;
    for (const Support& support : model.supports) carried.insert(support.node);
    for (gas::OrificeCard& orifice : model.bags.at(0).orifices) {
        orifice.pushes = true;
        carried.insert(orifice.node);
    }
    for (const Shell& shell : model.shells)
        if (shell.part == part)
            for (const Index node : shell.nodes) carried.erase(node);
    model.supports.clear();
    model.bags[0].vents.clear();  // what leaves would take its momentum along, unbooked
    for (const Index node : carried) model.rigid_extra_nodes.push_back({part, node});
    return model;
}

struct Momentum {
    Vec3 module = Vec3::Zero();     ///< of the rigid part, with the nodes that ride on it
    Vec3 fabric = Vec3::Zero();     ///< of all other nodes
    Vec3 gas = Vec3::Zero();        ///< of the particles
    Vec3 under_way = Vec3::Zero();  ///< from hits, not yet given to the fabric
};

Momentum momentum(const Simulation& now) {
    Momentum sum;
    std::vector<char> is_free(now.nodes().size(), 1);
    for (const RigidBody& body : now.bodies()) {
        sum.module += body.mass() * body.velocity();
        for (const Index node : body.nodes()) is_free[node] = 0;
    }
    for (std::size_t n = 0; n < is_free.size(); ++n)
        if (is_free[n]) sum.fabric += now.nodes().mass[n] * now.nodes().v[n];
    const gas::BagGas& bag = now.bags().at(0);
    for (std::size_t i = 0; i < bag.particles().size(); ++i)
        sum.gas += bag.particle_mass()[bag.particles().species[i]] * bag.particles().v[i];
    sum.under_way = bag.owed().linear;
    return sum;
}

/// Of the particles. None leaves.
double mass_of_all(const Simulation& now) {
    const gas::BagGas& bag = now.bags().at(0);
    double sum = 0.0;
    for (const std::int32_t species : bag.particles().species) sum += bag.particle_mass()[species];
    return sum;
}

/// Mean of the nozzles in the last step.
Vec3 nozzle_velocity(const Simulation& now) {
    Vec3 sum = Vec3::Zero();
    const auto& orifices = now.bags().at(0).card().orifices;
    for (const gas::OrificeCard& orifice : orifices)
        sum += now.nodes().v[orifice.node] / static_cast<double>(orifices.size());
    return sum;
}

/// @param share  of the module's momentum that may be missing at most
void check(const std::string& name, int module_part, double share) {
    Simulation simulation(with_free_module(name, module_part));
    Vec3 on_plate = Vec3::Zero();  // impulse on what is no part of the balance
    Vec3 brought = Vec3::Zero();   // by new gas, which came along with the module
    double mass_in = 0.0;
    double greatest = 0.0, missing = 0.0;
    Momentum now;
    while (!simulation.is_over()) {
        Vec3 force = Vec3::Zero();
        const StepReport report = simulation.step([&](Simulation& at) {
            if (!at.walls().empty()) force = at.walls().front().force();
        });
        on_plate += report.dt * force;
        now = momentum(simulation);
        const double mass = mass_of_all(simulation);
        brought += (mass - mass_in) * nozzle_velocity(simulation);
        mass_in = mass;
        greatest = std::max(greatest, now.module.norm());
        missing = std::max(
            missing,
            (now.module + now.fabric + now.gas + now.under_way + on_plate - brought).norm());
    }
    fmt::print(
        "{}: after 1 ms module {:.4g}, fabric {:.4g}, gas {:.4g}, under way {:.4g}, plate {:.4g} "
        "kg mm/ms along z; at most {:.2g} of the module's is missing\n",
        name, now.module[2], now.fabric[2], now.gas[2], now.under_way[2], on_plate[2],
        missing / greatest);
    CHECK(simulation.bags().at(0).state(simulation.nodes().x).particles_out == 0.0);
    CHECK(now.module[2] < 0.0);
    CHECK(now.fabric[2] > 0.0);
    CHECK(missing < share * greatest);
}

}  // namespace

TEST_CASE("the flat bag's module takes what gas and fabric carry forward", "[model]") {
    check("driver_bag_flat", 3, 1e-3);
}

TEST_CASE("the folded bag's module takes what gas and fabric carry forward", "[model][folded]") {
    check("driver_bag_folded", 7, 1e-5);
}
