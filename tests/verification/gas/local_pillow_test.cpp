// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the pressure of particles is quiet: an inflated pillow, free and undamped, moves as it
// does under uniform pressure, but for little more kinetic energy.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "tests/support/case_report.hpp"
#include "tests/support/decks/box_deck.hpp"
#include "tests/support/decks/pillow_nodes.hpp"
#include "tests/support/gas/air.hpp"
#include "tests/support/runs/deck_run.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr double SIDE = 0.5, RISE = 0.01;  ///< of the pillow; of its middle at the start [m]
constexpr int CELLS = 40;                  ///< quads along a side
constexpr double DENSITY = 727.0, THICKNESS = 3.3e-4;  ///< of the cloth        [kg/m^3], [m]
constexpr double FULL = 20e-3, END = 30e-3;            ///< all gas is in        [s]

/// Two panels sewn at the rim, z = ± RISE (1 - X²)(1 - Y²), X and Y from -1 to 1.
DeckMesh pillow() {
    DeckMesh mesh;
    PillowNodes node(SIDE, RISE, CELLS, mesh);
    for (const int side : {-1, 1})
        for (int i = 0; i < CELLS; ++i)
            for (int j = 0; j < CELLS; ++j) {
                std::array<int, 4> corners{node(i, j, side), node(i + 1, j, side),
                                           node(i + 1, j + 1, side), node(i, j + 1, side)};
                if (side < 0) std::swap(corners[1], corners[3]);
                // a quad is cut from its first corner: in the pillow's corners from the rim inward
                if ((i == 0 && j == CELLS - 1) || (i == CELLS - 1 && j == 0))
                    std::rotate(corners.begin(), corners.begin() + 1, corners.end());
                mesh.quads.push_back({1, corners});
            }
    return mesh;
}

/// Cloth of models/driver_bag_flat without DAMP; 16 g of air at 700 K, static, come in evenly from
/// the middle, into every direction. `uniform_from`: TSW.
std::string deck(const DeckMesh& mesh, double uniform_from) {
    constexpr double RATE = 0.016 / FULL, T = 700.0;
    constexpr int PARTICLES = 100000;
    return "*KEYWORD\n*TITLE\npillow\n" + mesh.cards([](const Vec3&) { return false; }) +
           part_card(1, 1) + section_card(1, THICKNESS) +
           fmt::format(
               "*MAT_FABRIC\n1, {}, 0.35e9, 0.35e9, , 0.2, 0.2\n5e6, , , 1, 0.05e9, 0.3, "
               "0.1\n,\n,\n,\n",
               DENSITY) +
           fmt::format(
               "*CONTACT_AIRBAG_SINGLE_SURFACE_ID\n1, fabric on fabric\n1, 0, 3\n"
               "0.2, 0.2, 0.0, 0.0, 20.0, 0, 0.0, 1.0E+20\n1.0, 1.0, {0}, {0}\n",
               THICKNESS) +
           node_card(100001, Vec3::Zero()) +
           curve_card(1, {{0.0, RATE}, {FULL, RATE}, {FULL, 0.0}, {1.0, 0.0}}) +
           curve_card(2, {{0.0, T}, {1.0, T}}) +
           fmt::format(
               "*AIRBAG_PARTICLE\n1, 0\n{0}, 1, 3, 300.0, {1}, 0, , {2}\n1, 1, 1\n"
               "{1}, 300.0, {3}, {4}\n1, 2, {3}, {4}\n100001, 1.0\n",
               PARTICLES, air::P_ATM, uniform_from, air::MOLAR_MASS, air::MOLAR_CP) +
           fmt::format("*CONTROL_TERMINATION\n{},\n*DATABASE_ABSTAT\n1e-4,\n", END) +
           "*DATABASE_BINARY_D3PLOT\n1e-3,\n*END\n";
}

/// Kinetic energy of what nodes do beside the mean of their neighbours: sum m (v - v_mean)² / 2.
double node_scale_energy(const DeckRun& run, const DeckMesh& mesh, std::size_t frame) {
    std::vector<double> mass(mesh.nodes.size(), 0.0);
    std::vector<std::set<int>> near(mesh.nodes.size());
    for (const auto& [part, corners] : mesh.quads) {
        const auto at = [&](int k) -> const Vec3& { return mesh.nodes[corners[k] - 1]; };
        const double area = 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
        for (int k = 0; k < 4; ++k) {
            mass[corners[k] - 1] += 0.25 * area * DENSITY * THICKNESS;
            near[corners[k] - 1].insert(corners[(k + 1) % 4] - 1);
            near[corners[k] - 1].insert(corners[(k + 3) % 4] - 1);
        }
    }
    const auto v = run.read(fmt::format("/frames/{:05d}/velocity", frame));
    const auto velocity = [&](std::size_t n) { return Vec3(v[3 * n], v[3 * n + 1], v[3 * n + 2]); };
    double sum = 0.0;
    for (std::size_t n = 0; n < mass.size(); ++n) {
        Vec3 mean = Vec3::Zero();
        for (const int other : near[n])
            mean += velocity(other) / static_cast<double>(near[n].size());
        sum += 0.5 * mass[n] * (velocity(n) - mean).squaredNorm();
    }
    return sum;
}

double mean_since(const DeckRun& run, const std::string& path, double begin) {
    const auto time = run.time(), value = run.read(path);
    double sum = 0.0, count = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] >= begin) {
            sum += value[i];
            count += 1.0;
        }
    return sum / count;
}

}  // namespace

TEST_CASE("a pillow that is blown up is as quiet as under uniform pressure", "[pillow]") {
    const DeckMesh mesh = pillow();
    const DeckRun run("pillow", deck(mesh, 1e10));
    const DeckRun uniform("pillow_uniform", deck(mesh, 1e-9));
    REQUIRE(run.status() == 0);
    REQUIRE(uniform.status() == 0);
    const std::string kinetic = "/history/energy/kinetic";
    for (const double t : {5e-3, 10e-3, 20e-3, END})
        report(fmt::format("pillow: kinetic energy at {:.0f} ms [J]", 1e3 * t),
               uniform.at(kinetic, t), run.at(kinetic, t));
    const auto node_energy = [&](const DeckRun& of) {
        double sum = 0.0;
        for (std::size_t f = 26; f <= 30; ++f) sum += node_scale_energy(of, mesh, f) / 5.0;
        return sum;
    };
    const double in_the_end = mean_since(run, kinetic, END - 5e-3);
    const double of_nodes = node_energy(run);
    report("pillow: kinetic energy, last 5 ms [J]", mean_since(uniform, kinetic, END - 5e-3),
           in_the_end);
    report("pillow: that of nodes beside their neighbours [J]", node_energy(uniform), of_nodes);
    CHECK(in_the_end < 50.0);
    CHECK(of_nodes < 50.0);
    for (const std::string path : {"volume", "pressure"}) {
        const double p = mean_since(run, "/history/airbag/1/" + path, END - 5e-3),
                     u = mean_since(uniform, "/history/airbag/1/" + path, END - 5e-3);
        report("pillow: " + path + ", last 5 ms", u, p);
        CHECK(p == Approx(u).epsilon(0.02));
    }
}
