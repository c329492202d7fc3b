// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include "contact/culling/flat_regions.hpp"
#include "tests/support/geometry/shapes.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

/// Least distance of nodes from triangles, and of edges from edges, without a node in common.  [m]
double least_distance(const Cloth& cloth, std::span<const Index> triangles,
                      std::span<const Index> others, const Points& x) {
    double least = INF;
    const auto look = [&](const Pair& pair) {
        least = std::min(least, nearest(pair, corners(pair, x)).apart.norm());
    };
    for (const Index t : triangles)
        for (const Index u : others) {
            const Triangle &a = cloth.triangles[t], &b = cloth.triangles[u];
            const auto is_of = [](Index n, const Triangle& of) {
                return n == of[0] || n == of[1] || n == of[2];
            };
            for (std::size_t k = 0; k < 3; ++k) {
                if (!is_of(a[k], b)) look({{a[k], b[0], b[1], b[2]}, false});
                if (!is_of(b[k], a)) look({{b[k], a[0], a[1], a[2]}, false});
                const Index i = a[k], j = a[(k + 1) % 3];
                for (std::size_t m = 0; m < 3; ++m) {
                    const Index r = b[m], s = b[(m + 1) % 3];
                    if (i != r && i != s && j != r && j != s) look({{i, j, r, s}, true});
                }
            }
        }
    return least;
}

/// Triangles of a patch and of all that share a node with it.
std::vector<Index> region(const Cloth& cloth, std::size_t patch) {
    std::vector<std::uint8_t> is_of(cloth.inverse_mass.size(), 0);
    for (const Index t : cloth.patches[patch])
        for (const Index n : cloth.triangles[t]) is_of[n] = 1;
    std::vector<Index> triangles;
    for (std::size_t q = 0; q < cloth.patches.size(); ++q) {
        const auto of_patch = cloth.patches[q];
        const auto touches = [&](Index t) {
            const Triangle& nodes = cloth.triangles[t];
            return is_of[nodes[0]] || is_of[nodes[1]] || is_of[nodes[2]];
        };
        if (std::any_of(of_patch.begin(), of_patch.end(), touches))
            triangles.insert(triangles.end(), of_patch.begin(), of_patch.end());
    }
    return triangles;
}

Points in_waves(Points x, double height, double noise, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> one(-1.0, 1.0);
    const Vec3 along(one(random), one(random), one(random)),
        wave = 60.0 * Vec3(one(random), one(random), one(random));
    for (Vec3& p : x) {
        p += height * std::sin(wave.dot(p)) * along;
        for (int k = 0; k < 3; ++k) p[k] += noise * one(random);
    }
    return x;
}

FlatRegions regions_of(const Cloth& cloth, double margin = 0.0) {
    return {cloth, std::vector<double>(cloth.patches.size(), margin)};
}

}  // namespace

TEST_CASE("nothing in a flat region is nearer than its clearance", "[contact]") {
    const auto ball = shapes::sphere(0.08, 3);
    std::size_t flat = 0, not_flat = 0;
    for (const auto& sheet :
         {support::square_sheet(20, 0.2), support::Sheet{ball.x, ball.triangles}}) {
        const Cloth cloth = support::cloth_of(sheet);
        const FlatRegions regions = regions_of(cloth);
        for (unsigned state = 0; state < 6; ++state) {
            const Points x = in_waves(sheet.x, 4e-3 * state, 5e-4 * (state % 3), state);
            for (std::size_t p = state % 3; p < cloth.patches.size(); p += 3) {
                const double clearance = regions.clearance(static_cast<Index>(p), x);
                (clearance > 0.0 ? flat : not_flat) += 1;
                if (clearance > 0.0)
                    CHECK(least_distance(cloth, region(cloth, p), region(cloth, p), x) >=
                          clearance);
            }
        }
    }
    CHECK(flat > 30);
    CHECK(not_flat > 3);
}

TEST_CASE("clearance of a flat sheet is the height of its triangles", "[contact]") {
    const support::Sheet sheet = support::square_sheet(20, 0.2);  // edges of 1 cm
    const Cloth cloth = support::cloth_of(sheet);
    const FlatRegions regions = regions_of(cloth);
    for (std::size_t p = 0; p < cloth.patches.size(); ++p)
        CHECK(regions.clearance(static_cast<Index>(p), sheet.x) ==
              Approx(0.01 / std::sqrt(2.0)).epsilon(1e-4));
}

