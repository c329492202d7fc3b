// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// After the last hit the wall gets all that it is owed, then nothing; jets still push.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>

#include "gas/wall_load/wall_load.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double RELEASE = 50e-6, SPAN = 5e-6;  // [s]
constexpr double HITS = 2.0, UNIFORM = 1.5;     // [Pa]

/// A sphere's wall that is pressed by HITS, then, hits being over, by UNIFORM from elsewhere.
class LeftWall {
public:
    LeftWall()
        : surface_(
              std::make_shared<WettedSurface>(shape_.triangles, shape_.triangles.size(), shape_.x)),
          held_(shape_.x.size(), 0),
          load_(surface_, held_, std::vector<Index>{JET}, LoadTimes{RELEASE, RELEASE}, 0.0),
          v_(shape_.x.size(), Vec3::Zero()),
          mass_(shape_.x.size(), 1.0) {
        load_.begin_with(HITS, 0.01, shape_.x);
        load_.end_of_hits(std::vector<double>{UNIFORM}, shape_.x);
        Points area(surface_->points());
        surface_->point_areas(shape_.x, area);
        for (const Vec3& a : area) area_ += a.norm();
    }
    /// Force on each node over the next SPAN.
    Points release() {
        Points f(shape_.x.size(), Vec3::Zero());
        load_.release(SPAN, shape_.x, v_, mass_, f);
        for (std::size_t n = 0; n < f.size(); ++n) {
            given_.add(shape_.x[n], SPAN * f[n]);
            outward_ += SPAN * f[n].dot(shape_.x[n].normalized());
        }
        load_.book(v_, SPAN);
        return f;
    }
    void release_for(double time) {
        for (double t = 0.0; t < time; t += SPAN) release();
    }
    void push_jet(const Vec3& impulse) { load_.owe_jet(JET, 0, shape_.x[JET], impulse, 0.0); }

    static constexpr Index JET = 7;
    [[nodiscard]] const WallLoad& load() const { return load_; }
    [[nodiscard]] double area() const { return area_; }        // [m^2]
    [[nodiscard]] double outward() const { return outward_; }  // given so far [N s]
    [[nodiscard]] const Wrench& given() const { return given_; }

private:
    shapes::Shape shape_ = shapes::sphere(1.0, 3);
    std::shared_ptr<const WettedSurface> surface_;
    std::vector<std::uint8_t> held_;
    WallLoad load_;
    Points v_;
    std::vector<double> mass_;
    double area_ = 0.0, outward_ = 0.0;
    Wrench given_;
};

bool is_zero(const Points& f) {
    return std::all_of(f.begin(), f.end(), [](const Vec3& one) { return one.isZero(0.0); });
}

}  // namespace

TEST_CASE("after the last hit all that is owed is given, then nothing", "[gas]") {
    LeftWall wall;
    wall.release_for(35.0 * RELEASE);
    CHECK_FALSE(is_zero(wall.release()));
    wall.release_for(10.0 * RELEASE);
    CHECK(is_zero(wall.release()));
    CHECK(wall.load().pressure_at_node(0) == 0.0);
    // points push along normals of their own, which are within a per cent of the sphere's
    const double all = (HITS - UNIFORM) * wall.area() * RELEASE;
    CHECK(wall.outward() == Approx(all).epsilon(0.01));
    CHECK(wall.load().owed().linear.norm() < 1e-12 * all);
    CHECK(wall.load().owed().angular.norm() < 1e-12 * all);
}

TEST_CASE("a wall whose hits are over is pushed by jets", "[gas]") {
    LeftWall wall;
    wall.release_for(45.0 * RELEASE);
    const Wrench before = wall.given();
    const Vec3 impulse(0.0, 1e-3, -2e-3);
    wall.push_jet(impulse);
    const Points first = wall.release();
    CHECK((first[LeftWall::JET] * RELEASE - impulse).norm() < 1e-12);
    CHECK(wall.load().force(LeftWall::JET) == first[LeftWall::JET]);
    CHECK(is_zero(Points(first.begin(), first.begin() + LeftWall::JET)));
    wall.release_for(40.0 * RELEASE);
    CHECK((wall.given().linear - before.linear - impulse).norm() < 1e-15);
    CHECK(wall.load().force(LeftWall::JET).norm() < 1e-10);
}

