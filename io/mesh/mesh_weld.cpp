// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

#include "io/mesh/mesh_file.hpp"

namespace corpuscle::io {
namespace {

/// Points in cubes of the tolerance's size: what is close lies in the same cube or in one beside
/// it.
class Neighbourhood {
public:
    explicit Neighbourhood(double tolerance) : tolerance_(tolerance) {}

    /// The first point kept within the tolerance of p, else -1.
    [[nodiscard]] Index find(const Vec3& p, const Points& kept) const {
        Index first = -1;
        const Cube at = cube(p);
        for (int beside = 0; beside < 27; ++beside) {
            const Cube near{at[0] + beside % 3 - 1, at[1] + beside / 3 % 3 - 1,
                            at[2] + beside / 9 - 1};
            const auto [begin, end] = points_.equal_range(key(near));
            for (auto it = begin; it != end; ++it) {
                const Index i = it->second;
                if ((kept[static_cast<std::size_t>(i)] - p).norm() <= tolerance_ &&
                    (first < 0 || i < first))
                    first = i;
            }
        }
        return first;
    }

    void add(const Vec3& p, Index i) { points_.emplace(key(cube(p)), i); }

private:
    using Cube = std::array<std::int64_t, 3>;

    [[nodiscard]] Cube cube(const Vec3& p) const {
        const double size =
            tolerance_ > 0.0 ? tolerance_ : 1.0;  // only equal points are close then
        return {static_cast<std::int64_t>(std::floor(p.x() / size)),
                static_cast<std::int64_t>(std::floor(p.y() / size)),
                static_cast<std::int64_t>(std::floor(p.z() / size))};
    }
    /// Cubes that share a key cost a comparison, nothing else.
    [[nodiscard]] static std::uint64_t key(const Cube& c) {
        std::uint64_t k = 0;
        for (const std::int64_t i : c)
            k = (k ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15U;
        return k;
    }

    double tolerance_;
    std::unordered_multimap<std::uint64_t, Index> points_;
};

/// New row of each old vertex; mesh.x keeps the first of every heap.
std::vector<Index> weld_points(ImportedMesh& mesh, double tolerance) {
    std::vector<Index> row(mesh.x.size());
    Points kept;
    Neighbourhood near(tolerance);
    for (std::size_t i = 0; i < mesh.x.size(); ++i) {
        row[i] = near.find(mesh.x[i], kept);
        if (row[i] < 0) {
            row[i] = static_cast<Index>(kept.size());
            near.add(mesh.x[i], row[i]);
            kept.push_back(mesh.x[i]);
        }
    }
    mesh.mended.welded += mesh.x.size() - kept.size();
    mesh.x = std::move(kept);
    return row;
}

/// The facet without corners that repeat the one before; a triangle repeats its 3rd.
std::vector<Index> corners(const std::array<Index, 4>& facet) {
    std::vector<Index> distinct;
    for (const Index node : facet)
        if (std::find(distinct.begin(), distinct.end(), node) == distinct.end())
            distinct.push_back(node);
    return distinct;
}

void drop_unused_nodes(ImportedMesh& mesh) {
    std::vector<Index> row(mesh.x.size(), -1);
    for (const auto& facet : mesh.shells)
        for (const Index node : facet) row[static_cast<std::size_t>(node)] = 0;
    Index next = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
        if (row[i] < 0) continue;
        mesh.x[static_cast<std::size_t>(next)] = mesh.x[i];
        row[i] = next++;
    }
    mesh.x.resize(static_cast<std::size_t>(next));
    for (auto& facet : mesh.shells)
        for (Index& node : facet) node = row[static_cast<std::size_t>(node)];
}

}  // namespace

void weld(ImportedMesh& mesh, double tolerance) {
    const std::vector<Index> row = weld_points(mesh, tolerance);
    std::set<std::vector<Index>> seen;
    std::size_t kept = 0;
    for (std::size_t e = 0; e < mesh.shells.size(); ++e) {
        std::array<Index, 4> facet = mesh.shells[e];
        const bool was_quad = facet[2] != facet[3];
        for (Index& node : facet) node = row[static_cast<std::size_t>(node)];
        std::vector<Index> nodes = corners(facet);
        if (nodes.size() < 3) {
            ++mesh.mended.degenerate;
            continue;
        }
        if (was_quad && nodes.size() == 3) ++mesh.mended.collapsed;
        facet = {nodes[0], nodes[1], nodes[2], nodes.back()};
        std::sort(nodes.begin(), nodes.end());
        if (!seen.insert(nodes).second) {
            ++mesh.mended.duplicate;
            continue;
        }
        mesh.shells[kept] = facet;
        mesh.part[kept++] = mesh.part[e];
    }
    mesh.shells.resize(kept);
    mesh.part.resize(kept);
    drop_unused_nodes(mesh);
}

}  // namespace corpuscle::io
