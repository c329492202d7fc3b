// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: an inflated bag that flies and spins free keeps its momentum and angular momentum: those
// of cloth and gas, and of what the gas has given up and the cloth has not yet got.
//
// Row by row x is that of t and v the mean of v(t - dt/2) and v(t + dt/2). Internal forces F change
// sum m x(t) × v by sum x × F dt = 0 between the two, so the mean is as exact as they are.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "io/deck.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/decks/free_bag.hpp"
#include "tests/support/scenes/flying_bag.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// An ellipsoid that spins about an axis that it is not round about.
free_bag::Bag spinning(double atmospheres) {
    free_bag::Bag bag;
    bag.shape = shapes::sphere(0.1, 3);
    for (Vec3& x : bag.shape.x) x = x.cwiseProduct(Vec3(1.0, 1.0, 0.7));
    bag.p = atmospheres * air::P_ATM;
    bag.spin = 200.0;
    bag.velocity = {3.0, 0.0, -1.0};
    return bag;
}

}  // namespace

TEST_CASE("an inflated bag that spins keeps its angular momentum", "[momentum]") {
    const int atmospheres = GENERATE(2, 10);
    const free_bag::Bag bag = spinning(atmospheres);
    const std::string name = fmt::format("spin_{}_atm", atmospheres);
    const DeckRun run(name, free_bag::deck(bag));
    REQUIRE(run.status() == 0);
    const auto masses = free_bag::node_masses(bag.shape);
    const auto frames = run.read("/frames/time");
    const std::string owed_path = "/history/airbag/1/owed_";
    const bool has_owed = run.has(owed_path + "momentum");
    CHECK(has_owed);
    std::vector<double> owed, owed_angular;
    if (has_owed) {
        owed = run.read(owed_path + "momentum");
        owed_angular = run.read(owed_path + "angular_momentum");
    }
    const auto part = run.read("/history/part/1/momentum");
    REQUIRE(run.time().size() == frames.size());

    free_bag::Momentum start;
    double worst = 0.0, worst_linear = 0.0;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        REQUIRE(run.time()[f] == frames[f]);
        const auto [cloth, gas] = free_bag::momenta(run, f, masses);
        // masses are the program's
        REQUIRE((cloth.linear - free_bag::row(part, f)).norm() < 1e-6 * bag.velocity.norm());
        free_bag::Momentum all{cloth.linear + gas.linear, cloth.angular + gas.angular};
        if (has_owed) {
            all.linear += free_bag::row(owed, f);
            all.angular += free_bag::row(owed_angular, f);
        }
        if (f == 0) start = all;
        const double change = (all.angular - start.angular).norm() / start.angular.norm();
        worst = std::max(worst, change);
        worst_linear =
            std::max(worst_linear, (all.linear - start.linear).norm() / start.linear.norm());
        if (f % 4 == 0)
            report(name + fmt::format(": angular momentum at {:.0f} ms, change of (cloth {:.3g}, "
                                      "gas {:.3g})",
                                      1e3 * frames[f], cloth.angular.x(), gas.angular.x()),
                   0.0, change);
    }
    report(name + ": angular momentum, relative change at worst", 0.0, worst);
    report(name + ": momentum in results, relative change at worst", 0.0, worst_linear);
    CHECK(worst < 1e-6);
    CHECK(worst_linear < 1e-6);  // frames hold velocities in single precision
}

TEST_CASE("a bag at uniform pressure keeps its cloth's angular momentum", "[momentum]") {
    // how exact the measure is: frames hold velocities in single precision
    free_bag::Bag bag = spinning(10);
    bag.is_uniform = true;
    const DeckRun run("spin_uniform", free_bag::deck(bag));
    REQUIRE(run.status() == 0);
    const auto masses = free_bag::node_masses(bag.shape);
    const std::size_t frames = run.read("/frames/time").size();
    const Vec3 start = free_bag::momenta(run, 0, masses).cloth.angular;
    double worst = 0.0;
    for (std::size_t f = 1; f < frames; ++f) {
        const Vec3 now = free_bag::momenta(run, f, masses).cloth.angular;
        worst = std::max(worst, (now - start).norm() / start.norm());
    }
    report("spin_uniform: angular momentum, relative change at worst", 0.0, worst);
    CHECK(worst < 1e-7);
}

TEST_CASE("an inflated bag that flies keeps its momentum", "[momentum]") {
    const int atmospheres = GENERATE(2, 10);
    free_bag::Bag bag = spinning(atmospheres);
    bag.end = 4e-3;
    const std::string name = fmt::format("flight_{}_atm", atmospheres);
    const DeckFile deck(name, free_bag::deck(bag));
    parallel::set_threads(1);
    Simulation simulation(io::read_deck(deck.path()));
    const auto observe = [](Simulation&) {};
    simulation.step(observe);
    const Vec3 start = scenes::momentum(simulation).all();
    double worst = 0.0;
    while (!simulation.is_over()) {
        simulation.step(observe);
        const double change = (scenes::momentum(simulation).all() - start).norm();
        worst = std::max(worst, change / start.norm());
    }
    report(name + ": momentum, relative change at worst", 0.0, worst);
    CHECK(worst < 1e-9);
}
