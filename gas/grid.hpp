// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// Uniform cubic cells over a box. Points outside belong to the nearest cell.
struct Grid {
    Vec3 low = Vec3::Zero();            ///< corner of cell (0, 0, 0)            [m]
    double edge = 1.0;                  ///< of a cell                           [m]
    double per_edge = 1.0;              ///< 1 / edge                            [1/m]
    std::array<int, 3> count{1, 1, 1};  ///< cells along x, y, z

    void set_edge(double length) {
        edge = length;
        per_edge = 1.0 / length;
    }

    [[nodiscard]] std::size_t size() const {
        return static_cast<std::size_t>(count[0]) * count[1] * count[2];
    }
    /// Cell coordinate along one axis.
    [[nodiscard]] int along(int axis, double position) const {
        const double cells = (position - low[axis]) * per_edge;
        return static_cast<int>(std::clamp(cells, 0.0, count[axis] - 1.0));
    }
    [[nodiscard]] std::size_t row(int i, int j, int k) const {
        return (static_cast<std::size_t>(k) * count[1] + j) * count[0] + i;
    }
    [[nodiscard]] std::size_t cell_of(const Vec3& x) const {
        return row(along(0, x[0]), along(1, x[1]), along(2, x[2]));
    }

    /// Cells of at least `edge` that cover the box [from, to], grown until there are at most
    /// `most`.
    static Grid over(const Vec3& from, const Vec3& to, double edge, std::size_t most) {
        Grid grid;
        grid.edge = edge;
        for (;; grid.edge *= 1.25) {
            std::size_t cells = 1;
            for (int a = 0; a < 3; ++a) {
                const double n = std::floor((to[a] - from[a]) / grid.edge) + 1.0;
                if (!(n <= static_cast<double>(most))) {
                    cells = most + 1;
                    break;
                }
                grid.count[a] = static_cast<int>(n);
                cells *= static_cast<std::size_t>(n);
                if (cells > most) break;
            }
            if (cells <= most) break;
        }
        const Vec3 span(grid.count[0], grid.count[1], grid.count[2]);
        grid.set_edge(grid.edge);
        grid.low = 0.5 * (from + to - grid.edge * span);
        return grid;
    }

    /// Cells of about `edge` over the middle of the box [from, to], as many along each axis as come
    /// nearest to its length: none at its faces is a sliver, for what lies beyond belongs to the
    /// nearest cell. Grown until there are at most `most`.
    static Grid fitted(const Vec3& from, const Vec3& to, double edge, std::size_t most) {
        const Vec3 less = Vec3::Constant(0.25 * edge).cwiseMin(0.5 * (to - from));
        const Vec3 low = from + less;
        // Flat is flat, whatever the rounding
        return over(low, low.cwiseMax(to - less), edge, most);
    }
};

}  // namespace corpuscle::gas
