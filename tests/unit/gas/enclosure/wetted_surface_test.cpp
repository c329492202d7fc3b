// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Which sides of a bag's walls face the same gas.

#include "gas/enclosure/wetted_surface.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>

#include "gas/enclosure/side_patches.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// A box of nx × 1 × 1 cells of edge 1; membranes across it at whole x.
struct Boxes {
    Points x;
    std::vector<Triangle> triangles;
    std::size_t closing = 0;

    Index node(int i, int j, int k) const { return 4 * i + 2 * k + j; }
    explicit Boxes(int n) {
        for (int i = 0; i <= n; ++i)
            for (int k = 0; k < 2; ++k)
                for (int j = 0; j < 2; ++j) x.emplace_back(i, j, k);
        const auto quad = [&](Index a, Index b, Index c, Index d) {
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        };
        quad(node(0, 0, 0), node(0, 0, 1), node(0, 1, 1), node(0, 1, 0));
        quad(node(n, 0, 0), node(n, 1, 0), node(n, 1, 1), node(n, 0, 1));
        for (int i = 0; i < n; ++i) {
            quad(node(i, 0, 0), node(i, 1, 0), node(i + 1, 1, 0), node(i + 1, 0, 0));
            quad(node(i, 0, 1), node(i + 1, 0, 1), node(i + 1, 1, 1), node(i, 1, 1));
            quad(node(i, 0, 0), node(i + 1, 0, 0), node(i + 1, 0, 1), node(i, 0, 1));
            quad(node(i, 1, 0), node(i, 1, 1), node(i + 1, 1, 1), node(i + 1, 1, 0));
        }
        closing = triangles.size();
    }
    void add_membrane(int i, bool is_turned, bool is_whole = true) {
        Triangle a{node(i, 0, 0), node(i, 1, 0), node(i, 1, 1)},
            b{node(i, 0, 0), node(i, 1, 1), node(i, 0, 1)};
        if (is_turned) {
            std::swap(a[1], a[2]);
            std::swap(b[1], b[2]);
        }
        triangles.push_back(a);
        if (is_whole) triangles.push_back(b);
    }
    [[nodiscard]] WettedSurface surface() const { return {triangles, closing, x}; }
};

double volume_of(const WettedSurface& surface, const Points& x, std::size_t room) {
    std::vector<double> volume;
    surface.volumes(x, volume);
    return volume[room];
}

}  // namespace

TEST_CASE("a closed surface is one room, with a point for each node", "[gas]") {
    const Boxes box(2);
    const WettedSurface surface = box.surface();
    CHECK(surface.sides() == box.triangles.size());
    CHECK(surface.rooms() == 1);
    CHECK(surface.points() == box.x.size());
    CHECK(volume_of(surface, box.x, 0) == Approx(2.0));
}

TEST_CASE("a membrane makes two rooms, whichever way its facets are turned", "[gas]") {
    Boxes box(2);
    box.add_membrane(1, GENERATE(false, true));
    const WettedSurface surface = box.surface();
    REQUIRE(surface.rooms() == 2);
    CHECK(volume_of(surface, box.x, 0) == Approx(1.0));
    CHECK(volume_of(surface, box.x, 1) == Approx(1.0));
    // The four nodes on the membrane are a point in each room.
    CHECK(surface.points() == box.x.size() + 4);
    Points area(surface.points());
    surface.point_areas(box.x, area);
    Vec3 sum[2] = {Vec3::Zero(), Vec3::Zero()};
    for (std::size_t p = 0; p < surface.points(); ++p) sum[surface.room_of_point(p)] += area[p];
    CHECK(sum[0].norm() < 1e-14);
    CHECK(sum[1].norm() < 1e-14);
    // No edge leads from one room to the other.
    for (const auto& [a, b] : surface.edges())
        CHECK(surface.room_of_point(a) == surface.room_of_point(b));
    const std::vector<Vec3> places{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}};
    const auto rooms = surface.rooms_of(places, box.x);
    CHECK(rooms[0] != rooms[1]);
    for (std::size_t f = 0; f < box.closing; ++f) {
        const auto& [a, b, c] = box.triangles[f];
        const double at = (box.x[a] + box.x[b] + box.x[c])[0] / 3.0;
        CHECK(surface.room(surface.side(f, false)) == rooms[at > 1.0 ? 1 : 0]);
    }
}

