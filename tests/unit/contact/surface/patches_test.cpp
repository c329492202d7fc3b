// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "contact/surface/patches.hpp"
#include "tests/support/geometry/cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

void check_partition(const Patches& patches, std::size_t triangles) {
    REQUIRE(patches.start.front() == 0);
    REQUIRE(static_cast<std::size_t>(patches.start.back()) == triangles);
    std::vector<Index> all = patches.triangle;
    std::sort(all.begin(), all.end());
    for (std::size_t t = 0; t < triangles; ++t) REQUIRE(all[t] == static_cast<Index>(t));
}

/// Box of a patch's triangles.
Box patch_box(const Patches& patches, std::size_t patch, std::span<const Triangle> triangles,
              std::span<const Vec3> x) {
    Box box;
    for (const Index t : patches[patch]) box.include(triangle_box(triangles[t], x, x, 0.0));
    return box;
}

}  // namespace

TEST_CASE("every triangle is in one patch of the promised size", "[contact]") {
    const support::Sheet sheet = support::square_sheet(40, 0.6);
    const Patches patches = make_patches(sheet.x, sheet.triangles);
    check_partition(patches, sheet.triangles.size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        REQUIRE(patches[p].size() >= 32);
        REQUIRE(patches[p].size() <= 64);
    }
}

TEST_CASE("patches of a sheet are compact", "[contact]") {
    const support::Sheet sheet = support::square_sheet(64, 1.0);
    const Patches patches = make_patches(sheet.x, sheet.triangles);
    double area = 0.0;
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const Box box = patch_box(patches, p, sheet.triangles, sheet.x);
        area += (box.high - box.low).x() * (box.high - box.low).y();
    }
    CHECK(area < 2.5);  // squares would cover the sheet's 1 m² once
}

TEST_CASE("two separate panels that lie on each other share no patch", "[contact]") {
    const support::Sheet bag = support::two_panels(24, 0.6, 0.0, false);
    const Patches patches = make_patches(bag.x, bag.triangles);
    check_partition(patches, bag.triangles.size());
    const auto panel = static_cast<Index>(bag.triangles.size() / 2);
    for (std::size_t p = 0; p < patches.size(); ++p)
        REQUIRE((patches[p].front() < panel) == (patches[p].back() < panel));
}

TEST_CASE("patches of a flat seamed bag stay compact when it is inflated", "[contact]") {
    support::Sheet bag = support::two_panels(24, 0.6, 0.0, true);
    const Patches patches = make_patches(bag.x, bag.triangles);
    check_partition(patches, bag.triangles.size());
    // lift the panels apart into a pillow that is 0.6 m high
    const std::size_t lower_nodes = 25 * 25;
    for (std::size_t i = 0; i < bag.x.size(); ++i) {
        Vec3& x = bag.x[i];
        const double rim = std::min({x.x(), x.y(), 0.6 - x.x(), 0.6 - x.y()});
        x.z() += i < lower_nodes ? -rim : rim;
    }
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const Box box = patch_box(patches, p, bag.triangles, bag.x);
        CHECK((box.high - box.low).norm() < 0.35);  // a patch in the middle of both would have 0.6
    }
}

TEST_CASE("the box of a moving triangle holds it at both ends", "[contact]") {
    const support::Sheet sheet = support::square_sheet(10, 1.0);
    Points x_1 = sheet.x;
    for (Vec3& x : x_1) x.z() += 0.5;
    for (const Triangle& t : sheet.triangles) {
        const Box box = triangle_box(t, sheet.x, x_1, 0.01);
        CHECK(box.low.z() == Approx(-0.01));
        CHECK(box.high.z() == Approx(0.51));
        for (const Index n : t) CHECK(box.overlaps({sheet.x[n], sheet.x[n]}));
    }
}

TEST_CASE("no triangles make no patches", "[contact]") {
    CHECK(make_patches({}, {}).size() == 0);
}
