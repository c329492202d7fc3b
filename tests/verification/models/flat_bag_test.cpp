// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
// The flat driver bag: particles stay inside, books close.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/results/hdf5.hpp"
#include "tests/support/geometry/inside.hpp"
#include "tests/support/runs/model_run.hpp"

using namespace corpuscle;
using corpuscle::test::ModelRun;

namespace {

double last(const ModelRun& run, const std::string& path) {
    return run.history(path).back();
}

/// Facets of the mesh at a frame. All shells of the flat driver bag close it.
std::vector<std::array<Vec3, 3>> facets_at(const io::Hdf5Reader& results,
                                           const std::string& frame) {
    const auto nodes = results.read<std::int64_t>("/mesh/shell_nodes");
    const auto x = results.read<double>(frame + "/coordinates");
    const auto node = [&](std::size_t i) {
        const auto row = static_cast<std::size_t>(3 * nodes[i]);
        return Vec3(x[row], x[row + 1], x[row + 2]);
    };
    std::vector<std::array<Vec3, 3>> facets;
    for (std::size_t i = 0; i < nodes.size(); i += 4) {
        facets.push_back({node(i), node(i + 1), node(i + 2)});
        if (nodes[i + 3] != nodes[i + 2]) facets.push_back({node(i), node(i + 2), node(i + 3)});
    }
    return facets;
}

}  // namespace

TEST_CASE("a surface winds once round what is inside it, and not round the rest", "[oracle]") {
    const Vec3 o(0, 0, 0), a(1, 0, 0), b(0, 1, 0), c(0, 0, 1);
    const std::vector<std::array<Vec3, 3>> tetrahedron{{o, b, a}, {o, a, c}, {o, c, b}, {a, b, c}};
    CHECK(std::abs(oracle::winding_number({0.1, 0.2, 0.3}, tetrahedron)) == Approx(1.0));
    CHECK(oracle::winding_number({0.4, 0.4, 0.4}, tetrahedron) == Approx(0.0).margin(1e-12));
    CHECK(oracle::is_inside({0.2, 0.3, -1e-4}, tetrahedron, 1e-3));
    CHECK_FALSE(oracle::is_inside({0.2, 0.3, -1e-2}, tetrahedron, 1e-3));
}

TEST_CASE("the flat driver bag opens, keeps its particles in and its books closed", "[models]") {
    const ModelRun run("driver_bag_flat", "-D NP=20000 --until 3 -j 1");
    REQUIRE(run.status() == 0);
    CHECK(last(run, "/history/airbag/1/volume") > 4.0 * run.at("/history/airbag/1/volume", 0.0));
    CHECK(std::abs(last(run, "/history/energy/residual")) <
          0.01 * last(run, "/history/energy/inflow"));

    const io::Hdf5Reader results(run.results());
    std::size_t looked_at = 0, outside = 0;
    for (const std::string& name : results.names("/frames")) {
        if (name == "time") continue;
        const auto facets = facets_at(results, "/frames/" + name);
        const auto x = results.read<double>("/frames/" + name + "/particles/position");
        for (std::size_t i = 0; i < x.size(); i += 3) {
            // 1 um of slack: a frame is in single precision
            outside += !oracle::is_inside({x[i], x[i + 1], x[i + 2]}, facets, 1e-3);
            ++looked_at;
        }
    }
    CHECK(looked_at > 1000);
    CHECK(outside == 0);
}
