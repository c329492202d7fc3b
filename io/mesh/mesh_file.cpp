// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/mesh/mesh_file.hpp"

#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "io/system/confined.hpp"
#include "io/text/text.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

constexpr double WELD = 1e-6;  ///< of the bounding box; float32, which assimp reads, holds 1e-7

/// The shortest decimal that names this float: nearer to what the file said than its binary digits.
double as_written(float value) {
    return std::strtod(fmt::format("{}", value).c_str(), nullptr);
}

/// Gathers the facets of assimp's tree of nodes, each with its placement.
class Collector {
public:
    explicit Collector(const aiScene& scene) : scene_(scene) {}

    void visit(const aiNode& node, const aiMatrix4x4& parent) {
        const aiMatrix4x4 placement = parent * node.mTransformation;
        for (unsigned m = 0; m < node.mNumMeshes; ++m)
            add(*scene_.mMeshes[node.mMeshes[m]], node.mName.C_Str(), placement);
        for (unsigned c = 0; c < node.mNumChildren; ++c) visit(*node.mChildren[c], placement);
    }

    ImportedMesh mesh;
    std::size_t polygons = 0;  ///< facets of more than 4 corners
    std::size_t astray = 0;    ///< facets with a corner that the file does not hold

private:
    void add(const aiMesh& group, const std::string& node_name, const aiMatrix4x4& placement) {
        const auto base = static_cast<Index>(mesh.x.size());
        const int part = static_cast<int>(mesh.part_names.size());
        for (unsigned v = 0; v < group.mNumVertices; ++v) {
            const aiVector3D p =
                placement.IsIdentity() ? group.mVertices[v] : placement * group.mVertices[v];
            mesh.x.emplace_back(as_written(p.x), as_written(p.y), as_written(p.z));
        }
        const std::size_t before = mesh.shells.size();
        for (unsigned f = 0; f < group.mNumFaces; ++f)
            add(group.mFaces[f], base, group.mNumVertices);
        if (mesh.shells.size() == before) return;
        mesh.part.resize(mesh.shells.size(), part);
        std::string name = group.mName.length > 0 ? group.mName.C_Str() : node_name;
        mesh.part_names.push_back(name.empty() ? fmt::format("part {}", part + 1) : name);
    }

    void add(const aiFace& facet, Index base, unsigned vertices) {
        const unsigned corners = facet.mNumIndices;
        if (corners < 3) ++mesh.mended.loose;
        if (corners > 4) ++polygons;
        if (corners < 3 || corners > 4) return;
        if (std::any_of(facet.mIndices, facet.mIndices + corners,
                        [=](unsigned index) { return index >= vertices; })) {
            ++astray;
            return;
        }
        std::array<Index, 4> nodes{};
        for (unsigned c = 0; c < 4; ++c)
            nodes[c] = base + static_cast<Index>(facet.mIndices[std::min(c, corners - 1)]);
        mesh.shells.push_back(nodes);
    }

    const aiScene& scene_;
};

double diagonal(const Points& x) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : x) box.extend(p);
    return box.diagonal().norm();
}

template <class Archive>
void list(Archive& archive, ImportedMesh& mesh) {
    archive(mesh.x, mesh.shells, mesh.part, mesh.part_names, mesh.mended);
}

/// The file's text behind its byte order mark; empty where it has none.
std::string behind_mark(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string mark(BYTE_ORDER_MARK.size(), ' ');
    if (!in.read(mark.data(), static_cast<std::streamsize>(mark.size())) || mark != BYTE_ORDER_MARK)
        return {};
    std::ostringstream text;
    text << in.rdbuf();
    return std::move(text).str();
}

/// The file as assimp sees it, whose readers of OBJ and PLY do not know a byte order mark.
const aiScene* read_scene(Assimp::Importer& importer, const std::filesystem::path& file) {
    constexpr unsigned NO_POST_PROCESSING = 0;
    const std::string text = behind_mark(file);
    if (text.empty()) return importer.ReadFile(file.string(), NO_POST_PROCESSING);
    return importer.ReadFileFromMemory(text.data(), text.size(), NO_POST_PROCESSING,
                                       file.extension().string().c_str());
}

/// The mesh as assimp sees it, as bytes.
std::vector<char> imported(const std::filesystem::path& file) {
    Assimp::Importer importer;
    const aiScene* scene = read_scene(importer, file);
    if (scene == nullptr || scene->mRootNode == nullptr)
        throw InputError(importer.GetErrorString());
    Collector collector(*scene);
    collector.visit(*scene->mRootNode, aiMatrix4x4());
    if (collector.polygons > 0)
        throw InputError(
            fmt::format("{} facets have more than 4 corners, expected 3 or 4", collector.polygons));
    if (collector.astray > 0)
        throw InputError(
            fmt::format("{} facets have corners that are not in the file, expected a "
                        "file that is whole",
                        collector.astray));
    StateWriter bytes;
    list(bytes, collector.mesh);
    return bytes.bytes();
}

/// Enough for the slowest of assimp's readers many times over.
Limits limits_for(const std::filesystem::path& file) {
    constexpr std::uintmax_t SECONDS_PER_MB = 2;
    constexpr std::uint64_t PER_BYTE = 200;
    Limits limits;
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(file, unknown);
    if (unknown) return limits;
    limits.seconds += static_cast<int>(SECONDS_PER_MB * (size / 1'000'000));
    limits.memory += PER_BYTE * size;
    return limits;
}

}  // namespace

ImportedMesh read_mesh(const std::filesystem::path& file) {
    const Confined found = confined([&] { return imported(file); }, limits_for(file));
    if (!found.bytes) throw InputError(fmt::format("{}: {}", file.string(), found.failure));
    ImportedMesh mesh;
    StateReader bytes(*found.bytes);
    list(bytes, mesh);
    if (mesh.shells.empty()) throw InputError(fmt::format("{}: no facets", file.string()));
    if (!std::all_of(mesh.x.begin(), mesh.x.end(), [](const Vec3& p) { return p.allFinite(); }))
        throw InputError(fmt::format("{}: a coordinate is not a number", file.string()));
    weld(mesh, WELD * diagonal(mesh.x));
    orient(mesh);
    return mesh;
}

}  // namespace corpuscle::io
