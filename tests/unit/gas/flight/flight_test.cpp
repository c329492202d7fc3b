// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/flight.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

#include "gas/enclosure/enclosure.hpp"
#include "gas/flight/crossing.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

std::vector<int> ids(std::size_t n) {
    std::vector<int> id(n);
    std::iota(id.begin(), id.end(), 1);
    return id;
}

/// Particles at rest positions inside `enclosure`, thermal speeds about 300 m/s.
Particles fill(const Enclosure& enclosure, const Points& x, double reach, std::size_t count) {
    Particles gas;
    Random draw(7, Stream::INITIAL, 0, 0);
    while (gas.size() < count) {
        const Vec3 at =
            reach * Vec3(2 * draw.uniform() - 1, 2 * draw.uniform() - 1, 2 * draw.uniform() - 1);
        if (!enclosure.contains(at, x)) continue;
        gas.add(at, 300.0 * Vec3(draw.normal(), draw.normal(), draw.normal()), 0.0, 0,
                static_cast<int>(gas.size()));
    }
    return gas;
}

FacetLists lists_for(const shapes::Shape& shape, const Points& x_0, const Points& x_1, double edge,
                     double reach = 0.0) {
    FacetLists lists(shape.triangles, shape.x, FacetLists::Of::EIGHTS);
    lists.build(Grid::over(Vec3::Constant(-0.3), Vec3::Constant(0.3), edge, 1000000), x_0, x_1, 0.0,
                reach);
    return lists;
}

struct Total {
    Vec3 impulse = Vec3::Zero();
    double energy = 0.0;
    std::size_t hits = 0;
};
Total total(const FlightResult& flight) {
    Total sum;
    for (const auto& chunk : flight.hits)
        for (const Hit& hit : chunk) {
            sum.impulse += hit.impulse;
            sum.energy += hit.energy;
            ++sum.hits;
        }
    return sum;
}

double kinetic(const Particles& gas) {
    double sum = 0.0;
    for (const Vec3& v : gas.v) sum += 0.5 * v.squaredNorm();
    return sum;
}

}  // namespace

TEST_CASE("a head-on hit on a moving wall reverses the relative velocity", "[gas][flight]") {
    // One triangle at z = 0.1 that rises at 20 m/s; a particle below it rises at 120 m/s.
    const double dt = 1e-3, wall = 20.0;
    const shapes::Shape shape{{{-1, -1, 0.1}, {1, -1, 0.1}, {0, 2, 0.1}}, {{0, 1, 2}}};
    Points x_1 = shape.x;
    for (Vec3& x : x_1) x.z() += wall * dt;
    const FacetLists lists = lists_for(shape, shape.x, x_1, 0.1);
    Particles gas;
    gas.add({0, 0, 0.09}, {5, 0, 120}, 0.0, 0, 0);
    FlightResult flight;
    const std::vector<double> mass{2.0};
    fly(lists, shape.x, x_1, dt, mass, {}, gas, flight);

    REQUIRE(total(flight).hits == 1);
    CHECK(gas.v[0].x() == Approx(5.0));
    CHECK(gas.v[0].z() == Approx(2 * wall - 120.0));
    // met after 0.01 m / 100 m/s = 1e-4 s at z = 0.102
    CHECK(gas.x[0].z() == Approx(0.102 - 80.0 * 0.9e-3).epsilon(1e-5));
    CHECK(gas.x[0].x() == Approx(5e-3));
    CHECK(total(flight).impulse.z() == Approx(2.0 * (120.0 - (2 * wall - 120.0))));
    CHECK(total(flight).energy == Approx(total(flight).impulse.z() * wall));
}

TEST_CASE("rough fabric takes its share of the velocity along it, and turns it into heat",
          "[gas][flight]") {
    const double dt = 1e-3, wall = 20.0, f = 0.3;
    const shapes::Shape shape{{{-1, -1, 0.1}, {1, -1, 0.1}, {0, 2, 0.1}}, {{0, 1, 2}}};
    Points x_1 = shape.x;
    for (Vec3& x : x_1) x += dt * Vec3(10, 0, wall);
    const FacetLists lists = lists_for(shape, shape.x, x_1, 0.1);
    const bool pushes_along = GENERATE(true, false);
    Particles gas;
    gas.add({0, 0, 0.09}, {60, 0, 120}, 7.0, 0, 0);
    FlightResult flight;
    fly(lists, shape.x, x_1, dt, std::vector<double>{2.0}, {}, gas, flight, nullptr,
        {f, pushes_along});
    CHECK(gas.v[0].x() == Approx(10.0 + (1.0 - f) * 50.0));
    CHECK(gas.v[0].z() == Approx(2 * wall - 120.0));
    CHECK(total(flight).impulse.x() == Approx(pushes_along ? 2.0 * f * 50.0 : 0.0).margin(1e-9));
    CHECK(total(flight).energy == Approx(total(flight).impulse.dot(Vec3(10, 0, wall))));
    const double before = 0.5 * 2.0 * Vec3(60, 0, 120).squaredNorm() + 7.0;
    CHECK(0.5 * 2.0 * gas.v[0].squaredNorm() + gas.e[0] + total(flight).energy == Approx(before));
}

