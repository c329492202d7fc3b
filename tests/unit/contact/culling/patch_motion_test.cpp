// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "contact/culling/patch_motion.hpp"
#include "tests/support/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

constexpr double DT = 1e-5;  ///< [s]
const Vec3 FLIGHT(300.0, -60.0, 90.0);

/// A sheet that flies, drifts apart patch by patch, waves and shakes.
struct Flying {
    support::SpringCloth spring{support::square_sheet(16, 0.16)};
    Cloth cloth{spring.setup({}, spring.x)};
    Points rest = spring.x, kick;

    Flying() {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> one(-1.0, 1.0);
        for (std::size_t i = 0; i < rest.size(); ++i) {
            const double a = one(random), b = one(random);
            kick.emplace_back(a, b, one(random));
        }
    }
    [[nodiscard]] Points at(double t) const {
        Points x = rest;
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] += t * FLIGHT + 5e-3 * std::sin(3e4 * t + 50.0 * rest[i].x()) * Vec3(0, 0, 1) +
                    1e-3 * kick[i] * std::sin(1e5 * t + 9.0 * kick[i].y()) +
                    40.0 * t * rest[i].cwiseProduct(Vec3(1, 0, 0));
        return x;
    }
    /// Half the most that two corners of a patch's triangle have gone against each other.  [m]
    [[nodiscard]] double flutter(Index patch, const Points& from, const Points& to) const {
        double most = 0.0;
        for (const Index t : cloth.patches[patch])
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = cloth.triangles[t][k], b = cloth.triangles[t][(k + 1) % 3];
                most = std::max(most, 0.5 * ((to[a] - to[b]) - (from[a] - from[b])).norm());
            }
        return most;
    }
};

void step(PatchMotion& motion, const Flying& flying, int n) {
    const Points x = flying.at(n * DT), next = flying.at((n + 1) * DT);
    const Points v = support::velocity_between(x, next, DT);
    motion.foresee(v, DT);
    motion.follow(next);
}

}  // namespace

TEST_CASE("flutter bounds how triangles change, from each mark to each later time", "[contact]") {
    const Flying flying;
    PatchMotion motion(flying.cloth);
    motion.start(flying.at(0.0));
    struct Mark {
        Index patch;
        double flutter;
        Points x;
    };
    std::vector<Mark> marks;
    std::mt19937 random(2);
    std::vector<double> ways(motion.size(), 0.0);
    for (int n = 0; n < 60; ++n) {
        const Points x = flying.at(n * DT);
        for (std::size_t i = 0; i < motion.size(); ++i) {
            const auto p = static_cast<Index>(i);
            if (random() % 3 == 0) motion.measure_flutter(p, x);
            if (random() % 5 != 0) continue;
            motion.mark_shape(p, x);
            marks.push_back({p, motion.gone(p).flutter, x});
        }
        for (const Mark& mark : marks)
            CHECK(motion.gone(mark.patch).flutter - mark.flutter >=
                  flying.flutter(mark.patch, mark.x, x) - 1e-12);
        for (std::size_t i = 0; i < ways.size(); ++i)
            ways[i] -= motion.gone(static_cast<Index>(i)).flutter;
        step(motion, flying, n);
        for (std::size_t i = 0; i < ways.size(); ++i)
            ways[i] += motion.gone(static_cast<Index>(i)).flutter;
    }
    CHECK(marks.size() > 50);
    // what swings back and forth has come to less than its way
    for (std::size_t i = 0; i < ways.size(); ++i)
        CHECK(motion.gone(static_cast<Index>(i)).flutter < 0.8 * ways[i]);
}

TEST_CASE("what is measured at once is what triangles have come to", "[contact]") {
    const Flying flying;
    PatchMotion motion(flying.cloth);
    const Points x0 = flying.at(0.0);
    motion.start(x0);
    for (int n = 0; n < 30; ++n) step(motion, flying, n);
    const Points x = flying.at(30 * DT);
    for (std::size_t i = 0; i < motion.size(); ++i) {
        const auto p = static_cast<Index>(i);
        motion.measure_flutter(p, x);
        CHECK(motion.gone(p).flutter == Approx(flying.flutter(p, x0, x)));
    }
}

TEST_CASE("two patches' nodes move against each other by no more than their drifts", "[contact]") {
    const Flying flying;
    PatchMotion motion(flying.cloth);
    motion.start(flying.at(0.0));
    Points marked = flying.at(0.0);
    double measured = 0.0, greatest = 0.0;
    for (int n = 0; n < 60; ++n) {
        const Points x = flying.at(n * DT);
        if (n == 25) {
            motion.mark(x);
            marked = x;
        }
        if (n % 8 == 0)
            for (std::size_t p = 0; p < motion.size(); p += 2)
                motion.measure_drift(static_cast<Index>(p), x);
        for (std::size_t p = 0; p < motion.size(); ++p)
            for (std::size_t q = p + 1; q < motion.size(); ++q) {
                double most = 0.0;
                for (const Index i : motion.nodes(p))
                    for (const Index j : motion.nodes(q))
                        most = std::max(most, ((x[i] - x[j]) - (marked[i] - marked[j])).norm());
                const double bound = motion.gone(static_cast<Index>(p)).drift +
                                     motion.gone(static_cast<Index>(q)).drift;
                CHECK(most <= bound + 1e-12);
                if ((n == 24 || n == 48) && p % 2 == 0 && q % 2 == 0)
                    measured = std::max(measured, bound);
                greatest = std::max(greatest, most);
            }
        step(motion, flying, n);
    }
    CHECK(greatest > 5e-3);
    CHECK(measured < 0.5 * 24 * DT * FLIGHT.norm());  // flying together is none
}
