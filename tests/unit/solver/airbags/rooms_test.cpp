// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rooms of a bag: what is told of each alone.
#include <catch2/catch.hpp>

#include <array>
#include <string>
#include <vector>

#include "solver/base/error.hpp"
#include "solver/simulation.hpp"
#include "tests/unit/solver/airbags/two_chambers.hpp"

using namespace corpuscle;
using Catch::Contains;

TEST_CASE("after the switch a sensor reads the room that it lies in, be it a chamber or not",
          "[solver][chambers]") {
    Model model = chambered::two_chambers();
    model.bags[0].switch_at = 1.2e-3;
    const int chambers = GENERATE(0, 1, 2);  // one: of two rooms
    if (chambers == 0) model.bags[0].chambers.clear();
    if (chambers == 1) model.bags[0].chambers = {{21, {0, 1}}};
    // Beside a segment at z = 0 whose normal points into the large room; the small one is behind it
    for (const double offset : {0.05, 0.12})
        model.sensors.push_back(
            {gas::SensorCard::Shape::SPHERE, model.shells[0].nodes, offset, {0.01}});
    Simulation simulation(model);
    double residual = 0.0;
    chambered::run_until(simulation, 1.0, residual);
    simulation.close([&](Simulation& at_end) {
        const auto sensors = at_end.sample().sensors;
        const double T[] = {600.0, 300.0}, volume[] = {1e-3, 0.5e-3};
        for (const std::size_t k : {0, 1}) {
            CHECK(sensors[k].density == Approx(1e-3 / volume[k]).epsilon(1e-9));
            CHECK(sensors[k].temperature == Approx(T[k]).epsilon(1e-9));
            CHECK(sensors[k].pressure ==
                  Approx(1e-3 / 0.028 * GAS_CONSTANT * T[k] / volume[k]).epsilon(1e-9));
        }
    });
}

TEST_CASE("chambers within chambers, down to what no card names", "[solver][chambers]") {
    // Cubes in cubes, edges 0.2, 0.1, 0.06 and 0.03 m: parts 0 to 3, all but the first internal
    Model model = scenes::of(shapes::box(Vec3::Constant(0.2), 2), scenes::null_material(), 1e-3);
    const double edge[] = {0.2, 0.1, 0.06, 0.03};
    for (Index part = 1; part < 4; ++part) {
        const shapes::Shape cube = shapes::box(Vec3::Constant(edge[part]), 2);
        const auto first = static_cast<Index>(model.x.size());
        for (const Vec3& x : cube.x) {
            model.x.push_back(x + Vec3::Constant(0.1 - 0.5 * edge[part]));
            model.velocity.push_back(Vec3::Zero());
            model.node_id.push_back(static_cast<int>(model.x.size()));
        }
        for (const auto& [a, b, c] : cube.triangles)
            model.shells.push_back({static_cast<int>(model.shells.size()) + 1,
                                    part,
                                    {first + a, first + (part == 2 ? c : b),
                                     first + (part == 2 ? b : c), first + (part == 2 ? b : c)}});
        model.parts.push_back(model.parts[0]);
        model.parts.back().id = part + 1;
    }
    scenes::fix_all_nodes(model);
    gas::BagCard bag;
    bag.id = 1;
    bag.external_parts = {0};
    bag.internal_parts = {1, 2, 3};
    bag.particles = 2000;
    bag.air = gas::InitialAirCard{scenes::air(), 1e5, 300.0};
    model.bags = {bag};
    model.end_time = 1e-5;
    const auto volume = [&](int cube) { return edge[cube] * edge[cube] * edge[cube]; };
    const auto check = [&](const std::vector<gas::ChamberCard>& cards,
                           const std::vector<double>& wanted) {
        model.bags[0].chambers = cards;
        const Simulation simulation(model);
        const auto found = chambered::chambers(simulation);
        REQUIRE(found.size() == wanted.size());
        for (std::size_t c = 0; c < found.size(); ++c) {
            CAPTURE(c);
            CHECK(found[c].volume == Approx(wanted[c]).epsilon(1e-12));
            CHECK(found[c].mass ==
                  Approx(1e5 * 0.028 / (GAS_CONSTANT * 300.0) * wanted[c]).epsilon(1e-9));
        }
    };
    const double v[] = {volume(0) - volume(1), volume(1) - volume(2), volume(2) - volume(3),
                        volume(3)};
    SECTION("each a chamber, in any order") {
        check({{11, {2}}, {12, {0}}, {13, {3}}, {14, {1}}}, {v[2], v[0], v[3], v[1]});
    }
    SECTION("their cards name the cavities") {
        check({{11, {0, 1}}, {12, {1, 2}}, {13, {2, 3}}, {14, {3}}}, {v[0], v[1], v[2], v[3]});
    }
    SECTION("a chamber of two rooms, one within the other's cavity") {
        check({{11, {0, 1, 2}}, {12, {1, 2}}}, {v[0] + v[2] + v[3], v[1]});
    }
    SECTION("what no card names belongs to the chamber around it") {
        check({{11, {0}}, {12, {1}}}, {v[0], v[1] + v[2] + v[3]});
    }
    SECTION("around chambers in a bag that is none, there is none") {
        check({{12, {1}}}, {v[1] + v[2] + v[3]});
    }
    SECTION("a cavity that belongs to no chamber is refused") {
        model.bags[0].chambers = {{11, {0, 1}}};
        CHECK_THROWS_AS(Simulation(model), InputError);
    }
}

