// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Nothing leaks: millions of hits (a thousand millions on request) in a pleated bag that shakes.

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>

#include "gas/enclosure/enclosure.hpp"
#include "gas/flight/flight.hpp"
#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// In a step particles fly 50 mm, nearly the width of a pleat, and the walls up to 20 mm: one hit
/// in two steps and particle.
constexpr double RADIUS = 0.2, SHAKE_STEP = 1e-4, SHAKE_SPEED = 500.0;

/// A ball of 8 192 facets with twelve pleats that open and close, and nodes that jitter. Each ray
/// from the centre meets it once, so the facets never cross each other.
class PleatedBall {
public:
    PleatedBall() {
        for (Vec3& x : shape_.x) x /= RADIUS;
    }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return shape_.triangles; }

    [[nodiscard]] Points at(std::uint64_t step) const {
        const double beat = std::sin(0.9 * static_cast<double>(step)),
                     turn = 0.02 * static_cast<double>(step);
        Points x(shape_.x.size());
        for (std::size_t n = 0; n < x.size(); ++n) {
            const Vec3& u = shape_.x[n];
            const double pleat =
                std::cos(12.0 * std::atan2(u.y(), u.x()) + turn) * std::hypot(u.x(), u.y());
            const double jitter = Random(5, Stream::WALL, step, n).uniform() - 0.5;
            x[n] = RADIUS * (0.6 + (0.25 + 0.1 * beat) * pleat + 0.01 * jitter) * u;
        }
        return x;
    }

private:
    shapes::Shape shape_ = shapes::sphere(RADIUS, 5);
};

struct Flown {
    std::size_t hits = 0, lost = 0, outside = 0;
};

/// Flies until there have been so many hits. Speeds are kept: the walls would heat the gas for
/// ever.
Flown fly_in_pleats(int particles, std::size_t hits_wanted, std::uint64_t seed = 1) {
    const PleatedBall ball;
    Points x_0 = ball.at(0), x_1;
    Particles gas;
    for (int i = 0; i < particles; ++i) {
        Random draw(seed, Stream::INITIAL, 0, static_cast<std::uint64_t>(i));
        gas.add(0.2 * RADIUS * draw.uniform() * draw.direction(), SHAKE_SPEED * draw.direction(),
                0.0, 0, i);
    }
    FacetLists lists(ball.triangles(), x_0, FacetLists::Of::EIGHTS);
    const Grid grid = Grid::over(Vec3::Constant(-RADIUS), Vec3::Constant(RADIUS), 0.01, 1000000);
    const std::vector<double> mass{1.0};
    FlightResult flight;
    Flown flown;
    for (std::uint64_t step = 1; flown.hits < hits_wanted; ++step) {
        x_1 = ball.at(step);
        lists.build(grid, x_0, x_1, 0.0);
        fly(lists, x_0, x_1, SHAKE_STEP, mass, {}, gas, flight);
        flown.lost += flight.lost.size();
        for (const auto& some : flight.hits) flown.hits += some.size();
        for (Vec3& v : gas.v) v *= SHAKE_SPEED / v.norm();
        x_0.swap(x_1);
    }
    std::vector<int> id(x_0.size());
    std::iota(id.begin(), id.end(), 1);
    const Enclosure bag(ball.triangles(), x_0, id, "bag 1");
    // Who leaks flies away; and a sample is looked at closely.
    for (const Vec3& x : gas.x) flown.outside += x.norm() > RADIUS;
    for (std::size_t i = 0; i < 1000; ++i) flown.outside += !bag.contains(gas.x[i], x_0);
    return flown;
}

}  // namespace

TEST_CASE("two million hits in shaking pleats, and every particle is still inside", "[gas]") {
    const Flown flown = fly_in_pleats(50'000, 2'000'000);
    CHECK(flown.lost == 0);
    CHECK(flown.outside == 0);
}

TEST_CASE("a thousand million hits in shaking pleats, and every particle is still inside",
          "[.billion]") {
    // In pieces: CORPUSCLE_HITS says how many, CORPUSCLE_SEED draws other particles.
    const auto asked = [](const char* name, std::uint64_t otherwise) {
        const char* text = std::getenv(name);
        return text != nullptr ? std::stoull(text) : otherwise;
    };
    const std::uint64_t hits = asked("CORPUSCLE_HITS", 1'000'000'000);
    const Flown flown =
        fly_in_pleats(hits < 100'000'000 ? 50'000 : 1'000'000, hits, asked("CORPUSCLE_SEED", 1));
    WARN(flown.hits << " hits, " << flown.lost << " lost, " << flown.outside << " outside");
    CHECK(flown.lost == 0);
    CHECK(flown.outside == 0);
}
