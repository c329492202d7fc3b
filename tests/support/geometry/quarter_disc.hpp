// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <map>
#include <vector>

#include "fabric/mesh.hpp"

namespace corpuscle::test {

/// A flat mesh in z = 0 of one part.
struct FlatMesh {
    Points x;
    std::vector<Shell> shells;

    void add(Index a, Index b, Index c, Index d) {
        shells.push_back({static_cast<int>(shells.size()) + 1, 0, {a, b, c, d}});
    }
    /// A cell as a quad, or as two triangles whose diagonal alternates.
    void add_cell(bool triangles, bool odd, Index a, Index b, Index c, Index d) {
        if (!triangles) return add(a, b, c, d);
        if (odd) {
            add(a, b, c, c);
            add(a, c, d, d);
        } else {
            add(a, b, d, d);
            add(b, c, d, d);
        }
    }
};

/// Cells n × n on [0, side]².
inline FlatMesh square(int n, double side, bool triangles) {
    FlatMesh mesh;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.x.push_back({side * i / n, side * j / n, 0.0});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = j * (n + 1) + i;
            mesh.add_cell(triangles, (i + j) % 2 == 0, a, a + 1, a + n + 2, a + n + 1);
        }
    return mesh;
}

/// x >= 0, y >= 0 of a disc: three blocks of n × n cells, a bulged square at the middle and two
/// that reach to the rim.
inline FlatMesh quarter_disc(int n, double radius, bool triangles) {
    FlatMesh mesh;
    std::map<std::pair<long, long>, Index> known;
    const auto node = [&](double x, double y) {
        const auto key =
            std::make_pair(std::lround(x / radius * 1e7), std::lround(y / radius * 1e7));
        const auto [at, is_new] = known.try_emplace(key, static_cast<Index>(mesh.x.size()));
        if (is_new) mesh.x.push_back({x, y, 0.0});
        return at->second;
    };
    const double middle = 0.5 * radius,
                 corner = 0.43 * radius;  // ends of the bulged square's edges
    const auto square_point = [&](double u, double v) {
        return std::make_pair(u * (middle + v * (corner - middle)),
                              v * (middle + u * (corner - middle)));
    };
    const auto block = [&](auto&& point) {
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const auto at = [&](int k, int l) {
                    const auto [x, y] = point(double(i + k) / n, double(j + l) / n);
                    return node(x, y);
                };
                mesh.add_cell(triangles, (i + j) % 2 == 0, at(0, 0), at(1, 0), at(1, 1), at(0, 1));
            }
    };
    block(square_point);
    const auto outward = [&](std::pair<double, double> inner, double angle, double s) {
        return std::make_pair((1 - s) * inner.first + s * radius * std::cos(angle),
                              (1 - s) * inner.second + s * radius * std::sin(angle));
    };
    const double eighth = std::atan(1.0);
    block([&](double s, double v) { return outward(square_point(1, v), v * eighth, s); });
    block([&](double u, double s) {
        return outward(square_point(u, 1), 2 * eighth - u * eighth, s);
    });
    return mesh;
}

}  // namespace corpuscle::test
