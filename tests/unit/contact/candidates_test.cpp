// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <set>

#include "contact/candidates.hpp"
#include "tests/support/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

using Named = std::array<Index, 5>;  ///< a pair whatever the order of its nodes

Named name(Pair pair) {
    auto& n = pair.node;
    if (pair.is_edges) {
        if (n[0] > n[1]) std::swap(n[0], n[1]);
        if (n[2] > n[3]) std::swap(n[2], n[3]);
        if (n[0] > n[2]) std::swap(n[0], n[2]), std::swap(n[1], n[3]);
    } else {
        std::sort(n.begin() + 1, n.end());
    }
    return {pair.is_edges, n[0], n[1], n[2], n[3]};
}

/// Every node against every triangle and every edge against every edge that has no node in common.
std::vector<Pair> all_pairs(const std::vector<Triangle>& triangles, std::size_t nodes) {
    std::vector<Pair> pairs;
    std::set<std::pair<Index, Index>> edges;
    for (const Triangle& t : triangles) {
        for (std::size_t n = 0; n < nodes; ++n) {
            const auto i = static_cast<Index>(n);
            if (i != t[0] && i != t[1] && i != t[2])
                pairs.push_back({{i, t[0], t[1], t[2]}, false});
        }
        for (std::size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    }
    for (const auto& a : edges)
        for (const auto& b : edges)
            if (a < b && a.first != b.first && a.first != b.second && a.second != b.first &&
                a.second != b.second)
                pairs.push_back({{a.first, a.second, b.first, b.second}, true});
    return pairs;
}

}  // namespace

TEST_CASE("whatever is near is due, and whatever may meet is known, as in a list of all pairs",
          "[contact]") {
    support::Sheet sheet = support::square_sheet(9, 0.1);
    const Points flat = sheet.x;
    const double dt = 1e-5;
    const auto place = [&](double t) {  // crumples, and flies off at 30 m/s
        Points x = flat;
        for (Vec3& p : x) {
            const double u = 60 * p.x(), w = 50 * p.y(), a = 400 * t;
            p = {p.x() * (1 - 1.2 * a) + 0.01 * a * std::sin(w + 3 * a),
                 p.y() + 0.02 * a * std::sin(u), 0.02 * a * std::cos(u + w) * (1 - a) + 30 * t};
        }
        return x;
    };
    support::SpringCloth cloth(sheet);
    ContactCard card;
    card.thickness = 1e-3;
    const Cloth fixed(cloth.setup(card, flat));
    constexpr double REACH = 1.5;
    Candidates pairs(fixed, REACH);
    const auto everything = all_pairs(sheet.triangles, flat.size());

    std::size_t near = 0, meeting = 0;
    for (int n = 0; n < 200; ++n) {
        const double t = n * dt;
        const Points x = place(t), next = place(t + dt);
        Points v(x.size());
        for (std::size_t i = 0; i < x.size(); ++i) v[i] = (next[i] - x[i]) / dt;
        if (n == 0)
            pairs.start(x, v, t, dt, std::vector<std::uint8_t>{1});
        else
            pairs.follow(x, t);
        pairs.foresee(x, v, t, dt);
        std::set<Named> due, may_meet;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (pairs.is_due(i)) due.insert(name(pairs[i]));
            if (pairs.may_meet(i)) may_meet.insert(name(pairs[i]));
            if (pairs.is_due(i))
                pairs.tell_distance(i, nearest(pairs[i], corners(pairs[i], x)).apart.norm());
        }
        if (n % 10 != 0) continue;
        for (const Pair& pair : everything) {
            const double now = nearest(pair, corners(pair, x)).apart.norm();
            if (now < REACH * card.thickness) {
                ++near;
                REQUIRE(due.count(name(pair)) == 1);
            }
            const double later = nearest(pair, corners(pair, next)).apart.norm();
            if (later < 0.2 * now) {
                ++meeting;
                REQUIRE(may_meet.count(name(pair)) == 1);
            }
        }
    }
    CHECK(near > 100);
    CHECK(pairs.builds() < 100);
    CHECK(pairs.builds() > 2);
}

TEST_CASE("cloth that flies without changing builds its lists once", "[contact]") {
    support::Sheet bag = support::two_panels(6, 0.1, 2e-3, true);
    support::SpringCloth cloth(bag);
    const Cloth fixed(cloth.setup({}, bag.x));
    Candidates pairs(fixed, 1.5);
    const Points v(bag.x.size(), Vec3(80, 10, -30));
    const double dt = 1e-5;
    pairs.start(bag.x, v, 0.0, dt, std::vector<std::uint8_t>{1});
    for (int n = 1; n < 90; ++n) {
        for (std::size_t i = 0; i < v.size(); ++i) bag.x[i] += dt * v[i];
        pairs.follow(bag.x, n * dt);
        pairs.foresee(bag.x, v, n * dt, dt);
    }
    CHECK(pairs.builds() <=
          13);  // only the predictions' age, which doubles as none is disappointed
    std::size_t due = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) due += pairs.is_due(i);
    CHECK(due == 0);
}
