// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <cstring>
#include <map>

#include "io/export/d3plot.hpp"
#include "io/results/results_content.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;

namespace {

/// Words of a d3plot file, one after the other.
class D3plotReader {
public:
    explicit D3plotReader(std::string bytes) : bytes_(std::move(bytes)) {
        REQUIRE(bytes_.size() % 2048 == 0);
    }
    void go(std::size_t word) { at_ = word; }
    std::int32_t integer() { return take<std::int32_t>(); }
    float real() { return take<float>(); }
    std::int32_t integer(std::size_t word) {
        go(word);
        return integer();
    }

private:
    template <class T>
    T take() {
        T value;
        REQUIRE(4 * at_ + 4 <= bytes_.size());
        std::memcpy(&value, bytes_.data() + 4 * at_++, 4);
        return value;
    }
    std::string bytes_;
    std::size_t at_ = 0;
};

}  // namespace

TEST_CASE("frames are in the order of their numbers, however many digits those have", "[export]") {
    const scene::Folder folder("frame_order");
    std::filesystem::create_directories(folder.path);
    const auto file = folder.path / "results.h5";
    io::Hdf5Writer writer(file);
    for (const char* group : {"time", "100000/x", "00009/x", "99999/x", "100001/x"})
        writer.dataset<double>(std::string("/frames/") + group, std::vector{1.0}, {1}, {"-", ""});
    writer.close();
    CHECK(io::frame_groups(io::Hdf5Reader(file)) ==
          std::vector<std::string>{"/frames/00009/", "/frames/99999/", "/frames/100000/",
                                   "/frames/100001/"});
}

TEST_CASE("a d3plot holds mesh, ids and states, value by value", "[export]") {
    const scene::Folder folder("d3plot");
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder.path, scene::info(), layout);
    std::vector<Frame> frames;
    for (std::size_t k = 0; k < 2; ++k) {
        results.append(scene::sample(layout, 3 * k));  // at the frames' times
        frames.push_back(scene::frame(layout, k, 2));
        results.write(frames.back());
    }
    results.finish("normal");
    std::map<std::string, std::string> files;
    io::write_d3plot(
        io::Hdf5Reader(folder.path / "results.h5"),
        [&](const std::string& name, const std::string& bytes) { files.emplace(name, bytes); },
        /*has_particles=*/false);
    REQUIRE(files.size() == 3);

    D3plotReader mesh(files.at("d3plot"));
    const int nodes = mesh.integer(16), shells = mesh.integer(31), parts = mesh.integer(32);
    CHECK((mesh.integer(15) == 4 && nodes == 5 && shells == 2 && parts == 2));
    const int points = -mesh.integer(36) - 10000;
    const int stresses = mesh.integer(43) == 1000 ? 6 : 0, strain = mesh.integer(44) == 1000;
    const int values = points * (stresses + strain + mesh.integer(35)) +
                       8 * (mesh.integer(45) == 1000) + 4 * (mesh.integer(46) == 1000);
    CHECK(mesh.integer(33) == values + 12);  // more by two faces' strains
    CHECK(mesh.integer(39) == 16 + nodes + shells + 3 * parts);
    CHECK(mesh.integer(54) == 0);  // no particles
    mesh.go(14);
    CHECK(mesh.real() == 960.0F);
    mesh.go(64);
    for (const Vec3& x : layout.coordinates)
        for (const double value : x) CHECK(mesh.real() == static_cast<float>(value));
    for (const auto& word : {1, 2, 3, 4, 1, 4, 3, 5, 5, 2}) CHECK(mesh.integer() == word);
    CHECK(mesh.integer() < 0);
    for (int k = 0; k < 12; ++k) (void)mesh.integer();
    CHECK(mesh.integer() == parts);  // of their ids
    for (int k = 0; k < 2; ++k) (void)mesh.integer();
    for (const int id : layout.node_id) CHECK(mesh.integer() == id);
    for (const int id : layout.shell_id) CHECK(mesh.integer() == id);
    for (const int id : {10, 11, 10, 11, 1, 2}) CHECK(mesh.integer() == id);
    CHECK(mesh.real() == -999999.0F);
    CHECK(mesh.integer() == 90001);
    CHECK(mesh.integer() == 2);
    CHECK(mesh.integer() == 10);

    for (std::size_t k = 0; k < 2; ++k) {
        D3plotReader state(files.at(k == 0 ? "d3plot01" : "d3plot02"));
        const Frame& frame = frames[k];
        CHECK(state.real() == static_cast<float>(frame.time));
        const Sample sample = scene::sample(layout, 3 * k);
        CHECK(state.real() == static_cast<float>(sample.energy.kinetic));
        state.go(1 + 6);
        CHECK(state.real() == static_cast<float>(sample.parts[0].strain_energy));
        state.go(1 + static_cast<std::size_t>(mesh.integer(18)));
        for (const Points& rows : {frame.coordinates, frame.velocity})
            for (const Vec3& row : rows)
                for (const double value : row) CHECK(state.real() == static_cast<float>(value));
        for (std::size_t s = 0; s < 2; ++s) {
            const auto& stress = frame.shell_stress[s];
            for (const float value :
                 {stress[0], stress[1], 0.0F, stress[2], 0.0F, 0.0F, frame.shell_pressure[s]})
                CHECK(state.real() == value);
            const auto& of_shell = frame.shell_strain[s];
            for (int face = 0; face < 2; ++face)
                for (const float value : {of_shell[0], of_shell[1], 0.0F, of_shell[2], 0.0F, 0.0F})
                    CHECK(state.real() == value);
        }
        for (std::size_t s = 0; s < 2; ++s)
            CHECK(state.real() == static_cast<float>(frame.shell_active[s]));
        CHECK(state.real() == -999999.0F);
    }
}

