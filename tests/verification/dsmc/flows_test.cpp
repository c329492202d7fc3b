// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the program's decks, with default settings, make jets as hard spheres do whose mean free path l is a
// 26th of the slot; shear layers half a cell to two cells thick; in LIN two gases diffuse as in spheres of
// l = h / 12, h the edge of a cell; random pairs make what spheres of their viscosity make. Spheres:
// hard_spheres.hpp, cells of a third of the l of the air at rest. Flows: flows.hpp. The table of
// docs/theory/collisions.md:
//
//     verify_dsmc "[.long]"        all of it, whose checks need the spheres
//     verify_dsmc "[.program]"     the columns of the program
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "tests/support/case_report.hpp"
#include "tests/verification/dsmc/flows.hpp"
#include "tools/verify/statistics.hpp"

using namespace corpuscle;
using namespace corpuscle::dsmc;
using corpuscle::test::report;
using verify::Estimate;

namespace {

using Means = std::map<std::string, Estimate>;

enum class By { SPHERES, LIN, PAIRS };

/// Who makes a flow: the program by a model in cells of L / resolution, or spheres of that mean free path.
struct Maker {
    By by;
    double resolution;
    int seeds;

    [[nodiscard]] std::string name() const {
        constexpr const char* NAMES[] = {"spheres, λ", "LIN, h", "pairs, h"};
        return fmt::format("{} = L/{}", NAMES[static_cast<int>(by)], resolution);
    }
};

/// Each finding's mean over seeds 1, 2, ... with its 95 % interval.
template <class Flow>
Means ensemble(const Flow& flow, const Maker& maker) {
    std::map<std::string, std::vector<double>> samples;
    for (int s = 1; s <= maker.seeds; ++s) {
        const auto seed = static_cast<std::uint64_t>(s);
        const std::string model = maker.by == By::PAIRS ? "-D COLLISION=pairs" : "";
        for (const auto& [name, value] : maker.by == By::SPHERES
                                             ? by_spheres(flow, maker.resolution, seed)
                                             : by_program(flow, maker.resolution, seed, model))
            samples[name].push_back(value);
    }
    Means means;
    for (const auto& [name, values] : samples) means[name] = verify::mean_of(values);
    return means;
}

/// Runs and prints, a column a maker.
template <class Flow>
std::vector<Means> table(const std::string& title, const Flow& flow,
                         const std::vector<Maker>& makers) {
    std::map<std::string, std::string> rows;
    std::string head = "| " + title + " |", rule = "|---|";
    std::vector<Means> all;
    for (const Maker& maker : makers) {
        head += " " + maker.name() + " |";
        rule += "---|";
        all.push_back(ensemble(flow, maker));
        for (const auto& [name, estimate] : all.back())
            rows[name] += fmt::format(" {:.3f} ± {:.3f} |", estimate.value, estimate.half_width);
    }
    fmt::print("\n{}\n{}\n", head, rule);
    for (const auto& [name, cells] : rows) fmt::print("| {} |{}\n", name, cells);
    std::fflush(stdout);
    return all;
}

/// D / (c L) of a tube's gases.
double diffusivity_of(const Means& tube) {
    double sum = 0.0;
    for (const std::string gas : {"air", "helium"})
        sum += 0.5 * diffusivity(tube.at(gas + ", 5").value, 5.0);
    return sum;
}

// What kinetic theory gives of spheres, and what is found of LIN
constexpr double SPHERES_DIFFUSE = 3.01;  ///< D / (c l) of helium and air: 1.019 [D12]1
constexpr double LIN_DIFFUSES = 0.25;     ///< D / (c h)
constexpr double LIKE_SPHERES = 12.0;  ///< l of spheres that diffuse as LIN in cells of h: h / 12

/// Columns of the program, behind those of `spheres`.
std::vector<Maker> beside_program(std::vector<Maker> spheres) {
    for (const Maker& maker :
         {Maker{By::LIN, 1.0, 8}, {By::LIN, 2.0, 8}, {By::LIN, 4.0, 4}, {By::PAIRS, 2.0, 4}})
        spheres.push_back(maker);
    return spheres;
}

void print_diffusivities(const std::vector<Maker>& makers, const std::vector<Means>& tube) {
    fmt::print("\nD of helium and air, in c λ of spheres, else in c h:\n");
    for (std::size_t i = 0; i < makers.size(); ++i)
        fmt::print("{}: {:.3f}\n", makers[i].name(),
                   makers[i].resolution * diffusivity_of(tube[i]));
}

}  // namespace

