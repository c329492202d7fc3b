// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/energy/growth_monitor.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/unit/solver/energy/growth_setup.hpp"

using namespace corpuscle;
using namespace growth_setup;

TEST_CASE("shells at 1.1 of their step are noticed, and who grows is named", "[solver][growth]") {
    // One shell is its own mesh: its bound is the limit
    const bool is_woven = GENERATE(false, true);
    const int which = GENERATE(0, 1, 2);
    const auto scene = [&] {
        Model model =
            sheet(is_woven ? woven() : fabric::MaterialCard(scenes::cloth()), 1, which == 0);
        model.supports.clear();
        model.pressure_loads.clear();
        model.shells.resize(1);
        if (which == 2) model.parts[0].element_form = 9;
        // Taut, so that it stays in tension while it swings
        ReferenceGeometry smaller;
        for (Index n = 0; n < 4; ++n) {
            smaller.nodes.emplace_back(n, 0.99 * model.x[n]);
            model.supports.push_back({n, 4U});
        }
        if (is_woven) model.references = {smaller};
        model.velocity[0] = {1e-3, 2e-3, 0};
        return model;
    };
    CAPTURE(is_woven, which);
    const std::string what = stop(scene(), 1.1, 20e-3);
    CAPTURE(what);
    CHECK(what.find("shell 1 of part 1") != std::string::npos);
    CHECK(what.find("became unstable") != std::string::npos);
    CHECK(stop(scene(), 0.9, 20e-3).empty());
}

TEST_CASE("sheets and balloons beyond their limit are noticed", "[solver][growth]") {
    // The bound is 0.6 to 0.9 of what these meshes could bear
    const bool is_woven = GENERATE(false, true);
    const auto card = is_woven ? woven() : fabric::MaterialCard(scenes::cloth());
    const int which = GENERATE(0, 1, 2);
    CAPTURE(is_woven, which);
    const std::string what =
        stop(which == 0 ? sphere(card) : sheet(card, 8, which == 1), 1.5, 20e-3);
    CAPTURE(what);
    CHECK(what.find("shell ") != std::string::npos);
    CHECK(what.find("became unstable") != std::string::npos);
}

TEST_CASE("a step of 0.9 times the stable one raises no alarm", "[solver][growth]") {
    const bool is_woven = GENERATE(false, true);
    const auto card = is_woven ? woven() : fabric::MaterialCard(scenes::cloth());
    const int which = GENERATE(0, 1, 2);
    CAPTURE(is_woven, which);
    CHECK(stop(which == 0 ? sphere(card) : sheet(card, 8, which == 1), 0.9, 20e-3).empty());
}

TEST_CASE("an oscillator zigzags above its limit only", "[solver][growth]") {
    // x'' = -ω² x, one node; above ω dt = 2 it turns round and grows in every step
    const double limit = GENERATE(0.5, 0.9, 0.97, 1.001, 1.01, 1.1);
    GrowthMonitor monitor({0}, {1.0});
    double x = 0.0, v = 1e-9;
    bool found = false;
    for (int i = 0; i < 1000 && !found; ++i) {
        const Points f(1, Vec3(-4.0 * limit * limit * x, 0.0, 0.0));
        found = monitor.zigzag(f, {1.0}, 1.0) == 0;
        v += f[0].x();
        x += v;
    }
    CHECK(found == (limit > 1.0));
}

TEST_CASE("a node that contacts shake a little is no zigzag of the fabric", "[solver][growth]") {
    // A steady pull hides nothing; kicks from elsewhere that grow, but stay small, are let alone
    const bool is_shaken = GENERATE(false, true);
    GrowthMonitor monitor({0}, {1.0});
    double x = 0.0, v = 1e-9, shake = 1e-9;
    bool found = false;
    for (int i = 0; i < 1000 && !found; ++i) {
        const Points f(1, Vec3(1.0 - (is_shaken ? 2.0 : 4.1) * x, 0.0, 0.0));
        found = monitor.zigzag(f, {1.0}, 1.0) == 0;
        if (is_shaken) shake = -std::min(std::abs(1.1 * shake), 1e-3) * std::copysign(1.0, shake);
        v += f[0].x() - 1.0 + (is_shaken ? shake : 0.0);
        x += v;
    }
    CHECK(found == !is_shaken);
}

TEST_CASE("an oscillator below its limit gains nothing, one that is fed is not blamed",
          "[solver][growth]") {
    const double limit = GENERATE(0.3, 0.9);
    const bool is_fed = GENERATE(false, true);
    const bool from_rest = GENERATE(false, true);
    GrowthMonitor monitor({0}, {1.0});
    const std::vector<double> mass{1.0};
    const double k = 4.0 * limit * limit;
    Points v(1, Vec3(from_rest ? 0.0 : 1.0, 0, 0)), before(1);
    double x = from_rest ? 1.0 : 0.0;
    for (int i = 0; i < 10000; ++i) {
        before = v;
        const double inner = -k * x;
        const double feed = is_fed ? 0.01 * std::cos(0.3 * i) : 0.0;
        v[0].x() += (i == 0 ? 0.5 : 1.0) * (inner + feed);
        const double work = (i == 0 ? 0.5 : 1.0) * inner * 0.5 * (before[0].x() + v[0].x());
        const double early = (i == 0 ? 0.5 : 1.0) * inner * before[0].x();
        REQUIRE_FALSE(monitor.gains({0.5 * k * x * x, work, early}, mass, before, v));
        REQUIRE(std::abs(monitor.gained()) < 1e-9 * monitor.scale());
        x += v[0].x();
    }
}

