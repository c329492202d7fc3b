// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// A front that runs along a wall: smoothing brings its load ahead of it, and a moment with it, which
// is made good at the front and nowhere else.

#include <catch2/catch.hpp>

#include <memory>

#include "gas/wall_load/rigid_field.hpp"
#include "gas/wall_load/wall_load.hpp"
#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double TIME = 50e-6, STEP = 5e-6;  ///< [s]
constexpr double LOW = 1.0, HIGH = 3.0;      ///< pressure ahead of the front, behind it   [Pa]
constexpr double FRONT_FROM = 0.2,
                 FRONT_SPEED = 1000.0;  ///< where it starts [m], its speed         [m/s]
constexpr int CELLS = 20, FRONT_STEPS = 60;

/// A cube whose lid alone is free; all of it is hit in the middle of each facet.
class Lid {
public:
    Lid() : held_(shape_.x.size(), 1), mass_(shape_.x.size(), 1.0), v_(held_.size(), Vec3::Zero()) {
        for (std::size_t n = 0; n < held_.size(); ++n)
            if (is_free(shape_.x[n])) held_[n] = 0;
        surface_ =
            std::make_shared<WettedSurface>(shape_.triangles, shape_.triangles.size(), shape_.x);
        load_ = std::make_unique<WallLoad>(surface_, held_, std::span<const Index>{},
                                           LoadTimes{TIME, TIME}, 0.0);
        impulse_.assign(held_.size(), Vec3::Zero());
        particle_.add(Vec3::Zero(), Vec3::Zero(), 0.0, 0, 0);
        load_->begin_with(LOW, 0.01, shape_.x);
    }
    void step(double front) {
        FlightResult flight;
        flight.hits.resize(1);
        for (std::size_t f = 0; f < shape_.triangles.size(); ++f) {
            const auto& [a, b, c] = shape_.triangles[f];
            const Vec3 middle = (shape_.x[a] + shape_.x[b] + shape_.x[c]) / 3.0;
            const double p = middle.x() < front ? HIGH : LOW;
            flight.hits[0].push_back({static_cast<Index>(f),
                                      0,
                                      {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0},
                                      p * STEP * vector_area(shape_.x[a], shape_.x[b], shape_.x[c]),
                                      0.0,
                                      middle});
        }
        load_->find_sides(flight, shape_.x, shape_.x);
        load_->receive(flight, particle_mass_, particle_);
        Points f(held_.size(), Vec3::Zero());
        load_->release(STEP, shape_.x, v_, mass_, f);
        for (std::size_t n = 0; n < f.size(); ++n) impulse_[n] += STEP * f[n];
    }
    /// Mean of what free nodes from x = low to high got more than LOW, by area.           [Pa s]
    [[nodiscard]] double mean(double low, double high, double lasted) const {
        double sum = 0.0, area = 0.0;
        for (std::size_t p = 0; p < surface_->points(); ++p) {
            const auto n = static_cast<std::size_t>(surface_->node(p));
            if (held_[n] != 0 || shape_.x[n].x() < low || shape_.x[n].x() > high) continue;
            sum += impulse_[n].z();
            area += load_->area()[p].z();
        }
        return sum / area - LOW * lasted;
    }

private:
    static bool is_free(const Vec3& x) {
        constexpr double EDGE = 1e-9;
        return x.z() > 1.0 - EDGE && x.x() > EDGE && x.x() < 1.0 - EDGE && x.y() > EDGE &&
               x.y() < 1.0 - EDGE;
    }

    shapes::Shape shape_ = shapes::box(Vec3::Ones(), CELLS);
    std::vector<std::uint8_t> held_;
    std::vector<double> mass_, particle_mass_{1e-9};
    Points v_, impulse_;
    std::shared_ptr<const WettedSurface> surface_;
    std::unique_ptr<WallLoad> load_;
    Particles particle_;
};

}  // namespace

TEST_CASE("a front's load is felt at the front, not ahead of it", "[gas]") {
    Lid lid;
    for (int s = 0; s < FRONT_STEPS; ++s) lid.step(FRONT_FROM + FRONT_SPEED * STEP * s);
    const double lasted = FRONT_STEPS * STEP, end = FRONT_FROM + FRONT_SPEED * lasted;
    const double behind = lid.mean(0.0, FRONT_FROM, lasted);
    CHECK(behind == Approx((HIGH - LOW) * (lasted - TIME)).epsilon(0.02));
    for (const double ahead : {0.2, 0.3, 0.4})
        CHECK(std::abs(lid.mean(end + ahead, end + ahead + 0.1, lasted)) < 0.01 * behind);
}

TEST_CASE("a rigid field has the force and the moment that are wanted", "[gas]") {
    Random draw(4, Stream::WALL, 0, 0);
    const auto random = [&] { return Vec3(draw.uniform(), draw.uniform(), draw.uniform()); };
    for (const double scale : {1e-60, 1.0, 1e60}) {
        Lever lever;
        std::vector<std::pair<double, Vec3>> points;
        const Vec3 origin = random();
        for (int i = 0; i < 20; ++i) {
            points.emplace_back(scale * draw.uniform(), random());
            lever.add(points.back().first, points.back().second - origin);
        }
        const Wrench wanted{random(), random()};
        const RigidField field(lever, origin, wanted);
        Wrench given;
        for (const auto& [weight, at] : points) given.add(at, weight * field.at(at));
        CHECK((given.linear - wanted.linear).norm() < 1e-12);
        CHECK((given.angular - wanted.angular).norm() < 1e-12);
        CHECK((field.whole().angular - wanted.angular).norm() < 1e-12);
    }
    Lever line;
    for (int i = 0; i < 5; ++i) line.add(1.0, i * Vec3(1.0, 2.0, 3.0));
    const RigidField field(line, Vec3::Zero(), {Vec3::UnitX(), Vec3::UnitZ()});
    CHECK((field.at(Vec3::Zero()) - 0.2 * Vec3::UnitX()).norm() < 1e-15);
}
