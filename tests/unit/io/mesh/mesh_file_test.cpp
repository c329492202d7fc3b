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
#include "tests/unit/io/mesh/mesh_file_setup.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::ImportedMesh;
using namespace mesh_file_setup;

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

TEST_CASE("a mesh behind a byte order mark is the same mesh", "[io]") {
    const scene::Folder folder("marked");
    const auto [name, text] = GENERATE(table<std::string, std::string>(
        {{"c.obj", obj_cube()}, {"c.stl", stl_cube()}, {"c.ply", ply_cube()}}));
    INFO(name);
    const ImportedMesh plain = io::read_mesh(written(folder, name, text));
    const ImportedMesh marked = io::read_mesh(written(folder, name, "\xEF\xBB\xBF" + text));
    CHECK(marked.x == plain.x);
    CHECK(marked.shells == plain.shells);
    CHECK(marked.part_names == plain.part_names);
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
