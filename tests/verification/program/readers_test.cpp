// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what is written for others is read by others' programs. Without VTK for Debian's Python
// (python3-vtk9) this says that it was skipped.

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "io/results/hdf5.hpp"
#include "tests/places.hpp"
#include "tests/support/shell.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using test::shell;

namespace {

double sum(const std::vector<double>& values, std::size_t step) {
    double all = 0.0;
    for (std::size_t i = 0; i < values.size(); i += step) all += values[i];
    return all;
}

}  // namespace

TEST_CASE("VTK reads our d3plot: shells, places, stress and pressure", "[export]") {
    const test::DeckFolder folder;
    const std::string out = (folder.write("note", "").parent_path() / "out").string();
    const std::string program = CORPUSCLE_PROGRAM;
    const auto [ran, told] =
        shell(program + " run '" CORPUSCLE_DECKS "/wang_nefske_inflator_card.k' -q -o '" + out +
              "' 2>&1");
    CAPTURE(told);
    REQUIRE(ran == 0);
    REQUIRE(shell(program + " export '" + out + "' --d3plot --no-particles").first == 0);
    const auto [status, text] =
        shell("/usr/bin/python3 " CORPUSCLE_READERS "/vtk_d3plot.py '" + out + "' 2>/dev/null");
    if (status == 77 || status == 127) {
        WARN("skipped: needs VTK for Python (Debian's python3-vtk9)");
        return;
    }
    CAPTURE(text);
    REQUIRE(status == 0);
    std::istringstream found(text);
    std::size_t states = 0, nodes = 0, shells = 0;
    double time = NaN, stress = NaN, pressure = NaN;
    std::array<double, 6> box{};
    found >> states >> nodes >> shells >> time;
    for (double& side : box) found >> side;
    found >> stress >> pressure;

    const io::Hdf5Reader results(out + "/results.h5");
    const auto times = results.read<double>("/frames/time");
    const auto frames = results.names("/frames");
    const std::string last = "/frames/" + frames.at(times.size() - 1) + "/";
    CHECK(states == times.size());
    CHECK(nodes == results.shape("/mesh/node_id")[0]);
    CHECK(shells == results.shape("/mesh/shell_id")[0]);
    CHECK(time == Approx(times.back()));
    const auto x = results.read<double>(last + "coordinates");
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double low = INF, high = -INF;
        for (std::size_t i = axis; i < x.size(); i += 3) {
            low = std::min(low, x[i]);
            high = std::max(high, x[i]);
        }
        CHECK(box[axis] == Approx(low).margin(1e-7));
        CHECK(box[3 + axis] == Approx(high).margin(1e-7));
    }
    CHECK(stress == Approx(sum(results.read<double>(last + "shell_stress"), 3)).epsilon(1e-4));
    CHECK(pressure == Approx(sum(results.read<double>(last + "shell_pressure"), 1)).epsilon(1e-5));
    CHECK(pressure > 0.0);
}
