// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: cloth that begins greatly strained lets go of it with books within 1 % at TSSFAC 0.9.

#include <catch2/catch.hpp>
#include <cmath>

#include "solver/energy/strained_start.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

/// A sheet of n × n cells, pressed to half its length, free, in a fluid that stops it soon.
Model pressed(int n) {
    Model model = scenes::of({}, scenes::cloth(), 3e-4);
    ReferenceGeometry flat;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            const Vec3 place(0.2 * i / n, 0.2 * j / n, 0.0);
            flat.nodes.emplace_back(static_cast<Index>(model.x.size()), place);
            model.x.emplace_back(0.5 * place.x(), place.y(), 0.0);
            model.node_id.push_back(static_cast<int>(model.x.size()));
            model.velocity.push_back(Vec3::Zero());
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = j * (n + 1) + i;
            model.shells.push_back(
                {static_cast<int>(model.shells.size()) + 1, 0, {a, a + 1, a + n + 2, a + n + 1}});
        }
    model.references = {flat};
    model.mass_damping = 3e4;
    model.end_time = 1e-3;
    return model;
}

}  // namespace

TEST_CASE("steps of cloth that begins strained grow to whole ones", "[solver][energy]") {
    StrainedStart start;
    start.advance();
    CHECK(start.longest() == INF);
    start.begin(1.0);
    double passed = 0.0;
    int steps = 0;
    for (; start.longest() < 1.0; ++steps) {
        CHECK(start.longest() ==
              Approx(StrainedStart::FIRST * std::pow(StrainedStart::RISE, steps)));
        passed += start.longest();
        start.advance();
    }
    CHECK(steps == 43);
    CHECK(passed == Approx(18.0).epsilon(0.02));
    start.begin(1.0);  // a reference shape that begins to count
    CHECK(start.longest() == StrainedStart::FIRST);
    start.begin(10.0);
    CHECK(start.longest() == StrainedStart::FIRST);
}

TEST_CASE("cloth pressed to half its length lets go without loss", "[solver][energy]") {
    for (const double factor : {0.9, 0.5}) {
        Model model = pressed(8);
        model.step_factor = factor;
        Simulation simulation(std::move(model));
        const double stable = simulation.shells_step().dt / factor;
        double start = -1.0, worst = 0.0;
        const auto look = [&](Simulation& s) {
            const EnergyBooks books = s.books();
            if (start < 0.0) start = books.strain;
            worst = std::max(worst, std::abs(books.residual));
        };
        const StepReport first = simulation.step(look);
        CHECK(first.dt == Approx(StrainedStart::FIRST * stable));
        CHECK(first.limit.who == StepLimit::Who::STRAIN);
        while (!simulation.is_over()) simulation.step(look);
        simulation.close(look);
        CAPTURE(factor, worst / start);
        CHECK(worst < 0.01 * start);
    }
}