TEST_CASE("helium and air diffuse in LIN as in spheres of a twelfth of a cell", "[dsmc]") {
    const Means spheres = ensemble(TUBE, {By::SPHERES, 8.0, 1}),
                lin = ensemble(TUBE, {By::LIN, 2.0, 2});
    const double of_spheres = 8.0 * diffusivity_of(spheres), of_lin = 2.0 * diffusivity_of(lin);
    report("helium and air in a tube, spheres: D / (c l)", SPHERES_DIFFUSE, of_spheres);
    report("helium and air in a tube, LIN: D / (c h)", LIN_DIFFUSES, of_lin);
    CHECK(of_spheres == Approx(SPHERES_DIFFUSE).epsilon(0.05));
    CHECK(of_lin == Approx(LIN_DIFFUSES).epsilon(0.1));

    const Means opening = ensemble(OPENING, {By::LIN, 1.0, 3}),
                exact = ensemble(OPENING, {By::SPHERES, LIKE_SPHERES, 1});
    for (const std::string gas : {"air, 5", "helium, 5"}) {
        report(gas + " through an opening of a cell, spheres and LIN", exact.at(gas).value,
               opening.at(gas).value);
        CHECK(opening.at(gas).value == Approx(exact.at(gas).value).epsilon(0.15));
    }
}

TEST_CASE("a jet by random pairs is one of spheres of their viscosity, and LIN keeps it longer",
          "[dsmc]") {
    // pairs: nu = 0.34 c h, spheres: 0.80 c l; h = L / 2 is l = L / 4.7
    const Means spheres = ensemble(JET, {By::SPHERES, 4.7, 3}),
                pairs = ensemble(JET, {By::PAIRS, 2.0, 2}), lin = ensemble(JET, {By::LIN, 2.0, 2});
    for (const std::string what :
         {"middle, x = 2", "middle, x = 4", "middle, x = 6", "mass, x = 4"}) {
        report("jet, " + what + ": spheres and pairs", spheres.at(what).value,
               pairs.at(what).value);
        CHECK(pairs.at(what).value == Approx(spheres.at(what).value).epsilon(0.1));
    }
    report("jet, middle, x = 4: spheres and LIN", spheres.at("middle, x = 4").value,
           lin.at("middle, x = 4").value);
    CHECK(lin.at("middle, x = 4").value > 1.2 * spheres.at("middle, x = 4").value);
    CHECK(lin.at("mass, x = 2").value == Approx(spheres.at("mass, x = 2").value).epsilon(0.03));
}

TEST_CASE("a shear layer, a jet and an opening by LIN and by hard spheres", "[.long][dsmc]") {
    const std::vector<Maker> slots =
        beside_program({{By::SPHERES, 6.5, 4}, {By::SPHERES, 13.0, 4}, {By::SPHERES, 26.0, 2}});
    const auto layer = table("shear layer", SHEAR_LAYER, slots), jet = table("jet", JET, slots);
    const auto opening = table("opening", OPENING,
                               beside_program({{By::SPHERES, 0.25, 8},
                                               {By::SPHERES, 1.0, 8},
                                               {By::SPHERES, 4.0, 8},
                                               {By::SPHERES, LIKE_SPHERES, 4}}));
    const std::vector<Maker> tubes = beside_program({{By::SPHERES, 8.0, 4}});
    print_diffusivities(tubes, table("tube", TUBE, tubes));
    for (const char* what : {"thickness, x = 1", "thickness, x = 2", "thickness, x = 3"}) {
        CHECK(layer[4].at(what).value > layer[5].at(what).value);
        CHECK(layer[5].at(what).value < layer[2].at(what).value);
    }
    for (const char* what :
         {"middle, x = 2", "middle, x = 4", "middle, x = 6", "mass, x = 2", "mass, x = 4"})
        for (const std::size_t lin : {3, 4, 5})
            CHECK(jet[lin].at(what).value == Approx(jet[2].at(what).value).epsilon(0.05));
    for (const char* what : {"air, 5", "helium, 5"})
        CHECK(opening[4].at(what).value == Approx(opening[3].at(what).value).epsilon(0.1));
}

TEST_CASE("a shear layer, a jet, an opening and a tube by the program", "[.program][dsmc]") {
    const std::vector<Maker> program = beside_program({});
    const auto layer = table("shear layer", SHEAR_LAYER, program), jet = table("jet", JET, program),
               opening = table("opening", OPENING, program);
    print_diffusivities(program, table("tube", TUBE, program));
    // of spheres: a layer of l = L/26 at x = L, a jet's speed at x = 4 L, helium of l = h/12 (one seed)
    CHECK(layer[1].at("thickness, x = 1").value > 0.418);
    CHECK(jet[1].at("middle, x = 4").value == Approx(1.057).epsilon(0.05));
    CHECK(opening[0].at("helium, 5").value == Approx(0.070).epsilon(0.1));
}
