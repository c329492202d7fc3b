// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: Sod's tube, run through decks with default settings, is as near the exact solution as the
// collision model's bench (verify_gas "[.sod]"). Hidden, for it takes minutes;
// `corpuscle verify sod --full` is the same by files.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "tests/support/case_report.hpp"
#include "tests/support/decks/sod_deck.hpp"
#include "tests/support/gas/sod.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr double L1_DENSITY = 0.011, PRESSURE = 0.0075;  ///< at 10^5 particles and 40 runs
constexpr double DENSITY_NOISE = 0.0020, PRESSURE_NOISE = 0.0025;  ///< in them, .0016 sqrt(64/40)

/// A bound for `runs`: noise adds to each slab's error as squares do. Fewer than 40: a tenth more,
/// for sound ties slabs together, and so their sum scatters.
double bound(double of_40, double noise_of_40, double noise, int runs) {
    const double slack = runs < 40 ? 1.1 : 1.0;
    return slack * std::sqrt(of_40 * of_40 - noise_of_40 * noise_of_40 + noise * noise);
}

void check(const std::string& name, int runs) {
    const oracle::SodError bench =
        oracle::sod_error({gas::CollisionModel::LIN, 100000, 1.0 / 60.0, 0.1}, runs);
    const SodDeckError error = sod_deck_error(100000, runs);
    const double density = bound(L1_DENSITY, DENSITY_NOISE, error.density_noise, runs),
                 pressure = bound(PRESSURE, PRESSURE_NOISE, error.pressure_noise, runs);
    report(name + fmt::format(": L1 of density, bench and decks (noise {:.4f}, bound {:.4f})",
                              error.density_noise, density),
           bench.density, error.density);
    report(name + fmt::format(": L1 of pressure, bench and decks (noise {:.4f}, bound {:.4f})",
                              error.pressure_noise, pressure),
           bench.pressure, error.pressure);
    CHECK(error.density < density);
    CHECK(error.pressure < pressure);
}

}  // namespace

TEST_CASE("Sod's tube through decks, eight seeds", "[.full][sod]") {
    check("sod, 8 seeds", 8);
}

TEST_CASE("Sod's tube through decks, forty seeds", "[.full][sod]") {
    check("sod, 40 seeds", 40);
}
