// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// A heavy particle and light cloth meet as two bodies do.

#include "gas/wall_load/recoil.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

#include "gas/wall_load/wall_load.hpp"
#include "solver/base/random.hpp"
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
    /// `times` in the same step by the facet opposite and that one in turns; it holds `internal`.
    void hit(double m, const Vec3& v, bool is_held, int times = 1, double internal = 0.0) {
        const std::vector<std::uint8_t> held(shape.x.size(), is_held ? 1 : 0);
        const std::vector<double> node_mass(shape.x.size(), NODE), mass{m};
        WallLoad load(surface, held, {}, {50e-6, 50e-6}, 0.0);
        Points f(shape.x.size(), Vec3::Zero()), rest(shape.x.size(), Vec3::Zero());
        load.release(1e-6, shape.x, rest, node_mass, f);
        const auto& [a, b, c] = shape.triangles[0];
        const Vec3 n = vector_area(shape.x[a], shape.x[b], shape.x[c]).normalized();
        normal = n;
        const Vec3 mirrored = v - 2.0 * v.dot(n) * n;
        particles.add(shape.x[a] + flown, times % 2 == 1 ? mirrored : v, internal, 0, 0);
        flight.hits.resize(1);
        for (int k = 0; k < times; ++k)
            flight.hits[0].push_back({k % 2 == 0 ? 0 : 2,
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

/// A box of crumpled cloth that gas has reached, and its smoother.
struct Smoothed {
    shapes::Shape shape = shapes::box({1.0, 1.0, 1.0}, 8);
    WettedSurface surface;
    PointSmoother smoother;
    std::vector<double> size, mass;
    Recoil recoil;
    Random draw;

    explicit Smoothed(std::uint64_t seed)
        : surface((crumple(shape.x, seed), shape.triangles), shape.triangles.size(), shape.x),
          smoother(surface),
          recoil(std::vector<std::uint8_t>(surface.points(), 0)),
          draw(seed, Stream::INITIAL, 1, 0) {
        Points area(surface.points());
        surface.point_areas(shape.x, area);
        recoil.set_points(surface.points());
        for (std::size_t p = 0; p < surface.points(); ++p) {
            size.push_back(area[p].norm());
            mass.push_back(NODE * (0.5 + draw.uniform()));
            recoil.weigh(p, mass[p]);
        }
        smoother.prepare(surface, area, size, std::vector<std::uint8_t>(surface.points(), 1));
    }
    static void crumple(Points& x, std::uint64_t seed) {
        constexpr double ROUGH = 0.12;  // [m]
        Random draw(seed, Stream::INITIAL, 0, 0);
        for (Vec3& at : x)
            for (int k = 0; k < 3; ++k) at[k] += ROUGH * (2.0 * draw.uniform() - 1.0);
    }
    /// What each point gets of an impulse at one place, by way of a field over all of them.
    std::vector<double> share_of_points(std::size_t side, const std::array<double, 3>& at) {
        std::vector<Brought> field(surface.points());
        for (int c = 0; c < 3; ++c) {
            const Index p = surface.points(side)[c];
            field[p].push = at[c] / size[p];
        }
        smoother.spread(surface, field);
        std::vector<double> share;
        for (std::size_t p = 0; p < field.size(); ++p) share.push_back(size[p] * field[p].push);
        return share;
    }
    /// Energies: of the hits' books; lost by the particle; that their impulses bring cloth at rest.
    struct Outcome {
        double taken, lost, brought;
    };
    /// A particle hits sides at random, back and forth between two of them and their neighbours.
    Outcome hit(double m, int times) {
        std::vector<Hit> hits;
        std::vector<Index> sides;
        const Vec3 start(300.0, -200.0, -400.0);
        Vec3 v = start;
        for (int k = 0; k < times; ++k) {
            const auto side = static_cast<std::size_t>((k % 2) * 100 + draw.uniform() * 10);
            Vec3 n = surface.facet_area(side, shape.x).normalized();
            if (v.dot(n) < 0.0) n = -n;  // it comes from the side that it can hit
            hits.push_back({0, 0, {0.2, 0.3, 0.5}, 2.0 * m * v.dot(n) * n, 0.0, shape.x[0]});
            sides.push_back(static_cast<Index>(side));
            v -= 2.0 * v.dot(n) * n;
        }
        recoil.set_right(surface, smoother, hits, sides, m, shape.x[0], v);
        Outcome now{0.0, 0.5 * m * (start.squaredNorm() - v.squaredNorm()), 0.0};
        Points moved(surface.points(), Vec3::Zero());
        for (std::size_t k = 0; k < hits.size(); ++k) {
            const auto share = share_of_points(static_cast<std::size_t>(sides[k]), hits[k].at);
            for (std::size_t p = 0; p < moved.size(); ++p)
                moved[p] += share[p] / mass[p] * hits[k].impulse;
            now.taken += hits[k].energy;
        }
        for (std::size_t p = 0; p < moved.size(); ++p)
            now.brought += 0.5 * mass[p] * moved[p].squaredNorm();
        return now;
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
        const double bearing = NODE / (0.2 * 0.2 + 0.3 * 0.3 + 0.5 * 0.5);
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

TEST_CASE("hits of one step take what their impulses bring the cloth", "[gas]") {
    for (const int seed : {1, 2, 3, 4, 5, 6}) {
        Smoothed cloth(static_cast<std::uint64_t>(seed));
        for (const double m : {0.1 * NODE, NODE, 5.0 * NODE, 30.0 * NODE})
            for (const int times : {1, 2, 5, 40}) {
                const Smoothed::Outcome now = cloth.hit(m, times);
                INFO("seed " << seed << ", particle " << m << " kg, " << times << " hits");
                CHECK(now.taken == Approx(now.brought).epsilon(1e-9));
                CHECK(now.lost == Approx(now.taken).epsilon(1e-9));
                CHECK(now.taken > 0.0);
            }
    }
}

TEST_CASE("an impulse at one place spreads as a field of them does", "[gas]") {
    for (const int seed : {1, 2, 3}) {
        Smoothed cloth(static_cast<std::uint64_t>(seed));
        double least = 1.0, most = 0.0;
        for (std::size_t side = 0; side < cloth.surface.sides(); side += 7) {
            const std::array<double, 3> at{0.2, 0.3, 0.5};
            const std::vector<double> field = cloth.share_of_points(side, at);
            PlaceSpread place;
            place.begin(field.size());
            for (int c = 0; c < 3; ++c) place.add(cloth.surface.points(side)[c], at[c]);
            cloth.smoother.spread(cloth.surface, place);
            double sum = 0.0, squares = 0.0, worst = 0.0, reached = 0.0;
            for (const Index p : place.points()) {
                sum += place.share(p);
                squares += place.share(p) * place.share(p);
                reached += field[p];
                worst = std::max(worst, std::abs(place.share(p) - field[p]));
            }
            CHECK(sum == Approx(1.0).epsilon(1e-12));
            CHECK(reached == Approx(1.0).epsilon(1e-12));
            CHECK(worst < 1e-14);
            least = std::min(least, squares);
            most = std::max(most, squares);
        }
        CHECK(2.0 * least < most);  // cloth is so rough that gates are shut
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
