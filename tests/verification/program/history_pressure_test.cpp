// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: text files at an interval of their own leave the histories bit by bit as they are.

#include <catch2/catch.hpp>

#include "io/results/hdf5.hpp"
#include "tests/support/scenes/flying_bag.hpp"
#include "tests/unit/io/results/results_scene.hpp"
#include "tools/commands/run_recorder.hpp"

using namespace corpuscle;

namespace {

/// Pressure on the inside of the bag's part, row after row.                              [Pa]
std::vector<double> part_pressure(const Model& model) {
    const scene::Folder folder("history_pressure");
    Simulation simulation(model);
    io::ResultsFile results(folder.path, scene::info(), simulation.layout());
    io::AsciiFiles ascii(folder.path, simulation.layout(), model.output, model.title);
    tools::RunRecorder recorder(simulation, results, ascii);
    while (!simulation.is_over())
        simulation.step([&](Simulation& at) { recorder.observe(at, false); });
    simulation.close([&](Simulation& at) { recorder.observe(at, true); });
    results.finish("normal");
    return io::Hdf5Reader(folder.path / "results.h5")
        .read<double>("/history/airbag/1/part/1/pressure");
}

}  // namespace

TEST_CASE("a part's pressure is the mean since the row before, whatever text files are written",
          "[results]") {
    Model model = scenes::flying_bag(300);
    model.end_time = 1e-3;
    model.output.abstat = 1e-4;
    const std::vector<double> alone = part_pressure(model);
    REQUIRE(alone.size() > 10);
    REQUIRE(alone.back() > 0.0);
    model.output.glstat = 0.97e-4;  // most often just before a row
    CHECK(part_pressure(model) == alone);
}