namespace {

/// x'' = -ω² x + hits by others, one node at rest: steps until its energy is noticed, or -1.
struct Hit {
    int step;
    double speed;
};
int noticed(double limit, const std::vector<Hit>& hits, int steps, double& worst) {
    GrowthMonitor monitor({0}, {1.0});
    const std::vector<double> mass{1.0};
    const double k = 4.0 * limit * limit;
    Points v(1, Vec3::Zero());
    double x = 0.0;
    worst = 0.0;
    for (int i = 0; i < steps; ++i) {
        const Points before = v, f(1, Vec3(-k * x, 0.0, 0.0));
        static_cast<void>(monitor.zigzag(f, mass, 1.0));
        v[0] += (i == 0 ? 0.5 : 1.0) * f[0];
        for (const Hit& hit : hits)
            if (hit.step == i) v[0].x() += hit.speed;
        const double inner = (i == 0 ? 0.5 : 1.0) * f[0].x();
        const double mean = 0.5 * (before[0].x() + v[0].x());
        if (monitor.gains({0.5 * k * x * x, inner * mean, inner * before[0].x()}, mass, before, v))
            return i;
        worst = std::max(worst, std::abs(monitor.gained()) / monitor.scale());
        x += v[0].x();
    }
    return -1;
}

}  // namespace

TEST_CASE("hits on an oscillator at rest are no growth, however strong", "[solver][growth]") {
    // 1e-6 and then 1 m/s: the second's energy is 1e12 times what was given before
    const double limit = GENERATE(0.1, 0.5, 0.9);
    const int second = GENERATE(5, 6, 7, 8);
    const double speed = GENERATE(1.0, -1.0);
    double worst = 0.0;
    CAPTURE(limit, second, speed);
    CHECK(noticed(limit, {{5, 1e-6}, {second, speed}}, 1000, worst) == -1);
    CHECK(noticed(limit, {{0, 1e-6}, {second, speed}, {50, 1e3 * speed}}, 1000, worst) == -1);
    CHECK(worst < 1e-9);
}

TEST_CASE("an oscillator beyond its limit is noticed within a few steps of its first hit",
          "[solver][growth]") {
    // S = θ² W over E° grows by e²ˣ, cosh x = 2 θ² - 1: for 1.01 by 1.76, for 1.05 by 3.5 a step
    const auto [limit, steps] = GENERATE(std::pair(1.01, 6), std::pair(1.05, 4), std::pair(1.5, 2));
    double worst = 0.0;
    CAPTURE(limit);
    const int at = noticed(limit, {{5, 1e-6}}, 1000, worst);
    CHECK(at > 5);
    CHECK(at <= 5 + steps);
}

TEST_CASE("first hits of the gas on light cloth at rest stop no run", "[solver][growth]") {
    const double factor = GENERATE(0.2, 0.5, 0.9);
    const double density = GENERATE(70.0, 700.0);
    const auto particles = GENERATE(std::size_t{20}, std::size_t{500});
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Stop stop = stop_of(bag(density, particles), factor, 0.25e-3, seed);
        CAPTURE(factor, density, particles, seed, stop.why);
        CHECK(stop.why.empty());
    }
}

TEST_CASE("cloth that gas sets in motion beyond its limit is noticed within few steps",
          "[solver][growth]") {
    // This mesh bears 1.55 of the bound; light enough for the fabric to limit the step
    const double density = GENERATE(20.0, 100.0);
    const double factor = GENERATE(1.7, 3.0);
    CHECK(stop_of(bag(density, 500), 0.9, 0.5e-3).why.empty());
    const Stop stop = stop_of(bag(density, 500), factor, 0.5e-3);
    CAPTURE(density, factor, stop.why, stop.time);
    CHECK(stop.why.find("shell ") != std::string::npos);
    CHECK(stop.why.find("became unstable") != std::string::npos);
    CHECK(stop.steps < 20);
}

TEST_CASE("fabric that is all held has no energy from nowhere", "[solver][growth]") {
    GrowthMonitor monitor({}, {0.1});
    const std::vector<double> mass{1.0};
    const Points v{Vec3::Zero()};
    static_cast<void>(monitor.gains({0.0, 0.0, 0.0}, mass, v, v));
    CHECK(!monitor.gains({1e3, 0.0, 0.0}, mass, v, v));
}

TEST_CASE("a strip that is pulled by its end is not blamed, at any time and speed",
          "[solver][growth]") {
    // at rest until its end moves, which works a kick before the others know
    const double begin = GENERATE(0.0, 0.3e-3), speed = GENERATE(0.1, 1.0, 5.0);
    const bool triangles = GENERATE(false, true);
    Model strip = sheet(woven(), 6, triangles);
    strip.pressure_loads.clear();
    strip.supports.clear();
    PrescribedMotion pull;
    for (std::size_t n = 0; n < strip.x.size(); ++n) {
        if (strip.x[n].x() == 0.0) strip.supports.push_back({static_cast<Index>(n), 7U});
        if (strip.x[n].x() > 0.199) pull.nodes.push_back(static_cast<Index>(n));
    }
    strip.curves.push_back({1, {begin, 1.0}, {speed, speed}});
    pull.curve = static_cast<Index>(strip.curves.size()) - 1;
    pull.birth = begin;
    strip.motions.push_back(pull);
    const Stop stop = stop_of(std::move(strip), 0.9, 1e-3);
    CAPTURE(begin, speed, triangles, stop.why, stop.time);
    CHECK(stop.why.empty());
}
