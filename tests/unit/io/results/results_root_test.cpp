// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "io/text/text.hpp"
#include "solver/base/error.hpp"
#include "tests/places.hpp"
#include "tests/unit/io/results/results_file_setup.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::Hdf5Reader;
using io::ResultsFile;
using io::Shape;
using namespace results_file_setup;

TEST_CASE("the root says who ran what and how it ended", "[io]") {
    const scene::Folder folder("root");
    ResultsFile results(folder.path, scene::info(), scene::layout());
    std::string termination = "running";
    SECTION("while it runs") {}
    SECTION("in the end") {
        results.finish(termination = "normal");
    }
    SECTION("when it broke") {
        results.finish(termination = "error: at time 1: shell 3 inverted");
    }
    const Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.text("/", "program") == "corpuscle");
    CHECK(file.text("/", "version") == "0.1.0");
    CHECK(file.number<int>("/", "format") == 1);
    CHECK(file.text("/", "deck") == "bag.k");
    CHECK(file.text("/", "unit_system") == "kg-mm-ms-K");
    CHECK(file.number<std::uint64_t>("/", "seed") == 18446744073709551615ULL);
    CHECK(file.number<int>("/", "threads") == 2);
    CHECK(file.text("/", "termination") == termination);
}

TEST_CASE("FORMAT.md counts its rows by formats up to the one that is written", "[io]") {
    const scene::Folder folder("format");
    const ResultsFile results(folder.path, scene::info(), scene::layout());
    const int written = Hdf5Reader(folder.path / "results.h5").number<int>("/", "format");
    std::ifstream page(std::filesystem::path(CORPUSCLE_MODELS).parent_path() / "io/FORMAT.md");
    bool is_table = false;
    std::size_t rows = 0;
    for (std::string line; std::getline(page, line);) {
        if (line.empty()) is_table = false;
        if (is_table && !line.starts_with("|---")) {
            CAPTURE(line);
            const std::size_t cell = line.rfind('|', line.size() - 2) + 1;
            const auto since = io::parse_integer(line.substr(cell, line.size() - 1 - cell));
            CHECK((since && *since >= 1 && *since <= written));
            CHECK(line.find(" | 1 | ") == std::string::npos);  // a shape of one number is "scalar"
            ++rows;
        }
        if (line.ends_with("| since |")) is_table = true;
    }
    CHECK(rows > 80);
}

TEST_CASE("every dataset has a unit and a description, in the deck's units", "[io]") {
    const scene::Folder folder("units");
    const RecordLayout layout = scene::layout();
    io::RunInfo info = scene::info();
    const auto [system, pressure, time, force] =
        GENERATE(table<std::string, std::string, std::string, std::string>(
            {{"SI", "Pa", "s", "N"},
             {"kg-mm-ms-K", "GPa", "ms", "kN"},
             {"ton-mm-s-K", "MPa", "s", "N"},
             {"consistent", "deck [pressure]", "deck [time]", "deck [force]"}}));
    info.unit_system = system;
    ResultsFile results(folder.path, info, layout);
    results.append(scene::sample(layout, 0));
    results.write(scene::frame(layout, 0, 3));
    results.finish("normal");

    const Hdf5Reader file(folder.path / "results.h5");
    for (const std::string& path : datasets(file)) {
        INFO(path);
        CHECK_FALSE(file.text(path, "unit").empty());
        CHECK_FALSE(file.text(path, "description").empty());
    }
    CHECK(file.text("/history/airbag/7/pressure", "unit") == pressure);
    CHECK(file.text("/frames/00000/shell_stress", "unit") == pressure);
    CHECK(file.text("/history/time", "unit") == time);
    CHECK(file.text("/frames/time", "unit") == time);
    CHECK(file.text("/history/rigidwall/31/force", "unit") == force);
    CHECK(file.text("/frames/00000/particles/id", "unit") == "-");
}

TEST_CASE("a run without samples or frames leaves empty histories", "[io]") {
    const scene::Folder folder("empty");
    ResultsFile(folder.path, scene::info(), scene::layout()).finish("normal");
    const Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.shape("/history/time") == Shape{0});
    CHECK(file.shape("/history/node/102/velocity") == Shape{0, 3});
    CHECK(file.shape("/frames/time") == Shape{0});
}

TEST_CASE("a new run clears away the frames of an earlier one", "[io]") {
    const scene::Folder folder("again");
    const RecordLayout layout = scene::layout();
    ResultsFile(folder.path, scene::info(), layout).write(scene::frame(layout, 0, 1));
    ResultsFile(folder.path, scene::info(), layout).flush();
    CHECK_FALSE(Hdf5Reader(folder.path / "results.h5").has("/frames/00000"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "results.parts/00000.h5"));
}

