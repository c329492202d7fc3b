// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>
#include <map>

#include "tests/support/random/random_plan.hpp"

namespace corpuscle::support {
namespace {

/// Writes nodes and shells, each once.
class BoxWriter {
public:
    BoxWriter(Plan& plan, bool has_triangles) : plan_(plan), has_triangles_(has_triangles) {}

    /// All cells of the box at one level of an axis.
    void face(int axis, int level, bool is_far, bool is_inside) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < cells(u); ++i)
            for (int j = 0; j < cells(v); ++j) {
                const auto corner = [&](int di, int dj) {
                    std::array<int, 3> grid{};
                    grid[static_cast<std::size_t>(axis)] = level;
                    grid[static_cast<std::size_t>(u)] = i + di;
                    grid[static_cast<std::size_t>(v)] = j + dj;
                    return grid;
                };
                const auto low = corner(0, 0);
                const int x = axis == 0 ? (is_far ? cells(0) : 0) : low[0];
                int part = part_at(axis, is_far, i, j, x);
                if (is_inside)
                    part =
                        plan_.has_hole && i == cells(u) / 2 && j == cells(v) / 2 ? HOLE : MEMBRANE;
                const int a = node(low), b = node(corner(1, 0)), c = node(corner(1, 1)),
                          d = node(corner(0, 1));
                if (axis == 2 && !is_far)
                    plan_.floor[part == FAR_WALL ? 1 : 0].push_back(shell_count_ + 1);
                quad(part, is_far ? std::array{a, d, c, b} : std::array{a, b, c, d});
            }
    }
    [[nodiscard]] int cells(int axis) const { return plan_.cells[static_cast<std::size_t>(axis)]; }
    [[nodiscard]] std::string text() const { return nodes_ + shells_ + held_; }

private:
    int node(const std::array<int, 3>& grid) {
        const auto [at, is_new] = known_.try_emplace(grid, static_cast<int>(known_.size()) + 1);
        if (is_new) {
            Vec3 x;
            for (std::size_t i = 0; i < 3; ++i)
                x[static_cast<int>(i)] = plan_.side[static_cast<int>(i)] * grid[i] / plan_.cells[i];
            nodes_ += fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", at->second, x[0], x[1], x[2]);
            if (plan_.is_rigid || grid[2] == 0) held_ += fmt::format("{}\n", at->second);
        }
        return at->second;
    }
    void quad(int part, const std::array<int, 4>& n) {
        if (!has_triangles_) {
            shells_ += fmt::format("{}, {}, {}, {}, {}, {}\n", ++shell_count_, part, n[0], n[1],
                                   n[2], n[3]);
            return;
        }
        for (const auto& [a, b, c] : {std::array{n[0], n[1], n[2]}, std::array{n[0], n[2], n[3]}})
            shells_ += fmt::format("{}, {}, {}, {}, {}, {}\n", ++shell_count_, part, a, b, c, c);
    }
    [[nodiscard]] int part_at(int axis, bool is_far, int i, int j, int x) const {
        const auto middle = [&](int k, int count) { return k == count / 2; };
        if (plan_.has_vent && axis == 0 && is_far && middle(i, plan_.cells[1]) &&
            middle(j, plan_.cells[2]))
            return VENT;
        if (plan_.is_porous && axis == 2 && is_far && 2 * x >= plan_.cells[0]) return POROUS;
        return plan_.has_chambers && 2 * x >= plan_.cells[0] ? FAR_WALL : WALL;
    }

    Plan& plan_;
    bool has_triangles_;
    std::string nodes_ = "*NODE\n", shells_ = "*ELEMENT_SHELL\n", held_ = "*SET_NODE_LIST\n1\n";
    std::map<std::array<int, 3>, int> known_;
    int shell_count_ = 0;
};

}  // namespace

std::string mesh_of(Plan& plan, bool has_triangles) {
    BoxWriter box(plan, has_triangles);
    for (int axis = 0; axis < 3; ++axis) {
        box.face(axis, 0, false, false);
        box.face(axis, box.cells(axis), true, false);
        if (axis == 0 && plan.has_chambers) box.face(axis, box.cells(0) / 2, false, true);
    }
    const std::string dofs = "*BOUNDARY_SPC_SET\n1, 0, 1, 1, 1, 1, 1, 1\n";
    return box.text() + (plan.is_free ? "" : dofs);
}

}  // namespace corpuscle::support
