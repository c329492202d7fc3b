// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <set>
#include "contact/candidates/candidates.hpp"
#include "solver/base/archive.hpp"
#include "tests/support/geometry/brute_force.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

TEST_CASE("cloth that flies without changing builds its lists once", "[contact]") {
    support::Sheet bag = support::two_panels(6, 0.1, 2e-3, true);
    support::SpringCloth cloth(bag);
    const Cloth fixed(cloth.setup({}, bag.x));
    Candidates pairs(fixed, 1.5);
    const Points v(bag.x.size(), Vec3(80, 10, -30));
    const double dt = 1e-5;
    pairs.start(bag.x, v, 0.0, dt);
    for (int n = 1; n < 90; ++n) {
        for (std::size_t i = 0; i < v.size(); ++i) bag.x[i] += dt * v[i];
        pairs.follow(bag.x, n * dt, dt);
        pairs.foresee(bag.x, v, n * dt, dt);
    }
    CHECK(pairs.builds() <=
          13);  // only the predictions' age, which doubles as none is disappointed
    std::size_t due = 0;
    pairs.for_each_due(0, pairs.size(), [&](std::size_t) { ++due; });
    CHECK(due == 0);
}

TEST_CASE("lists that are restarted in any step are renewed alike", "[contact][restart]") {
    constexpr double DT = 1e-5;
    support::Sheet sheet = support::square_sheet(30, 0.3);  // most of it lies open
    sheet.append(support::square_sheet(6, 0.06), {0.031, 0.022, 4e-3});
    const Cloth fixed = support::cloth_of(sheet);
    // the small sheet flies over the large one, whose nodes behind it dash off and come back
    const auto place = [&](double t) {
        Points x = sheet.x;
        for (std::size_t n = 31 * 31; n < x.size(); ++n) x[n].x() += 1e-3 * t / DT;
        for (std::size_t k = 0; k < 35; ++k) {
            const std::size_t node = 31 * (1 + 5 * k % 9) + 2 + 6 * k / 10;
            const double at = t / DT - 6.0 * static_cast<double>(k);
            const double a = std::clamp(0.1 * at, 0.0, 1.0) - std::clamp(0.1 * at - 2.0, 0.0, 1.0);
            x[node] += a * Vec3(6e-3, 0.0, 3e-3);
        }
        return x;
    };
    const auto state_of = [](Candidates& pairs) {
        StateWriter state;
        state(pairs);
        return state.take();
    };
    const auto told = [](const Candidates& pairs) {
        std::vector<std::size_t> all{pairs.builds(), pairs.renewals(), pairs.pairs()};
        for (std::size_t i = 0; i < pairs.size(); ++i)
            all.insert(all.end(), pairs[i].node.begin(), pairs[i].node.end());
        pairs.for_each_due(0, pairs.size(), [&](std::size_t i) { all.push_back(i); });
        pairs.for_each_meeting(0, pairs.size(), [&](std::size_t i) { all.push_back(i); });
        return all;
    };
    Candidates whole(fixed, 1.5);
    auto broken = std::make_unique<Candidates>(fixed, 1.5);
    for (int n = 0; n < 200; ++n) {
        const double t = n * DT;
        const Points x = place(t), v = support::velocity_between(x, place(t + DT), DT);
        for (Candidates* const pairs : {&whole, broken.get()}) {
            if (n == 0)
                pairs->start(x, v, t, DT);
            else
                pairs->follow(x, t, DT);
            pairs->foresee(x, v, t, DT);
        }
        CAPTURE(n, whole.builds(), whole.renewals());
        REQUIRE((told(*broken) == told(whole)));
        const std::vector<char> state = state_of(*broken);
        broken = std::make_unique<Candidates>(fixed, 1.5);
        StateReader reader(state);
        reader(*broken);
    }
    CHECK(whole.renewals() > 5);
    CHECK(whole.searched() < sheet.triangles.size());
}
