// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "gas/thermo/control_volume.hpp"
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/error.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

constexpr double CV = 718.0, CP = 1005.0, GAMMA = CP / CV, ATM = 101325.0;
const Simulation::Observer NOTHING = [](Simulation&) {};

gas::UniformBagCard over(const Model& model) {
    gas::UniformBagCard card;
    card.keyword = "*AIRBAG_SIMPLE_AIRBAG_MODEL";
    card.id = 1;
    for (std::size_t s = 0; s < model.shells.size(); ++s)
        card.shells.push_back(static_cast<Index>(s));
    card.cv = CV, card.cp = CP;
    card.p_atm = ATM;
    card.density = 1.2;
    return card;
}

/// A rigid box of 1 l.
Model rigid_box() {
    Model model = scenes::of(shapes::box({0.1, 0.1, 0.1}, 1), scenes::null_material(), 1e-3);
    scenes::fix_all_nodes(model);
    model.uniform_bags = {over(model)};
    return model;
}

Index add_curve(Model& model, std::vector<double> x, std::vector<double> y) {
    model.curves.push_back({static_cast<int>(model.curves.size()) + 1, std::move(x), std::move(y)});
    return static_cast<Index>(model.curves.size() - 1);
}

/// The box's wall at x = 0.1 moves by `stroke` and back within 10 ms.
Model piston(double stroke) {
    Model model = scenes::of(shapes::box({0.1, 0.1, 0.1}, 1), scenes::null_material(), 1e-3);
    model.uniform_bags = {over(model)};
    std::vector<double> t, v;
    for (int i = 0; i <= 400; ++i) {
        t.push_back(1e-2 * i / 400);
        v.push_back(stroke * M_PI / 1e-2 * std::sin(2.0 * M_PI * i / 400));
    }
    PrescribedMotion motion;
    motion.axis = Vec3::UnitX();
    motion.curve = add_curve(model, t, v);
    for (std::size_t n = 0; n < model.x.size(); ++n) {
        if (model.x[n].x() > 0.05) motion.nodes.push_back(static_cast<Index>(n));
        model.supports.push_back({static_cast<Index>(n), model.x[n].x() > 0.05 ? 6U : 7U});
    }
    model.motions = {motion};
    model.end_time = 1e-2;
    return model;
}

}  // namespace

TEST_CASE("uniform gas keeps p V^gamma to second order in the step", "[solver][gas]") {
    const double stroke = GENERATE(0.1, -0.05);
    const auto error = [&](double end) {
        Model model = piston(stroke);
        model.end_time = end;  // nothing limits the step but a thousandth of this
        Simulation simulation(model);
        double worst = 0.0;
        const gas::UniformBag& bag = simulation.uniform_bags()[0];
        const double p0 = bag.gas().pressure(), V0 = bag.gas().volume();
        while (!simulation.is_over())
            simulation.step([&](Simulation&) {
                const double exact = p0 * std::pow(V0 / bag.gas().volume(), GAMMA);
                worst = std::max(worst, std::abs(bag.gas().pressure() / exact - 1.0));
            });
        return worst;
    };
    const double coarse = error(4e-2), fine = error(1e-2);
    CAPTURE(coarse, fine);
    CHECK(fine < 5e-6);
    CHECK(fine < coarse / 12.0);  // 16 for second order
}

