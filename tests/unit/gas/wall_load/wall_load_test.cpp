// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What hits bring reaches the fabric: all of it, promptly, quietly, and where it came.

#include "gas/wall_load/wall_load.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double LOAD_TIME = 50e-6, LOAD_STEP = 5e-6;

/// Nodes' impulse released exponentially, each for itself: plain smoothing.
class PlainSmoothing {
public:
    explicit PlainSmoothing(std::size_t nodes) : owed_(nodes, Vec3::Zero()) {}
    void receive(const FlightResult& flight, std::span<const Triangle> triangles) {
        for (const Hit& hit : flight.hits[0])
            for (int c = 0; c < 3; ++c) owed_[triangles[hit.facet][c]] += hit.at[c] * hit.impulse;
    }
    void release(Points& f) {
        for (std::size_t n = 0; n < f.size(); ++n) {
            const Vec3 given = -std::expm1(-LOAD_STEP / LOAD_TIME) * owed_[n];
            owed_[n] -= given;
            f[n] += given / LOAD_STEP;
        }
    }

private:
    Points owed_;
};

/// A closed surface whose facets are hit at random, each equally often, with an impulse that is
/// exponential in size (as m v_n² is): one hit a facet and `LOAD_TIME` at `pressure` 1.
class HitSurface {
public:
    explicit HitSurface(bool is_plain, double mass = 1.0)
        : surface_(
              std::make_shared<WettedSurface>(shape_.triangles, shape_.triangles.size(), shape_.x)),
          held_(shape_.x.size(), 0),
          load_(surface_, held_, {}, {LOAD_TIME, LOAD_TIME}, 0.0),
          plain_(shape_.x.size()),
          is_plain_(is_plain),
          area_(surface_->points(), Vec3::Zero()),
          v_(shape_.x.size(), Vec3::Zero()),
          mass_(shape_.x.size(), mass) {
        Points of_point(surface_->points());
        surface_->point_areas(shape_.x, of_point);
        for (std::size_t p = 0; p < of_point.size(); ++p) area_[surface_->node(p)] = of_point[p];
        flight_.hits.resize(1);
        particle_.add(Vec3::Zero(), Vec3::Zero(), 0.0, 0, 0);
    }
    struct Facets {
        double mean = 0.0, scatter = 0.0;
    };
    Facets step(double pressure, double until = INF) {
        flight_.hits[0].clear();
        for (std::size_t f = 0; f < shape_.triangles.size(); ++f) {
            const auto& [a, b, c] = shape_.triangles[f];
            if (shape_.x[a][0] > until) continue;
            Random draw(9, Stream::WALL, step_, f);
            for (double t = -std::log(draw.uniform()); t < pressure * LOAD_STEP / LOAD_TIME;
                 t -= std::log(draw.uniform())) {
                const double u = draw.uniform(), v = draw.uniform(), root = std::sqrt(u);
                const Vec3 impulse = -std::log(draw.uniform()) * LOAD_TIME *
                                     vector_area(shape_.x[a], shape_.x[b], shape_.x[c]);
                flight_.hits[0].push_back({static_cast<Index>(f),
                                           0,
                                           {1 - root, root * (1 - v), root * v},
                                           impulse,
                                           0.0,
                                           hit_place(f, root, v)});
                brought_.add(hit_place(f, root, v), impulse);
            }
        }
        ++step_;
        Points f(shape_.x.size(), Vec3::Zero());
        if (is_plain_) {
            plain_.receive(flight_, shape_.triangles);
            plain_.release(f);
        } else {
            load_.find_sides(flight_, shape_.x, shape_.x);
            load_.receive(flight_, particle_mass_, particle_);
            load_.release(LOAD_STEP, shape_.x, v_, mass_, f);
        }
        Facets out;
        for (const Triangle& t : shape_.triangles) {
            double on = 0.0;
            for (const Index n : t) on += f[n].dot(area_[n]) / area_[n].squaredNorm() / 3.0;
            out.mean += on / static_cast<double>(shape_.triangles.size());
            out.scatter +=
                (on - pressure) * (on - pressure) / static_cast<double>(shape_.triangles.size());
        }
        for (std::size_t n = 0; n < f.size(); ++n) {
            given_.add(shape_.x[n], LOAD_STEP * f[n]);
            outward_ += LOAD_STEP * f[n].dot(area_[n].normalized());
        }
        out.scatter = std::sqrt(out.scatter);
        return out;
    }

