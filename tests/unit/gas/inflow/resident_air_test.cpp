// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/resident_air.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

#include "gas/enclosure/inside.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// A ball that is pressed flat and folded over, so that a ray passes several layers.
shapes::Shape folded_ball() {
    shapes::Shape shape = shapes::sphere(0.1, 4);
    for (Vec3& x : shape.x) {
        const double bend = 25.0 * x.x(), z = 0.1 * x.z();
        x = {(0.04 + z) * std::sin(bend), x.y(), (0.04 + z) * std::cos(bend) + 0.02 * x.x()};
    }
    return shape;
}

Enclosure enclosure(const shapes::Shape& shape) {
    std::vector<int> id(shape.x.size());
    std::iota(id.begin(), id.end(), 1);
    return {shape.triangles, shape.x, id, "bag"};
}

const Species AMBIENT_AIR({0.029, 29.1, 0.001, 0.0}, GAS_CONSTANT, "air");
constexpr ResidentAir SOME{20000, 3, 500, 1e-8, 350.0};

Particles fill(const shapes::Shape& shape) {
    Particles particles;
    const Enclosure bag = enclosure(shape);
    const WettedSurface surface(bag.triangles(), bag.triangles().size(), shape.x);
    add_resident_air(SOME, AMBIENT_AIR, bag, surface, shape.x, 7, "bag", particles);
    return particles;
}

}  // namespace

TEST_CASE("rays through columns and solid angles agree on what is inside", "[gas]") {
    const shapes::Shape shape =
        GENERATE(folded_ball(), shapes::sphere(1.0, 2), shapes::box({1, 2, 0.3}, 3));
    const Enclosure bag = enclosure(shape);
    const InsideTest inside(bag.triangles(), shape.x);
    Random draw(3, Stream::INITIAL, 0, 0);
    int in = 0;
    for (int i = 0; i < 3000; ++i) {
        Vec3 p;
        for (int k = 0; k < 3; ++k)
            p[k] =
                inside.low()[k] + (1.1 * draw.uniform() - 0.05) * (inside.high() - inside.low())[k];
        const auto winding = inside.winding(p);
        REQUIRE(winding);
        REQUIRE((*winding > 0) == bag.contains(p, shape.x));
        in += *winding > 0;
    }
    CHECK(in > 100);
}

TEST_CASE("resident air fills a folded bag evenly, at rest, with exact energy", "[gas]") {
    const shapes::Shape shape = folded_ball();
    const Enclosure bag = enclosure(shape);
    const Particles particles = fill(shape);
    REQUIRE(particles.size() == SOME.count);
    Vec3 momentum = Vec3::Zero(), centre = Vec3::Zero();
    double translational = 0.0, internal = 0.0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (i % 40 == 0) REQUIRE(bag.contains(particles.x[i], shape.x));
        CHECK(particles.id[i] == SOME.first_id + static_cast<int>(i));
        momentum += SOME.mass * particles.v[i];
        translational += 0.5 * SOME.mass * particles.v[i].squaredNorm();
        internal += particles.e[i];
        centre += particles.x[i];
    }
    const double all = SOME.mass * static_cast<double>(SOME.count);
    const double exact = 1.5 * GAS_CONSTANT * SOME.temperature / 0.029 * all;
    CHECK(momentum.norm() < 1e-12 * std::sqrt(2.0 * all * translational));
    CHECK(translational == Approx(exact).epsilon(1e-12));
    CHECK(translational + internal == Approx(all * AMBIENT_AIR.u(SOME.temperature)).epsilon(1e-12));

    // The centre of volume, by the divergence theorem, and its deviation at this number: some 3e-4.
    Vec3 moment = Vec3::Zero();
    for (const auto& [a, b, c] : bag.triangles()) {
        const Vec3 &p = shape.x[a], &q = shape.x[b], &r = shape.x[c];
        moment += signed_volume(p, q, r) * (p + q + r) / 4.0;
    }
    CHECK((centre / static_cast<double>(SOME.count) - moment / bag.volume(shape.x)).norm() < 2e-3);
}

TEST_CASE("resident air does not depend on threads", "[gas]") {
    const shapes::Shape shape = folded_ball();
    parallel::set_threads(1);
    const Particles one = fill(shape);
    parallel::set_threads(3);
    const Particles three = fill(shape);
    parallel::set_threads(1);
    for (std::size_t i = 0; i < one.size(); ++i) {
        REQUIRE(one.x[i] == three.x[i]);
        REQUIRE(one.v[i] == three.v[i]);
    }
}

TEST_CASE("every closed room has its share of resident air, at rest, with exact energy", "[gas]") {
    // A box, and one within whose wall parts the gas: walls of the inner one are internal.
    shapes::Shape shape = shapes::box({0.1, 0.1, 0.1}, 2);
    const auto closing = shape.triangles.size();
    const Enclosure bag = enclosure(shape);
    std::vector<Triangle> all = bag.triangles();
    const shapes::Shape inner = shapes::box({0.07, 0.07, 0.07}, 1);
    const auto nodes = static_cast<Index>(shape.x.size());
    for (const Vec3& at : inner.x) shape.x.push_back(at + Vec3(0.01, 0.01, 0.01));
    for (const auto& [a, b, c] : inner.triangles) all.push_back({a + nodes, b + nodes, c + nodes});
    const WettedSurface surface(all, closing, shape.x);
    REQUIRE(surface.rooms() == 2);
    std::vector<double> volume;
    surface.volumes(shape.x, volume);
    Particles particles;
    add_resident_air(SOME, AMBIENT_AIR, bag, surface, shape.x, 7, "bag", particles);
    REQUIRE(particles.size() == SOME.count);
    const std::vector<Index> room = surface.rooms_of(particles.x, shape.x);
    for (const Index r : {0, 1}) {
        double count = 0.0, square = 0.0;
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < room.size(); ++i) {
            if (room[i] != r) continue;
            count += 1.0;
            sum += particles.v[i];
            square += particles.v[i].squaredNorm();
        }
        const double share =
            static_cast<double>(SOME.count) * volume[static_cast<std::size_t>(r)] / 1e-3;
        CHECK(std::abs(count - share) < 1.0);
        CHECK(sum.norm() < 1e-9 * std::sqrt(count * square));
        CHECK(square ==
              Approx(count * 3.0 * GAS_CONSTANT * SOME.temperature / 0.029).epsilon(1e-12));
    }
}
