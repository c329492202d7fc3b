// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>
#include "io/mesh/deck_writer.hpp"
#include "io/mesh/mesh_file.hpp"
#include "solver/base/error.hpp"
#include "solver/base/random.hpp"
#include "tests/unit/io/results/results_scene.hpp"

namespace mesh_file_setup {

using namespace corpuscle;
using io::ImportedMesh;

/// The unit cube's corners and its six faces, normals outward.
inline const Points CORNERS{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                            {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
inline const std::vector<std::array<int, 4>> FACES{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                   {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

inline std::string obj_cube() {  // two groups that share no vertex
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

inline std::string stl_cube() {
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

inline std::string ply_cube() {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
        "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
    for (const Vec3& x : CORNERS) text += fmt::format("{} {} {}\n", x.x(), x.y(), x.z());
    for (const auto& f : FACES) text += fmt::format("4 {} {} {} {}\n", f[0], f[1], f[2], f[3]);
    return text;
}

inline std::filesystem::path written(const scene::Folder& folder, const std::string& name,
                                     const std::string& text) {
    std::filesystem::create_directories(folder.path);
    std::ofstream(folder.path / name) << text;
    return folder.path / name;
}

/// The cube as it is, in quads.
inline ImportedMesh cube() {
    ImportedMesh mesh;
    mesh.x = CORNERS;
    for (const auto& f : FACES) mesh.shells.push_back({f[0], f[1], f[2], f[3]});
    mesh.part.assign(6, 0);
    mesh.part_names = {"cube"};
    return mesh;
}

}  // namespace mesh_file_setup
