// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/orifices.hpp"

#include <catch2/catch.hpp>

#include <algorithm>

#include "gas/flight/crossing.hpp"
#include "solver/base/random.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// A quad of 1 m in the plane z = 0, two of whose corners are `raised` inward, which is up: the
/// diagonal between them bends.
Points bent_quad(double raised) {
    return {Vec3(0, 0, raised), Vec3(1, 0, 0), Vec3(1, 1, raised), Vec3(0, 1, 0)};
}
const std::vector<Triangle> OUTWARD{{0, 2, 1}, {0, 3, 2}};

Orifices orifice_on_quad(const Points& x) {
    const std::vector<Triangle> given{{0, 1, 2}, {0, 2, 3}};
    OrificeCard card;
    card.shell = 0;
    card.normal_sign = 1.0;
    return {{card}, OUTWARD, given, {0, 0}, {-1, -1, -1}, x};
}

Vec3 place_on_bent_quad(double raised) {
    const Points x = bent_quad(raised);
    return orifice_on_quad(x).place(0, x);
}

}  // namespace

TEST_CASE("gas enters inside, however the quad of its orifice bends", "[gas]") {
    constexpr double OFF = 1e-3;
    const double raised = GENERATE(0.0, 1e-4, 1e-3, 0.03, 0.3);
    const Vec3 inward = place_on_bent_quad(raised), outward = place_on_bent_quad(-raised);
    CAPTURE(raised, inward.z(), outward.z());
    CHECK(inward.head<2>().isApprox(Eigen::Vector2d(0.5, 0.5)));
    CHECK(inward.z() > raised);  // the diagonal's height, there
    CHECK(inward.z() < raised + 2.0 * OFF * (1.0 + raised));
    CHECK(outward.z() > -raised);
}

TEST_CASE("gas enters inside of what an orifice's facets sweep", "[gas]") {
    constexpr double FAR = 0.01;  // that nodes move in the step: ten times as far as gas enters in
    const double share = GENERATE(0.0, 0.1, 0.3, 0.5, 0.7, 0.9);
    const double raised = GENERATE(0.0, -0.03, 0.03);
    const Points x_0 = bent_quad(raised);
    const Orifices orifices = orifice_on_quad(x_0);
    Random draw(11, Stream::INITIAL, 0, 0);
    int met = 0;
    double deepest = 0.0;
    for (int i = 0; i < 200; ++i) {
        Points x_1 = x_0;
        for (Vec3& x : x_1)
            for (int k = 0; k < 3; ++k) x[k] += FAR * (2.0 * draw.uniform() - 1.0);
        const Vec3 at = orifices.entry(0, share, x_0, x_1), v(0.0, 0.0, 1.0);
        const Path path{at - share * v, at + (1.0 - share) * v};
        for (const Triangle& facet : OUTWARD)
            met += cross(path, facet, x_0.data(), x_1.data(), share) ? 1 : 0;
        const Vec3 from = orifices.place(0, x_0), to = orifices.place(0, x_1);
        deepest = std::max(deepest, (at - from - share * (to - from)).norm());
    }
    CAPTURE(share, raised);
    CHECK(met == 0);
    CHECK(deepest <= 2.1 * FAR * share * (1.0 - share));
}

TEST_CASE("gas enters where its orifice is, on a wall whose nodes move alike", "[gas]") {
    const Points x_0 = bent_quad(0.03);
    const Orifices orifices = orifice_on_quad(x_0);
    Points x_1 = x_0;
    for (Vec3& x : x_1) x += Vec3(0.25, -0.125, 0.5);
    const Vec3 middle = 0.5 * (orifices.place(0, x_0) + orifices.place(0, x_1));
    CHECK(orifices.entry(0, 0.5, x_0, x_1).isApprox(middle, 1e-14));
}
