// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "gas/flight/clearance.hpp"
#include "gas/flight/crossing.hpp"
#include "gas/flight/safe_distances.hpp"
#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double REACH = 0.03;

/// A crumpled box of half a metre about the origin.
shapes::Shape crumpled() {
    shapes::Shape shape = shapes::box(Vec3(0.5, 0.5, 0.5), 12);
    Random draw(3, Stream::INITIAL, 0, 0);
    for (Vec3& x : shape.x)
        x += 0.02 * Vec3(draw.uniform(), draw.uniform(), draw.uniform()) - Vec3::Constant(0.26);
    return shape;
}

FacetLists lists_of(const shapes::Shape& shape) {
    FacetLists lists(shape.triangles, shape.x, FacetLists::Of::EIGHTS);
    lists.build(Grid::over(Vec3::Constant(-0.4), Vec3::Constant(0.4), 0.04, 100000), shape.x,
                shape.x, 0.005, REACH);
    return lists;
}

Vec3 anywhere(Random& draw, double reach) {
    return reach * (2.0 * Vec3(draw.uniform(), draw.uniform(), draw.uniform()) - Vec3::Ones());
}

/// Points of all facets, a few hundred each.
Points cover(const shapes::Shape& shape) {
    constexpr int PARTS = 20;
    Points points;
    for (const auto& [a, b, c] : shape.triangles)
        for (int i = 0; i <= PARTS; ++i)
            for (int j = 0; i + j <= PARTS; ++j)
                points.push_back((i * shape.x[a] + j * shape.x[b] + (PARTS - i - j) * shape.x[c]) /
                                 PARTS);
    return points;
}

}  // namespace

TEST_CASE("the free way at a point is never longer than that to the nearest facet", "[gas]") {
    const shapes::Shape shape = crumpled();
    const FacetLists lists = lists_of(shape);
    const Points cloth = cover(shape);
    Random draw(1, Stream::INITIAL, 0, 0);
    double told = 0.0, there_is = 0.0;
    for (int i = 0; i < 400; ++i) {
        const Vec3 at = anywhere(draw, 0.3);
        double nearest = INF;
        for (const Vec3& x : cloth) nearest = std::min(nearest, (x - at).cwiseAbs().maxCoeff());
        CHECK(lists.clearance().at(at) <= nearest);
        told += std::max(0.0F, lists.clearance().at(at));
        there_is += nearest;
    }
    CHECK(told > 0.5 * there_is);  // and of some use
}

TEST_CASE("who streams meets no facet, however facets move and lists are renewed", "[gas]") {
    shapes::Shape shape = crumpled();
    const Points rest = shape.x;
    FacetLists lists = lists_of(shape);
    Particles gas;
    Random draw(2, Stream::INITIAL, 0, 0);
    for (int i = 0; i < 300; ++i) gas.add(anywhere(draw, 0.2), anywhere(draw, 500.0), 0.0, 0, i);
    SafeDistances safe;
    constexpr double STEP = 1e-5;
    std::size_t streamed = 0, asked = 0;
    for (int step = 0; step < 60; ++step) {
        const Points x_0 = shape.x;
        const Vec3 shift = 0.01 * std::sin(0.2 * (step + 1)) * Vec3(1, 0.5, -1);
        for (std::size_t n = 0; n < rest.size(); ++n) shape.x[n] = rest[n] + shift;
        if (!lists.hold_for(shape.x)) lists.build(lists.grid(), x_0, shape.x, 0.005, REACH);
        safe.begin_flight(lists, x_0, shape.x, gas);
        for (std::size_t begin = 0; begin < gas.size(); begin += SafeDistances::BLOCK) {
            const std::size_t count = std::min(gas.size() - begin, SafeDistances::BLOCK);
            const std::uint32_t unclear = safe.ask(lists, begin, count, STEP, gas);
            for (std::size_t k = 0; k < count; ++k) {
                ++asked;
                Vec3 &x = gas.x[begin + k], &v = gas.v[begin + k];
                if ((unclear >> k & 1U) != 0) {
                    v = -x.normalized() * v.norm();  // inward, without asking where
                    x *= 0.9;
                    gas.safe_distance[begin + k] = 0.0F;
                    continue;
                }
                ++streamed;
                const Path path{x, x + STEP * v};
                x = path.at_1;
                for (const Triangle& t : shape.triangles)
                    if (cross(path, t, x_0.data(), shape.x.data())) FAIL("a facet in the way");
            }
        }
    }
    CHECK(streamed > asked / 2);
}
