// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: decks as pre-processors write them are read, and mean what their authors meant
// (tests/decks).

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

#include "gas/thermo/orifice_flow.hpp"
#include "tests/support/decks/stepped_deck.hpp"
#include "tests/verification/decks/decks_setup.hpp"

using namespace corpuscle;
using namespace decks_setup;

TEST_CASE("Wang and Nefske's inflator card is there and blank", "[io]") {
    Run run("wang_nefske_inflator_card.k");
    const gas::UniformBag& bag = run.scene.uniform_bags().at(0);
    CHECK(bag.card().id == 7);
    CHECK(bag.gas().mass() == Approx(RO * VOLUME).epsilon(1e-12));
    CHECK(bag.gas().pressure() == Approx(PE).epsilon(1e-12));
    run.steps(5);
    CHECK(bag.mass_in() == Approx(0.1 * run.scene.time()).epsilon(1e-12));
    CHECK_FALSE(tells(run.scene.model().warnings, "inflator card"));
}

TEST_CASE("with CV = 0 heat capacities stand behind the inflator card", "[io]") {
    Run run("wang_nefske_molar.k");
    const gas::UniformBagCard& card = run.scene.uniform_bags().at(0).card();
    CHECK(card.cp == Approx((26.0 + 0.01 * 300.0) / 0.028).epsilon(1e-12));
    CHECK(card.cp - card.cv == Approx(8.314 / 0.028).epsilon(1e-12));
    CHECK_FALSE(tells(run.scene.model().warnings, "inflator card"));
    run.steps(5);
}

TEST_CASE("IABT is the temperature of the gas inside at the start", "[io]") {
    Run run("wang_nefske_iabt.k");
    const gas::ControlVolume& gas = run.scene.uniform_bags().at(0).gas();
    CHECK(gas.temperature() == Approx(400.0).epsilon(1e-12));
    CHECK(gas.pressure() == Approx(PE + 5000.0).epsilon(1e-12));
    CHECK(gas.mass() == Approx((PE + 5000.0) * VOLUME / (R * 400.0)).epsilon(1e-12));
    CHECK(tells(run.scene.model().warnings, "RO does not count"));
    run.steps(5);
}

TEST_CASE("A23 = -2: the shells of part 2 are the vent, and blank angles turn nothing", "[io]") {
    const struct {
        std::string deck;
        double area;  ///< of the vent: one face of the cube, five faces
    } cases[] = {{"vent_by_part.k", 0.01}, {"vent_by_part_1.k", 0.05}};
    for (const auto& [deck, area] : cases) {
        CAPTURE(deck);
        Run run(deck);
        const gas::UniformBag& bag = run.scene.uniform_bags().at(0);
        const double p = PE + POVER, T = p / (RO * R), mass = RO * VOLUME;
        const double rate = 0.6 * area * gas::orifice_flow(p, PE, T, CP / CV, R);
        run.steps(1);
        const double dt = run.scene.time();
        CHECK(bag.mass_out() == Approx(first_loss(rate, mass, dt)).epsilon(1e-10));
        run.steps(5);
    }
}

TEST_CASE("MAT_ADD_AIRBAG_POROSITY_LEAKAGE: by the law of FVOPT", "[io]") {
    const double p = PE + POVER, T = p / (RO * R), mass = RO * VOLUME, FLC = 0.5;
    const struct {
        std::string deck;
        double rate;
        bool is_blocked;  ///< even FVOPT: by what touches, which no bag of uniform pressure does
    } cases[] = {
        {"leakage_fvopt_1.k", FLC * 0.02 * AREA * gas::orifice_flow(p, PE, T, CP / CV, R), false},
        {"leakage_fvopt_2.k", FLC * 0.02 * AREA * gas::orifice_flow(p, PE, T, CP / CV, R), true},
        {"leakage_fvopt_3.k", FLC * 0.02 * AREA * std::sqrt(2.0 * POVER * RO), false},
        {"leakage_fvopt_4.k", FLC * 0.02 * AREA * std::sqrt(2.0 * POVER * RO), true},
        {"leakage_fvopt_5.k", FLC * 2e-6 * AREA * POVER, false},
        {"leakage_fvopt_6.k", FLC * 2e-6 * AREA * POVER, true},
        {"leakage_fvopt_8.k", FLC * 3.0 * AREA * RO, true}};
    for (const auto& [deck, rate, is_blocked] : cases) {
        CAPTURE(deck);
        Run run(deck);
        const gas::UniformBag& bag = run.scene.uniform_bags().at(0);
        run.steps(1);
        CHECK(bag.mass_out() == Approx(first_loss(rate, mass, run.scene.time())).epsilon(1e-10));
        CHECK(tells(run.scene.model().warnings, "no part of material 5 closes a bag"));
        CHECK(tells(run.scene.model().warnings, "what touches is not taken out") == is_blocked);
        run.steps(5);
    }
}

