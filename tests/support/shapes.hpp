// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "solver/base/surface.hpp"

/// Closed surfaces that tests share, normals outward.
namespace corpuscle::shapes {

struct Shape {
    Points x;
    std::vector<Triangle> triangles;
};

/// Box from the origin to `size`, each face n × n quads cut into two triangles.
inline Shape box(const Vec3& size, int n = 1) {
    Shape shape;
    std::map<std::array<int, 3>, Index> rows;
    const auto node = [&](int i, int j, int k) {
        const auto [at, fresh] = rows.try_emplace({i, j, k}, static_cast<Index>(shape.x.size()));
        if (fresh) shape.x.push_back(size.cwiseProduct(Vec3(i, j, k)) / n);
        return at->second;
    };
    const auto quad = [&](Index a, Index b, Index c, Index d) {
        shape.triangles.push_back({a, b, c});
        shape.triangles.push_back({a, c, d});
    };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            quad(node(i, j, 0), node(i, j + 1, 0), node(i + 1, j + 1, 0), node(i + 1, j, 0));
            quad(node(i, j, n), node(i + 1, j, n), node(i + 1, j + 1, n), node(i, j + 1, n));
            quad(node(i, 0, j), node(i + 1, 0, j), node(i + 1, 0, j + 1), node(i, 0, j + 1));
            quad(node(i, n, j), node(i, n, j + 1), node(i + 1, n, j + 1), node(i + 1, n, j));
            quad(node(0, i, j), node(0, i, j + 1), node(0, i + 1, j + 1), node(0, i + 1, j));
            quad(node(n, i, j), node(n, i + 1, j), node(n, i + 1, j + 1), node(n, i, j + 1));
        }
    return shape;
}

/// Octahedron refined `levels` times, its nodes put on a sphere about the origin.
inline Shape sphere(double radius, int levels) {
    Shape shape{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<Index, Index>, Index> middle;
        const auto between = [&](Index a, Index b) {
            const auto key = std::minmax(a, b);
            const auto [at, fresh] =
                middle.try_emplace({key.first, key.second}, static_cast<Index>(shape.x.size()));
            if (fresh) shape.x.push_back((shape.x[a] + shape.x[b]).normalized());
            return at->second;
        };
        std::vector<Triangle> finer;
        for (const auto& [a, b, c] : shape.triangles) {
            const Index ab = between(a, b), bc = between(b, c), ca = between(c, a);
            for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c},
                                      Triangle{ab, bc, ca}})
                finer.push_back(t);
        }
        shape.triangles = std::move(finer);
    }
    for (Vec3& x : shape.x) x *= radius;
    return shape;
}

}  // namespace corpuscle::shapes