TEST_CASE("two things of one kind with one id are told apart from a broken disk", "[io]") {
    const scene::Folder folder("twins");
    RecordLayout layout = scene::layout();
    layout.walls = {31, 31};
    CHECK_THROWS_AS(ResultsFile(folder.path, scene::info(), layout), InputError);
}

TEST_CASE("a results folder that cannot be made is named with the reason", "[io]") {
    const scene::Folder folder("file_in_the_way");
    std::ofstream(folder.path) << "a file, not a folder";
    CHECK_THROWS_AS(ResultsFile(folder.path / "run", scene::info(), scene::layout()), SystemError);
    CHECK_THROWS_WITH(ResultsFile(folder.path / "run", scene::info(), scene::layout()),
                      Catch::Contains("Not a directory") && Catch::Contains(folder.path.string()));
}

TEST_CASE("a number that is not finite is refused by its name, and is never in the results",
          "[io]") {
    const scene::Folder folder("finite");
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder.path, scene::info(), layout);
    results.append(scene::sample(layout, 0));
    results.write(scene::frame(layout, 0, 20));
    const double broken = GENERATE(as<double>{}, NaN, INF, -INF);
    CAPTURE(broken);
    const auto fault = [&](auto&& spoil, auto what, auto&& take) {
        spoil(what);
        try {
            take(what);
        } catch (const PhysicsError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    const auto of_sample = [&](auto&& spoil) {
        return fault(spoil, scene::sample(layout, 1), [&](const Sample& s) { results.append(s); });
    };
    const auto of_frame = [&](auto&& spoil) {
        return fault(spoil, scene::frame(layout, 1, 20), [&](const Frame& f) { results.write(f); });
    };
    using Catch::Contains;
    CHECK_THAT(of_sample([&](Sample& s) { s.energy.contact = broken; }),
               Contains("at time 0.5: /history/energy/contact is not finite"));
    CHECK_THAT(of_sample([&](Sample& s) { s.airbags[1].pressure = broken; }),
               Contains("/history/airbag/9/pressure is not finite"));
    CHECK_THAT(of_sample([&](Sample& s) { s.airbags[0].species[2].temperature = broken; }),
               Contains("/history/airbag/7/species/2/temperature is not finite"));
    CHECK_THAT(of_sample([&](Sample& s) { s.node_velocity[1].z() = broken; }),
               Contains("/history/node/105/velocity is not finite"));
    CHECK_THAT(of_frame([&](Frame& f) { f.coordinates[3].y() = broken; }),
               Contains("at time 1.5: position of node 104 is not finite"));
    CHECK_THAT(of_frame([&](Frame& f) { f.shell_stress[1][2] = static_cast<float>(broken); }),
               Contains("stress of shell 1002 is not finite"));
    CHECK_THAT(of_frame([&](Frame& f) { f.particles->velocity[7].x() = broken; }),
               Contains("velocity of particle " + std::to_string((std::int64_t{1} << 40) + 7)));
    CHECK_THAT(of_frame([&](Frame& f) { f.particles->velocity[7].x() = 1e39; }),
               Contains("is not finite in single precision"));
    CHECK_THAT(of_frame([&](Frame& f) { f.velocity[3].x() = -1e39; }),
               Contains("velocity of node 104 is not finite in single precision"));
    CHECK_THAT(of_frame([&](Frame& f) { f.particles->internal_energy[0] = broken; }),
               Contains("internal energy of particle"));
    CHECK_THAT(
        of_frame([&](Frame& f) { f.particles->temperature[19] = static_cast<float>(broken); }),
        Contains("temperature of particle"));
    results.append(scene::sample(layout, 1));
    results.finish("error: not finite");
    const io::Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.shape("/frames/time") == io::Shape{1});
    const auto pressure = file.read<double>("/history/airbag/9/pressure");
    REQUIRE(pressure.size() == 2);
    CHECK(pressure[1] == scene::sample(layout, 1).airbags[1].pressure);
}

TEST_CASE("a run whose end is not gathered is not finished, and keeps its parts", "[io]") {
    const scene::Folder folder("not_gathered");
    const RecordLayout layout = scene::layout();
    ResultsFile results(folder.path, scene::info(), layout);
    results.write(scene::frame(layout, 0, 20));
    results.settle();
    const auto frame = folder.path / "results.parts/00000.h5", away = folder.path / "away";
    std::filesystem::rename(frame, away);
    CHECK_THROWS_AS(results.finish("normal"), SystemError);
    CHECK_FALSE(io::finished_run(folder.path).has_value());
    CHECK(std::filesystem::exists(folder.path / "results.parts/mesh.h5"));
    std::filesystem::rename(away, frame);
    results.finish("normal");
    CHECK(io::finished_run(folder.path).has_value());
}