TEST_CASE("particles leak by the laws of FVOPT 2 with curves, 4 and 6 as a stirred tank does",
          "[io]") {
    constexpr double T0 = 300.0, P0 = 201325.0, M = 0.02897, r = GAS_CONSTANT / M;
    constexpr double cv = 29.1 / M - r, gamma = 1.0 + r / cv;
    const auto between = [](double x, double x0, double x1, double y0, double y1) {
        return y0 + (y1 - y0) * std::clamp((x - x0) / (x1 - x0), 0.0, 1.0);
    };
    struct {
        std::string deck;
        std::function<double(double t, double p, double rho)> speed;  ///< FLC FAC u
    } const cases[] = {
        {"leakage_particles_curves.k",
         [&](double t, double p, double rho) {
             return between(t, 0.0, 1e-3, 0.2, 0.8) * between(p, PE, 301325.0, 0.01, 0.05) *
                    gas::orifice_flow(p, PE, p / (rho * r), gamma, r) / rho;
         }},
        {"leakage_particles_fvopt_4.k",
         [](double, double p, double rho) { return 0.5 * 0.02 * std::sqrt(2.0 * (p - PE) / rho); }},
        {"leakage_particles_fvopt_6.k",
         [](double, double p, double rho) { return 0.5 * 2e-4 * (p - PE) / rho; }}};
    for (const auto& [deck, speed] : cases) {
        CAPTURE(deck);
        Run run(deck);
        run.to_the_end();
        const double start = P0 * VOLUME / (r * T0);
        double mass = start, energy = mass * cv * T0;
        constexpr int STEPS = 20000;
        const double dt = run.scene.time() / STEPS;
        for (int i = 0; i < STEPS; ++i) {
            const double T = energy / (mass * cv), p = mass * r * T / VOLUME, rho = mass / VOLUME;
            const double lost = p > PE ? rho * AREA * speed(i * dt, p, rho) * dt : 0.0;
            mass -= lost;
            energy -= lost * (cv + r) * T;
        }
        const gas::GasState gas = run.scene.bags().at(0).state(run.scene.nodes().x);
        CHECK(mass < 0.85 * start);
        CHECK(start - gas.mass == Approx(start - mass).epsilon(0.01));
        CHECK(gas.temperature == Approx(energy / (mass * cv)).epsilon(0.003));
    }
}

TEST_CASE("gravity by parts pulls these alone, against the direction that it names", "[io]") {
    Run all("gravity_part_set.k");
    all.steps(10);
    for (int node = 1; node <= 26; ++node) {
        CHECK(all.v(node).z() == Approx(-1.62 * all.half_step).epsilon(1e-9));
        CHECK(std::abs(all.v(node).x()) < 1e-9);
    }
    Run parts("gravity_part.k");
    parts.steps(10);
    CHECK(parts.v(1).y() == Approx(-9.81 * parts.half_step).epsilon(1e-9));
    CHECK(parts.v(31).isZero(0.0));
    Run body("body_load_parts.k");
    body.steps(10);
    CHECK(body.v(26).x() == Approx(-2.0 * body.half_step).epsilon(1e-9));
}