TEST_CASE("a d3plot holds the particles of all frames, as airbags of LS-DYNA do", "[export]") {
    const scene::Folder folder("d3plot_particles");
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder.path, scene::info(), layout);
    std::vector<Frame> frames;
    for (std::size_t k = 0; k < 3; ++k) {
        results.append(scene::sample(layout, 3 * k));  // at the frames' times
        frames.push_back(scene::frame(layout, k, k == 1 ? 4 : 2));
        results.write(frames.back());
    }
    results.finish("normal");
    std::map<std::string, std::string> files;
    io::write_d3plot(
        io::Hdf5Reader(folder.path / "results.h5"),
        [&](const std::string& name, const std::string& bytes) { files.emplace(name, bytes); });
    REQUIRE(files.size() == 4);

    D3plotReader mesh(files.at("d3plot"));
    REQUIRE(mesh.integer(54) == 3002);  // two bags
    mesh.go(64);
    const int of_bag = mesh.integer(), of_particle = mesh.integer(), count = mesh.integer(),
              of_state = mesh.integer(), list = of_bag + of_particle + of_state;
    CHECK((of_bag == 4 && of_particle == 14 && count == 4 && of_state == 2));
    for (int k = 0; k < list; ++k) {
        const bool is_real = (k >= of_bag + 3 && k < of_bag + of_particle) || k == list - 1;
        CHECK(mesh.integer() == (is_real ? 2 : 1));
    }
    std::string name;
    for (int k = 0; k < 8 * (of_bag + 4); ++k) name += static_cast<char>(mesh.integer());
    CHECK(name.substr(8 * (of_bag + 3)) == "mass    ");
    const std::size_t section = 64 + 4 + 9 * static_cast<std::size_t>(list);
    mesh.go(section);
    CHECK(mesh.real() == static_cast<float>(layout.coordinates[0].x()));
    mesh.go(section + 3 * 5 + 5 * 2 + static_cast<std::size_t>(mesh.integer(39)));
    // ids 0 and 2 are of bag 7, 1 and 3 of bag 9
    for (const int word : {1, 2, 7, 3, 3, 2, 9, 1}) CHECK(mesh.integer() == word);
    CHECK(mesh.real() == -999999.0F);

    const std::size_t before = 1 + static_cast<std::size_t>(mesh.integer(18)) + 2 * 3 * 5 +
                               2 * static_cast<std::size_t>(mesh.integer(33)) + 2;
    for (std::size_t k = 0; k < 3; ++k) {
        CAPTURE(k);
        D3plotReader state(files.at("d3plot0" + std::to_string(k + 1)));
        state.go(before);
        const Frame::Particles& now = *frames[k].particles;
        const Sample sample = scene::sample(layout, 3 * k);
        for (const std::size_t bag : {0U, 1U}) {
            CHECK(state.integer() == (k == 1 ? 2 : 1));
            CHECK(state.real() == static_cast<float>(sample.airbags[bag].volume));
        }
        for (const std::size_t p : {0U, 2U, 1U, 3U}) {
            const bool is_there = p < now.id.size();
            const Frame::Particles& seen = is_there ? now : *frames[1].particles;
            const auto value = [&](double number) {
                return is_there ? static_cast<float>(number) : 0.0F;
            };
            CHECK(state.integer() == seen.species[p]);
            CHECK(state.integer() == 0);
            CHECK(state.integer() == (is_there || k == 0 ? 0 : 2));
            CHECK(state.real() == value(seen.mass[p]));
            CHECK(state.real() ==
                  Approx(value(0.5 * std::cbrt(sample.airbags[p % 2].volume / 2.0))));
            CHECK(state.real() == value(seen.internal_energy[p]));
            CHECK(state.real() ==
                  Approx(value(0.5 * seen.mass[p] * seen.velocity[p].squaredNorm())));
            CHECK(state.real() == 1e10F);
            for (const double x : seen.position[p]) CHECK(state.real() == static_cast<float>(x));
            for (const double v : seen.velocity[p]) CHECK(state.real() == value(v));
        }
        CHECK(state.real() == -999999.0F);
    }
}
