// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <map>
#include <sstream>

#include "io/export/iso_mme.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;

namespace {

using Files = std::map<std::string, std::string>;

/// A file of "name :value" lines, then numbers.
struct Read {
    std::map<std::string, std::string> entries;
    std::vector<double> values;

    explicit Read(const std::string& text) {
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) {
            const std::size_t colon = line.find(':');
            if (colon == std::string::npos) {
                values.push_back(std::stod(line));
                continue;
            }
            REQUIRE(values.empty());
            REQUIRE(colon == 28);
            const std::string name = line.substr(0, line.find_last_not_of(' ', 27) + 1);
            REQUIRE(entries.emplace(name, line.substr(29)).second);
        }
    }
    [[nodiscard]] double number(const std::string& name) const {
        return std::stod(entries.at(name));
    }
};

/// A body of part 20 that force pushes along z; more of them on demand.
Files exported(const std::string& units, const std::vector<int>& bodies) {
    const scene::Folder folder("iso_mme");
    io::RunInfo info = scene::info();
    info.unit_system = units;
    io::ResultsFile results(folder.path, info, scene::layout());
    std::vector<io::RigidTrack> tracks;
    for (const int id : bodies) tracks.push_back({id, 4.0, Vec3(1, 2, 3), Vec3(0, 3, -10)});
    results.follow(0.5, tracks);
    const std::vector<io::RigidState> states(bodies.size(),
                                             {Vec3(1, 5, -7), Vec3(0, 3, -8), Vec3(0, 0, 8)});
    results.observe(
        0.0,
        std::vector<io::RigidState>(bodies.size(), {Vec3(1, 2, 3), Vec3(0, 3, -10), Vec3::Zero()}),
        false);
    results.observe(1.0, states, true);
    results.finish("normal");
    Files files;
    io::write_iso_mme(
        io::Hdf5Reader(folder.path / "results.h5"), "oop",
        [&](const std::string& name, const std::string& bytes) { files[name] = bytes; });
    return files;
}

}  // namespace

TEST_CASE("ISO-MME: a body's channels are in SI and named by their codes", "[export]") {
    const Files files = exported("kg-mm-ms-K", {20});
    CHECK(files.size() == 16);  // .mme, .chn and 14 channels
    const Read about(files.at("oop.mme")), contents(files.at("Channel/oop.chn"));
    CHECK(about.entries.at("Data format edition number") == "1.6");
    CHECK(about.entries.at("Title") == "bag.k");
    CHECK(contents.number("Number of channels") == 14);
    std::map<std::string, Read> by_code;
    for (int k = 1; k <= 14; ++k) {
        const std::string number = (k < 10 ? "00" : "0") + std::to_string(k);
        const Read channel(files.at("Channel/oop." + number));
        const std::string code = channel.entries.at("Channel code");
        CHECK(code.size() == 16);
        CHECK(contents.entries.at("Name of channel " + number) ==
              code + " / " + channel.entries.at("Name of the channel"));
        CHECK(channel.number("Sampling interval") == Approx(0.5e-3));
        CHECK(channel.number("Time of first sample") == 0.0);
        CHECK(channel.number("Number of samples") == static_cast<double>(channel.values.size()));
        by_code.emplace(code, channel);
    }
    // rows at 0, 0.5 and 1 ms: the force of 8 kN acts in the last half millisecond
    const Read& a = by_code.at("H0IMPA000000ACZ0");
    CHECK(a.entries.at("Unit") == "m/(s*s)");
    REQUIRE(a.values.size() == 3);
    const Read& f = by_code.at("H0IMPA000000FOZ0");
    CHECK(f.entries.at("Unit") == "N");
    CHECK(f.values == std::vector<double>{0.0, 0.0, 8000.0});
    CHECK(f.number("First global maximum value") == 8000.0);
    CHECK(f.number("Time of maximum value") == Approx(1e-3));
    CHECK(f.number("First global minimum value") == 0.0);
    CHECK(by_code.at("H0IMPA000000FOR0").values == f.values);
    CHECK(by_code.at("H0IMPA000000VEY0").values == std::vector<double>{3.0, 3.0, 3.0});
    CHECK(by_code.at("H0IMPA000000VEY0").number("Time of maximum value") == 0.0);  // the first
    CHECK(by_code.at("H0IMPA000000DSZ0").values[0] == 0.0);
    CHECK(by_code.at("H0IMPA000000DSZ0").values[1] == Approx(-5e-3));
}

TEST_CASE("ISO-MME: bodies are numbered and other unit systems converted", "[export]") {
    const Files files = exported("ton-mm-s-K", {20, 30});
    CHECK(files.size() == 30);
    const Read first(files.at("Channel/oop.001")), second(files.at("Channel/oop.019"));
    CHECK(first.entries.at("Channel code") == "H0IMPA000001ACX0");
    CHECK(second.entries.at("Channel code") == "H0IMPA000002FOX0");
    CHECK(Read(files.at("Channel/oop.007")).values.back() == 8.0);  // 8 N
    CHECK(first.number("Sampling interval") == 0.5);
}

TEST_CASE("ISO-MME without a body or with units unknown is refused", "[export]") {
    CHECK_THROWS_WITH(exported("kg-mm-ms-K", {}), Catch::Contains("a rigid body that can move"));
    CHECK_THROWS_WITH(exported("consistent", {20}), Catch::Contains("these are consistent"));
}
