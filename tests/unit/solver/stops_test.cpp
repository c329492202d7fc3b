// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a number of the state that is no number any more stops the run in the step in which it is
// met, and its message says what it is, where, and which phase met it.
#include <catch2/catch.hpp>

#include <cstring>
#include <functional>

#include "gas/particles.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/flying_bag.hpp"

using namespace corpuscle;
using Catch::Contains;
using scenes::flying_bag;

namespace {

const auto left_alone = [](Simulation&) {};

/// A bag of cloth that particles come into.
Simulation new_run() {
    Model model = flying_bag(500);
    model.end_time = 1.0;
    return Simulation(model);
}

/// The same state, but for one number: `broken` in place of the one at `at`, three doubles of it
/// telling the place.
std::vector<char> with(std::vector<char> state, const Vec3& at, int component, double broken) {
    for (std::size_t i = 0; i + sizeof(Vec3) <= state.size(); ++i)
        if (std::memcmp(state.data() + i, at.data(), sizeof(Vec3)) == 0) {
            std::memcpy(state.data() + i + sizeof(double) * static_cast<std::size_t>(component),
                        &broken, sizeof(double));
            return state;
        }
    FAIL("the state holds no such place");
    return state;
}

/// What a run says that goes on from such a state; "" when it comes to its end.
std::string told_after(const std::function<Vec3(const Simulation&)>& whose, int component,
                       double broken) {
    Simulation simulation = new_run();
    for (int k = 0; k < 45; ++k) simulation.step(left_alone);
    StateWriter state;
    state(simulation);
    const std::vector<char> bytes = with(state.bytes(), whose(simulation), component, broken);
    Simulation other = new_run();
    StateReader reader(bytes);
    reader(other);
    try {
        for (int k = 0; k < 20; ++k) other.step(left_alone);
    } catch (const PhysicsError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a particle that is not finite stops the run, by its name and phase", "[solver][gas]") {
    const double broken = GENERATE(as<double>{}, NaN, INF, -INF);
    const int component = GENERATE(0, 1, 2);
    const std::size_t row = GENERATE(0U, 17U, 100U);
    CAPTURE(broken, component, row);
    int id = -1;
    const auto velocity = [&](const Simulation& s) {
        id = s.bags()[0].particles().id[row];
        return s.bags()[0].particles().v[row];
    };
    const std::string told = told_after(velocity, component, broken);
    CAPTURE(told);
    CHECK_THAT(told, Contains("bag 1: particle ") && Contains(" of gas 1 near ("));
    // its collision spreads it over the group, of which the first is named; its flight does not
    if (told.find("at its collisions") == std::string::npos)
        CHECK_THAT(told, Contains("particle " + std::to_string(id) + " of gas 1") &&
                             Contains("before its flight"));
}

TEST_CASE("a node that is not finite stops the run", "[solver]") {
    const double broken = GENERATE(as<double>{}, NaN, INF, -INF);
    const bool is_place = GENERATE(false, true);
    const std::string told = told_after(
        [&](const Simulation& s) { return is_place ? s.nodes().x[5] : s.nodes().v[5]; }, 2, broken);
    CAPTURE(is_place, told);
    CHECK_THAT(told, Contains("near (") || Contains("shell"));
    CHECK_THAT(told, Contains("finite"));
}