TEST_CASE("friction below zero bends the path towards the fabric and keeps its speed",
          "[gas][flight]") {
    const double dt = 1e-3, f = -0.4;
    const Vec3 wall(10, 0, 20);
    const shapes::Shape shape{{{-1, -1, 0.1}, {1, -1, 0.1}, {0, 2, 0.1}}, {{0, 1, 2}}};
    Points x_1 = shape.x;
    for (Vec3& x : x_1) x += dt * wall;
    const FacetLists lists = lists_for(shape, shape.x, x_1, 0.1);
    const bool pushes_along = GENERATE(true, false);
    Particles gas;
    gas.add({0, 0, 0.09}, {60, 0, 120}, 7.0, 0, 0);
    FlightResult flight;
    fly(lists, shape.x, x_1, dt, std::vector<double>{2.0}, {}, gas, flight, nullptr,
        {f, pushes_along});
    const Vec3 before(50, 0, 100), after = gas.v[0] - wall;
    CHECK(after.norm() == Approx(before.norm()));
    const double theta = std::atan2(50.0, 100.0);
    CHECK(std::atan2(after.x(), -after.z()) == Approx(theta + 0.4 * (M_PI / 2.0 - theta)));
    CHECK((total(flight).impulse.x() == 0.0) != pushes_along);
    CHECK(total(flight).energy == Approx(total(flight).impulse.dot(wall)));
    const double energy = 0.5 * 2.0 * Vec3(60, 0, 120).squaredNorm() + 7.0;
    CHECK(0.5 * 2.0 * gas.v[0].squaredNorm() + gas.e[0] + total(flight).energy == Approx(energy));
}

TEST_CASE("a membrane's two sides are rough each in its own way", "[gas][flight]") {
    const double dt = 1e-3;
    const shapes::Shape shape{{{-1, -1, 0.1}, {1, -1, 0.1}, {0, 2, 0.1}}, {{0, 1, 2}}};
    const FacetLists lists = lists_for(shape, shape.x, shape.x, 0.1);
    Particles gas;
    gas.add({0, 0, 0.09}, {60, 0, 120}, 0.0, 0, 0);
    gas.add({0, 0, 0.11}, {60, 0, -120}, 0.0, 0, 1);
    FlightResult flight;
    const std::vector<double> of_side{0.2, 0.7};  // back, front
    fly(lists, shape.x, shape.x, dt, std::vector<double>{2.0}, {}, gas, flight, nullptr,
        {0.0, true, of_side});
    CHECK(gas.v[0].x() == Approx(0.8 * 60.0));
    CHECK(gas.v[1].x() == Approx(0.3 * 60.0));
}

TEST_CASE("no particle leaves a closed surface that shakes violently", "[gas][flight]") {
    const int levels = GENERATE(0, 2, 3);
    const double friction = GENERATE(0.0, 0.9, -0.9);
    shapes::Shape shape = shapes::sphere(0.1, levels);
    Enclosure enclosure(shape.triangles, shape.x, ids(shape.x.size()), "bag 1");
    Particles gas = fill(enclosure, shape.x, 0.1, 400);
    const Points home = shape.x;
    Points x_0 = shape.x, x_1 = shape.x;
    const std::vector<double> mass{1.0};
    FlightResult flight;
    std::size_t hits = 0;
    const auto energy = [&] {
        return kinetic(gas) + std::accumulate(gas.e.begin(), gas.e.end(), 0.0);
    };
    for (int step = 0; step < 150; ++step) {
        // Nodes jump at random by up to 8 % of the radius a step: facets turn, stretch, nearly
        // invert.
        for (std::size_t n = 0; n < home.size(); ++n) {
            Random draw(3, Stream::WALL, static_cast<std::uint64_t>(step), n);
            x_1[n] = home[n] * (0.9 + 0.15 * draw.uniform()) + 0.004 * draw.direction();
        }
        const FacetLists lists = lists_for(shape, x_0, x_1, 0.05);
        const double before = energy();
        fly(lists, x_0, x_1, 2e-5, mass, {}, gas, flight, nullptr, {friction});
        REQUIRE(flight.lost.empty());
        for (const Vec3& x : gas.x) REQUIRE(enclosure.contains(x, x_1));
        CHECK(before - energy() == Approx(total(flight).energy).epsilon(1e-9).margin(1e-6));
        hits += total(flight).hits;
        x_0 = x_1;
    }
    CHECK(hits > 3000);
}

TEST_CASE("momentum given to the walls is momentum lost by the gas", "[gas][flight]") {
    const shapes::Shape shape = shapes::sphere(0.1, 2);
    Enclosure enclosure(shape.triangles, shape.x, ids(shape.x.size()), "bag 1");
    Particles gas = fill(enclosure, shape.x, 0.1, 1000);
    Points x_1 = shape.x;
    for (Vec3& x : x_1) x *= 0.99;
    Vec3 before = Vec3::Zero(), after = Vec3::Zero();
    for (const Vec3& v : gas.v) before += v;
    FlightResult flight;
    fly(lists_for(shape, shape.x, x_1, 0.02), shape.x, x_1, 1e-4, std::vector<double>{1.0}, {}, gas,
        flight);
    for (const Vec3& v : gas.v) after += v;
    CHECK((before - after - total(flight).impulse).norm() < 1e-9 * before.norm());
}