TEST_CASE("every kind of contact is the one that there is, and what it lacks is said", "[io]") {
    using Kind = contact::ContactCard::Kind;
    const Model model = read("contact_kinds.k");
    REQUIRE(model.contacts.size() == 6);
    CHECK(model.contacts[0].kind == Kind::SURFACE_TO_SURFACE);
    CHECK(model.contacts[0].thickness == 0.001);
    CHECK(model.contacts[1].kind == Kind::SINGLE_SURFACE);
    CHECK(model.contacts[2].kind == Kind::NODES_TO_SURFACE);
    CHECK(model.contacts[2].id == 3);
    CHECK(model.contacts[3].id == 5);
    CHECK(model.contacts[4].kind == Kind::SURFACE_TO_SURFACE);
    CHECK(model.contacts[5].kind == Kind::SINGLE_SURFACE);
    CHECK(tells(model.warnings, "*CONTACT_AUTOMATIC_ONE_WAY_SURFACE_TO_SURFACE_ID is taken as"));
    CHECK(tells(model.warnings, "*CONTACT_SINGLE_SURFACE sets THKOPT, SHLTHK, IGNORE: there is"));
    CHECK(tells(model.warnings, "(SOFT) = 2"));
    CHECK(tells(model.notes, "*CONTACT_FORCE_TRANSDUCER_PENALTY is not read"));
    Run(model).steps(10);
}

TEST_CASE("contact on some segments of a part holds there alone", "[contact]") {
    Run run("contact_on_segments.k");
    REQUIRE(run.scene.model().contact_shells.at(0).first.size() == 4);
    run.to_the_end();
    const int on_top = 26;                     // the middle of the upper face
    CHECK(run.x(on_top).z() < 0.1 - 1e-4);     // it was pushed down
    CHECK(run.x(31).z() > run.x(on_top).z());  // and not passed
    CHECK(run.v(31).z() > -20.0);

    // The same set on the lower face: nothing holds the plate.
    Model other = read("contact_on_segments.k");
    for (Index& shell : other.contact_shells[0].first)
        for (std::size_t s = 0; s < other.shells.size(); ++s) {
            const auto& n = other.shells[s].nodes;
            if (std::all_of(n.begin(), n.end(), [&](Index i) { return other.x[i].z() == 0.0; }))
                shell = static_cast<Index>(s);
        }
    Run past(other);
    past.to_the_end();
    CHECK(past.v(31).z() == -20.0);
}

TEST_CASE("parts that nothing is of may lack what they like", "[io]") {
    Run run("empty_parts.k");
    CHECK(tells(run.scene.model().warnings, "*PART card 2, field 2 (SECID) = 0"));
    run.steps(5);
}

TEST_CASE("nodal rigid bodies, spot welds and rigid beams are bodies", "[io]") {
    Run run("joined_nodes.k");
    REQUIRE(run.scene.bodies().size() == 3);
    const double tube = 3.14159265358979 / 4.0 * (4e-4 - 0.016 * 0.016);
    double frame = 0.0;
    for (const RigidBody& body : run.scene.bodies())
        if (run.scene.model().parts[body.part()].id == 7) frame = body.mass();
    CHECK(frame == Approx(7800.0 * tube * 0.7).epsilon(1e-12));
    CHECK(tells(run.scene.model().warnings, "1 elements of part 8 \"strut apart from the bag\""));
    run.steps(20);
    CHECK(std::abs(run.v(1).x()) > 0.01);  // the cloth pulls it
    for (int node = 1; node <= 9; ++node) {
        CHECK(run.v(node).x() == Approx(run.v(1).x()).epsilon(1e-12));
        CHECK(std::abs(run.v(node).y()) < 1e-12);
        CHECK(std::abs(run.v(node).z()) < 1e-12);
    }
    CHECK((run.x(26) - run.x(25)).norm() == Approx(0.1).epsilon(1e-12));
}

