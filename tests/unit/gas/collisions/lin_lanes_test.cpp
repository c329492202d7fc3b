// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/lin_lanes.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "gas/collisions/collide.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// Largest difference of two gases' velocities and internal energies, over a thermal one's.
double difference(const Particles& a, const Particles& b) {
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max({worst, (a.v[i] - b.v[i]).norm() / 300.0,
                          std::abs(a.e[i] - b.e[i]) / std::abs(b.e[i])});
    return worst;
}

}  // namespace

TEST_CASE("four groups at once collide as one by one", "[gas][lanes]") {
    const std::vector<SpeciesCard> cards = GENERATE(
        values<std::vector<SpeciesCard>>({{AIR}, {CARBON_DIOXIDE}, {HELIUM}, {AIR, HELIUM}}));
    const double per_cell = GENERATE(4.0, 12.0, 60.0);
    const double jet = GENERATE(0.0, 2000.0);
    const bool sinks = GENERATE(false, true);  // internal energies, of which some are nothing
    const Mixture mixture = mixture_of(cards);
    const Vec3 box(1, 1, 1);
    std::vector<double> T(cards.size(), 300.0);
    Particles fast = random_gas(3000, box, mixture, T);
    for (Vec3& v : fast.v) v += Vec3(jet, 0, -jet);
    for (std::size_t i = 0; sinks && i < fast.size(); ++i) fast.e[i] *= i % 5 == 0 ? 0.0 : 2.0;
    const Grid grid = Grid::over(Vec3::Zero(), box, cell_edge(1.0, fast.size(), per_cell), 10000);
    CellSort cells;
    cells.sort(grid, fast);
    Groups groups;
    groups.find(cells, {}, fast, 1.0);
    Particles plain = fast;
    const CollisionStep step{
        groups.lists(), mixture, {sinks ? 0.5 : 1.01, 200.0}, 1e-5, 1.0, 0.0, 7, 3};
    const CollisionReport a = collide_lin(step, fast), b = collide_lin_plainly(step, plain);
    CHECK(a.thermal == Approx(b.thermal).epsilon(1e-11));
    CHECK(a.unrelaxed == b.unrelaxed);
    CHECK(difference(fast, plain) < 1e-8);  // near-singular groups of ten magnify rounding
}

TEST_CASE("sine and cosine and cube root of four numbers are those of the library",
          "[gas][lanes]") {
    double turning = 0.0, root = 0.0;
    for (int i = 0; i <= 4000; ++i) {
        const double u = i / 4000.0, q = std::exp(40.0 * (u - 0.5));
        const SineCosine at = turn(all_four(u));
        turning = std::max({turning, std::abs(at.sine[i % 4] - std::sin(2.0 * M_PI * u)),
                            std::abs(at.cosine[i % 4] - std::cos(2.0 * M_PI * u))});
        root = std::max(root, std::abs(cbrt(all_four(q))[i % 4] / std::cbrt(q) - 1.0));
    }
    CHECK(turning < 1e-15);
    CHECK(root < 1e-15);
}
