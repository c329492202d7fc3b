// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include "io/mesh/deck_writer.hpp"
#include "io/mesh/mesh_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/random.hpp"
#include "tests/unit/io/mesh/mesh_file_setup.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::ImportedMesh;
using namespace mesh_file_setup;

TEST_CASE("welding joins what is within the tolerance and nothing else", "[io]") {
    ImportedMesh mesh;
    const double gap = GENERATE(0.0, 0.9e-3, 1.1e-3);
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, gap, 0}, {gap, 1, 0}, {1, 1, 0}};
    mesh.shells = {{0, 1, 2, 2}, {3, 5, 4, 4}};
    mesh.part = {0, 1};
    io::weld(mesh, 1e-3);
    const bool joins = gap < 1e-3;
    CHECK(mesh.mended.welded == (joins ? 2 : 0));
    CHECK(mesh.x.size() == (joins ? 4 : 6));
    CHECK(io::check_mesh(mesh).free_edges == (joins ? 4 : 6));
    CHECK(io::check_mesh(mesh).components == (joins ? 1 : 2));
}

TEST_CASE("welding drops what it spoils, and counts it", "[io]") {
    ImportedMesh mesh;
    mesh.x = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1e-9, 1, 0}, {9, 9, 9}};
    mesh.shells = {{0, 1, 2, 3},   // stays
                   {0, 2, 3, 4},   // a quad with two corners at one point: a triangle
                   {3, 4, 0, 0},   // no area
                   {2, 1, 0, 3}};  // the first again, from behind
    mesh.part = {0, 1, 2, 3};
    io::weld(mesh, 1e-6);
    CHECK(mesh.shells == std::vector<std::array<Index, 4>>{{0, 1, 2, 3}, {0, 2, 3, 3}});
    CHECK(mesh.part == std::vector<int>{0, 1});
    CHECK(mesh.x.size() == 4);  // without the one that no facet uses
    CHECK(mesh.mended.welded == 1);
    CHECK(mesh.mended.collapsed == 1);
    CHECK(mesh.mended.degenerate == 1);
    CHECK(mesh.mended.duplicate == 1);
}

TEST_CASE("facets turn to agree with their neighbours, outward when they close", "[io]") {
    const unsigned turned = GENERATE(0U, 1U, 0b101010U, 0b111110U, 0b111111U);
    ImportedMesh mesh = cube();
    std::size_t wrong = 0;
    for (std::size_t f = 0; f < 6; ++f)
        if ((turned >> f & 1U) != 0) {
            std::reverse(mesh.shells[f].begin(), mesh.shells[f].end());
            ++wrong;
        }
    if (wrong == 1) CHECK(io::check_mesh(mesh).inconsistent_edges == 4);
    io::orient(mesh);
    const io::MeshReport report = io::check_mesh(mesh);
    CHECK(report.inconsistent_edges == 0);
    CHECK(report.mended.turned == wrong);
    REQUIRE(report.volume);
    CHECK(*report.volume == Approx(1.0));
}

TEST_CASE("an open piece keeps the side of most of its facets", "[io]") {
    ImportedMesh mesh = cube();
    mesh.shells.pop_back();
    mesh.part.pop_back();
    for (std::size_t f = 1; f < 5; ++f)  // four of five look inward
        std::reverse(mesh.shells[f].begin(), mesh.shells[f].end());
    io::orient(mesh);
    CHECK(mesh.mended.turned == 1);
    const io::MeshReport report = io::check_mesh(mesh);
    CHECK(report.free_edges == 4);
    CHECK(report.inconsistent_edges == 0);
    CHECK_FALSE(report.volume);
}

TEST_CASE("a Moebius strip is told apart from a mesh that can agree", "[io]") {
    ImportedMesh mesh;
    constexpr int N = 12;
    for (int i = 0; i < N; ++i) {
        const double along = 2.0 * M_PI * i / N, twist = 0.5 * along;
        for (const double s : {-0.3, 0.3})
            mesh.x.emplace_back((1.0 + s * std::cos(twist)) * std::cos(along),
                                (1.0 + s * std::cos(twist)) * std::sin(along), s * std::sin(twist));
        const Index a = 2 * i, b = 2 * i + 1;
        if (i + 1 < N)
            mesh.shells.push_back({a, b, b + 2, a + 2});
        else
            mesh.shells.push_back({a, b, 0, 1});
    }
    mesh.part.assign(N, 0);
    io::orient(mesh);
    CHECK(io::check_mesh(mesh).inconsistent_edges == 1);
}

