// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/facet_eights.hpp"

#include <algorithm>

namespace corpuscle::gas {
namespace {

/// Facets of a patch, brought together eight by eight along the cloth, as contact::make_patches()
/// brings patches together: cut midway between two ends, but at a multiple of eight.
class Cutter {
public:
    Cutter(std::span<const Vec3> x, std::span<const Triangle> triangles)
        : triangles_(triangles), distance_(triangles.size()), from_a_(triangles.size()) {
        for (const auto& [i, j, k] : triangles) middle_.push_back((x[i] + x[j] + x[k]) / 3.0);
    }

    void cut(std::span<Index> facets) {
        if (facets.size() <= EIGHT) return;
        const Index a = walk(facets, facets.front()), b = walk(facets, a);
        for (const Index f : facets) from_a_[f] = distance_[f];
        walk(facets, b);
        for (const Index f : facets) from_a_[f] -= distance_[f];
        std::sort(facets.begin(), facets.end(), [&](Index f, Index g) {
            return from_a_[f] != from_a_[g] ? from_a_[f] < from_a_[g] : f < g;
        });
        const std::size_t half = (facets.size() / 2 + EIGHT - 1) / EIGHT * EIGHT;
        cut(facets.first(half));
        cut(facets.subspan(half));
    }

private:
    [[nodiscard]] bool share_a_node(Index f, Index g) const {
        return std::any_of(triangles_[f].begin(), triangles_[f].end(), [&](Index node) {
            return std::find(triangles_[g].begin(), triangles_[g].end(), node) !=
                   triangles_[g].end();
        });
    }
    /// Distances from a facet along the cloth, straight to those of other pieces. Few facets: plain
    /// relaxation.
    /// @returns the farthest
    Index walk(std::span<const Index> facets, Index from) {
        for (const Index f : facets) distance_[f] = INF;
        distance_[from] = 0.0;
        for (bool is_done = false; !is_done;) {
            is_done = true;
            for (const Index f : facets)
                for (const Index g : facets) {
                    if (!(distance_[f] < INF) || f == g || !share_a_node(f, g)) continue;
                    const double through = distance_[f] + (middle_[g] - middle_[f]).norm();
                    if (!(through < distance_[g])) continue;
                    distance_[g] = through;
                    is_done = false;
                }
        }
        for (const Index f : facets)
            if (!(distance_[f] < INF)) distance_[f] = (middle_[f] - middle_[from]).norm();
        return *std::max_element(facets.begin(), facets.end(),
                                 [&](Index f, Index g) { return distance_[f] < distance_[g]; });
    }

    std::span<const Triangle> triangles_;
    Points middle_;
    std::vector<double> distance_, from_a_;  ///< by facet                                  [m]
};

}  // namespace

FacetEights make_eights(std::span<const Vec3> x, std::span<const Triangle> triangles,
                        contact::Patches& patches) {
    Cutter cutter(x, triangles);
    FacetEights out;
    out.of.resize(triangles.size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const std::span<Index> facets(
            patches.triangle.data() + patches.start[p],
            static_cast<std::size_t>(patches.start[p + 1] - patches.start[p]));
        cutter.cut(facets);
        for (std::size_t i = 0; i < facets.size(); ++i) {
            if (i % EIGHT == 0) out.facet.emplace_back().fill(-1);
            out.facet.back()[i % EIGHT] = facets[i];
            out.of[facets[i]] = static_cast<Index>(out.size() - 1);
        }
    }
    return out;
}

}  // namespace corpuscle::gas
