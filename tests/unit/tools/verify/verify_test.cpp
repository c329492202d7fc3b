// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "solver/base/error.hpp"
#include "tests/places.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"
#include "tools/verify/case_list.hpp"
#include "tools/verify/page.hpp"
#include "tools/verify/plot.hpp"
#include "tools/verify/table.hpp"

using namespace corpuscle;
using namespace corpuscle::verify;

TEST_CASE("Student's t is that of the tables", "[verify]") {
    CHECK(std::isnan(student_95(0)));
    CHECK(student_95(1) == Approx(12.7062).epsilon(1e-5));
    CHECK(student_95(10) == Approx(2.2281).epsilon(1e-4));
    CHECK(student_95(11) == Approx(2.2010).epsilon(1e-4));
    CHECK(student_95(30) == Approx(2.0423).epsilon(1e-4));
    CHECK(student_95(1000000) == Approx(1.95996).epsilon(1e-5));
    for (std::size_t n = 1; n < 60; ++n) CHECK(student_95(n) > student_95(n + 1));
}

TEST_CASE("a mean has t s / sqrt(n) on either side", "[verify]") {
    const Estimate three = mean_of(std::vector<double>{1.0, 2.0, 3.0});
    CHECK(three.value == Approx(2.0));
    CHECK(three.half_width == Approx(4.3027 / std::sqrt(3.0)));
    CHECK(std::isnan(mean_of(std::vector<double>{1.0}).half_width));
}

TEST_CASE("the jackknife of a mean is the mean's interval", "[verify]") {
    const std::vector<double> x{0.3, -1.2, 2.5, 0.1, 0.9};
    const Estimate plain = mean_of(x), knifed = jackknife(x.size(), [&](std::size_t out) {
                                           double sum = 0.0, n = 0.0;
                                           for (std::size_t k = 0; k < x.size(); ++k)
                                               if (k != out) {
                                                   sum += x[k];
                                                   n += 1.0;
                                               }
                                           return sum / n;
                                       });
    CHECK(knifed.value == Approx(plain.value));
    CHECK(knifed.half_width == Approx(plain.half_width));
}

TEST_CASE("an order is the slope in logarithms, whatever the error's sign", "[verify]") {
    const std::vector<double> sizes{8.0, 16.0, 32.0}, errors{0.64, -0.16, 0.04};
    CHECK(fitted_order(sizes, errors) == Approx(2.0));
    CHECK(std::isnan(fitted_order(std::vector<double>{8.0}, std::vector<double>{0.1})));
    CHECK(std::isnan(fitted_order(sizes, std::vector<double>{0.1, 0.0, 0.1})));
}

TEST_CASE("Kolmogorov and Smirnov's distance is the largest gap", "[verify]") {
    const auto uniform = [](double x) { return std::clamp(x, 0.0, 1.0); };
    // the middles of n equal shares are 1/2n away from it at most
    CHECK(kolmogorov_smirnov({0.875, 0.125, 0.625, 0.375}, uniform) ==
          Approx(std::sqrt(4.0) * 0.125));
    CHECK(kolmogorov_smirnov({0.5}, uniform) == Approx(0.5));
    CHECK(kolmogorov_smirnov({0.0, 0.0, 0.0, 0.0}, uniform) == Approx(2.0));
}

TEST_CASE("Maxwell's distribution has its median and its tail", "[verify]") {
    CHECK(maxwell_below(0.0, 300.0) == 0.0);
    CHECK(maxwell_below(1.5381722 * 300.0, 300.0) == Approx(0.5).epsilon(1e-6));
    CHECK(maxwell_below(3000.0, 300.0) == Approx(1.0));
}

namespace {

const char* const CARD = R"(title = "A box"
family = "boxes"
source = "p = nRT/V"
method = "box_at_rest"
[[quantity]]
name = "pressure"
what = "pressure"
unit = "%"
budget = 0.01
budget_quick = 0.02
[[quick]]
deck = "case.toml"
set = { NP = 100 }
size = 100
seeds = 3
[[full]]
deck = "case.toml"
)";

Row row_of(const Card& card, std::vector<Point> points) {
    Row row;
    row.card = &card;
    row.quantity = &card.quantities[0];
    row.budget = 0.02;
    row.points = std::move(points);
    row.verdict = Row::Verdict::MISSED;
    return row;
}

}  // namespace

TEST_CASE("a card says what a case is", "[verify]") {
    const test::DeckFolder folder;
    const Card card = read_card(folder.write("case.toml", CARD));
    CHECK(card.quantities.at(0).budget_quick == 0.02);
    CHECK(card.quick.at(0).seeds == 3);
    CHECK(card.quick.at(0).parameters.at(0) == std::pair<std::string, double>("NP", 100.0));
    CHECK(card.full.at(0).seeds == 1);
    CHECK(method_of(card) == box_at_rest);
}

TEST_CASE("a card's faults are told all at once, with their lines", "[verify]") {
    const test::DeckFolder folder;
    std::string text = CARD;
    text.replace(text.find("budget = 0.01"), 13, "budget = -1.0");
    text.replace(text.find("seeds = 3"), 9, "sedes = 3");
    try {
        static_cast<void>(read_card(folder.write("case.toml", text)));
        FAIL("it was read");
    } catch (const InputError& error) {
        REQUIRE(error.faults.size() == 2);
        CHECK(error.faults[0].find("case.toml:9:") != std::string::npos);
        CHECK(error.faults[1].find("sedes") != std::string::npos);
    }
}

TEST_CASE("a missed budget is told in the table and red in the page", "[verify]") {
    const test::DeckFolder folder;
    const Card card = read_card(folder.write("case.toml", CARD));
    Point coarse{100.0, {0.06, 0.01}, 1.0, 10.0, 1e3, 3},
        fine{400.0, {0.03, 0.005}, 4.0, 20.0, 8e3, 3};
    const std::vector<Row> rows{row_of(card, {coarse, fine})};
    CHECK(table_text(rows, false).find("3 ± 0.5 %") != std::string::npos);
    CHECK(count_text(rows) == "0 of 1 quantities hold, 1 do not: " + card.name + "/pressure");
    CHECK(page(rows, "made here").find("class='missed'>MISSED<") != std::string::npos);
    CHECK(table_markdown(rows, "made here").find("**MISSED**") != std::string::npos);
    CHECK(error_plot(rows).find("1.5 of the budget") != std::string::npos);
    CHECK(total_cpu(rows) == Approx(15.0));
}

TEST_CASE("every case of models/verification has a card and a method", "[verify][models]") {
    const auto cards = read_cards(CORPUSCLE_MODELS "/verification", {});
    CHECK(cards.size() >= 18);
    for (const Card& card : cards) {
        CAPTURE(card.name);
        CHECK_NOTHROW(static_cast<void>(method_of(card)));
    }
    CHECK_THROWS_AS(read_cards(CORPUSCLE_MODELS "/verification", {"no_such_case"}), InputError);
}
