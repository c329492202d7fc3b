// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/separation.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "contact/geometry/distance.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

/// Nodes of a pair somewhere in a unit cube, now and late.
struct MovingPair {
    Corners now, late;

    explicit MovingPair(std::mt19937& random) {
        std::uniform_real_distribution<double> any(-0.5, 0.5);
        const auto anywhere = [&] {  // in this order with every compiler
            const double z = any(random), y = any(random), x = any(random);
            return Vec3(x, y, z);
        };
        for (int k = 0; k < 4; ++k) {
            now[k] = anywhere();
            late[k] = now[k] + 0.5 * anywhere();
        }
    }
    [[nodiscard]] Corners at(double share) const {
        Corners x;
        for (int k = 0; k < 4; ++k) x[k] = now[k] + share * (late[k] - now[k]);
        return x;
    }
};

template <int CORNERS>
void put(const MovingPair& pair, int first, int lane, EightMoving<CORNERS>& into) {
    for (int c = 0; c < CORNERS; ++c)
        for (int k = 0; k < 3; ++k) {
            into.now[c][k][lane] = static_cast<float>(pair.now[first + c][k]);
            into.late[c][k][lane] = static_cast<float>(pair.late[first + c][k]);
        }
}

/// The separation now is the distance, and on the line to that late it is never above it.
/// @returns how far off the distance it is at most
template <int A, int B>
double check_pairs(bool is_edges) {
    constexpr double ROUNDING = 2e-6;
    std::mt19937 random(7);
    double off = 0.0;
    for (int n = 0; n < 500; ++n) {
        std::vector<MovingPair> pairs;
        EightMoving<A> a;
        EightMoving<B> b;
        for (int lane = 0; lane < EIGHT; ++lane) {
            pairs.emplace_back(random);
            put(pairs.back(), 0, lane, a);
            put(pairs.back(), A, lane, b);
        }
        const EightSeparations apart = separations(a, b);
        for (int lane = 0; lane < EIGHT; ++lane) {
            const Pair nodes{{0, 1, 2, 3}, is_edges};
            const double length = std::sqrt(static_cast<double>(apart.square[lane]));
            const double now = static_cast<double>(apart.now[lane]) / length;
            const double late = static_cast<double>(apart.late[lane]) / length;
            const double distance = nearest(nodes, pairs[lane].now).apart.norm();
            off = std::max(off, distance - now);
            for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0})
                REQUIRE(now + share * (late - now) <=
                        nearest(nodes, pairs[lane].at(share)).apart.norm() + ROUNDING);
        }
    }
    return off;
}

}  // namespace

TEST_CASE("eight edges at once: the separation is the distance, and a bound of what it becomes",
          "[contact]") {
    CHECK(check_pairs<2, 2>(true) < 1e-4);
}

TEST_CASE("eight nodes and triangles at once: the separation is the distance, and a bound",
          "[contact]") {
    // of slivers the foot is less exact in single precision: not the nearest place, still a bound
    CHECK(check_pairs<1, 3>(false) < 1e-3);
}

TEST_CASE("parallel edges and edges without length have finite separations", "[contact]") {
    EightMoving<2> p{}, q{};  // both along x, 1 apart; the last four without length
    for (int lane = 0; lane < EIGHT; ++lane) {
        p.now[1][0][lane] = p.late[1][0][lane] = lane < 4 ? 1.0F : 0.0F;
        q.now[1][0][lane] = q.late[1][0][lane] = lane < 4 ? 2.0F : 0.0F;
        for (int c = 0; c < 2; ++c) q.now[c][1][lane] = q.late[c][1][lane] = 1.0F;
    }
    const EightSeparations apart = separations(p, q);
    for (int lane = 0; lane < EIGHT; ++lane) {
        CHECK(apart.square[lane] == 1.0F);
        CHECK(apart.now[lane] == 1.0F);
        CHECK(apart.late[lane] == 1.0F);
    }
}
