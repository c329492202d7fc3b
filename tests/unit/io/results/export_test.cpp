// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cstring>
#include <map>
#include <sstream>

#include "io/export/binout.hpp"
#include "io/export/history_source.hpp"
#include "io/export/lsda.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;

namespace {

/// Reads an LSDA file from its symbol table, by the format's description.
class LsdaReader {
public:
    explicit LsdaReader(std::string file) : file_(std::move(file)) {
        REQUIRE(file_.substr(0, 8) == std::string({8, 8, 8, 1, 1, 1, 0, 0}));
        REQUIRE(take<std::uint64_t>(8) == 17);
        REQUIRE(file_[16] == 7);
        std::size_t at = take<std::uint64_t>(17);
        REQUIRE(file_[at + 8] == 5);
        REQUIRE(at + take<std::uint64_t>(at) == file_.size());
        at += 9;
        for (std::string folder; file_[at + 8] != 6; at += take<std::uint64_t>(at)) {
            const std::uint64_t length = take<std::uint64_t>(at);
            if (file_[at + 8] == 2) {
                folder = file_.substr(at + 9, length - 9);
                continue;
            }
            REQUIRE(file_[at + 8] == 4);
            const std::size_t name = length - 9 - 17, after = at + 9 + name;
            places_[folder + "/" + file_.substr(at + 9, name)] = {
                file_[after], take<std::uint64_t>(after + 1), take<std::uint64_t>(after + 9)};
        }
        REQUIRE(take<std::uint64_t>(at) == 17);
        REQUIRE(take<std::uint64_t>(at + 9) == 0);
    }
    [[nodiscard]] bool has(const std::string& path) const { return places_.count(path) > 0; }
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    template <class T>
    [[nodiscard]] std::vector<T> read(const std::string& path, int type) const {
        INFO(path);
        REQUIRE(has(path));
        const Place& place = places_.at(path);
        const std::string name = path.substr(path.rfind('/') + 1);
        REQUIRE(place.type == type);
        REQUIRE(file_[place.offset + 8] == 3);
        REQUIRE(take<std::uint64_t>(place.offset) == 11 + name.size() + place.count * sizeof(T));
        REQUIRE(file_.substr(place.offset + 11, name.size()) == name);
        std::vector<T> values(place.count);
        std::memcpy(values.data(), file_.data() + place.offset + 11 + name.size(),
                    place.count * sizeof(T));
        return values;
    }
    [[nodiscard]] std::vector<double> reals(const std::string& path) const {
        return read<double>(path, 10);
    }

private:
    struct Place {
        char type;
        std::uint64_t offset, count;
    };
    template <class T>
    [[nodiscard]] T take(std::size_t at) const {
        T value;
        REQUIRE(at + sizeof(T) <= file_.size());
        std::memcpy(&value, file_.data() + at, sizeof(T));
        return value;
    }
    std::string file_;
    std::map<std::string, Place> places_;
};

/// Results of three samples.
struct Run {
    scene::Folder folder{"export"};
    RecordLayout layout = scene::layout();
    std::vector<Sample> samples;
    Run() {
        io::ResultsFile results(folder.path, scene::info(), layout);
        results.follow(0.01, {{20, 4.5, Vec3(1, 2, 3), Vec3(10, 0, 0)}});
        for (std::size_t row = 0; row < 3; ++row) {
            samples.push_back(scene::sample(layout, row));
            results.append(samples.back());
            results.observe(0.5 * static_cast<double>(row), {{}}, row == 2);
        }
        results.finish("normal");
    }
    [[nodiscard]] io::Hdf5Reader open() const { return io::Hdf5Reader(folder.path / "results.h5"); }
};

}  // namespace

TEST_CASE("LSDA: what is written is found by its name, value by value", "[export]") {
    io::LsdaWriter writer;
    const std::vector<std::int32_t> ids{3, -1, 2000000000};
    writer.folder("/a/b");
    writer.write("text", std::string_view("some words"));
    writer.write("ids", std::span(ids));
    writer.folder("/c");
    writer.write("one", 0.1);
    const LsdaReader reader(writer.finish());
    CHECK(reader.size() == 3);
    const auto text = reader.read<char>("/a/b/text", 1);
    CHECK(std::string(text.begin(), text.end()) == "some words");
    CHECK(reader.read<std::int32_t>("/a/b/ids", 3) == ids);
    CHECK(reader.reals("/c/one") == std::vector<double>{0.1});
}

