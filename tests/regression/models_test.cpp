// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
// Short runs of the models against what they gave before. Whether that was right is for
// verification/.
#include <fmt/core.h>

#include <catch2/catch.hpp>

#include "tests/places.hpp"
#include "tests/regression/baseline.hpp"
#include "tests/support/runs/model_run.hpp"

using namespace corpuscle::test;

namespace {

std::filesystem::path baseline_of(const std::string& model) {
    return std::filesystem::path(CORPUSCLE_MODELS) / model / "baseline.csv";
}

void compare(const std::string& model) {
    const Baseline baseline = Baseline::read(baseline_of(model));
    const ModelRun run(model, baseline.options);
    REQUIRE(run.status() == 0);
    for (const Baseline::Row& row : baseline.rows) {
        INFO(row.dataset << " at " << row.time << "; tolerance: " << row.why);
        const double measured = run.at(row.dataset, std::stod(row.time));
        CHECK(measured == Approx(std::stod(row.value)).epsilon(0).margin(std::stod(row.tolerance)));
    }
}

}  // namespace

TEST_CASE("helium_air gives what it gave", "[regression]") {
    compare("helium_air");
}
TEST_CASE("fast_piston gives what it gave", "[regression]") {
    compare("fast_piston");
}
TEST_CASE("driver_bag_flat gives what it gave", "[regression]") {
    compare("driver_bag_flat");
}

TEST_CASE("two_inflators gives what it gave", "[regression]") {
    compare("two_inflators");
}

TEST_CASE("write the baselines anew", "[.rebaseline]") {
    for (const std::string model :
         {"helium_air", "fast_piston", "driver_bag_flat", "two_inflators"}) {
        Baseline baseline = Baseline::read(baseline_of(model));
        const ModelRun run(model, baseline.options);
        REQUIRE(run.status() == 0);
        for (Baseline::Row& row : baseline.rows) {
            row.value = fmt::format("{:.6g}", run.at(row.dataset, std::stod(row.time)));
        }
        baseline.write(baseline_of(model));
    }
}
