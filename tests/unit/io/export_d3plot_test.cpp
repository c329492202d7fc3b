// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cstring>
#include <map>

#include "io/export/d3plot.hpp"
#include "tests/unit/io/results_scene.hpp"

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
        [&](const std::string& name, const std::string& bytes) { files.emplace(name, bytes); });
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
    CHECK(mesh.integer() == 90000);

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
            const auto& strain = frame.shell_strain[s];
            for (int face = 0; face < 2; ++face)
                for (const float value : {strain[0], strain[1], 0.0F, strain[2], 0.0F, 0.0F})
                    CHECK(state.real() == value);
        }
        for (std::size_t s = 0; s < 2; ++s)
            CHECK(state.real() == static_cast<float>(frame.shell_active[s]));
        CHECK(state.real() == -999999.0F);
    }
}
