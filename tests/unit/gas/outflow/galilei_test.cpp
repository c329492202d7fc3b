// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the state of a gas is the same to all who move evenly [Galilei]: of a box that flies with
// its gas, wall samples, rooms and openings tell what they tell of the box at rest.
#include <catch2/catch.hpp>

#include <cmath>
#include <memory>

#include "gas/flight/flight.hpp"
#include "gas/outflow/wall_samples.hpp"
#include "gas/particle_gas.hpp"
#include "gas/wall_load/wall_hits.hpp"
#include "tests/support/geometry/shapes.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double BOX = 0.1, BOX_STEP = 5e-6, BOX_HEAT = 300.0;
constexpr std::size_t BOX_PARTICLES = 4000;

/// Gas that flies freely in a box, both at one velocity, with a wind of its own, a half of it hot;
/// the wall's samples take in its hits.
class FlyingBox {
public:
    explicit FlyingBox(const Vec3& velocity) : velocity_(velocity) {
        for (std::size_t i = 0; i < gas_.size(); ++i) {
            const double hot = gas_.x[i].y() < 0.5 * BOX ? 2.0 : 1.0;
            gas_.e[i] *= hot;
            gas_.v[i] = std::sqrt(hot) * gas_.v[i] + Vec3(40.0, 0.0, -25.0) + velocity_;
        }
        walls_.triangles = shape_.triangles;
        walls_.closing = shape_.triangles.size();
        for (std::size_t f = 0; f < walls_.closing; ++f) {
            walls_.shell.push_back(static_cast<Index>(f));
            walls_.part.push_back(0);
        }
        walls_.part_ids = {1};
        walls_.part_rows = {0};
        samples_ = WallSamples(surface_, walls_, mixture_.species(), mass_, GAS_CONSTANT, 2e-4,
                               std::vector<char>(walls_.closing, 0), shape_.x);
        std::vector<Index> round_a_hole(24);
        for (std::size_t s = 0; s < round_a_hole.size(); ++s)
            round_a_hole[s] = static_cast<Index>(s);
        hole_ = samples_.add(round_a_hole, true);
        room_.temperature = BOX_HEAT;
        room_.molar_mass = AIR.molar_mass;
        room_.gamma = mixture_.species()[0].gamma(BOX_HEAT);
        room_.density = {mass_[0] * static_cast<double>(gas_.size()) / std::pow(BOX, 3)};
        room_.pressure = room_.density[0] * GAS_CONSTANT / AIR.molar_mass * BOX_HEAT;
        room_.heat_capacity =
            static_cast<double>(gas_.size()) * mixture_.moles_each() * (AIR.A - GAS_CONSTANT);
    }
    void step() {
        Points x_1 = x_;
        for (Vec3& x : x_1) x += BOX_STEP * velocity_;
        FacetLists lists(shape_.triangles, x_, FacetLists::Of::EIGHTS);
        lists.build(Grid::over(x_[0] - Vec3::Constant(0.01), x_[0] + Vec3::Constant(BOX + 0.01),
                               0.02, 100000),
                    x_, x_1, 0.0);
        fly(lists, x_, x_1, BOX_STEP, mass_, {}, gas_, flight_);
        hits_.list(flight_, x_, x_1);
        samples_.receive(hits_, BOX_STEP, x_, x_1, std::vector<Inside>{room_}, gas_);
        x_.swap(x_1);
    }
    [[nodiscard]] Inside state(std::size_t sample) const {
        Inside out;
        samples_.state(sample, room_, out);
        return out;
    }
    [[nodiscard]] std::size_t patches() const { return samples_.patches().size(); }
    [[nodiscard]] std::size_t hole() const { return static_cast<std::size_t>(hole_); }
    [[nodiscard]] const Particles& gas() const { return gas_; }

private:
    Vec3 velocity_;
    shapes::Shape shape_ = shapes::box(Vec3::Constant(BOX), 6);
    Points x_ = shape_.x;
    Mixture mixture_ = mixture_of({AIR});
    std::vector<double> mass_{mixture_.particle_mass(0)};
    /// In a half of the box: hits tell what the room's mean state does not.
    Particles gas_ = random_gas(BOX_PARTICLES, Vec3(0.5 * BOX, BOX, BOX), mixture_, {BOX_HEAT});
    std::shared_ptr<const WettedSurface> surface_ =
        std::make_shared<WettedSurface>(shape_.triangles, shape_.triangles.size(), shape_.x);
    BagWalls walls_;
    WallSamples samples_;
    Index hole_ = 0;
    Inside room_;
    FlightResult flight_;
    WallHits hits_{*surface_};
};

}  // namespace

