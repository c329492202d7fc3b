// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "solver/base/surface.hpp"

/// Pieces of cloth for tests.
namespace corpuscle::support {

struct Sheet {
    Points x;  ///< [m]
    std::vector<Triangle> triangles;

    /// Adds another sheet, moved by `shift`.
    void append(const Sheet& other, const Vec3& shift) {
        const auto base = static_cast<Index>(x.size());
        for (const Vec3& p : other.x) x.push_back(p + shift);
        for (const Triangle& t : other.triangles)
            triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    }
};

/// Square sheet of n × n quads, each cut into two triangles in turn, edge `size`, in the xy plane.
inline Sheet square_sheet(Index n, double size) {
    Sheet sheet;
    for (Index j = 0; j <= n; ++j)
        for (Index i = 0; i <= n; ++i) sheet.x.emplace_back(size * i / n, size * j / n, 0.0);
    for (Index j = 0; j < n; ++j)
        for (Index i = 0; i < n; ++i) {
            const Index a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
            if ((i + j) % 2 == 0) {
                sheet.triangles.push_back({a, b, c});
                sheet.triangles.push_back({a, c, d});
            } else {
                sheet.triangles.push_back({a, b, d});
                sheet.triangles.push_back({b, c, d});
            }
        }
    return sheet;
}

/// Two square sheets `gap` apart, the lower one's triangles first, normals outward; seamed: the
/// upper one's rim nodes are the lower one's.
inline Sheet two_panels(Index n, double size, double gap, bool is_seamed) {
    Sheet bag = square_sheet(n, size);
    const Sheet upper = bag;
    for (Triangle& t : bag.triangles) std::swap(t[1], t[2]);
    std::vector<Index> row(upper.x.size());
    for (Index j = 0, k = 0; j <= n; ++j)
        for (Index i = 0; i <= n; ++i, ++k) {
            const bool is_rim = i == 0 || j == 0 || i == n || j == n;
            if (is_seamed && is_rim) {
                row[k] = k;
                continue;
            }
            row[k] = static_cast<Index>(bag.x.size());
            bag.x.push_back(upper.x[k] + Vec3(0, 0, gap));
        }
    for (const Triangle& t : upper.triangles)
        bag.triangles.push_back({row[t[0]], row[t[1]], row[t[2]]});
    return bag;
}

/// What leads from x to x_1 in a step.                                                   [m/s]
inline Points velocity_between(const Points& x, const Points& x_1, double dt) {
    Points v(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) v[i] = (x_1[i] - x[i]) / dt;
    return v;
}

}  // namespace corpuscle::support
