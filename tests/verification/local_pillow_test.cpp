// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the pressure of particles is quiet: an inflated pillow, free and undamped, moves as it
// does under uniform pressure, but for little more kinetic energy.
#include <catch2/catch.hpp>

#include <set>

#include "tests/support/air.hpp"
#include "tests/support/box_deck.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/deck_run.hpp"
#include "tests/support/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr double RADIUS = 0.25, HALF_HEIGHT = 0.18;    ///< at the start                   [m]
constexpr double DENSITY = 727.0, THICKNESS = 3.3e-4;  ///< of the cloth        [kg/m^3], [m]
constexpr double END = 30e-3;

/// A spheroid so little flat (less than sqrt(2)) that pressure pulls at its cloth everywhere.
DeckMesh pillow() {
    const shapes::Shape ball = shapes::sphere(1.0, 4);
    DeckMesh mesh;
    for (const Vec3& x : ball.x)
        mesh.nodes.push_back(x.cwiseProduct(Vec3(RADIUS, RADIUS, HALF_HEIGHT)));
    for (const auto& [a, b, c] : ball.triangles)
        mesh.quads.push_back({1, {a + 1, b + 1, c + 1, c + 1}});
    return mesh;
}

/// Air of 1.3 atmospheres inside; `uniform_from`: TSW.
std::string deck(const DeckMesh& mesh, double uniform_from) {
    return "*KEYWORD\n*TITLE\npillow\n" + mesh.cards([](const Vec3&) { return false; }) +
           part_card(1, 1) + section_card(1, THICKNESS) +
           fmt::format("*MAT_FABRIC\n1, {}, 0.35e9, , , 0.3\n0.1346e9\n,\n,\n,\n", DENSITY) +
           fmt::format(
               "*AIRBAG_PARTICLE\n1, 0\n100000, 1, 3, 300.0, {}, 0, , {}\n2\n{}, 300.0, "
               "{}, {}\n",
               air::P_ATM, uniform_from, 1.3 * air::P_ATM, air::MOLAR_MASS, air::MOLAR_CP) +
           fmt::format("*CONTROL_TERMINATION\n{},\n*DATABASE_ABSTAT\n1e-4,\n", END) +
           "*DATABASE_BINARY_D3PLOT\n1e-3,\n*END\n";
}

/// Kinetic energy of what nodes do beside the mean of their neighbours: sum m (v - v_mean)² / 2.
double node_scale_energy(const DeckRun& run, const DeckMesh& mesh, std::size_t frame) {
    std::vector<double> mass(mesh.nodes.size(), 0.0);
    std::vector<std::set<int>> near(mesh.nodes.size());
    for (const auto& [part, corners] : mesh.quads) {
        const auto at = [&](int k) -> const Vec3& { return mesh.nodes[corners[k] - 1]; };
        const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
        for (int k = 0; k < 3; ++k) {
            mass[corners[k] - 1] += area * DENSITY * THICKNESS / 3.0;
            near[corners[k] - 1].insert(corners[(k + 1) % 3] - 1);
            near[corners[k] - 1].insert(corners[(k + 2) % 3] - 1);
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

TEST_CASE("an inflated pillow is as quiet as under uniform pressure", "[pillow]") {
    const DeckMesh mesh = pillow();
    const DeckRun particles("pillow", deck(mesh, 1e10));
    const DeckRun uniform("pillow_uniform", deck(mesh, 1e-9));
    REQUIRE(particles.status() == 0);
    REQUIRE(uniform.status() == 0);
    const auto energy = [](const DeckRun& run) {
        return mean_since(run, "/history/energy/kinetic", END - 5e-3);
    };
    const auto node_energy = [&](const DeckRun& run) {
        double sum = 0.0;
        for (std::size_t f = 26; f <= 30; ++f) sum += node_scale_energy(run, mesh, f) / 5.0;
        return sum;
    };
    for (const double t : {5e-3, 10e-3, 20e-3, END})
        report(fmt::format("pillow: kinetic energy at {:.0f} ms [J]", 1e3 * t),
               uniform.at("/history/energy/kinetic", t),
               particles.at("/history/energy/kinetic", t));
    report("pillow: kinetic energy, last 5 ms [J]", energy(uniform), energy(particles));
    const double noise = node_energy(particles);
    report("pillow: that of nodes beside their neighbours [J]", node_energy(uniform), noise);
    CHECK(energy(particles) < 50.0);
    for (const std::string path : {"volume", "pressure"}) {
        const double p = mean_since(particles, "/history/airbag/1/" + path, 0.5 * END),
                     u = mean_since(uniform, "/history/airbag/1/" + path, 0.5 * END);
        report("pillow: " + path + ", mean of the second half", u, p);
        CHECK(p == Approx(u).epsilon(0.01));
    }
}
