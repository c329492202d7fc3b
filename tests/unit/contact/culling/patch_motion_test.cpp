// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

#include "contact/culling/patch_motion.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

constexpr double SPAN = 1e-5;  ///< [s]
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
};

void step(PatchMotion& motion, const Flying& flying, int n) {
    const Points x = flying.at(n * SPAN), next = flying.at((n + 1) * SPAN);
    const Points v = support::velocity_between(x, next, SPAN);
    motion.foresee(v, SPAN);
    motion.follow(next);
}

}  // namespace

TEST_CASE("two patches' nodes move against each other by no more than their drifts", "[contact]") {
    const Flying flying;
    PatchMotion motion(flying.cloth);
    motion.start(flying.at(0.0));
    Points marked = flying.at(0.0);
    double measured = 0.0, greatest = 0.0;
    for (int n = 0; n < 60; ++n) {
        const Points x = flying.at(n * SPAN);
        if (n == 25) {
            motion.mark(x);
            marked = x;
        }
        if (n % 8 == 0)
            for (std::size_t p = 0; p < motion.size(); p += 2)
                motion.measure(static_cast<Index>(p), x);
        for (std::size_t p = 0; p < motion.size(); ++p)
            for (std::size_t q = p + 1; q < motion.size(); ++q) {
                double most = 0.0;
                for (const Index i : motion.nodes(p))
                    for (const Index j : motion.nodes(q))
                        most = std::max(most, ((x[i] - x[j]) - (marked[i] - marked[j])).norm());
                const double bound =
                    motion.gone(static_cast<Index>(p)) + motion.gone(static_cast<Index>(q));
                CHECK(most <= bound + 1e-12);
                if ((n == 24 || n == 48) && p % 2 == 0 && q % 2 == 0)
                    measured = std::max(measured, bound);
                greatest = std::max(greatest, most);
            }
        step(motion, flying, n);
    }
    CHECK(greatest > 5e-3);
    CHECK(measured < 0.5 * 24 * SPAN * FLIGHT.norm());  // flying together is none
}
