// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "solver/base/error.hpp"
#include "solver/base/vec.hpp"
#include "tests/unit/tools/study/desk.hpp"
#include "tools/study/known_names.hpp"
#include "tools/study/outcome.hpp"

using namespace corpuscle;
using study_test::Desk;

TEST_CASE("responses of vectors name a component or the length", "[study]") {
    const Desk desk("vectors");
    desk.put("bag.k", "*KEYWORD\n*PARAMETER\nR V          3.0\n*END\n");
    const auto of = [&](const std::string& responses) {
        return desk.study("deck = \"bag.k\"\nresponses = [" + responses +
                          "]\n[factors]\nV = [1]\n");
    };
    try {
        study::expect_known_names(
            of("\"max:/history/rigidwall/31/force\", \"max:/history/rigidwall/31/force.z\", "
               "\"end:/history/energy/total.norm\", \"min:/history_fast/rigid_body/20/velocity\""));
        FAIL("expected faults");
    } catch (const InputError& error) {
        REQUIRE(error.faults.size() == 3);
        CHECK_THAT(error.faults[0], Catch::Contains("force is a vector, expected "
                                                    "/history/rigidwall/31/force.x, .y, .z or "
                                                    ".norm"));
        CHECK_THAT(error.faults[1], Catch::Contains("total is one number a row"));
        CHECK_THAT(error.faults[2], Catch::Contains("velocity is a vector"));
    }

    const study::Study s =
        of("\"max:/history/node/102/coordinates.y\", \"min:/history/node/102/coordinates.x\", "
           "\"end:/history/node/102/coordinates.norm\"");
    study::expect_known_names(s);
    const study::Row row = study::rows(s)[0];
    io::ResultsFile results(study::folder_of(s, row), scene::info(), scene::layout());
    for (const std::size_t n : {0, 1}) {
        Sample sample = scene::sample(scene::layout(), n);
        sample.node_coordinates[0] = n == 0 ? Vec3(3, 1, -7) : Vec3(2, 3, 6);
        results.append(sample);
    }
    results.finish("normal");
    study::write_status(s, row, 0, {1.0}, "");
    const study::Outcome outcome = study::read_outcome(s, row);
    CHECK(outcome.reason.empty());
    CHECK(outcome.responses[0] == Approx(3.0));
    CHECK(outcome.responses[1] == Approx(2.0));
    CHECK(outcome.responses[2] == Approx(7.0));
}
