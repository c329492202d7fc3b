// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/mesh/mesh_file.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "io/mesh/deck_writer.hpp"
#include "solver/base/error.hpp"
#include "solver/base/random.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::ImportedMesh;

namespace {

/// The unit cube's corners and its six faces, normals outward.
const Points CORNERS{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                     {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
const std::vector<std::array<int, 4>> FACES{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                            {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::string obj_cube() {  // two groups that share no vertex
    std::string text;
    for (const char* group : {"lower", "upper"}) {
        for (const Vec3& x : CORNERS) text += fmt::format("v {} {} {}\n", x.x(), x.y(), x.z());
        text += fmt::format("g {}\n", group);
        const int base = group[0] == 'l' ? 1 : 9;
        for (std::size_t f = group[0] == 'l' ? 0 : 3; f < (group[0] == 'l' ? 3 : 6); ++f)
            text += fmt::format("f {} {} {} {}\n", FACES[f][0] + base, FACES[f][1] + base,
                                FACES[f][2] + base, FACES[f][3] + base);
    }
    return text;
}

std::string stl_cube() {
    std::string text = "solid cube\n";
    for (const auto& f : FACES)
        for (const auto& [a, b, c] : {std::array{f[0], f[1], f[2]}, std::array{f[0], f[2], f[3]}}) {
            text += "facet normal 0 0 0\nouter loop\n";
            for (const int corner : {a, b, c}) {
                const Vec3& x = CORNERS[static_cast<std::size_t>(corner)];
                text += fmt::format("vertex {} {} {}\n", x.x(), x.y(), x.z());
            }
            text += "endloop\nendfacet\n";
        }
    return text + "endsolid cube\n";
}

std::string ply_cube() {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
        "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3& x : CORNERS) text += fmt::format("{} {} {}\n", x.x(), x.y(), x.z());
    for (const auto& f : FACES) text += fmt::format("4 {} {} {} {}\n", f[0], f[1], f[2], f[3]);
    return text;
}

std::filesystem::path written(const scene::Folder& folder, const std::string& name,
                              const std::string& text) {
    std::filesystem::create_directories(folder.path);
    std::ofstream(folder.path / name) << text;
    return folder.path / name;
}

/// The cube as it is, in quads.
ImportedMesh cube() {
    ImportedMesh mesh;
    mesh.x = CORNERS;
    for (const auto& f : FACES) mesh.shells.push_back({f[0], f[1], f[2], f[3]});
    mesh.part.assign(6, 0);
    mesh.part_names = {"cube"};
    return mesh;
}

}  // namespace

TEST_CASE("a cube of any format becomes eight nodes and a closed unit volume", "[io]") {
    const scene::Folder folder("cube");
    const auto [name, text, quads, triangles, parts] =
        GENERATE(table<std::string, std::string, std::size_t, std::size_t, std::size_t>(
            {{"cube.obj", obj_cube(), 6, 0, 2},
             {"cube.stl", stl_cube(), 0, 12, 1},
             {"cube.ply", ply_cube(), 6, 0, 1}}));
    INFO(name);
    const ImportedMesh mesh = io::read_mesh(written(folder, name, text));
    CHECK(mesh.x.size() == 8);
    CHECK(mesh.part_names.size() == parts);
    CHECK(mesh.part.size() == mesh.shells.size());
    const io::MeshReport report = io::check_mesh(mesh);
    CHECK(report.quads == quads);
    CHECK(report.triangles == triangles);
    CHECK(report.components == 1);
    CHECK(report.is_closed());
    CHECK(report.non_manifold_edges == 0);
    CHECK(report.inconsistent_edges == 0);
    CHECK(report.slivers == 0);
    CHECK(report.mended.turned == 0);
    REQUIRE(report.volume);
    CHECK(*report.volume == Approx(1.0).epsilon(1e-12));
    if (parts == 2) {
        CHECK(mesh.part_names == std::vector<std::string>{"lower", "upper"});
        CHECK(mesh.part == std::vector<int>{0, 0, 0, 1, 1, 1});
    }
}

TEST_CASE("decimals of the file come back as written, not as their nearest float", "[io]") {
    const scene::Folder folder("decimals");
    const ImportedMesh mesh = io::read_mesh(
        written(folder, "t.obj", "v 0.1 0.2 0.3\nv 10.7 0 0\nv 0 1e-3 -2.54\nf 1 2 3\n"));
    CHECK(mesh.x == Points{{0.1, 0.2, 0.3}, {10.7, 0, 0}, {0, 1e-3, -2.54}});
}

TEST_CASE("what cannot be read says so", "[io]") {
    const scene::Folder folder("bad_mesh");
    CHECK_THROWS_AS(io::read_mesh(folder.path / "nowhere.stl"), InputError);
    CHECK_THROWS_AS(io::read_mesh(written(folder, "a.obj", "no mesh at all\n")), InputError);
    CHECK_THROWS_AS(io::read_mesh(written(folder, "a.xyz", "1 2 3\n")), InputError);
    CHECK_THROWS_WITH(
        io::read_mesh(written(folder, "five.obj",
                              "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4 5\n")),
        Catch::Contains("1 facets have more than 4 corners"));
}

TEST_CASE("a mesh file that was damaged is read or refused, nothing else", "[io]") {
    const scene::Folder folder("damaged_mesh");
    const auto [name, text] = GENERATE(table<std::string, std::string>(
        {{"cube.obj", obj_cube()}, {"cube.stl", stl_cube()}, {"cube.ply", ply_cube()}}));
    int refused = 0;
    constexpr int MUTANTS = 40;
    for (int i = 0; i < MUTANTS; ++i) {
        Random draw(2007, Stream::INITIAL, 0, static_cast<std::uint64_t>(i));
        std::string damaged = text;
        for (std::uint32_t changes = 1 + draw.below(4); changes > 0; --changes) {
            const auto at = draw.below(static_cast<std::uint32_t>(damaged.size()));
            if (draw.below(3) == 0)
                damaged.replace(at, 1, "99999999");
            else
                damaged[at] = static_cast<char>(draw.below(256));
        }
        CAPTURE(name, i);
        try {
            const ImportedMesh mesh = io::read_mesh(written(folder, name, damaged));
            for (const auto& shell : mesh.shells)
                for (const Index n : shell) REQUIRE(static_cast<std::size_t>(n) < mesh.x.size());
        } catch (const InputError&) {
            ++refused;
        }
    }
    CHECK(refused > 0);
    CHECK(refused < MUTANTS);
}

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
