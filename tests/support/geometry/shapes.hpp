// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
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

/// A flat bag `gap` thick in z, pleated: `panels` panels of height `height` that rise and fall
/// along x, `pitch` each, `width` wide in y; each panel across into `rows` and along the width into
/// `columns` quads. Nowhere do its layers meet: neighbours are some gap · pitch / height apart, and
/// pitch - that behind them.
struct Pleats {
    double pitch, height, gap, width;
    int panels, rows, columns;

    /// Midway between the layers.
    [[nodiscard]] double middle(double x) const {
        const double phase = std::fmod(x / pitch, 2.0);
        return height * (phase < 1.0 ? phase : 2.0 - phase);
    }
};
inline Shape pleated_bag(const Pleats& pleats) {
    const int n = pleats.panels * pleats.rows;
    Shape shape;
    for (const double side : {-0.5, 0.5})
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= pleats.columns; ++j) {
                const double x = pleats.pitch * i / pleats.rows;
                shape.x.push_back(
                    {x, pleats.width * j / pleats.columns, pleats.middle(x) + side * pleats.gap});
            }
    const int across = pleats.columns + 1, layer = (n + 1) * across;
    const auto quad = [&](int a, int b, int c, int d) {
        shape.triangles.push_back({a, b, c});
        shape.triangles.push_back({a, c, d});
    };
    const auto row = [&](int i, int j) { return i * across + j; };
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < pleats.columns; ++j) {
            const int a = row(i, j), b = row(i + 1, j), c = row(i + 1, j + 1), d = row(i, j + 1);
            quad(a, d, c, b);
            quad(a + layer, b + layer, c + layer, d + layer);
        }
    for (int i = 0; i < n; ++i)
        for (const auto& [a, b] : {std::pair(row(i, 0), row(i + 1, 0)),
                                   std::pair(row(i + 1, pleats.columns), row(i, pleats.columns))})
            quad(a, b, b + layer, a + layer);
    for (int j = 0; j < pleats.columns; ++j)
        for (const auto& [a, b] :
             {std::pair(row(0, j + 1), row(0, j)), std::pair(row(n, j), row(n, j + 1))})
            quad(a, b, b + layer, a + layer);
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
