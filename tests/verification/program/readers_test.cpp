// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what is written for others is read by others' programs: d3plot by VTK's reader (python3-vtk9 or
// python3-paraview), XDMF by both of ParaView's (python3-paraview), results.h5 by the lines of Python that
// FORMAT.md begins with (python3-h5py, python3-matplotlib). Without them this says what was skipped.

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
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

/// Runs a deck of tests/decks into FOLDER/NAME.
std::string ran(const test::DeckFolder& folder, const std::string& deck, const std::string& name) {
    const std::string out = (folder.write("note", "").parent_path() / name).string();
    const auto [status, told] =
        shell(std::string(CORPUSCLE_PROGRAM) + " run '" CORPUSCLE_DECKS "/" + deck + "' -q -o '" +
              out + "' 2>&1");
    CAPTURE(told);
    REQUIRE(status == 0);
    return out;
}

/// Lowest and highest corner, x y z of each point in a row.
std::array<double, 6> box_of(const std::vector<double>& x) {
    std::array<double, 6> box{INF, -INF, INF, -INF, INF, -INF};
    for (std::size_t i = 0; i < x.size(); ++i) {
        box[2 * (i % 3)] = std::min(box[2 * (i % 3)], x[i]);
        box[2 * (i % 3) + 1] = std::max(box[2 * (i % 3) + 1], x[i]);
    }
    return box;
}

/// One reader's findings about the last frame: a block, its box, and sums of its arrays.
void check_block(std::istream& found, const std::string& name, std::size_t points,
                 std::size_t cells, const std::array<double, 6>& box,
                 const std::vector<std::pair<std::string, double>>& sums) {
    std::string text;
    std::size_t there = 0;
    INFO(name);
    found >> text;
    CHECK(text == name);
    CHECK((found >> there && there == points));
    CHECK((found >> there && there == cells));
    double value = NaN;
    for (const double side : box) CHECK((found >> value && value == Approx(side).margin(1e-9)));
    for (const auto& [array, sum] : sums) {
        INFO(array);
        CHECK((found >> text && text == array));
        CHECK((found >> value && value == Approx(sum).epsilon(1e-6)));
    }
}

}  // namespace

TEST_CASE("VTK reads our d3plot: shells, places, stress and pressure, parts by their names",
          "[export]") {
    const test::DeckFolder folder;
    const std::string out = ran(folder, "wang_nefske_inflator_card.k", "out");
    const std::string program = CORPUSCLE_PROGRAM;
    REQUIRE(shell(program + " export '" + out + "' --d3plot --no-particles").first == 0);
    const auto [status, text] =
        shell("/usr/bin/python3 " CORPUSCLE_READERS "/vtk_d3plot.py '" + out + "' 2>/dev/null");
    if (status == 77 || status == 127) {
        WARN("skipped: needs VTK for Python (Debian's python3-vtk9 or python3-paraview)");
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
    found >> stress >> pressure >> std::ws;
    std::string line;
    CHECK((std::getline(found, line) && line == "body of the bag: 20"));
    CHECK((std::getline(found, line) && line == "face with the nozzle: 4"));

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

TEST_CASE("ParaView's readers read our XDMF: times, blocks by name, fields, particles",
          "[export]") {
    const test::DeckFolder folder;
    const std::string out = ran(folder, "inflator_particles.k", "out");
    const auto [status, text] = shell("/usr/bin/python3 " CORPUSCLE_READERS "/paraview_xdmf.py '" +
                                      out + "/results.xdmf' 2>/dev/null");
    if (status == 77 || status == 127) {
        WARN("skipped: needs ParaView for Python (Debian's python3-paraview)");
        return;
    }
    CAPTURE(text);
    REQUIRE(status == 0);
    const io::Hdf5Reader results(out + "/results.h5");
    const auto times = results.read<double>("/frames/time");
    const std::string last = "/frames/" + results.names("/frames").at(times.size() - 1) + "/";
    const auto x = results.read<double>(last + "coordinates"),
               gas = results.read<double>(last + "particles/position");
    std::istringstream found(text);
    for (const std::string reader : {"Xdmf2", "Xdmf3"}) {
        INFO(reader);
        std::string word;
        std::size_t states = 0;
        double first = NaN, end = NaN;
        CHECK((found >> word && word == reader));
        CHECK((found >> states && states == times.size()));
        CHECK((found >> first >> end && first == 0.0 && end == Approx(times.back())));
        // the same names in the first frame, which has no gas yet, and in the last; Xdmf3 has none
        const bool has_names = reader == "Xdmf2";
        const std::string bag = has_names ? "bag" : "-", particles = has_names ? "gas" : "-";
        for (const std::string& block : {bag, particles, bag, particles})
            CHECK((found >> word && word == block));
        check_block(found, bag, x.size() / 3, results.shape("/mesh/shell_id")[0], box_of(x),
                    {{"pressure", sum(results.read<double>(last + "shell_pressure"), 1)},
                     {"stress", sum(results.read<double>(last + "shell_stress"), 3)},
                     {"velocity", sum(results.read<double>(last + "velocity"), 3)}});
        check_block(found, particles, gas.size() / 3, gas.size() / 3, box_of(gas),
                    {{"velocity", sum(results.read<double>(last + "particles/velocity"), 3)},
                     {"mass", sum(results.read<double>(last + "particles/mass"), 1)}});
    }
}

TEST_CASE("FORMAT.md begins with lines of Python that plot a bag's pressure", "[export]") {
    const test::DeckFolder folder;
    const std::string out = ran(folder, "wang_nefske_inflator_card.k", "driver_bag.out");
    std::ifstream format(CORPUSCLE_FORMAT);
    std::string lines, line;
    while (std::getline(format, line) && line.rfind("| ", 0) != 0)
        if (line.rfind("    ", 0) == 0) lines += line.substr(4) + "\n";
    CHECK(std::count(lines.begin(), lines.end(), '\n') == 5);
    // the page's bag 1 is this deck's 7
    REQUIRE(lines.find("airbag/1") != std::string::npos);
    lines.replace(lines.find("airbag/1"), 8, "airbag/7");
    lines += "(drawn,) = plot.gca().lines\nprint(*drawn.get_ydata(), plot.gca().get_ylabel())\n";
    const std::string script = folder.write("plot.py", lines).string();
    if (shell("/usr/bin/python3 -c 'import h5py, matplotlib' 2>&1").first != 0) {
        WARN("skipped: needs Debian's python3-h5py and python3-matplotlib");
        return;
    }
    const auto [status, text] = shell(
        "cd '" + std::filesystem::path(out).parent_path().string() +
        "' && MPLBACKEND=Agg MPLCONFIGDIR=. /usr/bin/python3 -W ignore '" + script + "' 2>&1");
    CAPTURE(text);
    REQUIRE(status == 0);
    std::istringstream found(text);
    double value = NaN;
    const io::Hdf5Reader results(out + "/results.h5");
    for (const double pressure : results.read<double>("/history/airbag/7/pressure"))
        CHECK((found >> value && value == Approx(pressure).epsilon(1e-12)));
    std::string unit;
    CHECK((found >> unit && unit == "Pa"));
}
