// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include "io/results/ascii_files.hpp"
#include "io/results/ascii_tables.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_ascii_setup.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using namespace results_ascii_setup;

TEST_CASE("each text file appears only when asked for, each at its own interval", "[io]") {
    const scene::Folder folder("ascii");
    const RecordLayout layout = scene::layout();
    OutputIntervals intervals;
    intervals.abstat = 1.0;
    intervals.nodout = 2.5;
    intervals.matsum = 0.0;
    std::filesystem::create_directories(folder.path);
    std::ofstream(folder.path / "glstat") << "of an earlier run";
    {
        io::AsciiFiles files(folder.path, layout, intervals, "a bag");
        std::size_t offered = 0;
        for (std::size_t row = 0; row <= 20; ++row) {  // every 0.5, to 10
            const Sample s = scene::sample(layout, row);
            if (!files.due(s.time)) continue;
            CHECK(files.next_time() <= s.time);
            files.append(s);
            ++offered;
        }
        CHECK(offered == 13);  // 0 1 2 2.5 3 4 5 6 7 7.5 8 9 10
        CHECK(files.next_time() == Approx(11.0));
    }
    std::vector<double> abstat, nodout;
    for (const std::string& line : lines(text_of(folder.path / "abstat")))
        if (line.find("       7     ") == 12) abstat.push_back(std::stod(line.substr(0, 12)));
    for (const std::string& line : lines(text_of(folder.path / "nodout")))
        if (const std::size_t at = line.find("( at time"); at != std::string::npos)
            nodout.push_back(std::stod(line.substr(at + 9)));
    CHECK(abstat == std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
    CHECK(nodout == std::vector<double>{0.0, 2.5, 5.0, 7.5, 10.0});
    CHECK(lines(text_of(folder.path / "abstat"))[0] == " a bag");
    for (const char* name :
         {"glstat", "abstat_cpm", "cpm_sensor", "matsum", "rcforc", "rwforc", "rbdout"})
        CHECK_FALSE(std::filesystem::exists(folder.path / name));
}

TEST_CASE("a text file's forces are means since its own row before, whatever other files ask for",
          "[io]") {
    const scene::Folder folder("ascii_means");
    RecordLayout layout = scene::layout();
    layout.walls = {31};
    OutputIntervals intervals;
    intervals.rwforc = 2.0;
    intervals.glstat = 0.5;
    {
        io::AsciiFiles files(folder.path, layout, intervals, "a bag");
        for (std::size_t row = 0; row <= 8; ++row) files.append(scene::sample(layout, row));
    }
    std::vector<double> along_x;
    for (const std::string& line : lines(text_of(folder.path / "rwforc")))
        if (line.find("      31 ") == 12) along_x.push_back(std::stod(line.substr(35, 15)));
    const auto impulse = [&](std::size_t row) {
        return scene::sample(layout, row).wall_impulse[0];
    };
    check_near(along_x,
               {0.0, (impulse(4) - impulse(0)).x() / 2.0, (impulse(8) - impulse(4)).x() / 2.0});
}

TEST_CASE("text files that nobody asked for are never due", "[io]") {
    const scene::Folder folder("no_ascii");
    io::AsciiFiles files(folder.path, scene::layout(), OutputIntervals{}, "a bag");
    CHECK_FALSE(files.due(1e30));
    CHECK(files.next_time() == INF);
}

TEST_CASE("a text file that cannot be opened is named with the reason", "[io]") {
    const scene::Folder folder("ascii_in_the_way");
    std::filesystem::create_directories(folder.path / "abstat" / "x");
    OutputIntervals intervals;
    intervals.abstat = 1.0;
    CHECK_THROWS_WITH(io::AsciiFiles(folder.path, scene::layout(), intervals, ""),
                      Catch::Contains("abstat") && Catch::Contains("Is a directory"));
}

TEST_CASE("text files of a checkpoint are known by their names", "[io]") {
    const scene::Folder folder("ascii_names");
    const RecordLayout layout = scene::layout();
    OutputIntervals intervals;
    intervals.glstat = 0.5;
    intervals.abstat = 1.0;
    intervals.nodout = 1.0;
    StateWriter checkpoint;
    std::string abstat, nodout;
    {
        io::AsciiFiles files(folder.path, layout, intervals, "a bag");
        for (std::size_t row = 0; row <= 8; ++row) {
            files.append(scene::sample(layout, row));
            if (row != 6) continue;  // time 3
            checkpoint(files);
            abstat = text_of(folder.path / "abstat");
            nodout = text_of(folder.path / "nodout");
        }
    }
    const std::string later = text_of(folder.path / "abstat");
    const std::string glstat = text_of(folder.path / "glstat");
    intervals.glstat = 0.0;
    intervals.nodout = 2.0;
    intervals.matsum = 1.5;
    StateReader state(checkpoint.bytes());
    io::AsciiFiles files(folder.path, layout, intervals, "a bag", 3.25, state);
    CHECK(state.is_at_end());
    CHECK(files.next_time() == Approx(4.0));
    CHECK(text_of(folder.path / "abstat") == later);
    CHECK_FALSE(std::filesystem::exists(folder.path / "matsum"));
    SECTION("where one has lost rows none is touched") {
        std::filesystem::resize_file(folder.path / "nodout", nodout.size() - 1);
        CHECK_THROWS_WITH(files.go_on(), Catch::Contains("nodout is shorter"));
        CHECK(text_of(folder.path / "abstat") == later);
    }
    SECTION("each is as it was then, and a new one begins") {
        files.go_on();
        CHECK(text_of(folder.path / "abstat") == abstat);
        CHECK(text_of(folder.path / "nodout") == nodout);
        CHECK(text_of(folder.path / "glstat") == glstat);
        CHECK(lines(text_of(folder.path / "matsum"))[0] == " a bag");
        files.append(scene::sample(layout, 8));
        CHECK(text_of(folder.path / "abstat") == later);
        CHECK(files.next_time() == Approx(4.5));
    }
}
