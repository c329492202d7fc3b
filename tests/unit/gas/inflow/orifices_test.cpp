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
    return {{card}, OUTWARD, given, OUTWARD.size(), {0, 0}, {-1, -1, -1}, x};
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
    const double share = GENERATE(0.0, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0);
    const double raised = GENERATE(0.0, -0.03, 0.03);
    const double far = GENERATE(1e-4, 1e-3, 1e-2);  // that nodes move in the step         [m]
    const Points x_0 = bent_quad(raised);
    const Orifices orifices = orifice_on_quad(x_0);
    Random draw(11, Stream::INITIAL, 0, 0);
    int met = 0, on_time = 0;
    for (int i = 0; i < 200; ++i) {
        Points x_1 = x_0;
        for (Vec3& x : x_1)
            for (int k = 0; k < 3; ++k) x[k] += far * (2.0 * draw.uniform() - 1.0);
        const Birth birth = orifices.birth(0, share, x_0, x_1);
        const Vec3 v(0.0, 0.0, 1.0);
        const Path path{birth.at - birth.share * v, birth.at + (1.0 - birth.share) * v};
        for (const Triangle& facet : OUTWARD)
            met += cross(path, facet, x_0.data(), x_1.data(), birth.share) ? 1 : 0;
        const Vec3 from = orifices.place(0, x_0), to = orifices.place(0, x_1);
        CHECK((birth.share == share || birth.share == 0.0));
        CHECK((birth.at - from - birth.share * (to - from)).norm() < 1e-15);
        on_time += birth.share == share ? 1 : 0;
    }
    CAPTURE(share, raised, far);
    CHECK(met == 0);
    if (far == 1e-4) CHECK(on_time == 200);
}

TEST_CASE("gas enters when it is due, where its orifice is, on a wall whose nodes move alike",
          "[gas]") {
    const Points x_0 = bent_quad(0.03);
    const Orifices orifices = orifice_on_quad(x_0);
    Points x_1 = x_0;
    for (Vec3& x : x_1) x += Vec3(0.25, -0.125, 0.5);
    const Vec3 middle = 0.5 * (orifices.place(0, x_0) + orifices.place(0, x_1));
    const Birth birth = orifices.birth(0, 0.5, x_0, x_1);
    CHECK(birth.share == 0.5);
    CHECK(birth.at.isApprox(middle, 1e-14));
}

TEST_CASE("an orifice on a plate inside the bag lies on the side to which its jet leads", "[gas]") {
    const Points x = bent_quad(0.0);
    const double up = GENERATE(1.0, -1.0);
    const bool is_shell = GENERATE(true, false);
    const bool is_turned = GENERATE(true, false);  // as the deck orients the plate
    std::vector<Triangle> plate{{0, 1, 2}, {0, 2, 3}};
    if (is_turned) plate = OUTWARD;
    OrificeCard card;
    if (is_shell) {
        card.shell = 0;
        card.normal_sign = is_turned ? -up : up;
    } else {
        card.node = 0;
        card.direction = Vec3(0.6, 0.0, 0.8 * up);
    }
    const Orifices orifices({card}, plate, plate, 0, {0, 0}, {-1, -1, -1}, x);
    CAPTURE(up, is_shell, is_turned);
    CHECK(up * orifices.place(0, x).z() > 0.9e-3);
    CHECK(up * orifices.place(0, x).z() < 2e-3);
}
