// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/stable_step.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using corpuscle::INF;
using corpuscle::step_beside;

TEST_CASE("gas lets cloth have up to one and a half of its own step, and has its own beside more",
          "[solver]") {
    CHECK(step_beside(8e-6, 5e-6) == 5e-6);
    CHECK(step_beside(8e-6, 11.9e-6) == 11.9e-6);
    CHECK(step_beside(8e-6, 18e-6) == Approx(8e-6));
    CHECK(step_beside(8e-6, 1.0) == 8e-6);
    CHECK(step_beside(8e-6, INF) == 8e-6);
    CHECK(step_beside(INF, 5e-6) == 5e-6);
    CHECK(step_beside(INF, INF) == INF);

    // no jump, never beyond either's bound
    double before = 0.0;
    for (double cloth = 1e-7; cloth < 40e-6; cloth += 1e-7) {
        const double dt = step_beside(8e-6, cloth);
        CHECK(dt <= cloth);
        CHECK(dt <= 12e-6);
        CHECK(dt >= (cloth < 8e-6 ? cloth : 8e-6));
        CHECK(std::abs(dt - before) < 1.01e-7);
        before = dt;
    }
}