TEST_CASE("samples of a wall tell the same of a gas that flies with its box",
          "[gas][outflow][galilei]") {
    FlyingBox rest(Vec3::Zero()), flies(Vec3(120.0, -60.0, 30.0));
    for (int i = 0; i < 60; ++i) {
        rest.step();
        flies.step();
    }
    double warmest = 0.0, coldest = INF, highest = 0.0, lowest = INF;
    for (std::size_t k = 0; k <= rest.hole(); ++k) {
        const Inside at_rest = rest.state(k), in_flight = flies.state(k);
        CHECK(in_flight.pressure == Approx(at_rest.pressure).epsilon(1e-8));
        CHECK(in_flight.temperature == Approx(at_rest.temperature).epsilon(1e-8));
        CHECK(in_flight.density[0] == Approx(at_rest.density[0]).epsilon(1e-8));
        CHECK(in_flight.error == Approx(at_rest.error).epsilon(1e-6));
        warmest = std::max(warmest, at_rest.temperature);
        coldest = std::min(coldest, at_rest.temperature);
        highest = std::max(highest, at_rest.pressure);
        lowest = std::min(lowest, at_rest.pressure);
    }
    CHECK(warmest - coldest > 10.0);  // it is the hits that tell
    CHECK(highest > 1.2 * lowest);
}

TEST_CASE("energy about a velocity is that of the particles about it", "[gas][galilei]") {
    const Mixture mixture = mixture_of({AIR});
    const double m = mixture.particle_mass(0);
    const Particles gas = random_gas(500, Vec3::Ones(), mixture, {400.0});
    const Vec3 w(30.0, -200.0, 7000.0);
    Holding all;
    double about = 0.0;
    for (std::size_t i = 0; i < gas.size(); ++i) {
        Holding own;
        own.count = 1.0;
        own.mass = m;
        own.translational = 0.5 * m * gas.v[i].squaredNorm();
        own.internal = gas.e[i];
        own.momentum = m * gas.v[i];
        all += own;
        about += 0.5 * m * (gas.v[i] - w).squaredNorm() + gas.e[i];
    }
    CHECK(all.about(w) == Approx(about).epsilon(1e-13));
    CHECK(all.about(Vec3::Zero()) == all.all());
    // least about the mean velocity, by that of the motion as a whole
    CHECK(all.about(all.momentum / all.mass) == Approx(all.all() - all.bulk()).epsilon(1e-13));
}

TEST_CASE("the mean way of a room's wall is that of a box, and weighs by area", "[gas][galilei]") {
    const shapes::Shape box = shapes::box({0.1, 0.2, 0.3}, 3);
    const WettedSurface surface(box.triangles, box.triangles.size(), box.x);
    const Vec3 way(0.2, -0.1, 0.05);
    Points x_1 = box.x;
    for (Vec3& x : x_1) x += way;
    CHECK((surface.mean_way(box.x, x_1).at(0) - way).norm() < 1e-15);
    // the face at x = 0.1 moves out: it whole, the four beside it by a sixth (half of the last row)
    x_1 = box.x;
    for (Vec3& x : x_1)
        if (x.x() > 0.0999) x.x() += 0.01;
    const double end = 0.06, sides = 2.0 * (0.02 + 0.03);
    CHECK(surface.mean_way(box.x, x_1).at(0).x() ==
          Approx(0.01 * (end + sides / 6.0) / (2.0 * end + sides)).epsilon(1e-12));
}
