// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what is written in other columns means the same, what cannot matter is not refused, and what
// counts for nothing is said (tests/decks).

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "gas/particles.hpp"
#include "solver/base/error.hpp"
#include "tests/support/decks/stepped_deck.hpp"

using namespace corpuscle;

TEST_CASE("LONG=Y and I10=Y are the same scene in other columns", "[io]") {
    Run standard("wang_nefske_inflator_card.k");
    standard.steps(20);
    for (const char* deck : {"format_long.k", "format_i10.k"}) {
        CAPTURE(deck);
        Run other(deck);
        other.steps(20);
        CHECK(other.scene.time() == standard.scene.time());
        CHECK(other.scene.uniform_bags()[0].gas().pressure() ==
              standard.scene.uniform_bags()[0].gas().pressure());
        for (int node = 1; node <= 26; ++node) CHECK(other.x(node) == standard.x(node));
    }
}

TEST_CASE("an inflator's particles carry what its curves say", "[io]") {
    Run run("inflator_particles.k");
    run.to_the_end();
    const gas::GasState gas = run.scene.bags().at(0).state(run.scene.nodes().x);
    CHECK(run.scene.bags()[0].particles().size() == 2000);
    CHECK(gas.mass_in == Approx(0.1 * 0.002).epsilon(1e-9));
    CHECK(gas.mass == Approx(gas.mass_in).epsilon(1e-9));
    CHECK(gas.volume < 1e-3);  // the atmosphere presses on a bag that begins empty
    CHECK(run.scene.books().inflow == Approx(gas.mass_in / 0.02897 * 29.1 * 500.0).epsilon(1e-6));
}

TEST_CASE("rarer kinds of contact are the one that there is, some keywords cannot matter", "[io]") {
    using Kind = contact::ContactCard::Kind;
    const Model model = read("contact_kinds_rare.k");
    REQUIRE(model.contacts.size() == 5);
    CHECK(model.contacts[0].kind == Kind::SINGLE_SURFACE);
    CHECK(model.contacts[1].id == 2);
    CHECK(model.contacts[3].kind == Kind::SURFACE_TO_SURFACE);
    CHECK(model.contact_shells[4].first.size() == 2);
    for (const char* what :
         {"*CONTACT_AUTOMATIC_BEAMS_TO_SURFACE_ID is left out", "nothing erodes here",
          "*CONTACT_AUTOMATIC_SINGLE_SURFACE_MORTAR_ID is taken as",
          "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE_SMOOTH is taken as",
          "its force over penetration, LCID, does not count"}) {
        CAPTURE(what);
        CHECK(tells(model.warnings, what));
    }
    for (const char* what : {"*LOAD_THERMAL_CONSTANT", "*INITIAL_TEMPERATURE_SET",
                             "*DEFINE_FRICTION", "*SET_SOLID", "*SET_BEAM"}) {
        CAPTURE(what);
        CHECK(tells(model.notes, std::string(what) + " is not read, it cannot change the answer"));
    }
    Run(model).steps(10);
}

TEST_CASE("masses on a rigid part whose mass is given count for nothing, which is said", "[io]") {
    Run run("masses_of_rigid.k");
    REQUIRE(run.scene.bodies().size() == 1);
    CHECK(run.scene.bodies()[0].mass() == 2.5);
    const std::vector<std::string>& warnings = run.scene.model().warnings;
    CHECK(tells(warnings,
                "2 masses, 0.5 in all, are on nodes of rigid parts whose mass "
                "*PART_INERTIA says: they count for nothing"));
    CHECK_FALSE(tells(warnings, "ELFORM"));  // of a rigid part alone
    CHECK(run.scene.nodes().mass[run.row(25)] > 0.05);
    run.steps(10);
}

TEST_CASE("HCONV, chambers and TSW together: a chamber cools by itself, the other keeps its heat",
          "[io]") {
    Run run("chambers_cooling.k");
    const Model& model = run.scene.model();
    double area = 0.0;
    for (const Shell& shell : model.shells)
        if (model.parts[static_cast<std::size_t>(shell.part)].id == 2)
            area += 0.5 * (model.x[shell.nodes[2]] - model.x[shell.nodes[0]])
                              .cross(model.x[shell.nodes[3]] - model.x[shell.nodes[1]])
                              .norm();
    const auto chambers = [&] {
        return run.scene.bags().at(0).chamber_states(run.scene.nodes().x);
    };
    while (run.scene.time() < 0.002) run.steps(1);
    const auto first = chambers();
    const double begin = run.last_time;
    run.to_the_end();
    const auto last = chambers();
    REQUIRE(last.size() == 2);
    const double cv = (28.0 - GAS_CONSTANT) / 0.028;
    const double rate = 20000.0 * area / (first[1].mass * cv);
    const double cooled = std::exp(-rate * (run.last_time - begin));
    CHECK(cooled < 0.9);  // long after TSW: what the walls were owed then is settled
    CHECK((last[1].temperature - 250.0) / (first[1].temperature - 250.0) ==
          Approx(cooled).epsilon(1e-9));
    CHECK(last[0].temperature == Approx(first[0].temperature).epsilon(1e-12));
    CHECK(last[1].mass == Approx(first[1].mass).epsilon(1e-12));
}