TEST_CASE("cloth that lies on itself is not flat", "[contact]") {
    const support::Sheet flat = support::square_sheet(20, 0.2);
    const Cloth cloth = support::cloth_of(flat);
    const FlatRegions regions = regions_of(cloth);
    SECTION("folded") {
        Points x = flat.x;
        for (Vec3& p : x)
            if (p.x() > 0.1 + 1e-9) p = Vec3(0.2 - p.x(), p.y(), 2e-3);
        std::size_t found = 0;
        for (std::size_t p = 0; p < cloth.patches.size(); ++p) {
            const bool is_flat = regions.clearance(static_cast<Index>(p), x) > 0.0;
            bool has_left = false, has_right = false;
            for (const Index t : region(cloth, p))
                for (const Index n : cloth.triangles[t]) {
                    has_left |= flat.x[n].x() < 0.1 - 1e-9;
                    has_right |= flat.x[n].x() > 0.1 + 1e-9;
                }
            found += has_left && has_right;
            if (has_left && has_right) CHECK_FALSE(is_flat);
        }
        CHECK(found > 0);
    }
    SECTION("a ramp that winds over itself: no triangle is turned over, the rim crosses") {
        // a strip of 64 triangles round more than a whole turn is one patch
        support::Sheet ramp;
        for (int i = 0; i <= 32; ++i)
            for (const double radius : {0.03, 0.05}) {
                const double angle = 0.22 * i;
                ramp.x.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1e-3 * i);
            }
        for (Index i = 0; i < 32; ++i) {
            ramp.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
            ramp.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
        }
        const Cloth winding = support::cloth_of(ramp);
        const FlatRegions of_ramp = regions_of(winding);
        for (std::size_t p = 0; p < winding.patches.size(); ++p)
            CHECK(of_ramp.clearance(static_cast<Index>(p), ramp.x) == 0.0);
        Points short_of_a_turn = ramp.x;
        for (int i = 0; i <= 32; ++i)
            for (int k = 0; k < 2; ++k) {
                const double radius = k == 0 ? 0.03 : 0.05, angle = 0.15 * i;
                short_of_a_turn[2 * i + k] = {radius * std::cos(angle), radius * std::sin(angle),
                                              1e-3 * i};
            }
        for (std::size_t p = 0; p < winding.patches.size(); ++p)
            CHECK(of_ramp.clearance(static_cast<Index>(p), short_of_a_turn) > 0.0);
    }
}

TEST_CASE("what lies flat keeps its distance, however cloth moves, until it is found not to",
          "[contact]") {
    constexpr double MARGIN = 1e-3, SPAN = 1e-5;  // [m], [s]
    const support::Sheet flat = support::square_sheet(14, 0.14);
    const Cloth cloth = support::cloth_of(flat);
    std::size_t together = 0, given_up = 0;
    // Either half turns about the middle, or rows of nodes move towards each other in turn
    const auto [is_fold, speed] =
        GENERATE(table<bool, double>({{true, 0.004}, {true, 0.01}, {false, 0.02}, {false, 0.1}}));
    const auto at = [&, is_fold = is_fold, speed = speed](int n) {
        Points x = flat.x;
        const double angle = std::min(speed * n, 0.495 * std::numbers::pi);
        for (Vec3& p : x) {
            const double off = p.x() - 0.07;
            const bool is_even = std::lround(p.x() / 0.01) % 2 == 0;
            if (is_fold)
                p = {0.07 + off * std::cos(angle), p.y(), std::abs(off) * std::sin(angle)};
            else
                p.x() += (is_even ? 1.0 : -1.0) * 4.5e-3 * std::sin(angle);
        }
        return x;
    };
    FlatRegions regions = regions_of(cloth, MARGIN);
    PatchMotion motion(cloth);
    motion.start(at(0));
    bool are_held = false;
    for (int n = 0; speed * n < 1.8; ++n) {
        const Points x = at(n), next = at(n + 1);
        if (n > 0) {
            motion.follow(x);
            regions.follow();
        }
        motion.foresee(support::velocity_between(x, next, SPAN), SPAN);
        if (!are_held || !regions.hold(x, motion)) regions.find(x, motion);
        are_held = true;
        for (std::size_t p = 0; p < cloth.patches.size(); ++p)
            for (std::size_t q = p; q < cloth.patches.size(); ++q) {
                if (!regions.are_flat(static_cast<Index>(p), static_cast<Index>(q))) {
                    ++given_up;
                    continue;
                }
                ++together;
                CHECK(least_distance(cloth, cloth.patches[p], cloth.patches[q], next) >=
                      2.0 * MARGIN);
            }
    }
    CHECK(together > 10);
    CHECK(given_up > 10);
}
