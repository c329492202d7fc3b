// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <limits>
#include <random>

#include "contact/broad_phase/broad_phase.hpp"
#include "tests/support/geometry/brute_force.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using Pairs = std::vector<std::pair<Index, Index>>;

namespace {

/// n boxes in a unit cube; on a lattice their ends coincide and some have no thickness.
std::vector<Box> random_boxes(std::size_t n, double size, bool on_lattice, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0.0, 1.0);
    std::vector<Box> boxes(n);
    for (Box& box : boxes) {
        Vec3 low, edge;
        for (int k = 0; k < 3; ++k) {
            low[k] = place(random);
            edge[k] = size * place(random);
        }
        if (on_lattice) {
            low = (low / size).array().floor() * size;
            edge = (2.0 * edge / size).array().floor() * size;  // 0 or 1 cell
        }
        box = {low, low + edge};
    }
    return boxes;
}

/// The same pairs, asked for box by box.
Pairs asked_for(const BroadPhase& broad_phase, std::span<const Box> boxes) {
    Pairs out;
    std::vector<Index> overlapped;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        broad_phase.overlapping(boxes[i], overlapped);
        for (const Index j : overlapped)
            if (j > static_cast<Index>(i)) out.emplace_back(static_cast<Index>(i), j);
    }
    return out;
}

Pairs self_pairs(const BroadPhase& broad_phase) {
    Pairs out;
    broad_phase.self_pairs(out);
    return out;
}

}  // namespace

TEST_CASE("the broad phase finds just the pairs that brute force finds", "[contact]") {
    const bool on_lattice = GENERATE(false, true);
    BroadPhase broad_phase;
    for (unsigned seed = 0; seed < 10; ++seed) {
        // the same objects, more and fewer of them
        const auto boxes = random_boxes(seed % 2 ? 500 : 300, 0.1, on_lattice, seed);
        broad_phase.update(boxes);
        const Pairs expected = brute_force::self_pairs(boxes);
        REQUIRE(expected.size() > 10);
        REQUIRE(self_pairs(broad_phase) == expected);
        REQUIRE(asked_for(broad_phase, boxes) == expected);
    }
}

TEST_CASE("boxes that move are found wherever they are", "[contact]") {
    std::vector<Box> boxes = random_boxes(300, 0.1, false, 3);
    std::mt19937 random(4);
    std::normal_distribution<double> velocity(0.0, 0.02);
    std::vector<Vec3> v(boxes.size());
    for (Vec3& own : v) own = {velocity(random), velocity(random), velocity(random)};
    BroadPhase broad_phase;
    for (int step = 0; step < 50; ++step) {
        for (std::size_t i = 0; i < boxes.size(); ++i)
            boxes[i] = {boxes[i].low + v[i], boxes[i].high + v[i]};
        broad_phase.update(boxes);
        REQUIRE(self_pairs(broad_phase) == brute_force::self_pairs(boxes));
    }
}

TEST_CASE("boxes without thickness, all in one plane or all alike, are found", "[contact]") {
    std::vector<Box> boxes = random_boxes(200, 0.1, false, 7);
    SECTION("flat") {
        for (Box& box : boxes) box.low.z() = box.high.z() = 0.0;
    }
    SECTION("on a line") {
        for (Box& box : boxes) box.low.tail<2>() = box.high.tail<2>() = Vec3::Zero().tail<2>();
    }
    SECTION("all alike") {
        for (Box& box : boxes) box = boxes.front();
    }
    SECTION("all one point") {
        for (Box& box : boxes) box = {Vec3::Ones(), Vec3::Ones()};
    }
    BroadPhase broad_phase;
    broad_phase.update(boxes);
    REQUIRE(self_pairs(broad_phase) == brute_force::self_pairs(boxes));
    REQUIRE(asked_for(broad_phase, boxes) == brute_force::self_pairs(boxes));
}

TEST_CASE("no boxes and one box have no pairs", "[contact]") {
    BroadPhase none, one;
    none.update({});
    one.update(random_boxes(1, 0.1, false, 1));
    Pairs found{{1, 2}};
    none.self_pairs(found);
    CHECK(found.empty());
    one.self_pairs(found);
    CHECK(found.empty());
    const auto single = random_boxes(1, 0.1, false, 1);
    std::vector<Index> overlapped{7};
    none.overlapping(single.front(), overlapped);
    CHECK(overlapped.empty());
    one.overlapping(single.front(), overlapped);
    CHECK(overlapped == std::vector<Index>{0});
}

TEST_CASE("a box that is not finite or inside out is refused", "[contact]") {
    auto boxes = random_boxes(5, 0.1, false, 1);
    BroadPhase broad_phase;
    SECTION("NaN") {
        boxes[3].low.y() = NaN;
    }
    SECTION("infinite") {
        boxes[3].high.y() = INF;
    }
    SECTION("inside out") {
        boxes[3].low.y() = boxes[3].high.y() + 1.0;
    }
    CHECK_THROWS_WITH(broad_phase.update(boxes), Catch::Contains("box 3"));
}