TEST_CASE("a chamber of internal parts alone takes its volume from the one that it lies in",
          "[io]") {
    Model model = read("nested_chambers.k");
    // Set 3: all parts. Named by the outer chamber's card too, the inner one's walls are a cavity's
    const bool is_named = GENERATE(false, true);
    if (is_named)
        for (const Index part : model.bags.at(0).internal_parts)
            model.bags[0].chambers.at(0).parts.push_back(part);
    Run run(std::move(model));
    constexpr double VOLUME[] = {1e-3 - 0.125e-3, 0.125e-3}, T[] = {500.0, 300.0}, MASS = 1e-4;
    const double gamma = 29.1 / (29.1 - GAS_CONSTANT);
    for (const double until : {0.0014, 0.002}) {
        while (run.scene.time() < until && !run.scene.is_over()) run.steps(1);
        CAPTURE(is_named, until, run.scene.time());
        const auto& bag = run.scene.bags().at(0);
        CHECK(bag.is_uniform() == (until > 0.0015));
        const auto chambers = bag.chamber_states(run.scene.nodes().x);
        REQUIRE(chambers.size() == 2);
        for (const std::size_t c : {0, 1}) {
            CAPTURE(c);
            CHECK(chambers[c].volume == Approx(VOLUME[c]).epsilon(1e-12));
            CHECK(chambers[c].mass == Approx(MASS).epsilon(1e-9));
            CHECK(chambers[c].temperature == Approx(gamma * T[c]).epsilon(1e-9));
        }
        if (!bag.is_uniform()) continue;
        for (const std::size_t c : {0, 1})
            CHECK(chambers[c].pressure ==
                  Approx(MASS / 0.02897 * GAS_CONSTANT * gamma * T[c] / VOLUME[c]).epsilon(1e-9));
    }
}

TEST_CASE("a room of vacuum is warned of, and stops when its gas has given more than it had",
          "[io]") {
    const Model model = read("vacuum_room.k");
    for (const std::uint64_t seed : {1, 2, 3}) {
        CAPTURE(seed);
        Simulation scene(model, seed);
        CHECK(tells(scene.model().warnings, "chamber 2: a vacuum for good"));
        std::string why;
        try {
            while (!scene.is_over()) scene.step([](Simulation&) {});
        } catch (const PhysicsError& error) {
            why = error.what();
        }
        CHECK_THAT(why, Catch::Contains("its gas has given the fabric"));
    }
}

TEST_CASE("a bag runs the same wherever a deck places it, and however it numbers it", "[io]") {
    constexpr int STEPS = 25;
    Run whole("wang_nefske_inflator_card.k"), placed("placed_bags.k");
    whole.steps(STEPS);
    placed.steps(STEPS);
    REQUIRE(placed.scene.uniform_bags().size() == 3);
    const double apart[] = {(placed.x(2) - placed.x(26)).norm(),
                            (placed.x(1002) - placed.x(1026)).norm(),
                            (placed.x(4002) - placed.x(4026)).norm()};
    const auto& bags = placed.scene.uniform_bags();
    CHECK(bags[1].card().id == 1707);
    CHECK(bags[2].card().id == 4007);
    // turned it is the same to rounding, in a mirror its quads are cut along the other diagonal
    CHECK(bags[1].gas().pressure() == Approx(bags[0].gas().pressure()).epsilon(1e-9));
    CHECK(bags[2].gas().pressure() == Approx(bags[0].gas().pressure()).epsilon(1e-3));
    CHECK(apart[1] == Approx(apart[0]).epsilon(1e-9));
    CHECK(apart[2] == Approx(apart[0]).epsilon(1e-2));
    // POS6P, mirror and half a turn of node 1, which is held: (3, 0, 0), (3, -2, 0), and about the line
    // along z through (3, -5, 0), for points 4 and 5 move with the rows before: (3, -8, 0)
    CHECK((placed.x(4001) - Vec3(3.0, -8.0, 0.0)).norm() < 1e-12);
}
