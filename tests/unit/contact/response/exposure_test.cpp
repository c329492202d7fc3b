// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/exposure.hpp"

#include <catch2/catch.hpp>

#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

/// A single triangle whose first node hangs `height` above a place of a sheet of 4 × 4 quads of
/// 10 mm; the rest of it rises steeply.
struct Needle {
    static constexpr Index TIP = 25;
    support::Sheet sheet = support::square_sheet(4, 0.04);

    explicit Needle(const Vec3& tip) {
        sheet.append({{{0, 0, 0}, {0.001, 0, 0.05}, {0, 0.001, 0.05}}, {{0, 1, 2}}}, tip);
    }
    /// Of its tip and a triangle of the sheet.
    [[nodiscard]] double on(Index triangle) const {
        const Cloth cloth = support::cloth_of(sheet);
        const Triangle& t = cloth.triangles[triangle];
        const Pair pair{{TIP, t[0], t[1], t[2]}, false};
        const Nearest places = nearest(pair, sheet.x);
        return exposure(cloth, {0, 0}, sheet.x, pair, places, places.apart.norm());
    }
};

}  // namespace

// The sheet's first triangle has the corners (0, 0), (10, 0), (10, 10) mm
TEST_CASE("a node above a triangle's inside faces it, its neighbours it does not", "[contact]") {
    const Needle needle({0.0085, 0.003, 1e-3});
    CHECK(needle.on(0) == 1.0);
    CHECK(needle.on(1) == 0.0);  // over the diagonal, 3.9 mm away
    CHECK(needle.on(2) == 0.0);
}

TEST_CASE("a node right above an edge faces it", "[contact]") {
    const Needle needle({0.005, 0.005, 1e-3});
    CHECK(needle.on(0) == Approx(1.0).margin(1e-9));
    CHECK(needle.on(1) == Approx(1.0).margin(1e-9));
}

TEST_CASE("a free edge is faced from outside, not from inside", "[contact]") {
    CHECK(Needle({0.006, -0.002, 1e-3}).on(0) == 1.0);
}

TEST_CASE("edges beside each other in two sheets hide behind the sheets", "[contact]") {
    support::Sheet both = support::square_sheet(4, 0.04);
    both.append(support::square_sheet(4, 0.04), {0.0, 0.001, 1e-3});
    const Cloth cloth = support::cloth_of(both);
    const auto of = [&](Index a, Index b, Index c, Index d) {
        const Pair pair{{a, b, c, d}, true};
        const Nearest places = nearest(pair, both.x);
        return exposure(cloth, {0, 0}, both.x, pair, places, places.apart.norm());
    };
    CHECK(of(6, 7, 25 + 6, 25 + 7) == 0.0);                       // side by side
    CHECK(of(6, 7, 25 + 1, 25 + 6) == Approx(1.0).margin(1e-9));  // across
}
