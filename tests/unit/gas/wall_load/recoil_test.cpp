// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// A heavy particle and light cloth meet as two bodies do.

#include "gas/wall_load/recoil.hpp"

#include <catch2/catch.hpp>

#include <memory>

#include "gas/wall_load/wall_load.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double NODE = 1e-3;  // mass [kg]

/// A box whose wall gas has not reached: three nodes bear a hit on facet 0.
struct Struck {
    shapes::Shape shape = shapes::box({1.0, 1.0, 1.0}, 4);
    std::shared_ptr<const WettedSurface> surface =
        std::make_shared<WettedSurface>(shape.triangles, shape.triangles.size(), shape.x);
    Particles particles;
    FlightResult flight;
    Vec3 normal;
    Wrench owed;                ///< to the wall, after the hits
    Vec3 flown = Vec3::Zero();  ///< way of the particle from its last hit to the step's end

    /// A particle of mass m at velocity v is mirrored by facet 0, whose nodes are `held` or not; more
    /// `times` in the same step by walls that turn it round in between, and it holds `internal`.
    void hit(double m, const Vec3& v, bool is_held, int times = 1, double internal = 0.0) {
        const std::vector<std::uint8_t> held(shape.x.size(), is_held ? 1 : 0);
        const std::vector<double> node_mass(shape.x.size(), NODE), mass{m};
        WallLoad load(surface, held, {}, 50e-6, 0.0);
        Points f(shape.x.size(), Vec3::Zero()), rest(shape.x.size(), Vec3::Zero());
        load.release(1e-6, shape.x, rest, node_mass, f);
        const auto& [a, b, c] = shape.triangles[0];
        const Vec3 n = vector_area(shape.x[a], shape.x[b], shape.x[c]).normalized();
        normal = n;
        const Vec3 mirrored = v - 2.0 * v.dot(n) * n;
        particles.add(shape.x[a] + flown, times % 2 == 1 ? mirrored : v, internal, 0, 0);
        flight.hits.resize(1);
        for (int k = 0; k < times; ++k)
            flight.hits[0].push_back({0,
                                      0,
                                      {0.2, 0.3, 0.5},
                                      (k % 2 == 0 ? 1.0 : -1.0) * m * (v - mirrored),
                                      0.0,
                                      shape.x[a]});
        load.find_sides(flight, shape.x, shape.x);
        load.receive(flight, mass, particles);
        owed = load.owed();
    }
};

}  // namespace

TEST_CASE("a particle and the free cloth that it hits collide as two bodies", "[gas]") {
    const Vec3 v(300.0, -200.0, -400.0);
    for (const double m : {0.1 * NODE, NODE, 3.0 * NODE, 30.0 * NODE}) {
        Struck cloth;
        cloth.hit(m, v, false);
        const Hit& hit = cloth.flight.hits[0][0];
        const Vec3 after = cloth.particles.v[0];
        INFO("particle " << m << " kg");
        CHECK((hit.impulse - m * (v - after)).norm() < 1e-14 * m * v.norm());
        const double bearing = 3.0 * NODE;
        CHECK(hit.energy == Approx(0.5 * hit.impulse.squaredNorm() / bearing).epsilon(1e-12));
        CHECK(0.5 * m * (v.squaredNorm() - after.squaredNorm()) ==
              Approx(hit.energy).epsilon(1e-12));
    }
}

TEST_CASE("walls that are held, and cloth far heavier than the particle, mirror it", "[gas]") {
    const Vec3 v(300.0, -200.0, -400.0);
    Struck wall, cloth;
    wall.hit(NODE, v, true);
    cloth.hit(1e-4 * NODE, v, false);
    for (const Struck* struck : {&wall, &cloth}) {
        CHECK(struck->particles.v[0].norm() == Approx(v.norm()).epsilon(1e-14));
        CHECK(struck->flight.hits[0][0].energy == 0.0);
    }
}

TEST_CASE("cloth at rest makes no particle faster, however often it hits in a step", "[gas]") {
    const Vec3 v(300.0, -200.0, -400.0);
    for (const double m : {0.1 * NODE, NODE, 30.0 * NODE})
        for (const int times : {2, 3, 10, 25}) {
            Struck cloth;
            cloth.hit(m, v, false, times);
            Vec3 given = Vec3::Zero();
            double energy = 0.0;
            for (const Hit& hit : cloth.flight.hits[0]) {
                given += hit.impulse;
                energy += hit.energy;
            }
            const Vec3 after = cloth.particles.v[0];
            INFO("particle " << m << " kg, " << times << " hits");
            CHECK(after.norm() < v.norm());
            CHECK((given - m * (v - after)).norm() < 1e-13 * m * v.norm());
            CHECK(0.5 * m * (v.squaredNorm() - after.squaredNorm()) ==
                  Approx(energy).epsilon(1e-12));
        }
}

TEST_CASE("cloth takes a debt back where it takes the motion that was to pay for it", "[gas]") {
    const Vec3 v(300.0, -200.0, -400.0);
    const double motion = 0.5 * NODE * v.squaredNorm();
    Struck cloth, wall;
    cloth.hit(NODE, v, false, 1, -0.1 * motion);
    const double left = 0.5 * NODE * cloth.particles.v[0].squaredNorm();
    CHECK(left < 0.9 * motion);
    CHECK(cloth.particles.e[0] == Approx(-0.1 * left).epsilon(1e-12));

    wall.hit(NODE, v, true, 1, -0.5 * motion);  // it takes no motion, and so no debt
    CHECK(wall.particles.e[0] == -0.5 * motion);
}

TEST_CASE("recoil keeps linear and angular momentum", "[gas]") {
    const Vec3 v(300.0, -200.0, -400.0), flown(2e-3, 1e-3, -3e-3);
    for (const int times : {1, 2, 3})
        for (const double m : {0.1 * NODE, NODE, 30.0 * NODE}) {
            CAPTURE(times, m);
            Struck cloth;
            cloth.flown = flown;
            cloth.hit(m, v, false, times);
            const Vec3 hit = cloth.flight.hits[0][0].where, v_after = cloth.particles.v[0];
            const Vec3 given = m * (v - v_after);
            const Vec3 turned = m * (hit.cross(v) - (hit + flown).cross(v_after));
            // it has flown on as a wall of infinite mass has thrown it
            const Vec3 thrown =
                times % 2 == 1 ? Vec3(v - 2.0 * v.dot(cloth.normal) * cloth.normal) : v;
            const Vec3 flight = m * flown.cross(thrown);
            CHECK((cloth.owed.linear - given).norm() < 1e-12 * m * v.norm());
            CHECK((cloth.owed.angular - turned - flight).norm() < 1e-12 * m * v.norm());
        }
}
