// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/groups.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>
#include <numbers>
#include <numeric>
#include <set>

#include "solver/base/parallel.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// Fabric in a single cell, the cube -1..1, and particles in it.
struct Scene {
    Points x;
    std::vector<Triangle> triangles;
    Particles gas;

    /// cells × cells quads, halved, over -2..2 in u and v; node (u, v) goes to place(u, v).
    void add_sheet(int cells, const std::function<Vec3(double, double)>& place) {
        const auto first = static_cast<Index>(x.size());
        const int row = cells + 1;
        for (int j = 0; j <= cells; ++j)
            for (int i = 0; i <= cells; ++i)
                x.push_back(place(-2.0 + 4.0 * i / cells, -2.0 + 4.0 * j / cells));
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                const Index n = first + j * row + i;
                triangles.push_back({n, n + 1, n + row + 1});
                triangles.push_back({n, n + row + 1, n + row});
            }
    }
    void add(const Vec3& at) {
        gas.add(at, Vec3::Zero(), 0.0, 0, static_cast<std::int32_t>(gas.size()));
    }
    void add_random(int n, std::uint64_t seed) {
        Random draw(seed, Stream::INITIAL, 0, 0);
        for (int i = 0; i < n; ++i)
            add(Vec3(draw.uniform(), draw.uniform(), draw.uniform()) * 2.0 - Vec3(1, 1, 1));
    }
    /// Group of each particle, by id; groups are numbered as they come.
    std::vector<int> groups() {
        Grid grid;
        grid.low = Vec3(-1, -1, -1);
        grid.set_edge(2.0);
        FacetLists lists(triangles, x, FacetLists::Of::FACETS);
        lists.build(grid, x, x, 0.0);
        CellSort cells;
        cells.sort(grid, gas);
        Groups groups;
        groups.find(cells, {&lists, x}, gas, 2.0 * std::sqrt(3.0));
        std::vector<int> group(gas.size(), -1);
        for (std::size_t g = 0; g < groups.lists().size(); ++g)
            for (const Index row : groups.lists()[g]) group[gas.id[row]] = static_cast<int>(g);
        return group;
    }
};

/// Do the open segment and the triangle meet? Plane, then barycentric coordinates.
bool brute_force_blocks(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const double at_p = n.dot(p - a), at_q = n.dot(q - a);
    if ((at_p > 0.0) == (at_q > 0.0)) return false;
    const Vec3 hit = p + at_p / (at_p - at_q) * (q - p);
    const double u = n.dot((b - a).cross(hit - a)), v = n.dot((c - b).cross(hit - b)),
                 w = n.dot((a - c).cross(hit - c));
    return u >= 0.0 && v >= 0.0 && w >= 0.0;
}

bool brute_force_sees(const Scene& scene, std::size_t i, std::size_t j) {
    return std::none_of(scene.triangles.begin(), scene.triangles.end(), [&](const Triangle& t) {
        return brute_force_blocks(scene.gas.x[i], scene.gas.x[j], scene.x[t[0]], scene.x[t[1]],
                                  scene.x[t[2]]);
    });
}

/// Connected parts of the graph of all lines of sight.
std::vector<int> brute_force_parts(const Scene& scene) {
    const std::size_t n = scene.gas.size();
    std::vector<int> part(n, -1);
    for (std::size_t i = 0, parts = 0; i < n; ++i) {
        if (part[i] >= 0) continue;
        std::vector<std::size_t> open = {i};
        part[i] = static_cast<int>(parts);
        while (!open.empty()) {
            const std::size_t k = open.back();
            open.pop_back();
            for (std::size_t j = 0; j < n; ++j)
                if (part[j] < 0 && brute_force_sees(scene, k, j)) {
                    part[j] = static_cast<int>(parts);
                    open.push_back(j);
                }
        }
        ++parts;
    }
    return part;
}

Mat3 random_turn(std::uint64_t seed) {
    Random draw(seed, Stream::INITIAL, 1, 0);
    return Eigen::AngleAxisd(2 * std::numbers::pi * draw.uniform(), draw.direction())
        .toRotationMatrix();
}

std::size_t count(const std::vector<int>& group) {
    return std::set<int>(group.begin(), group.end()).size();
}

}  // namespace

