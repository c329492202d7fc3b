// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/orifices.hpp"

#include <catch2/catch.hpp>

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// Place of an orifice on a quad of 1 m in the plane z = 0, two of whose corners are `raised`
/// inward, which is up: the diagonal between them bends.
Vec3 place_on_bent_quad(double raised) {
    const Points x{Vec3(0, 0, raised), Vec3(1, 0, 0), Vec3(1, 1, raised), Vec3(0, 1, 0)};
    const std::vector<Triangle> outward{{0, 2, 1}, {0, 3, 2}}, given{{0, 1, 2}, {0, 2, 3}};
    OrificeCard card;
    card.shell = 0;
    card.normal_sign = 1.0;
    const Orifices orifices({card}, outward, given, {0, 0}, {-1, -1, -1}, x);
    return orifices.place(0, x);
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