    [[nodiscard]] double outward() const { return outward_; }
    [[nodiscard]] Wrench brought() const { return brought_; }
    [[nodiscard]] Wrench given() const { return given_; }
    [[nodiscard]] const WallLoad& load() const { return load_; }
    [[nodiscard]] const shapes::Shape& shape() const { return shape_; }

private:
    [[nodiscard]] Vec3 hit_place(std::size_t f, double root, double v) const {
        const auto& [a, b, c] = shape_.triangles[f];
        return (1 - root) * shape_.x[a] + root * (1 - v) * shape_.x[b] + root * v * shape_.x[c];
    }

    shapes::Shape shape_ = shapes::sphere(1.0, 4);
    std::shared_ptr<const WettedSurface> surface_;
    std::vector<std::uint8_t> held_;
    WallLoad load_;
    PlainSmoothing plain_;
    bool is_plain_;
    Points area_, v_;
    std::vector<double> mass_, particle_mass_{1e-9};
    Particles particle_;
    FlightResult flight_;
    std::uint64_t step_ = 0;
    Wrench brought_, given_;
    double outward_ = 0.0;
};

struct Measured {
    double scatter = 0.0, delay = 0.0;
};

/// Scatter at rest, and the time until a step of the pressure from 1 to 2 has come through by
/// 1 - 1/e.
Measured measure(bool is_plain) {
    HitSurface wall(is_plain);
    Measured out;
    constexpr int STEPS = 1000;
    for (int s = 0; s < STEPS; ++s) {
        const double scatter = wall.step(1.0).scatter;
        if (s >= STEPS / 2) out.scatter += scatter / (STEPS / 2);
    }
    while (wall.step(2.0).mean < 2.0 - std::exp(-1.0) && out.delay < 100 * LOAD_STEP)
        out.delay += LOAD_STEP;
    return out;
}

}  // namespace

TEST_CASE("the load on a wall is a third as noisy as plain smoothing, at the same delay", "[gas]") {
    const Measured quiet = measure(false), plain = measure(true);
    WARN("facet pressure scatters by " << 100 * quiet.scatter << " % against "
                                       << 100 * plain.scatter << " %, delay " << 1e6 * quiet.delay
                                       << " against " << 1e6 * plain.delay << " us");
    CHECK(quiet.scatter < plain.scatter / 3.0);
    CHECK(quiet.delay <= plain.delay + LOAD_STEP);
}

TEST_CASE("what the wall is owed is what hits brought less what was given, and goes in 0.3 ms",
          "[gas]") {
    HitSurface wall(false);
    for (int s = 0; s < 200; ++s) {
        wall.step(1.0);
        Wrench rest = wall.brought();
        rest -= wall.given();
        rest -= wall.load().owed();
        const double all = wall.outward();
        REQUIRE(rest.linear.norm() < 1e-13 * all);
        REQUIRE(rest.angular.norm() < 1e-13 * all);
    }
    const double before = wall.outward();
    for (int s = 0; s < 60; ++s) wall.step(0.0);
    const double owed = before * LOAD_TIME / (200 * LOAD_STEP);  // one delay's worth of pressure
    CHECK(wall.load().owed().linear.norm() < 0.01 * owed);
    CHECK(wall.load().owed().angular.norm() < 0.01 * owed);
}

TEST_CASE("cloth that gas has not reached feels nothing", "[gas]") {
    HitSurface wall(false);
    constexpr double FRONT = 0.0;
    double behind = 0.0, ahead = 0.0;
    for (int s = 0; s < 200; ++s) {
        wall.step(1.0, FRONT);
        for (std::size_t n = 0; n < wall.shape().x.size(); ++n) {
            const double push = wall.load().force(static_cast<Index>(n)).dot(wall.shape().x[n]);
            (wall.shape().x[n][0] > FRONT + 0.15 ? ahead : behind) += std::abs(push);
        }
    }
    CHECK(ahead < 1e-3 * behind);
}