TEST_CASE("a mixture with Cp(T) is compressed along its adiabat", "[gas]") {
    const gas::Species co2({0.044, 22.0, 0.056, -2e-5}, GAS_CONSTANT, "CO2");
    const gas::Species air({0.029, 29.1, 0.0, 0.0}, GAS_CONSTANT, "air");
    gas::ControlVolume gas({co2, air});
    gas.add(0, 2.0, 2.0 * co2.molar_energy()(400.0));
    gas.add(1, 1.0, air.molar_energy()(400.0));
    constexpr int STEPS = 4000;
    double V = 0.1;
    REQUIRE(gas.settle(V));
    // Entropy: sum n_s (integral of Cv dT/T + R ln V) stays.
    const auto entropy = [&] {
        const double T = gas.temperature(), R = GAS_CONSTANT;
        return 2.0 * ((22.0 - R) * std::log(T) + 0.056 * T - 1e-5 * T * T) +
               (29.1 - R) * std::log(T) + 3.0 * R * std::log(gas.volume());
    };
    const double before = entropy();
    for (int i = 0; i < STEPS; ++i) {
        // the leapfrog's order: work from half a step before to half a step after
        const double dV = -0.06 / STEPS;
        gas.work(i == 0 ? 0.5 * dV : dV);
        V += dV;
        REQUIRE(gas.settle(V));
    }
    CHECK(gas.temperature() > 450.0);
    CHECK(entropy() == Approx(before).margin(1e-5));
}

TEST_CASE("a rigid tank fills to the stagnation temperature", "[solver][gas]") {
    Model model = rigid_box();
    model.end_time = 1e-2;
    model.uniform_bags[0].density = 1e-6;
    model.uniform_bags[0].p_atm = 1e-3;
    model.uniform_bags[0].mass_rate = add_curve(model, {0.0, 5e-3, 1e-2}, {0.0, 1.0, 0.0});
    model.uniform_bags[0].temperature.value = 300.0;
    Simulation simulation(model);
    while (!simulation.is_over()) simulation.step(NOTHING);
    simulation.close([](Simulation& at_end) {
        const AirbagSample bag = at_end.sample().airbags.at(0);
        CHECK(bag.mass_in == Approx(5e-3).epsilon(1e-12));
        CHECK(bag.temperature == Approx(300.0 * GAMMA).epsilon(1e-6));
        CHECK(bag.pressure == Approx(5e-3 * (CP - CV) * 300.0 * GAMMA / 1e-3).epsilon(1e-6));
        CHECK(bag.energy == Approx(5e-3 * CP * 300.0).epsilon(1e-6));
        CHECK(std::abs(at_end.books().residual) < 1e-12 * at_end.books().inflow);
        CHECK(at_end.layout().airbags.at(0).parts == std::vector<int>{1});
    });
}

TEST_CASE("a rigid tank blows down by the equations of Wang and Nefske", "[solver][gas]") {
    Model model = rigid_box();
    model.end_time = 8e-3;
    gas::UniformBagCard& card = model.uniform_bags[0];
    card.overpressure = 4.0 * ATM;
    card.exits = {{{0.7}, false, {4e-4}, {}}};
    Simulation simulation(model);

    double m = 1.2e-3, T = 5.0 * ATM / (1.2 * (CP - CV)), t = 0.0, worst = 0.0;
    const auto rate = [&](double mass, double temperature) {
        const double p = mass * (CP - CV) * temperature / 1e-3, r = ATM / p;
        const double k = GAMMA, choked = std::pow(2.0 / (k + 1.0), k / (k - 1.0));
        const double Q = std::max(r, choked);
        return 0.7 * 4e-4 * p * std::pow(Q, 1.0 / k) *
               std::sqrt(2.0 * k / (k - 1.0) / ((CP - CV) * temperature) *
                         (1.0 - std::pow(Q, (k - 1.0) / k)));
    };
    const double m0 = m;
    const auto watch = [&](Simulation& at_t) {
        // what stays has expanded isentropically: T ~ m^(gamma - 1)
        while (t < at_t.time() - 1e-12) {
            const double dt = std::min(1e-7, at_t.time() - t);
            const double half = m - 0.5 * dt * rate(m, T * std::pow(m / m0, GAMMA - 1.0));
            m -= dt * rate(half, T * std::pow(half / m0, GAMMA - 1.0));
            t += dt;
        }
        worst = std::max(worst, std::abs(at_t.uniform_bags()[0].gas().mass() / m - 1.0));
    };
    while (!simulation.is_over()) simulation.step(watch);
    CHECK(m < 0.5 * m0);
    CHECK(worst < 2e-3);
    simulation.close([&](Simulation& at_end) {
        CHECK(at_end.sample().airbags[0].mass_out_vent == Approx(m0 - m).epsilon(2e-3));
        CHECK(std::abs(at_end.books().residual) < 1e-9 * at_end.books().outflow);
    });
}

