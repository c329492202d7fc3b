// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/pattern/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "solver/base/error.hpp"

namespace corpuscle::fold {
namespace {

std::map<std::pair<Index, Index>, int> count_edges(const std::vector<Cell>& cells) {
    std::map<std::pair<Index, Index>, int> count;
    for (const Cell& c : cells)
        for (int k = 0, n = corner_count(c); k < n; ++k) ++count[std::minmax(c[k], c[(k + 1) % n])];
    return count;
}

Cell triangle(Index a, Index b, Index c) {
    return {a, b, c, c};
}

double worst(const std::vector<Cell>& cells, const Points& X) {
    double least = 1.0;
    for (const Cell& c : cells) least = std::min(least, quality(c, X));
    return least;
}

}  // namespace

bool is_within(const std::vector<int>& a, const std::vector<int>& b) {
    return std::includes(b.begin(), b.end(), a.begin(), a.end());
}

std::vector<std::pair<Index, Index>> edges(const std::vector<Cell>& cells) {
    std::vector<std::pair<Index, Index>> all;
    for (const auto& [edge, n] : count_edges(cells)) all.push_back(edge);
    return all;
}

std::vector<std::pair<Index, Index>> rim_edges(const std::vector<Cell>& cells) {
    std::vector<std::pair<Index, Index>> rim;
    for (const auto& [edge, n] : count_edges(cells))
        if (n == 1) rim.push_back(edge);
    return rim;
}

std::vector<Triangle> triangles(const std::vector<Cell>& cells) {
    std::vector<Triangle> all;
    for (const Cell& c : cells) {
        all.push_back({c[0], c[1], c[2]});
        if (corner_count(c) == 4) all.push_back({c[0], c[2], c[3]});
    }
    return all;
}

double quality(const Cell& cell, const Points& X) {
    const int n = corner_count(cell);
    double least = 1.0;
    for (int k = 0; k < n; ++k) {
        const Vec3& at = X[cell[k]];
        const Vec3 a = X[cell[(k + 1) % n]] - at, b = X[cell[(k + n - 1) % n]] - at;
        const double lengths = a.norm() * b.norm();
        least = std::min(least, lengths > 0.0 ? a.cross(b).z() / lengths : -1.0);
    }
    return least;
}

double area(const Cell& cell, const Points& X) {
    double sum = 0.0;
    for (const Triangle& t : triangles({cell}))
        sum += vector_area(X[t[0]], X[t[1]], X[t[2]]).norm();
    return sum;
}

namespace {

std::string no_cell(const std::vector<Index>& polygon, const Points& X) {
    const Vec3 at = polygon.empty() ? Vec3(Vec3::Zero()) : X[polygon[0]];
    return fmt::format(
        "a line cuts a cell of the flat pattern at ({:.6g}, {:.6g}) so that a piece has {} "
        "corners, expected 3 to 5: a finer mesh there, without inward corners",
        at.x(), at.y(), polygon.size());
}

}  // namespace

std::vector<Cell> best_cells(const std::vector<Index>& p, const Points& X) {
    if (p.size() < 3 || p.size() > 5) throw InputError(no_cell(p, X));
    std::vector<std::vector<Cell>> ways;
    if (p.size() == 3) ways = {{triangle(p[0], p[1], p[2])}};
    if (p.size() == 4) {
        ways = {{triangle(p[0], p[1], p[2]), triangle(p[0], p[2], p[3])},
                {triangle(p[1], p[2], p[3]), triangle(p[1], p[3], p[0])}};
        const Cell whole{p[0], p[1], p[2], p[3]};
        if (quality(whole, X) > 0.7) ways = {{whole}};  // 45 to 135 degrees: no need to cut it
    }
    if (p.size() == 5)
        for (std::size_t k = 0; k < 5; ++k) {
            const auto at = [&](std::size_t i) { return p[(k + i) % 5]; };
            ways.push_back({triangle(at(0), at(1), at(2)), {at(0), at(2), at(3), at(4)}});
            ways.push_back({triangle(at(0), at(1), at(2)), triangle(at(0), at(2), at(3)),
                            triangle(at(0), at(3), at(4))});
        }
    return *std::max_element(ways.begin(), ways.end(), [&](const auto& a, const auto& b) {
        return worst(a, X) < worst(b, X);
    });
}

void drop_loose_nodes(Sheet& sheet, const std::vector<std::vector<Index>*>& sets) {
    std::vector<Index> row(sheet.X.size(), -1);
    for (const Cell& c : sheet.cells)
        for (const Index n : c) row[n] = 0;
    Index kept = 0;
    for (std::size_t n = 0; n < row.size(); ++n) {
        if (row[n] < 0) continue;
        row[n] = kept;
        sheet.X[kept] = sheet.X[n];
        sheet.x[kept] = sheet.x[n];
        sheet.on[kept] = sheet.on[n];
        ++kept;
    }
    for (std::vector<Index>* set : sets) {
        std::erase_if(*set, [&](Index n) { return row[n] < 0; });
        for (Index& n : *set) n = row[n];
    }
    sheet.X.resize(kept);
    sheet.x.resize(kept);
    sheet.on.resize(kept);
    for (Cell& c : sheet.cells)
        for (Index& n : c) n = row[n];
}

}  // namespace corpuscle::fold