TEST_CASE("cells of any size find the same hits, on any number of threads", "[gas][flight]") {
    const shapes::Shape shape = shapes::sphere(0.1, 3);
    Enclosure enclosure(shape.triangles, shape.x, ids(shape.x.size()), "bag 1");
    const Particles start = fill(enclosure, shape.x, 0.1, 3000);
    Points x_1 = shape.x;
    for (Vec3& x : x_1) x += Vec3(0.002, -0.001, 0.003 * x.x());

    const auto flown = [&](double edge, double reach, int threads) {
        parallel::set_threads(threads);
        Particles gas = start;
        FlightResult flight;
        fly(lists_for(shape, shape.x, x_1, edge, reach), shape.x, x_1, 1e-4,
            std::vector<double>{1.0}, {}, gas, flight);
        return gas;
    };
    const Particles one = flown(0.02, 0.0, 1);
    for (const auto& [edge, reach, threads] : {std::tuple{0.02, 0.0, 2},
                                               {0.02, 0.01, 1},
                                               {0.005, 0.03, 2},
                                               {0.005, 0.0, 1},
                                               {0.3, 0.0, 2}}) {
        const Particles other = flown(edge, reach, threads);
        CHECK(one.x == other.x);
        CHECK(one.v == other.v);
    }
    parallel::set_threads(2);
}

TEST_CASE("a path through an edge or a corner meets the surface once", "[gas][flight]") {
    const shapes::Shape shape = shapes::box(Vec3(1, 1, 1), 2);
    // Outward from the centre exactly through nodes, edge middles and facet diagonals, walls at
    // rest.
    const Vec3 centre(0.5, 0.5, 0.5);
    for (const Vec3& target : shape.x)
        for (const Vec3& other : shape.x) {
            const Vec3 through = 0.5 * (target + other);
            if ((through - centre).cwiseAbs().maxCoeff() < 0.5) continue;  // not on the surface
            const Path path{centre + Vec3(1e-3, 2e-3, -1e-3), 2.0 * through - centre};
            int crossings = 0;
            for (const Triangle& triangle : shape.triangles)
                crossings += cross(path, triangle, shape.x.data(), shape.x.data()).has_value();
            CHECK(crossings == 1);
        }
}

TEST_CASE("a particle that is born within a step flies for the rest of it", "[gas][flight]") {
    const shapes::Shape shape = shapes::sphere(0.1, 2);
    const FacetLists lists = lists_for(shape, shape.x, shape.x, 0.05);
    Particles gas;
    gas.add({0, 0, 0}, {100, 0, 0}, 0.0, 0, 0);
    gas.add({0, 0, 0.01}, {100, 0, 0}, 0.0, 0, 1);
    FlightResult flight;
    fly(lists, shape.x, shape.x, 1e-4, std::vector<double>{1.0}, std::vector<double>{0.25}, gas,
        flight);
    CHECK(gas.x[0].x() == Approx(0.01));
    CHECK(gas.x[1].x() == Approx(0.0075));
}

TEST_CASE("an enclosure knows its volume, mends its normals and finds its holes",
          "[gas][enclosure]") {
    shapes::Shape shape = shapes::box(Vec3(1, 2, 3), 3);
    for (std::size_t t = 0; t < shape.triangles.size(); t += 3)
        std::swap(shape.triangles[t][0], shape.triangles[t][1]);
    const auto id = ids(shape.x.size());
    Enclosure bag(shape.triangles, shape.x, id, "bag 1");
    CHECK(bag.volume(shape.x) == Approx(6.0));
    CHECK(bag.area(shape.x) == Approx(22.0));
    CHECK(bag.turned() == shape.triangles.size() / 3);
    CHECK(bag.contains({0.5, 1.0, 2.9}, shape.x));
    CHECK_FALSE(bag.contains({0.5, 1.0, 3.1}, shape.x));

    // node areas are the gradient of the volume
    Points area(shape.x.size(), Vec3::Zero());
    bag.node_areas(shape.x, area);
    const double step = 1e-6;
    for (const std::size_t n : {std::size_t{0}, std::size_t{7}, std::size_t{20}})
        for (int axis = 0; axis < 3; ++axis) {
            Points up = shape.x, down = shape.x;
            up[n][axis] += step;
            down[n][axis] -= step;
            CHECK(area[n][axis] ==
                  Approx((bag.volume(up) - bag.volume(down)) / (2 * step)).margin(1e-8));
        }

    shape.triangles.pop_back();
    CHECK_THROWS_WITH(Enclosure(shape.triangles, shape.x, id, "bag 1"),
                      Catch::Contains("not closed"));
}