TEST_CASE("a binout holds the run's numbers", "[export]") {
    const Run run;
    const LsdaReader binout(io::binout(run.open()));
    CHECK(binout.read<std::int32_t>("/abstat/metadata/ids", 3) == std::vector<std::int32_t>{7, 9});
    for (std::size_t row = 0; row < 3; ++row) {
        const Sample& s = run.samples[row];
        const std::string state = "/d00000" + std::to_string(row + 1) + "/";
        CHECK(binout.reals("/glstat" + state + "time") == std::vector<double>{s.time});
        CHECK(binout.reals("/glstat" + state + "kinetic_energy") ==
              std::vector<double>{s.energy.kinetic});
        CHECK(binout.reals("/abstat" + state + "pressure") ==
              std::vector<double>{s.airbags[0].pressure, s.airbags[1].pressure});
        CHECK(binout.reals("/abstat" + state + "surface_area")[0] ==
              Approx(s.airbags[0].parts[0].area + s.airbags[0].parts[1].area));
        CHECK(binout.reals("/abstat_cpm" + state + "pressure") ==
              binout.reals("/abstat" + state + "pressure"));
        CHECK(binout.reals("/abstat_cpm" + state + "Trans_ke") ==
              std::vector<double>{s.airbags[0].translational_energy,
                                  s.airbags[1].translational_energy});
        CHECK(binout.reals("/abstat_cpm" + state + "bag_data/pressure") ==
              std::vector<double>{s.airbags[0].parts[0].pressure, s.airbags[0].parts[1].pressure,
                                  s.airbags[1].parts[0].pressure});
        CHECK(binout.reals("/abstat_cpm" + state + "bag_data/area_tot")[1] ==
              s.airbags[0].parts[1].area);
        CHECK(binout.reals("/rbdout" + state + "global_vy") ==
              std::vector<double>{s.rigid_bodies[0].velocity.y()});
        CHECK(binout.reals("/rcforc" + state + "z_force") ==
              std::vector<double>{scene::contact_force(run.layout, row, 0).z()});
        CHECK(binout.reals("/rwforc/forces" + state + "x_force") ==
              std::vector<double>{scene::wall_force(run.layout, row, 0).x(),
                                  scene::wall_force(run.layout, row, 1).x()});
        const double span = row == 0 ? 1.0 : s.time - run.samples[row - 1].time;
        const Sample& was = run.samples[row == 0 ? 0 : row - 1];
        CHECK(binout.reals("/jntforc/joints" + state + "z_force") ==
              std::vector<double>{(s.joints[0].impulse - was.joints[0].impulse).z() / span,
                                  (s.joints[1].impulse - was.joints[1].impulse).z() / span});
        CHECK(binout.reals("/jntforc/joints" + state + "resultant_moment")[1] ==
              Approx((s.joints[1].turning - was.joints[1].turning).norm() / span));
        CHECK(binout.reals("/nodout" + state + "y_coordinate") ==
              std::vector<double>{s.node_coordinates[0].y(), s.node_coordinates[1].y()});
        CHECK(binout.reals("/matsum" + state + "kinetic_energy")[2] == s.parts[2].kinetic_energy);
    }
    CHECK(binout.read<std::int32_t>("/abstat_cpm/metadata/nparts", 3) ==
          std::vector<std::int32_t>{2, 1});
    CHECK(binout.read<std::int32_t>("/abstat_cpm/metadata/pid", 3) ==
          std::vector<std::int32_t>{10, 11, 12});
    const double in = run.samples[2].airbags[0].mass_in - run.samples[1].airbags[0].mass_in;
    CHECK(binout.reals("/abstat/d000003/dm_dt_in")[0] == Approx(in / 0.5));
    CHECK_FALSE(binout.has("/glstat/d000004/time"));
}

TEST_CASE("a CSV holds every history once, with units and all digits", "[export]") {
    const Run run;
    const auto histories = io::read_histories(run.open(), "/history");
    std::stringstream csv(io::csv_text(histories));
    std::string heading, line;
    std::getline(csv, heading);
    CHECK(heading.starts_with("time [ms],airbag/7/energy [J],"));
    const auto columns = std::count(heading.begin(), heading.end(), ',') + 1;
    std::map<std::string, std::size_t> place;
    std::stringstream names(heading);
    for (std::string name; std::getline(names, name, ',');) place.emplace(name, place.size());
    CHECK(place.size() == static_cast<std::size_t>(columns));
    for (const Sample& s : run.samples) {
        REQUIRE(std::getline(csv, line));
        std::vector<double> row;
        std::stringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
        REQUIRE(row.size() == static_cast<std::size_t>(columns));
        CHECK(row[0] == s.time);
        CHECK(row[place.at("airbag/9/pressure [GPa]")] == s.airbags[1].pressure);
        CHECK(row[place.at("rigid_body/20/force.z [kN]")] == s.rigid_bodies[0].force.z());
    }
    CHECK_FALSE(std::getline(csv, line));
    const auto fast = io::read_histories(run.open(), "/history_fast");
    CHECK(fast.size() == 5);  // time and four of the body; its mass is no history
    CHECK(fast.front().values.size() == 101);
}