TEST_CASE(
    "gas that has long been there pushes as hard from the first half step on, and over the switch",
    "[gas]") {
    const shapes::Shape shape = shapes::sphere(1.0, 3);
    const auto surface =
        std::make_shared<WettedSurface>(shape.triangles, shape.triangles.size(), shape.x);
    const std::size_t nodes = shape.x.size();
    const std::vector<std::uint8_t> held(nodes, 0);
    const std::vector<double> particle_mass{1e-6}, mass(nodes, 1.0);
    const Points v(nodes, Vec3::Zero());
    const double step = GENERATE(5e-6, 20e-6, 40e-6, 80e-6, 160e-6);
    WallLoad load(surface, held, {}, {RELEASE, RELEASE}, 0.0);
    Particles none;
    double area = 0.0, given = 0.0;
    FlightResult flight;
    flight.hits.emplace_back();
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        const auto& [a, b, c] = shape.triangles[t];
        const Vec3 normal = vector_area(shape.x[a], shape.x[b], shape.x[c]);
        flight.hits[0].push_back({static_cast<Index>(t),
                                  0,
                                  {1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0},
                                  HITS * step * normal,
                                  0.0,
                                  (shape.x[a] + shape.x[b] + shape.x[c]) / 3.0});
    }
    none.add(Vec3::Zero(), Vec3::Zero(), 1.0, 0, 0);
    Points areas(surface->points());
    surface->point_areas(shape.x, areas);
    for (const Vec3& a : areas) area += a.norm();
    const auto release = [&](double span) {
        Points f(nodes, Vec3::Zero());
        load.release(span, shape.x, v, mass, f);
        for (std::size_t p = 0; p < areas.size(); ++p)
            given +=
                span * f[static_cast<std::size_t>(surface->node(p))].dot(areas[p].normalized());
        load.book(v, span);
    };
    load.begin_with(HITS, 0.01, shape.x);
    release(0.5 * step);
    const double half = given;
    double before = 0.0, whole = 0.0;
    for (int s = 0; s < 40; ++s) {
        load.find_sides(flight, shape.x, shape.x);
        load.receive(flight, particle_mass, none);
        before = given;
        release(step);
        whole = given - before;
        CHECK(std::abs(whole - 2.0 * half) < 1e-9 * whole);
    }
    CHECK(half == Approx(0.5 * HITS * area * step));
    before = given;
    load.end_of_hits(std::vector<double>{whole / (area * step)}, shape.x);
    for (int s = 0; s < 400; ++s) release(step);
    CHECK(std::abs(given - before) < 1e-9 * whole);
}

TEST_CASE("what jets into a room owe is paid by the gas of that room", "[gas]") {
    shapes::Shape shape = shapes::box(Vec3::Ones(), 1);
    const auto first = static_cast<Index>(shape.x.size());
    const shapes::Shape other = shape;
    for (const Vec3& x : other.x) shape.x.push_back(x + Vec3(2.0, 0.0, 0.0));
    for (const auto& [a, b, c] : other.triangles)
        shape.triangles.push_back({a + first, b + first, c + first});
    const auto surface =
        std::make_shared<WettedSurface>(shape.triangles, shape.triangles.size(), shape.x);
    REQUIRE(surface->rooms() == 2);
    const std::vector<std::uint8_t> held(shape.x.size(), 0);
    WallLoad load(surface, held, std::vector<Index>{0, first}, LoadTimes{RELEASE, RELEASE}, 0.0);
    load.owe_jet(0, 0, shape.x[0], Vec3(0.1, 0.0, 0.0), 2.0);
    load.owe_jet(first, 1, shape.x[first], Vec3(0.0, 0.1, 0.0), 3.0);
    Points f(shape.x.size(), Vec3::Zero()), v(shape.x.size(), Vec3::Zero());
    load.release(SPAN, shape.x, v, std::vector<double>(shape.x.size(), 1.0), f);
    v[first] = Vec3(0.0, 10.0, 0.0);
    const double work = load.book(v, SPAN);
    CHECK(work > 0.0);
    CHECK(load.pay_jets(0) == 2.0);
    CHECK(load.pay_jets(0) == 0.0);
    CHECK(load.pay_jets(1) == Approx(3.0 - work));
    CHECK(load.taken() == Approx(work));
}
