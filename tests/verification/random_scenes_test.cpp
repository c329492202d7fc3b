// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: any legal scene runs to its end: status 0, every number of results.h5 finite, masses and
// temperatures that a gas can have, no particle lost, books that close within 1 % of the energy
// brought in (the gas of the start included where particles are less than 1000; where nothing
// moves to rounding), no more energy under way to the fabric than there is, no two facets that
// cross, counted exactly; and the same bits on two threads, and of a run that was killed and
// restarted. Random decks (support/random/random_scene.hpp), through the program that users run.
//
// Scenes 1 to 30 are an ordinary test, 1 to 100 the hidden one, and at wish
//
//   CORPUSCLE_SCENES=500 verify_random_scenes "a hundred*"     scenes 1 to 500
//   CORPUSCLE_SCENES=31-93 KEEP=folder ...                     those, and their decks and results stay

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>

#include "tests/places.hpp"
#include "tests/support/random/random_scene.hpp"
#include "tests/support/runs/scene_run.hpp"

using namespace corpuscle;
using corpuscle::test::SceneRun;

namespace {

constexpr double GAS_ROUNDING =
    1e-9;                   ///< of the energy there is: books where nothing moves but gas
constexpr int FINE = 1000;  ///< particles

std::string text_of(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// The text with the one place where it says `from` changed.
std::string with(std::string text, const std::string& from, const std::string& to) {
    const auto at = text.find(from);
    REQUIRE(at != std::string::npos);
    REQUIRE(text.find(from, at + 1) == std::string::npos);
    return text.replace(at, from.size(), to);
}

/// A rigid box of 6 litres of air at rest, 2 × 2 quads a face, into which helium is blown: a 500th
/// of it in the first half of the time, so that for long there are few particles. SI units.
std::string helium_into_air(int air, int particles) {
    constexpr double EDGE = 0.18171;  // [m]
    std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
    const auto node = [](int i, int j, int k) { return 1 + i + 3 * j + 9 * k; };
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i)
                nodes += fmt::format("{}, {:.6f}, {:.6f}, {:.6f}\n", node(i, j, k), 0.5 * EDGE * i,
                                     0.5 * EDGE * j, 0.5 * EDGE * k);
    int count = 0;
    const auto quad = [&](int a, int b, int c, int d) {
        shells += fmt::format("{}, 1, {}, {}, {}, {}\n", ++count, a, b, c, d);
    };
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j)
            for (const int k : {0, 2}) {
                quad(node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k));
                quad(node(i, k, j), node(i + 1, k, j), node(i + 1, k, j + 1), node(i, k, j + 1));
                quad(node(k, i, j), node(k, i + 1, j), node(k, i + 1, j + 1), node(k, i, j + 1));
            }
    return "*KEYWORD\n*CONTROL_TERMINATION\n10.0e-3\n*DATABASE_ABSTAT\n1.0e-4\n"
           "*DATABASE_BINARY_D3PLOT\n5.0e-3\n" +
           nodes + fmt::format("100000, {0:.6f}, {0:.6f}, {0:.6f}\n", 0.45 * EDGE) + shells +
           "*PART\nwalls\n1, 1, 1\n*SECTION_SHELL\n1, 5\n1.0e-3, 1.0e-3, 1.0e-3, 1.0e-3\n"
           "*MAT_NULL\n1, 1000.0\n*SET_NODE_GENERAL\n1\nALL\n"
           "*BOUNDARY_SPC_SET\n1, 0, 1, 1, 1, 1, 1, 1\n"
           "*DEFINE_CURVE\n1\n0.0, 2.0e-4\n5.0e-3, 2.0e-4\n5.0e-3, 0.1\n10.0e-3, "
           "0.1\n*DEFINE_CURVE\n2\n0.0, 500.0\n1.0, 500.0\n" +
           fmt::format("*AIRBAG_PARTICLE\n1, 0\n{}, 1, 1, 293.0, 101325.0\n{}, 1, 1\n", particles,
                       air) +
           "101325.0, 293.0, 0.02897, 29.1\n1, 2, 0.004, 20.786\n100000, 1.0\n*END\n";
}

void run_scenes(int first, int last) {
    double seconds = 0.0;
    int faults = 0;
    for (int seed = first; seed <= last; ++seed) {
        const support::RandomScene scene = support::random_scene(static_cast<unsigned>(seed));
        const SceneRun run(fmt::format("random_scene_{}", seed), scene.deck,
                           fmt::format("--seed {}", scene.seed));
        // Of a few particles each brings a share of all that the gas holds in one hit
        const double all = run.brought_in + run.held;
        const double of = scene.particles < FINE ? all : run.brought_in;
        std::string fault = run.fault(scene.is_rigid ? GAS_ROUNDING * all : 0.01 * of);
        const auto how = seed % 2 == 0 ? SceneRun::How::RESTARTED : SceneRun::How::TWO_THREADS;
        if (run.status == 0) fault += run.differences(how, 20);
        seconds += run.seconds;
        faults += fault.empty() ? 0 : 1;
        fmt::print("scene {}: {}: {:.1f} s, residual {:.2g} %\n{}", seed, scene.summary,
                   run.seconds, 100.0 * run.worst_residual / of, fault);
        std::fflush(stdout);
        INFO("scene " << seed << ": " << scene.summary << "\n" << fault);
        CHECK(fault.empty());
    }
    fmt::print("{} of {} scenes with a fault, {:.0f} s\n", faults, last - first + 1, seconds);
}

}  // namespace

TEST_CASE("helium is blown into a rigid box of air", "[scenes]") {
    const int air = GENERATE(1, -1, 2);
    const int particles = GENERATE(50, 5000, 20000);
    const std::string deck = helium_into_air(air, particles);
    for (const int seed : {1, 2, 3}) {
        const SceneRun run("helium_into_air", deck, fmt::format("--seed {}", seed));
        const std::string fault = run.fault(GAS_ROUNDING * (run.brought_in + run.held));
        INFO("IAIR " << air << ", NP " << particles << ", seed " << seed << "\n" << fault);
        CHECK(fault.empty());
    }
}

TEST_CASE("the tank test's inflator blows helium", "[scenes]") {
    const std::string folder = CORPUSCLE_MODELS "/tank_test/";
    std::string deck =
        with(text_of(folder + "tank_test.k"), "\nmesh.k\n", "\n" + folder + "mesh.k\n");
    deck = with(deck, "         1         2    0.0285      27.0    0.0056       0.0         1",
                "         1         2     0.004    20.786       0.0       0.0         1");
    const int air = GENERATE(1, -1, 2);
    const int particles = GENERATE(50, 500, 5000);
    const SceneRun run("tank_test_helium", deck,
                       fmt::format("-D IAIR={} -D NP={} --until 2", air, particles));
    const std::string fault = run.fault(GAS_ROUNDING * (run.brought_in + run.held));
    INFO("IAIR " << air << ", NP " << particles << "\n" << fault);
    CHECK(fault.empty());
}

TEST_CASE("random scenes run to their end", "[scenes]") {
    run_scenes(1, 30);
}

/// A few particles of some grams each: against light cloth that the atmosphere crushes, several hits
/// of one particle in a step, and debts of energy beyond what motion pays for; pairs that turn about
/// each other, and have no heat to give to the initial air.
TEST_CASE("scenes of a few heavy particles run to their end", "[scenes]") {
    for (const int seed : {105, 149, 235, 357}) run_scenes(seed, seed);
}

TEST_CASE("a hundred random scenes run to their end", "[.full][scenes]") {
    const auto [first, last] = test::SceneRange::asked();
    run_scenes(first, last);
}
