// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_file_setup.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::Hdf5Reader;
using io::ResultsFile;
using io::Shape;
using namespace results_file_setup;

TEST_CASE("every history comes back value by value under its promised path", "[io]") {
    const scene::Folder folder("histories");
    const RecordLayout layout = scene::layout();
    std::vector<Sample> samples;
    {
        ResultsFile results(folder.path, scene::info(), layout);
        for (std::size_t row = 0; row < 130; ++row) {
            samples.push_back(scene::sample(layout, row));
            results.append(samples.back());
        }
        results.finish("normal");
    }
    const Hdf5Reader file(folder.path / "results.h5");
    Histories histories{file, samples};
    expect_energy(histories);
    expect_airbag(histories, 0, "7", {"0", "1", "2"}, {"10", "11"});
    expect_airbag(histories, 1, "9", {"1"}, {"12"});
    expect_the_rest(histories);
    // and nothing else is there
    std::set<std::string> written = datasets(file);
    std::erase_if(written, [](const std::string& path) { return !path.starts_with("/history/"); });
    CHECK(written == histories.checked);
}

TEST_CASE("mesh and frames come back value by value, while running and when finished", "[io]") {
    const scene::Folder folder("frames");
    const RecordLayout layout = scene::layout();
    const std::vector<Frame> frames{scene::frame(layout, 0, 0), scene::frame(layout, 1, 4),
                                    scene::frame(layout, 2, -1)};
    ResultsFile results(folder.path, scene::info(), layout);
    for (const Frame& f : frames) results.write(f);
    results.flush();
    const bool finished = GENERATE(false, true);
    if (finished) results.finish("normal");
    CHECK(std::filesystem::exists(folder.path / "results.parts") == !finished);

    const Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.read<std::int32_t>("/mesh/node_id") == layout.node_id);
    CHECK(file.read<double>("/mesh/coordinates") == flat(layout.coordinates));
    CHECK(file.shape("/mesh/coordinates") == Shape{5, 3});
    CHECK(file.read<std::int32_t>("/mesh/shell_id") == layout.shell_id);
    CHECK(file.read<std::int32_t>("/mesh/shell_part") == layout.shell_part);
    CHECK(file.read<std::int32_t>("/mesh/shell_nodes") == flat(layout.shell_nodes));
    CHECK(file.shape("/mesh/shell_nodes") == Shape{2, 4});
    CHECK(file.read<std::int32_t>("/mesh/xdmf_topology") ==
          std::vector<std::int32_t>{5, 0, 1, 2, 3, 4, 3, 2, 4});
    CHECK(file.read<double>("/frames/time") == std::vector<double>{0.0, 1.5, 3.0});
    CHECK(file.names("/frames") == std::vector<std::string>{"00000", "00001", "00002", "time"});
    expect_frame(file, "/frames/00000", frames[0]);
    expect_frame(file, "/frames/00001", frames[1]);
    expect_frame(file, "/frames/00002", frames[2]);
}