TEST_CASE("pieces, inner walls and slivers are counted", "[io]") {
    SECTION("two cubes apart") {
        ImportedMesh mesh = cube();
        const ImportedMesh other = cube();
        for (const Vec3& x : other.x) mesh.x.push_back(x + Vec3(3, 0, 0));
        for (const auto& f : other.shells)
            mesh.shells.push_back({f[0] + 8, f[1] + 8, f[2] + 8, f[3] + 8});
        const io::MeshReport report = io::check_mesh(mesh);
        CHECK(report.components == 2);
        REQUIRE(report.volume);
        CHECK(*report.volume == Approx(2.0));
    }
    SECTION("a wall across a cube") {
        ImportedMesh mesh = cube();
        mesh.shells.push_back({0, 1, 6, 7});
        const io::MeshReport report = io::check_mesh(mesh);
        CHECK(report.non_manifold_edges == 2);
        CHECK(report.components == 1);
    }
    SECTION("a sliver") {
        const double height = GENERATE(0.019, 0.021, 0.0);
        ImportedMesh mesh;
        mesh.x = {{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}};
        mesh.shells = {{0, 1, 2, 2}};
        CHECK(io::check_mesh(mesh).slivers == (height < 0.02 ? 1 : 0));
    }
}

TEST_CASE("a written deck holds the mesh in LS-DYNA's columns", "[io]") {
    const scene::Folder folder("mesh_deck");
    std::filesystem::create_directories(folder.path);
    ImportedMesh mesh = cube();
    mesh.x[6] = {1.0 / 3.0, -1.2345678901234567e-100, 1e300};
    mesh.shells[5] = {3, 0, 4, 4};
    io::write_deck(folder.path / "bag.k", mesh, "$a\nbag");

    std::ifstream in(folder.path / "bag.k");
    std::string keyword, line;
    std::size_t nodes = 0, shells = 0, parts = 0;
    while (std::getline(in, line)) {
        if (line[0] == '*') keyword = line;
        if (line[0] == '*' || line[0] == '$') continue;
        if (keyword == "*TITLE") CHECK(line == " $a bag");
        if (keyword == "*NODE") {
            REQUIRE(line.size() == 56);
            CHECK(std::stoul(line.substr(0, 8)) == nodes + 1);
            for (int axis = 0; axis < 3; ++axis)
                CHECK(std::stod(line.substr(8 + 16 * static_cast<std::size_t>(axis), 16)) ==
                      Approx(mesh.x[nodes][axis]).epsilon(1e-9));
            ++nodes;
        }
        if (keyword == "*ELEMENT_SHELL") {
            REQUIRE(line.size() == 48);
            CHECK(std::stoul(line.substr(0, 8)) == shells + 1);
            CHECK(std::stoi(line.substr(8, 8)) == 1);
            for (std::size_t c = 0; c < 4; ++c)
                CHECK(std::stoi(line.substr(16 + 8 * c, 8)) == mesh.shells[shells][c] + 1);
            ++shells;
        }
        if (keyword == "*PART" && ++parts == 2) CHECK(line == "         1         1         1");
    }
    CHECK(keyword == "*END");
    CHECK(nodes == 8);
    CHECK(shells == 6);
    CHECK(parts == 2);
}

TEST_CASE("sixteen columns lose no digit that a float has", "[io]") {
    const double value = GENERATE(0.1, -123.456789, 1.0 / 3.0, -1.0 / 3.0, 1e-7, -1.17549435e-38);
    CHECK(io::in_16_columns(value).size() == 16);
    CHECK(std::stod(io::in_16_columns(value)) == Approx(value).epsilon(1e-9));
    CHECK(io::in_16_columns(0.1) == "             0.1");
}
