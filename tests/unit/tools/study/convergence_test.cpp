// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/study/convergence.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "solver/base/vec.hpp"

using namespace corpuscle;
using namespace corpuscle::study;

TEST_CASE("a law v^-k is followed to its limit", "[study]") {
    const std::vector<double> v{4.0, 1.0, 16.0};
    const auto means = [&](auto&& y, double half) {
        std::vector<Estimate> all;
        for (const double at : v) all.push_back({y(at), half});
        return all;
    };
    const auto falling = [](double at) { return 7.0 + 3.0 / std::sqrt(at); };
    CHECK(change_to_limit(v, means(falling, NaN), 0.5).value == Approx(-1.5));
    CHECK(std::isnan(change_to_limit(v, means(falling, NaN), 0.5).half_width));
    const auto rising = [](double at) { return 7.0 + 3.0 * at * at; };
    CHECK(change_to_limit(v, means(rising, 0.1), -2.0).value == Approx(-48.0));
    CHECK(std::isnan(change_to_limit({1.0}, {{1.0, 0.1}}, 1.0).value));
}

TEST_CASE("chance of two means is carried to the limit", "[study]") {
    // C = (y1 - y2) / (1 - 1/2), each mean with its own half width
    const Estimate change = change_to_limit({1.0, 2.0}, {{5.0, 0.3}, {4.0, 0.4}}, 1.0);
    CHECK(change.value == Approx(-2.0));
    CHECK(change.half_width == Approx(0.5 / 0.5));
}

TEST_CASE("a value that is known better counts more", "[study]") {
    const std::vector<double> v{1.0, 2.0, 4.0};
    const std::vector<Estimate> means{{5.0, 0.01}, {4.0, 0.01}, {9.0, 1e6}};
    CHECK(change_to_limit(v, means, 1.0).value == Approx(-2.0));
}

namespace {

/// y = 10 + 4 / NP + 2 DT + (seed 2: 0.2), at NP 1, 2 and DT 0.5, 0.25.
struct Star {
    Study study;
    Table table{study, {}, {}};
    Star() {
        study.plan = Plan::STAR;
        study.repeats = 2;
        study.responses = {"20.hic15"};
        study.factors = {{"NP", {1.0, 2.0}}, {"DT", {0.5, 0.25}}};
        study.factors[0].order = 1.0;
        study.factors[1].order = -1.0;
        table.rows = rows(study);
        for (const Row& row : table.rows) {
            Outcome outcome;
            outcome.is_finished = true;
            outcome.units = {"-"};
            outcome.responses = {10.0 + 4.0 / row.values[0] + 2.0 * row.values[1] +
                                 (row.seed == 2 ? 0.2 : 0.0)};
            table.outcomes.push_back(outcome);
        }
    }
};

}  // namespace

TEST_CASE("a star tells where its factors lead, and what each adds to the uncertainty", "[study]") {
    const Star star;
    const std::vector<Convergence> all = convergence(star.table);
    REQUIRE(all.size() == 1);
    CHECK(all[0].centre.value == Approx(15.1));
    CHECK(all[0].seeds == 2);
    REQUIRE(all[0].refinements.size() == 2);
    CHECK(all[0].refinements[0].to_limit.value == Approx(-4.0));
    CHECK(all[0].refinements[1].to_limit.value == Approx(-1.0));
    CHECK(all[0].extrapolated == Approx(10.1));
    const double chance = all[0].centre.half_width;
    CHECK(chance == Approx(12.7062 * 0.1));
    double squares = chance * chance;
    for (const Refinement& r : all[0].refinements)
        squares += Convergence::part_of(r) * Convergence::part_of(r);
    CHECK(all[0].uncertainty == Approx(std::sqrt(squares)));
    const std::string text = convergence_text(star.table);
    CHECK(text.find("20.hic15 [-]: **15.1 ± 1.3** at NP = 1, DT = 0.5") != std::string::npos);
    CHECK(text.find("| NP | 1: 15.1 ± 1.3; 2: 13.1 ± 1.3 | 1 | -4 ± 3.6 |") != std::string::npos);
}

TEST_CASE("what is missing is told as missing", "[study]") {
    Star star;
    for (std::size_t k = 0; k < star.table.rows.size(); ++k)
        if (star.table.rows[k].values[1] == 0.25) star.table.outcomes[k].responses[0] = NaN;
    const std::vector<Convergence> all = convergence(star.table);
    CHECK(std::isnan(all[0].refinements[1].to_limit.value));
    CHECK(all[0].extrapolated == Approx(11.1));
    CHECK(convergence_text(star.table).find("0.25: -") != std::string::npos);
}
