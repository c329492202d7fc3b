// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: of two rooms with a closed membrane between, each is a tank of its own: what leaves
// through a vent, and what heat goes to a wall, is paid by the gas of that room alone.
#include <catch2/catch.hpp>

#include "tests/support/case_report.hpp"
#include "tests/support/decks/two_rooms.hpp"
#include "tests/support/runs/deck_run.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

const std::string BAG = "/history/airbag/1/";

/// Greatest relative change of a history from its value at `from`, up to the end.
double greatest_change(const DeckRun& run, const std::string& path, double from) {
    const auto time = run.time(), value = run.read(path);
    const double start = run.at(path, from);
    double worst = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= from) worst = std::max(worst, std::abs(value[i] / start - 1.0));
    return worst;
}

/// Greatest relative error of A's mass after the vent has opened, and its share in the end.
struct BlowDown {
    double error, kept, kept_exactly;
};
BlowDown blow_down(const DeckRun& run, const std::string& mass, const rooms::Scene& scene) {
    oracle::StirredTank tank = rooms::tank(scene.a.p, scene.a.T);
    const double full = tank.mass();
    const auto time = run.time(), measured = run.read(mass);
    const auto share = [&](const oracle::StirredTank& now) {
        return rooms::vent_flow(now, scene.C23) / now.mass();
    };
    BlowDown found{0.0, 0.0, 0.0};
    double now = scene.opens;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] <= now) continue;
        tank.empty(time[i] - now, 50, share);
        now = time[i];
        found.error = std::max(found.error, std::abs(measured[i] / tank.mass() - 1.0));
    }
    found.kept = measured.back() / full;
    found.kept_exactly = tank.mass() / full;
    return found;
}

}  // namespace

TEST_CASE("a room that vents is a tank, and its neighbour keeps its energy", "[rooms][vent]") {
    // told apart by gases that differ in name only, or by chambers full of air from the start
    const bool has_chambers = GENERATE(false, true);
    rooms::Scene scene;
    scene.has_chambers = scene.is_air_there = has_chambers;
    scene.opens = has_chambers ? 0.5e-3 : 3e-3;
    scene.end = scene.opens + 7e-3;
    const std::string name = has_chambers ? "vent_chambers" : "vent_species";
    const DeckRun run(name, rooms::deck(scene));
    REQUIRE(run.status() == 0);
    const std::string a = BAG + (has_chambers ? "chamber/1/" : "species/1/"),
                      b = BAG + (has_chambers ? "chamber/2/" : "species/2/");
    const BlowDown found = blow_down(run, a + "mass", scene);
    const double change = greatest_change(run, b + "energy", scene.opens - 1e-4);
    report(name + ": A keeps of its mass", found.kept_exactly, found.kept);
    report(name + ": A's mass off by, at worst", 0.0, found.error);
    report(name + ": B's energy changes by, at worst", 0.0, change);
    CHECK(found.error < 0.02);
    CHECK(change < 1e-12);
}

TEST_CASE("nothing leaves a room at the atmosphere's pressure beside one at five times that",
          "[rooms][vent]") {
    rooms::Scene scene;
    scene.particles = 60000;
    scene.is_air_there = scene.has_chambers = true;
    scene.a.p = rooms::P_ATM;
    scene.opens = 3e-3;
    scene.end = 8e-3;
    const DeckRun run("vent_still", rooms::deck(scene));
    REQUIRE(run.status() == 0);
    const double mass = rooms::density(rooms::P_ATM, scene.a.T) * rooms::ROOM;
    const auto out = [&](double t) { return run.at(BAG + "mass_out_vent", t) / mass; };
    report("vent_still: out of A after 1 ms, of its mass", 0.0, out(scene.opens + 1e-3));
    report("vent_still: out of A after 5 ms, of its mass", 0.0, out(scene.end));
    const double change = greatest_change(run, BAG + "chamber/2/energy", scene.opens - 1e-4);
    report("vent_still: B's energy changes by, at worst", 0.0, change);
    CHECK(out(scene.end) < 0.005);
    CHECK(change < 1e-12);
}

TEST_CASE("a wall at the gas's own temperature takes no heat, whatever is behind the membrane",
          "[rooms][heat]") {
    rooms::Scene scene;
    scene.particles = 40000;
    scene.b.T = 600.0;
    scene.hconv_a = 1000.0;
    scene.end = 20e-3;
    const DeckRun run("heat_none", rooms::deck(scene));
    REQUIRE(run.status() == 0);
    const double a = greatest_change(run, BAG + "species/1/energy", 2e-3),
                 b = greatest_change(run, BAG + "species/2/energy", 2e-3);
    // a gas of N particles in a bath scatters by 1 / sqrt(N Cv / R) of its energy, once the bath
    // has had time: h A t / (m cv) is of order 1
    const double N = scene.particles * 2.0 / 3.0;
    const double scatter = 1.0 / std::sqrt(N / (rooms::GAMMA - 1.0));
    const oracle::StirredTank tank = rooms::tank(scene.a.p, scene.a.T);
    const double times =
        scene.hconv_a * rooms::WALLS * (scene.end - 2e-3) / tank.heat_capacity(1.0);
    const double bound = 3.0 * scatter * std::sqrt(1.0 - std::exp(-2.0 * times));
    report("heat_none: A's energy changes by, at worst (bound " + std::to_string(bound) + ")", 0.0,
           a);
    report("heat_none: B's energy changes by, at worst", 0.0, b);
    CHECK(a < bound);
    CHECK(b < 1e-12);
}

TEST_CASE("a room whose walls cool it follows its own equation", "[rooms][heat]") {
    rooms::Scene scene;
    scene.particles = 40000;
    scene.b.T = 600.0;
    scene.hconv_b = 1000.0;
    scene.end = 20e-3;
    const DeckRun run("heat_own", rooms::deck(scene));
    REQUIRE(run.status() == 0);
    // m cv dT/dt = -h A (T - T_atm), from 2 ms on
    const double begin = 2e-3;
    const double area = 0.03;
    const double capacity = rooms::tank(scene.b.p, scene.b.T).heat_capacity(1.0);
    const double start = run.at(BAG + "species/2/energy", begin);
    const double rest = capacity * rooms::T_ATM;
    const auto time = run.time(), energy = run.read(BAG + "species/2/energy");
    double worst = 0.0, lost_exactly = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] < begin) continue;
        const double left = std::exp(-scene.hconv_b * area * (time[i] - begin) / capacity);
        const double exact = rest + (start - rest) * left;
        lost_exactly = start - exact;
        worst = std::max(worst, std::abs(energy[i] / exact - 1.0));
    }
    const double a = greatest_change(run, BAG + "species/1/energy", begin);
    report("heat_own: B loses of its energy", lost_exactly / start,
           (start - energy.back()) / start);
    report("heat_own: B's energy off by, at worst", 0.0, worst);
    report("heat_own: A's energy changes by, at worst", 0.0, a);
    CHECK(worst < 0.02);
    CHECK(a < 1e-12);
}
