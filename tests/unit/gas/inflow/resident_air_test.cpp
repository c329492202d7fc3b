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
    add_resident_air(SOME, AMBIENT_AIR, enclosure(shape), shape.x, 7, "bag", particles);
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