TEST_CASE("a hanging node moves with the ends of its edge, which bear its mass", "[fabric]") {
    Model model = read("adaptivity.k");
    REQUIRE(model.tied_nodes.size() == 1);
    double mass = 0.0;
    {
        Run falling(model);
        for (const double m : falling.scene.nodes().mass) mass += m;
        CHECK(mass == Approx(800.0 * 3e-4 * 0.04).epsilon(1e-12));
        falling.steps(10);
        for (int node = 1; node <= 8; ++node)
            CHECK(falling.v(node).z() == Approx(-9.81 * falling.half_step).epsilon(1e-9));
    }
    model.body_loads.clear();
    model.velocity[6] = {1.0, 2.0, 3.0};  // node 7, beside the hanging one
    model.velocity[1] = {0.5, -1.0, 0.0};
    Run run(model);
    const auto momentum = [&] {
        Vec3 sum = Vec3::Zero();
        for (std::size_t n = 0; n < run.scene.nodes().size(); ++n)
            sum += run.scene.nodes().mass[n] * run.scene.nodes().v[n];
        return sum;
    };
    const Vec3 first = momentum();
    run.to_the_end();
    CHECK((momentum() - first).norm() < 1e-12 * first.norm());
    CHECK((run.x(4) - 0.5 * (run.x(5) + run.x(3))).norm() < 1e-14);
    CHECK((run.x(7) - Vec3(0.1, 0.2, 0.0)).norm() > 1e-4);
}

TEST_CASE("a hanging node that lands hands the push to the ends of its edge", "[fabric][contact]") {
    Run run("adaptivity_landing.k");
    double least = 0.0;
    while (!run.scene.is_over()) {
        run.steps(1);
        least = std::min(least, run.x(4).z());
        CHECK((run.x(4) - 0.5 * (run.x(5) + run.x(3))).norm() < 1e-13);
    }
    CHECK(least > -0.002);       // above the plate
    CHECK(least < -0.001);       // which it has met
    CHECK(run.v(4).z() > -1.0);  // and been stopped by
    CHECK(run.v(5).z() > -4.0);  // with the ends
    for (int node = 1; node <= 8; ++node) CHECK(run.x(node).z() > -0.004 - 1e-12);
}

TEST_CASE("solids that deform are a rigid table where they are held", "[contact]") {
    Model past = read("table_of_solids.k");
    past.contacts.clear();
    Run through(past);
    through.to_the_end();
    CHECK(through.x(1).z() < -0.01);
    Run run("table_of_solids.k");
    CHECK(tells(run.scene.model().warnings, "solids that deform are taken as one rigid body"));
    run.to_the_end();
    CHECK((run.x(35) - Vec3(-0.1, -0.1, -0.002)).norm() < 1e-15);
    CHECK(run.v(1).z() > -2.0);  // the lower face has been stopped, from 10 m/s
    for (int node = 1; node <= 26; ++node) CHECK(run.x(node).z() > -0.002);
}

TEST_CASE("a hybrid bag holds a mixture of gases with heat capacities of their own", "[io]") {
    Run run("hybrid.k");
    const gas::UniformBag& bag = run.scene.uniform_bags().at(0);
    constexpr double GC = 8.314, T = 293.0;
    const double air = PE * VOLUME * 0.02897 / (GC * T);
    CHECK(bag.gas().pressure() == Approx(PE).epsilon(1e-12));
    CHECK(bag.gas().temperature() == Approx(T).epsilon(1e-12));
    CHECK(bag.gas().mass(0) == Approx(air).epsilon(1e-12));
    run.steps(1);
    const double m = 0.1 * run.scene.time();
    CHECK(bag.gas().mass(1) == Approx(m).epsilon(1e-12));
    CHECK(bag.gas().mass(2) == Approx(m).epsilon(1e-12));
    // enthalpy: the integral of cp from 0 to 600 K
    const double h =
        (28.0 * 600.0 + 0.5 * 0.003 * 600.0 * 600.0) / 0.028 + 20.786 * 600.0 / 0.03995;
    CHECK(bag.inflow_energy() == Approx(m * h).epsilon(1e-12));
    run.steps(5);
    CHECK(bag.mass_out() > 0.0);
}
