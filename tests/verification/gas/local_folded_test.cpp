// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the pressure with which a jet opens the first pleat of a folded bag is the gas's, not that
// of the number of particles.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/results/hdf5.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/runs/model_run.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr double DISH = 30.0, FRONT_PANEL = 1.0;  ///< its radius [mm]; part
constexpr double LAST = 4.0, FRAME = 0.2;         ///< [ms]

/// Rows and areas of the front panel's shells that lie lowest over the inflator's dish, within half
/// the 0.7 mm from one layer to the next.
struct Pleat {
    std::vector<std::size_t> shells;
    std::vector<double> area;
};
Pleat first_pleat(const io::Hdf5Reader& results) {
    const auto x = results.read<double>("/mesh/coordinates"),
               part = results.read<double>("/mesh/shell_part");
    const auto nodes = results.read<std::int64_t>("/mesh/shell_nodes");
    const auto at = [&](std::size_t shell, int k) {
        const auto row = static_cast<std::size_t>(3 * nodes[4 * shell + k]);
        return Vec3(x[row], x[row + 1], x[row + 2]);
    };
    const auto centre = [&](std::size_t shell) {
        return Vec3(0.25 * (at(shell, 0) + at(shell, 1) + at(shell, 2) + at(shell, 3)));
    };
    const auto is_over_dish = [&](std::size_t shell) {
        return part[shell] == FRONT_PANEL && centre(shell).head<2>().norm() < DISH;
    };
    double lowest = 1e30;
    for (std::size_t s = 0; s < part.size(); ++s)
        if (is_over_dish(s)) lowest = std::min(lowest, centre(s).z());
    Pleat pleat;
    for (std::size_t s = 0; s < part.size(); ++s)
        if (is_over_dish(s) && centre(s).z() < lowest + 0.35) {
            pleat.shells.push_back(s);
            pleat.area.push_back(0.5 * (at(s, 2) - at(s, 0)).cross(at(s, 3) - at(s, 1)).norm());
        }
    return pleat;
}

/// Gauge pressure on the first pleat, the mean over each interval between frames.       [GPa]
struct PleatCurve {
    std::vector<double> pressure;
    /// What chance leaves of single hits, mean square: n hits of mean impulse q = m sqrt(2 pi R T /
    /// M) bring p A dt = n q, their squares have 4/pi q²: var p = 4/pi q p / (A dt)      [GPa^2]
    double chance = 0.0;
};
PleatCurve pleat_pressure(int particles, int seed) {
    const ModelRun run("driver_bag_folded_coarse",
                       fmt::format("-j 1 -D NP={} -D DTPLOT={} --until {} --seed {}", particles,
                                   FRAME, LAST, seed),
                       "driver_bag_folded");
    REQUIRE(run.status() == 0);
    const io::Hdf5Reader results(run.results());
    const Pleat pleat = first_pleat(results);
    REQUIRE(pleat.shells.size() > 3);
    const std::size_t frames = results.read<double>("/frames/time").size();
    constexpr double MASS = 33.4e-3, T = 760.0, MOLAR_MASS = 0.0285;  // of the inflator's gas
    constexpr double PI = 3.14159265358979;
    const double hit =
        MASS / particles * std::sqrt(2.0 * PI * GAS_CONSTANT * T / MOLAR_MASS);  // [kg mm/ms]
    PleatCurve curve;
    for (std::size_t f = 1; f < frames; ++f) {
        const auto p = results.read<double>(fmt::format("/frames/{:05d}/shell_pressure", f));
        double force = 0.0, area = 0.0;
        for (std::size_t k = 0; k < pleat.shells.size(); ++k) {
            force += pleat.area[k] * p[pleat.shells[k]];
            area += pleat.area[k];
        }
        curve.pressure.push_back(force / area);
        curve.chance += 4.0 / PI * hit * std::max(0.0, force / area) / (area * FRAME) /
                        static_cast<double>(frames - 1);
    }
    return curve;
}

double root_mean_square(const std::vector<double>& curve) {
    double sum = 0.0;
    for (const double p : curve) sum += p * p;
    return std::sqrt(sum / static_cast<double>(curve.size()));
}

/// RMS difference of two curves and what chance makes of it, over the RMS of the second.
struct Difference {
    double found, by_chance;
};
Difference difference(const PleatCurve& a, const PleatCurve& b) {
    std::vector<double> apart;
    for (std::size_t i = 0; i < a.pressure.size(); ++i)
        apart.push_back(a.pressure[i] - b.pressure[i]);
    const double scale = root_mean_square(b.pressure);
    return {root_mean_square(apart) / scale, std::sqrt(a.chance + b.chance) / scale};
}

/// Curves of ever more particles, printed in kPa.
std::vector<PleatCurve> curves(const std::vector<int>& particles) {
    std::vector<PleatCurve> all;
    for (const int n : particles) all.push_back(pleat_pressure(n, 1));
    for (std::size_t f = 0; f < all[0].pressure.size(); ++f)
        for (std::size_t k = 0; k + 1 < all.size(); ++k)
            report(fmt::format("folded: first pleat at {:.1f} ms, {} for {} [kPa]",
                               FRAME * (f + 0.5), particles[k], particles.back()),
                   1e6 * all.back().pressure[f], 1e6 * all[k].pressure[f]);
    return all;
}

/// Root of the 99.9 % quantile of chi² over its 20 degrees of freedom, one for each interval.
constexpr double SURE = 1.505;

/// The curves differ by no more than single hits would scatter, but for one case in a thousand.
void check(const std::string& name, const PleatCurve& a, const PleatCurve& b) {
    const auto [found, by_chance] = difference(a, b);
    report("folded: " + name + fmt::format(", RMS (chance {:.3f})", by_chance), 0.0, found);
    CHECK(found < SURE * by_chance);
}

}  // namespace

TEST_CASE("pressure on the first pleat, 20 000 and 100 000 particles", "[folded]") {
    const auto all = curves({20000, 100000});
    check("curve of 20 000 off that of 100 000", all[0], all[1]);
}

TEST_CASE("pressure on the first pleat converges with particles", "[.full][folded]") {
    const auto all = curves({20000, 100000, 500000});
    check("curve of 20 000 off that of 500 000", all[0], all[2]);
    check("curve of 100 000 off that of 500 000", all[1], all[2]);
    CHECK(difference(all[1], all[2]).found < difference(all[0], all[2]).found);
}
