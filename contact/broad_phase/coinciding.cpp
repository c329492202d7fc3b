// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/coinciding.hpp"

#include "contact/broad_phase/triangle_pairs.hpp"
#include "contact/geometry/distance.hpp"
#include "contact/geometry/orientation.hpp"

namespace corpuscle::contact {
namespace {

constexpr double AT_ONE_PLACE = 0.1;  ///< distance over the lift
constexpr double ALIKE = 0.9;         ///< cosine of two normals

struct Heap {
    std::span<const Triangle> triangles;
    std::span<const Vec3> x;
    double near;  ///< [m]

    [[nodiscard]] const Vec3& corner(Index t, int k) const { return x[triangles[t][k]]; }
    [[nodiscard]] Vec3 normal(Index t) const {
        return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).normalized();
    }
    /// Whether the centroid of a lies on b.
    [[nodiscard]] bool lies_on(Index a, Index b) const {
        const Vec3 centroid = (corner(a, 0) + corner(a, 1) + corner(a, 2)) / 3.0;
        const Vec3 w = foot_on_triangle(centroid, corner(b, 0), corner(b, 1), corner(b, 2));
        const Vec3 foot = w[0] * corner(b, 0) + w[1] * corner(b, 1) + w[2] * corner(b, 2);
        return (centroid - foot).norm() <= near;
    }
};

}  // namespace

Points lifts_of_coinciding(std::span<const Triangle> triangles, std::span<const Vec3> x,
                           double lift) {
    const Patches patches = make_patches(x, triangles);
    const TrianglePairs near(patches, triangles, x, lift);
    const Heap heap{triangles, x, AT_ONE_PLACE * lift};
    Points sum;
    std::vector<double> count;
    const auto move = [&](Index t, const Vec3& shift) {
        sum.resize(x.size(), Vec3::Zero());
        count.resize(x.size(), 0.0);
        for (const Index n : triangles[t]) {
            sum[n] += shift;
            count[n] += 1.0;
        }
    };
    for (const auto& pair : near.patch_pairs())
        near.for_each_in(pair, [&](Index i, Index j) {
            const Index a = std::min(i, j), b = std::max(i, j);
            if (share_node(triangles[a], triangles[b])) return;
            const Vec3 m = heap.normal(a), n = heap.normal(b);
            const double alike = m.dot(n);
            if (!(std::abs(alike) > ALIKE) || !(heap.lies_on(a, b) || heap.lies_on(b, a))) return;
            move(a, alike > 0.0 ? Vec3(-m) : m);
            move(b, n);
        });
    for (std::size_t n = 0; n < sum.size(); ++n)
        if (count[n] > 0.0) sum[n] *= lift / count[n];
    return sum;
}

}  // namespace corpuscle::contact