TEST_CASE("a membrane with a hole leaves one room", "[gas]") {
    Boxes box(2);
    box.add_membrane(1, false, false);
    const WettedSurface surface = box.surface();
    CHECK(surface.rooms() == 1);
    CHECK(volume_of(surface, box.x, 0) == Approx(2.0));
}

TEST_CASE("a sheet that floats in a room belongs to it on both sides", "[gas]") {
    Boxes box(3);
    box.add_membrane(1, false);
    const auto first = static_cast<Index>(box.x.size());
    for (const Vec3& x : {Vec3(2.2, 0.2, 0.3), Vec3(2.6, 0.3, 0.4), Vec3(2.4, 0.7, 0.5)})
        box.x.push_back(x);
    box.triangles.push_back({first, first + 1, first + 2});
    const WettedSurface surface = box.surface();
    REQUIRE(surface.rooms() == 2);
    const std::size_t sheet = box.triangles.size() - 1;
    const std::vector<Vec3> place{{2.5, 0.5, 0.9}};
    const Index room = surface.rooms_of(place, box.x)[0];
    CHECK(surface.room(surface.side(sheet, false)) == room);
    CHECK(surface.room(surface.side(sheet, true)) == room);
}

TEST_CASE("three membranes at one line part three wedges", "[gas]") {
    // A prism whose three side walls meet three membranes at its axis.
    Points x;
    std::vector<Triangle> triangles;
    for (int k = 0; k < 2; ++k) {
        for (int i = 0; i < 3; ++i)
            x.emplace_back(std::cos(2.0943951 * i), std::sin(2.0943951 * i), k);
        x.emplace_back(0, 0, k);
    }
    const auto at = [](int i, int k) { return static_cast<Index>(4 * k + i % 3); };
    for (int i = 0; i < 3; ++i) {
        triangles.push_back({at(i, 0), at(i + 1, 0), at(i + 1, 1)});
        triangles.push_back({at(i, 0), at(i + 1, 1), at(i, 1)});
        triangles.push_back({3, at(i + 1, 0), at(i, 0)});
        triangles.push_back({7, at(i, 1), at(i + 1, 1)});
    }
    const std::size_t closing = triangles.size();
    for (int i = 0; i < 3; ++i) {
        const bool is_turned = i == 1;
        triangles.push_back({3, is_turned ? at(i, 1) : at(i, 0), is_turned ? at(i, 0) : at(i, 1)});
        triangles.push_back({3, at(i, 1), 7});
    }
    const WettedSurface surface(triangles, closing, x);
    REQUIRE(surface.rooms() == 3);
    std::vector<double> volume;
    surface.volumes(x, volume);
    for (const double v : volume) CHECK(v == Approx(std::sqrt(27.0) / 12.0));
}

TEST_CASE("patches of one colour have no wall point in common, none reaches into another room",
          "[gas]") {
    Boxes box(40);
    box.add_membrane(13, false);
    box.add_membrane(27, true);
    const WettedSurface surface = box.surface();
    REQUIRE(surface.rooms() == 3);
    const SidePatches patches(surface);
    std::vector<std::set<Index>> points(patches.size());
    for (std::size_t s = 0; s < surface.sides(); ++s) {
        const auto patch = static_cast<std::size_t>(patches.of(s));
        CHECK(surface.room(s) == patches.room(patch));
        points[patch].insert(surface.points(s).begin(), surface.points(s).end());
    }
    std::size_t count = 0;
    for (std::size_t colour = 0; colour < patches.colours(); ++colour) {
        std::set<Index> all;
        std::size_t sum = 0;
        for (const Index patch : patches.of_colour(colour)) {
            all.insert(points[patch].begin(), points[patch].end());
            sum += points[patch].size();
            ++count;
        }
        CHECK(all.size() == sum);
    }
    CHECK(count == patches.size());
    CHECK(patches.size() > 20);
    // Whoever comes later in by_colour() and has a point in common waits
    const auto meets = [&](std::size_t a, std::size_t b) {
        const auto &of_a = points[static_cast<std::size_t>(patches.by_colour()[a])],
                   &of_b = points[static_cast<std::size_t>(patches.by_colour()[b])];
        return std::any_of(of_a.begin(), of_a.end(), [&](Index p) { return of_b.count(p) > 0; });
    };
    for (std::size_t later = 0; later < patches.size(); ++later) {
        const auto before = patches.before(later);
        for (std::size_t first = 0; first < later; ++first)
            REQUIRE(meets(first, later) == (std::find(before.begin(), before.end(),
                                                      static_cast<Index>(first)) != before.end()));
    }
}