TEST_CASE("the gas answers a wall's motion at once, and gives all of it what hits brought",
          "[gas]") {
    const shapes::Shape shape = shapes::sphere(1.0, 3);
    const auto surface =
        std::make_shared<WettedSurface>(shape.triangles, shape.triangles.size(), shape.x);
    const std::vector<std::uint8_t> held(shape.x.size(), 0);
    constexpr double PRESSURE = 2.0, FLUX = 0.01, SPEED = 3.0, MASS = 1e3;
    const std::vector<double> mass(shape.x.size(), MASS);
    Points areas(surface->points()), normal(shape.x.size());
    surface->point_areas(shape.x, areas);
    double area = 0.0;  // of node 0
    for (std::size_t p = 0; p < surface->points(); ++p) {
        const auto n = static_cast<std::size_t>(surface->node(p));
        normal[n] = areas[p].normalized();
        if (n == 0) area = areas[p].norm();
    }
    struct Pushed {
        double first = 0.0;       ///< force on node 0 in the first step
        double along = 0.0;       ///< what all nodes get along their normals, summed over steps
        Vec3 sum = Vec3::Zero();  ///< what they get together
    };
    const auto pushed = [&](auto&& speed) {
        WallLoad load(surface, held, {}, {LOAD_TIME, LOAD_TIME}, 0.0);
        load.begin_with(PRESSURE, FLUX, shape.x);
        Pushed all;
        for (int s = 0; s < 500; ++s) {  // 50 times the delay
            Points v(shape.x.size()), f(shape.x.size(), Vec3::Zero());
            for (std::size_t n = 0; n < v.size(); ++n)
                v[n] = (s == 0 ? speed(n) : 0.0) * shape.x[n];
            load.release(LOAD_STEP, shape.x, v, mass, f);
            if (s == 0) all.first = f[0].dot(shape.x[0]);
            for (std::size_t n = 0; n < f.size(); ++n) {
                all.along += f[n].dot(normal[n]);
                all.sum += f[n];
            }
        }
        return all;
    };
    const Pushed still = pushed([](std::size_t) { return 0.0; }),
                 as_one = pushed([](std::size_t) { return SPEED; }),
                 alone = pushed([](std::size_t n) { return n == 0 ? SPEED : 0.0; });
    // dp/dw = -4 times the flux of mass that hits
    const double answer = 4.0 * FLUX * SPEED * area;
    CHECK(still.first - as_one.first == Approx(answer).epsilon(0.01));
    CHECK(still.first - alone.first == Approx(answer).epsilon(0.01));
    CHECK(std::abs(as_one.along - still.along) < 1e-6 * answer);
    CHECK((alone.sum - still.sum).norm() < 1e-6 * answer);
}

TEST_CASE("what is charged to wall that gas has left is paid where gas is", "[gas]") {
    const shapes::Shape shape = shapes::sphere(1.0, 2);
    const auto surface =
        std::make_shared<WettedSurface>(shape.triangles, shape.triangles.size(), shape.x);
    const std::size_t nodes = shape.x.size();
    const std::vector<std::uint8_t> held(nodes, 0);
    const std::vector<double> particle_mass{1e-9}, mass(nodes, 1.0);
    WallLoad load(surface, held, {}, {LOAD_TIME, LOAD_TIME}, 0.0);
    Particles gas;
    gas.add(Vec3::Zero(), Vec3::Zero(), 1.0, 0, 0);
    const Points v(nodes, Vec3::Zero());
    const auto& [a, b, c] = shape.triangles[0];
    const Vec3 area = vector_area(shape.x[a], shape.x[b], shape.x[c]),
               centre = (shape.x[a] + shape.x[b] + shape.x[c]) / 3.0;
    FlightResult flight;
    const auto step = [&] {
        flight.hits = {{{0, 0, {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0}, 1e-9 * area, 0.0, centre}}};
        load.find_sides(flight, shape.x, shape.x);
        load.receive(flight, particle_mass, gas);
        Points f(nodes, Vec3::Zero());
        load.release(LOAD_STEP, shape.x, v, mass, f);
        load.book(v, LOAD_STEP);
    };
    step();
    const std::size_t far = surface->side(shape.triangles.size() - 1, false);
    load.charge(surface->points(far), 0.01);
    for (int i = 0; i < 100; ++i) step();
    CHECK(gas.e[0] == Approx(0.99).epsilon(1e-9));
    CHECK(std::abs(load.drain(0, 1.0)) < 1e-12);
}