TEST_CASE("flat sheets part the gas of a cell into its layers, however they lie", "[gas]") {
    const int sheets = GENERATE(1, 2, 3);
    const std::uint64_t seed = GENERATE(range(1, 8));
    const Mat3 turn = seed == 1 ? Mat3::Identity() : random_turn(seed);
    Scene scene;
    for (int s = 0; s < sheets; ++s) {
        const double height = -0.3 + 0.31 * s;
        scene.add_sheet(1 + static_cast<int>(seed), [&](double u, double v) {
            return Vec3(turn * Vec3(2 * u, 2 * v, height));
        });
    }
    scene.add_random(80, seed);
    const std::vector<int> group = scene.groups();
    std::vector<int> layer(group.size(), 0);
    for (std::size_t i = 0; i < layer.size(); ++i)
        for (int s = 0; s < sheets; ++s)
            layer[i] += (turn.transpose() * scene.gas.x[i]).z() > -0.3 + 0.31 * s;
    for (std::size_t i = 0; i < group.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            REQUIRE((group[i] == group[j]) == (layer[i] == layer[j]));
}

TEST_CASE("crumpled sheets: nobody shares a group with gas that the fabric parts", "[gas]") {
    const std::uint64_t seed = GENERATE(range(1, 40));
    Scene scene;
    const double roughness = 0.05 * static_cast<double>(seed % 6);
    for (int s = 0; s < 3; ++s) {
        Random draw(seed, Stream::INITIAL, 2, static_cast<std::uint64_t>(s));
        const Mat3 turn = random_turn(seed);
        scene.add_sheet(6, [&](double u, double v) {
            const double height = -0.5 + 0.5 * s + 0.3 * std::sin(2 * u) * std::cos(3 * v);
            return Vec3(turn * Vec3(u, v, height + roughness * (draw.uniform() - 0.5)));
        });
    }
    scene.add_random(60, seed);
    const std::vector<int> group = scene.groups(), part = brute_force_parts(scene);
    for (std::size_t i = 0; i < group.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (group[i] == group[j]) REQUIRE(part[i] == part[j]);
    // Not divided for nothing: at most a few groups more than there are parts.
    CHECK(count(group) <= 2 * count(part) + 4);
}

TEST_CASE("loose triangles: a group's particles are joined by free lines", "[gas]") {
    const std::uint64_t seed = GENERATE(range(1, 30));
    Scene scene;
    Random draw(seed, Stream::INITIAL, 3, 0);
    for (Index t = 0; t < 25; ++t) {
        for (int k = 0; k < 3; ++k) scene.x.push_back(1.5 * draw.uniform() * draw.direction());
        scene.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    scene.add_random(40, seed);
    const std::vector<int> group = scene.groups(), part = brute_force_parts(scene);
    for (std::size_t i = 0; i < group.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (group[i] == group[j]) REQUIRE(part[i] == part[j]);
}

TEST_CASE("lines of sight through edges and corners are blocked", "[gas]") {
    Scene scene;
    scene.add_sheet(8, [](double u, double v) { return Vec3(u, v, 0.0); });
    const std::size_t nodes = scene.x.size();
    for (std::size_t n = 0; n < nodes; ++n) {
        const Vec3 at = scene.x[n];
        if (at.cwiseAbs().maxCoeff() > 0.9) continue;
        for (const Vec3& aside : {Vec3(0, 0, 0), Vec3(0.25, 0, 0), Vec3(0.25, 0.25, 0)})
            for (double height : {-1e-3, 1e-3})
                scene.add(at + aside + Vec3(0, 0, height * (1 + n % 3)));
    }
    const std::vector<int> group = scene.groups();
    CHECK(count(group) == 2);
    for (std::size_t i = 0; i < group.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            REQUIRE((group[i] == group[j]) ==
                    ((scene.gas.x[i].z() > 0) == (scene.gas.x[j].z() > 0)));
}

TEST_CASE("gas is joined round the rim of a sheet that ends inside the cell", "[gas]") {
    Scene scene;
    scene.add_sheet(4, [](double u, double v) { return Vec3(u + 2.0, v, 0.0); });  // x > 0 only
    scene.add(Vec3(-0.5, 0.01, 0.013));  // sees both sides
    scene.add(Vec3(0.5, 0, 0.2));
    scene.add(Vec3(0.5, 0, -0.2));
    CHECK(count(scene.groups()) == 1);
    scene.gas.x[0].x() = 0.5;
    CHECK(count(scene.groups()) == 2);
}

TEST_CASE("who touches the fabric is alone", "[gas]") {
    Scene scene;
    scene.add_sheet(4, [](double u, double v) { return Vec3(u, v, 0.0); });
    scene.add(Vec3(0.3, 0.1, 0.5));
    scene.add(Vec3(0.1, 0.2, 0.7));
    scene.add(Vec3(0.1, 0.3, 0.0));
    scene.add(Vec3(0.3, 0.3, -0.4));
    scene.add(Vec3(0.3, 0.2, 1e-12));
    const std::vector<int> group = scene.groups();
    CHECK(group[0] == group[1]);
    CHECK(count(group) == 4);
}

TEST_CASE("groups depend neither on the order of rows nor on threads", "[gas]") {
    const std::uint64_t seed = GENERATE(range(1, 10));
    Scene scene;
    Random draw(seed, Stream::INITIAL, 4, 0);
    for (int s = 0; s < 2; ++s)
        scene.add_sheet(5, [&](double u, double v) {
            return Vec3(u, v, -0.4 + 0.6 * s + 0.4 * (draw.uniform() - 0.5));
        });
    scene.add_random(50, seed);
    const std::vector<int> group = scene.groups();

    Scene shuffled = scene;
    for (std::size_t i = scene.gas.size(); i > 1; --i) {
        const std::size_t j = draw.below(static_cast<std::uint32_t>(i));
        std::swap(shuffled.gas.x[i - 1], shuffled.gas.x[j]);
        std::swap(shuffled.gas.id[i - 1], shuffled.gas.id[j]);
    }
    CHECK(shuffled.groups() == group);
}

TEST_CASE("without fabric a cell is a group, and empty cells are none", "[gas]") {
    Particles gas = random_gas(300, Vec3(1, 1, 1), mixture_of({AIR}), {300});
    const Grid grid = Grid::over(Vec3::Zero(), Vec3(3, 3, 3), 0.3, 10000);
    CellSort cells;
    cells.sort(grid, gas);
    Groups groups;
    for (const int threads : {1, 2}) {
        parallel::set_threads(threads);
        groups.find(cells, {}, gas, 1.0);
        const Lists lists = groups.lists();
        std::size_t seen = 0;
        for (std::size_t g = 0; g < lists.size(); ++g) {
            REQUIRE(!lists[g].empty());
            const std::size_t cell = grid.cell_of(gas.x[lists[g][0]]);
            CHECK(lists[g].size() == cells.cells()[cell].size());
            seen += lists[g].size();
        }
        CHECK(seen == gas.size());
        CHECK(groups.divided_cells() == 0);
    }
}