TEST_CASE("exits stay shut below PPOP, and a curve of gauge pressure replaces them",
          "[solver][gas]") {
    Model model = rigid_box();
    model.end_time = 1e-3;
    gas::UniformBagCard& card = model.uniform_bags[0];
    card.overpressure = 5e4;
    card.exits = {{{1.0}, false, {1e-4}, {}}};
    const auto left = [&] {
        Simulation simulation(model);
        while (!simulation.is_over()) simulation.step(NOTHING);
        return simulation.uniform_bags()[0].gas().mass();
    };
    CHECK(left() < 1.19e-3);
    card.opens_at = 6e4;
    CHECK(left() == Approx(1.2e-3).epsilon(1e-12));
    card.opens_at = 4e4;
    card.exit_rate = add_curve(model, {0.0, 4e4, 6e4}, {0.01, 0.01, 0.01});
    CHECK(left() == Approx(1.2e-3 - 0.01 * 1e-3).epsilon(1e-4));
}

TEST_CASE("VSCA, VINI and PSCA scale volume and load, and the books say where energy went",
          "[solver][gas]") {
    Model model = piston(0.1);
    gas::UniformBagCard& card = model.uniform_bags[0];
    card.volume_scale = 1.5;
    card.volume_taken = 2e-4;
    card.pressure_scale = 2.0;
    Simulation simulation(model);
    const gas::UniformBag& bag = simulation.uniform_bags()[0];
    CHECK(bag.gas().volume() == Approx(1.5e-3 - 2e-4));
    CHECK(bag.gas().mass() == Approx(1.2 * bag.gas().volume()));
    double worst = 0.0, most = 0.0;
    const double V0 = bag.gas().volume();
    const auto watch = [&](Simulation& at_t) {
        worst = std::max(worst, std::abs(at_t.books().residual));
        most = std::max(most, std::abs(at_t.books().gas - 252.0));
        const double exact = ATM * std::pow(V0 / bag.gas().volume(), GAMMA);
        CHECK(bag.gas().pressure() == Approx(exact).epsilon(1e-5));
        Vec3 sum = Vec3::Zero();
        for (std::size_t n = 0; n < model.x.size(); ++n)
            if (model.x[n].x() > 0.05) sum += bag.force(static_cast<Index>(n));
        // the faces beside the moving one carry a third of theirs each, in y and z only
        CHECK(sum.x() == Approx(0.01 * 2.0 * (bag.gas().pressure() - ATM)).margin(1e-6));
    };
    while (!simulation.is_over()) simulation.step(watch);
    CHECK(worst < 1e-3 * most);
}

TEST_CASE("a bag of uniform pressure without volume at the start is refused", "[solver][gas]") {
    Model model = rigid_box();
    model.uniform_bags[0].volume_taken = 2e-3;
    CHECK_THROWS_AS(Simulation(model), InputError);
}

TEST_CASE("a mass flow below zero is refused by its curve", "[solver][gas]") {
    Model model = rigid_box();
    model.uniform_bags[0].mass_rate = add_curve(model, {0.0, 1.0}, {0.0, -1e30});
    model.uniform_bags[0].temperature.value = 500.0;
    CHECK_THROWS_WITH(Simulation(model), Catch::Contains("*AIRBAG_SIMPLE_AIRBAG_MODEL 1") &&
                                             Catch::Contains("mass-flow curve 1 falls to -1e+30"));
}
