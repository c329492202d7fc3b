// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// What was mended on the way in, each a count.
struct MeshMending {
    std::size_t welded = 0;      ///< vertices that were the same point as another
    std::size_t collapsed = 0;   ///< quads that became triangles, two corners being one node
    std::size_t degenerate = 0;  ///< facets dropped: less than three different nodes
    std::size_t duplicate = 0;   ///< facets dropped: the same nodes as another
    std::size_t loose = 0;       ///< points and lines, which are no fabric, left out
    std::size_t turned = 0;      ///< facets turned round to agree with their neighbours
};

/// A mesh from a drawing program: nodes, triangles and quads, one part a group of the file.
struct ImportedMesh {
    Points x;                                  ///< N × 3, the file's own unit
    std::vector<std::array<Index, 4>> shells;  ///< E × 4 node rows; a triangle repeats its 3rd
    std::vector<int> part;                     ///< E, rows in part_names
    std::vector<std::string> part_names;       ///< of the groups in the file, or "part 1", ...
    MeshMending mended;                        ///< by read_mesh(), weld() and orient()
};

/// What there is to say of a mesh before it is trusted with gas.
struct MeshReport {
    std::size_t nodes = 0,               ///< that the mesh holds
        triangles = 0,                   ///< shells of three nodes
        quads = 0;                       ///< shells of four nodes
    std::size_t components = 0;          ///< pieces that share no edge
    std::size_t free_edges = 0;          ///< with one facet: a hole, or a rim
    std::size_t non_manifold_edges = 0;  ///< with more than two facets
    std::size_t inconsistent_edges = 0;  ///< whose two facets have opposite normals
    std::size_t slivers = 0;             ///< facets lower than 1/50 of their longest edge
    std::optional<double> volume;        ///< enclosed, when closed and consistent, positive
                                         ///< with normals outward; in the unit of x, cubed
    MeshMending mended;                  ///< as the mesh came

    /// Whether every edge has two facets or more.
    [[nodiscard]] bool is_closed() const { return free_edges == 0; }
};

/// Reads any format that assimp knows (STL, OBJ, PLY, glTF ...), in a process of its own with
/// limits of time and memory that grow with the file: quads are kept, vertices within a
/// millionth of the bounding box's diagonal become one node, also over groups, and facets are
/// turned to agree with their neighbours, outward where they close.
/// @throws InputError if the file cannot be read, has no facets, or has some of more than 4 corners
[[nodiscard]] ImportedMesh read_mesh(const std::filesystem::path& file);

/// Vertices closer than `tolerance`, in the unit of x, become one node; facets that this spoils are
/// dropped, with their unused nodes. All is counted in `mended`.
void weld(ImportedMesh& mesh, double tolerance);

/// Turns facets until neighbours agree: outward in pieces that close, else as most of the piece
/// were.
void orient(ImportedMesh& mesh);

/// Counts what may be wrong, without a change to the mesh.
[[nodiscard]] MeshReport check_mesh(const ImportedMesh& mesh);

/// The report in sentences, a line each; nothing is said of what is in order.
[[nodiscard]] std::string text(const MeshReport& report);

}  // namespace corpuscle::io