TEST_CASE("a room that no gas is in and none comes to is warned of", "[solver][chambers]") {
    Model model = chambered::two_chambers();
    gas::BagCard& bag = model.bags[0];
    const auto told = [&] {
        std::string all;
        const Simulation simulation(model);
        for (const std::string& line : simulation.model().warnings)
            if (line.find("vacuum") != std::string::npos) all += line;
        return all;
    };
    CHECK(told().empty());
    bag.inflow.pop_back();
    bag.orifices.pop_back();
    CHECK_THAT(told(), Contains("bag 1, chamber 22: a vacuum") && Contains("IAIR = 1") &&
                           !Contains("chamber 21"));
    SECTION("but not of one that a hole leads to") {
        gas::VentCard hole;
        hole.parts = {3};
        bag.vents = {hole};
        CHECK(told().empty());
    }
    SECTION("nor of one with air") {
        bag.air = gas::InitialAirCard{scenes::air(), 2e4, 300.0};
        CHECK(told().empty());
    }
    SECTION("without chambers by the number of the room") {
        bag.chambers.clear();
        CHECK_THAT(told(), Contains("bag 1, room 2: a vacuum"));
    }
}

TEST_CASE("fabric between chambers lets the gas of each side through, whatever is on the other",
          "[solver][chambers]") {
    // density · area · FLC · FAC each way; initial air before the switch, uniform gas after it
    const double switch_at = GENERATE(1e10, 1e-9);
    constexpr double FLC = 0.5, FAC = 20.0, R = GAS_CONSTANT / 0.028, CP = 28.0 / 0.028;
    Model model = chambered::two_chambers();
    gas::BagCard& bag = model.bags[0];
    bag.inflow.clear();
    bag.orifices.clear();
    bag.air = gas::InitialAirCard{scenes::air(), 2e5, 300.0};
    bag.switch_at = switch_at;
    fabric::FabricCard cloth;
    cloth.density = 1000.0;
    cloth.E_warp = cloth.E_weft = 1e8;
    cloth.G = 4e7;
    cloth.leak_area = FLC;
    cloth.leak_velocity = FAC;
    cloth.leak_option = 7;
    model.materials.push_back({2, "", cloth});
    model.parts[3].material = 1;
    gas::VentCard out;  // of the small chamber, until 2 ms
    out.parts = {4};
    out.is_isentropic = true;
    model.curves.push_back({9, {0.0, 2e-3, 2.000001e-3, 1.0}, {1.0, 1.0, 0.0, 0.0}});
    out.time_curve = static_cast<Index>(model.curves.size() - 1);
    for (Shell& shell : model.shells)
        if (shell.part == 1) {
            shell.part = 4;
            break;
        }
    model.parts.push_back(model.parts[1]);
    model.parts[4].id = 5;
    bag.external_parts.push_back(4);
    bag.chambers[1].parts.push_back(4);
    bag.vents = {out};
    model.end_time = 8e-3;
    Simulation simulation(model);
    double residual = 0.0;
    chambered::run_until(simulation, 2.1e-3, residual);
    auto wanted = chambered::chambers(simulation);
    CHECK(wanted[1].mass / wanted[1].volume < 0.8 * wanted[0].mass / wanted[0].volume);
    const double from = simulation.time();
    chambered::run_until(simulation, 7e-3, residual);
    constexpr double AREA = 0.5 * (0.1 / 3.0) * (0.1 / 3.0);
    chambered::seep(wanted, FLC * FAC * AREA, CP / (CP - R), simulation.time() - from);
    const auto found = chambered::chambers(simulation);
    for (const std::size_t c : {0, 1}) {
        CAPTURE(switch_at, c);
        CHECK(found[c].mass == Approx(wanted[c].mass).epsilon(1e-3));
        CHECK(found[c].energy == Approx(wanted[c].energy).epsilon(5e-3));
    }
    CHECK(residual < 1e-12 * found[0].energy);
}
