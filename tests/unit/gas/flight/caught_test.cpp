// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Particles that bounce more than a thousand times in a step.
#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

#include "gas/enclosure/enclosure.hpp"
#include "gas/flight/flight.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

FacetLists cells_over(const shapes::Shape& shape, const Points& x_1) {
    FacetLists lists(shape.triangles, shape.x, FacetLists::Of::EIGHTS);
    lists.build(Grid::over(Vec3::Constant(-0.3), Vec3::Constant(0.3), 0.02, 1000000), shape.x, x_1,
                0.0);
    return lists;
}

std::vector<Hit> all_hits(const FlightResult& flight) {
    std::vector<Hit> all;
    for (const auto& chunk : flight.hits) all.insert(all.end(), chunk.begin(), chunk.end());
    return all;
}

}  // namespace

TEST_CASE("a particle in a gap of a tenth of a micrometre stays in it", "[gas][flight]") {
    const shapes::Shape shape = shapes::box(Vec3(0.1, 0.1, 1e-7), 4);
    std::vector<int> id(shape.x.size());
    std::iota(id.begin(), id.end(), 1);
    Enclosure enclosure(shape.triangles, shape.x, id, "bag 1");
    Points x_1 = shape.x;
    for (Vec3& x : x_1) x += Vec3(1e-4, 0, 2e-4);
    Particles gas;
    gas.add({0.03, 0.04, 4e-8}, {10, 20, 200}, 5.0, 0, 0);
    const double before = 0.5 * gas.v[0].squaredNorm();
    FlightResult flight;
    fly(cells_over(shape, x_1), shape.x, x_1, 1e-4, std::vector<double>{1.0}, {}, gas, flight);
    CHECK(flight.lost.empty());
    CHECK(enclosure.contains(gas.x[0], x_1));
    double given = 0.0;
    for (const Hit& hit : all_hits(flight)) given += hit.energy;
    CHECK(0.5 * gas.v[0].squaredNorm() == Approx(before - given).epsilon(1e-9));
    CHECK(all_hits(flight).size() > 100000);
}

TEST_CASE("a particle that bounces millions of times in a step is lost, others are not",
          "[gas][flight]") {
    shapes::Shape shape = shapes::box(Vec3(0.1, 0.1, 1e-8), 1);
    const shapes::Shape wide = shapes::box(Vec3(0.1, 0.1, 1e-6), 1);
    const auto first = static_cast<Index>(shape.x.size());
    for (const Vec3& x : wide.x) shape.x.push_back(x + Vec3(0, 0, 0.1));
    for (const auto& [a, b, c] : wide.triangles)
        shape.triangles.push_back({a + first, b + first, c + first});
    Particles gas;
    for (const double z : {0.1 + 4e-7, 4e-9, 0.1 + 6e-7})
        gas.add({0.03, 0.04, z}, {10, 20, 200}, 0.0, 0, static_cast<int>(gas.size()));
    FlightResult flight;
    fly(cells_over(shape, shape.x), shape.x, shape.x, 1e-4, std::vector<double>{1.0}, {}, gas,
        flight);
    REQUIRE(flight.lost.size() == 1);
    CHECK(flight.lost[0].particle == 1);
    CHECK(gas.x[1] == Vec3(0.03, 0.04, 4e-9));
    for (const std::size_t i : {0, 2}) CHECK(gas.x[i].x() == Approx(0.03 + 10 * 1e-4));
    const std::vector<Hit> hits = all_hits(flight);
    CHECK(hits.size() > 35000);  // 20 000 of each other one, in the order of their rows
    CHECK(hits.size() < 45000);
    std::vector<Index> who;
    for (const Hit& hit : hits)
        if (who.empty() || who.back() != hit.who) who.push_back(hit.who);
    CHECK(who == std::vector<Index>{0, 2});
}

TEST_CASE("a particle that flies many times the bag's size in a step meets every wall on its way",
          "[gas][flight]") {
    const shapes::Shape shape = shapes::box(Vec3(0.1, 0.1, 0.1), 8);
    FacetLists lists(shape.triangles, shape.x, FacetLists::Of::EIGHTS);
    lists.build(Grid::over(Vec3::Constant(-0.01), Vec3::Constant(0.11), 1e-3, 10000000), shape.x,
                shape.x, 0.0);
    const Vec3 start(0.03, 0.04, 0.05);
    const Vec3 way(3.72, -1.31, 4.17);
    Particles gas;
    gas.add(start, way / 1e-6, 0.0, 0, 0);
    FlightResult flight;
    std::size_t looked_at = 0;
    (void)lists.any_slab(start, start + way, [&](const auto&, double, double) {
        ++looked_at;
        return false;
    });
    CHECK(looked_at < 20000);  // of 1.7 million cells those on the way
    fly(lists, shape.x, shape.x, 1e-6, std::vector<double>{1.0}, {}, gas, flight);
    for (int a = 0; a < 3; ++a) {
        const double period = std::fmod(std::fmod(start[a] + way[a], 0.2) + 0.2, 0.2);
        CHECK(gas.x[0][a] == Approx(period < 0.1 ? period : 0.2 - period).margin(1e-4));
    }
    CHECK(gas.v[0].norm() == Approx(way.norm() / 1e-6));
    CHECK(all_hits(flight).size() == 37 + 13 + 42);
}
