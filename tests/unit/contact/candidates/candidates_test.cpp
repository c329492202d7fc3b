// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <random>
#include <set>

#include "contact/candidates/candidates.hpp"
#include "tests/support/geometry/brute_force.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

constexpr double REACH = 1.5, DT = 1e-5;  ///< [contact thicknesses], [s]

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

void tell_distance(Candidates& pairs, std::size_t i, const Points& x) {
    const Vec3 apart = nearest(pairs[i], x).apart;
    pairs.tell_distance(i, apart, apart.norm(), x);
}

auto insert_into(std::set<Named>& names, const Candidates& pairs) {
    return [&](std::size_t i) { names.insert(name(pairs[i])); };
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

/// Cloth that is thrown into random waves, so high that it meets itself, and goes on moving.
class Crumpling {
public:
    /// @param height  of the waves, in sizes of the cloth
    Crumpling(const Points& flat, double size, unsigned seed, double height = 0.1) : flat_(flat) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> any(-1.0, 1.0);
        for (Wave& wave : waves_) {
            wave.height = height * size * Vec3(any(random), any(random), any(random));
            wave.along = 20.0 / size * Vec3(any(random), any(random), 0.0);
            wave.phase = M_PI * any(random);
            wave.frequency = 3e3 * any(random);
        }
        flight_ = 50.0 * Vec3(any(random), any(random), any(random));
    }
    [[nodiscard]] Points at(double t) const {
        Points x = flat_;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += t * flight_;
            for (const Wave& wave : waves_)
                x[i] += wave.height *
                        std::sin(wave.along.dot(flat_[i]) + wave.phase + wave.frequency * t);
        }
        return x;
    }

private:
    struct Wave {
        Vec3 height, along;
        double phase, frequency;
    };
    Points flat_;
    std::array<Wave, 5> waves_;
    Vec3 flight_;
};

/// Is the pair one of two triangles that cross? Such pairs are left alone.
bool crosses(const Pair& pair, const std::vector<Triangle>& triangles,
             const std::vector<std::pair<Index, Index>>& crossing) {
    const auto holds = [&](Index triangle, int from, int to) {
        const Triangle& t = triangles[triangle];
        return std::all_of(pair.node.begin() + from, pair.node.begin() + to,
                           [&](Index n) { return n == t[0] || n == t[1] || n == t[2]; });
    };
    const int split = pair.is_edges ? 2 : 1;
    return std::any_of(crossing.begin(), crossing.end(), [&](const auto& both) {
        const auto [a, b] = both;
        return (holds(a, 0, split) && holds(b, split, 4)) ||
               (holds(b, 0, split) && holds(a, split, 4));
    });
}

/// Brings the lists to x at t, and looks at the step ahead.
void lead(Candidates& pairs, bool is_start, const Points& x, const Points& v, double t, double dt) {
    if (is_start)
        pairs.start(x, v, t, dt);
    else
        pairs.follow(x, t, dt);
    pairs.foresee(x, v, t, dt);
}

}  // namespace

TEST_CASE("of 200 random crumpled states, moving, nothing near or about to meet is missed",
          "[contact]") {
    const support::Sheet sheet = support::square_sheet(6, 0.06);
    const auto everything = all_pairs(sheet.triangles, sheet.x.size());
    const Cloth fixed = support::cloth_of(sheet);
    std::size_t near = 0, meeting = 0, listed = 0;
    for (unsigned state = 0; state < 200; ++state) {
        const Crumpling motion(sheet.x, 0.06, state);
        Candidates pairs(fixed, REACH);
        const auto left_alone = brute_force::crossings(sheet.triangles, motion.at(0.0));
        for (int n = 0; n < 12; ++n) {
            const Points x = motion.at(n * DT), next = motion.at((n + 1) * DT);
            const Points v = support::velocity_between(x, next, DT);
            lead(pairs, n == 0, x, v, n * DT, DT);
            if (n == 0) REQUIRE(pairs.crossing() == left_alone);
            std::set<Named> due, may_meet;
            pairs.for_each_meeting(0, pairs.size(), insert_into(may_meet, pairs));
            pairs.for_each_due(0, pairs.size(), insert_into(due, pairs));
            pairs.for_each_due(0, pairs.size(), [&](std::size_t i) { tell_distance(pairs, i, x); });
            if (n % 11 != 0) continue;  // fresh lists, and lists that have lived
            listed += pairs.size();
            for (const Pair& pair : everything) {
                const double now = nearest(pair, corners(pair, x)).apart.norm();
                const double later = nearest(pair, corners(pair, next)).apart.norm();
                const bool is_near = now < REACH * fixed.greatest_thickness,
                           meets = later < 0.2 * now;
                if ((!is_near && !meets) || crosses(pair, sheet.triangles, left_alone)) continue;
                near += is_near;
                meeting += meets;
                if (is_near) REQUIRE(due.count(name(pair)) == 1);
                if (meets) REQUIRE(may_meet.count(name(pair)) == 1);
            }
        }
    }
    CHECK(near > 5'000);
    CHECK(meeting > 10);
    CHECK(listed < 400 * everything.size() / 2);  // the lists do leave most pairs out
}

TEST_CASE("where most of the cloth lies open, nothing near is missed either", "[contact]") {
    const support::Sheet sheet = support::square_sheet(16, 0.16);
    const auto everything = all_pairs(sheet.triangles, sheet.x.size());
    const Cloth fixed = support::cloth_of(sheet);
    std::size_t near = 0;
    for (unsigned state = 0; state < 10; ++state) {
        const Crumpling motion(sheet.x, 0.16, state, 0.01 * (1 + state % 5));
        Candidates pairs(fixed, REACH);
        const auto left_alone = brute_force::crossings(sheet.triangles, motion.at(0.0));
        for (int n = 0; n < 40; ++n) {
            const Points x = motion.at(n * DT), next = motion.at((n + 1) * DT);
            const Points v = support::velocity_between(x, next, DT);
            lead(pairs, n == 0, x, v, n * DT, DT);
            std::set<Named> due;
            pairs.for_each_due(0, pairs.size(), insert_into(due, pairs));
            pairs.for_each_due(0, pairs.size(), [&](std::size_t i) { tell_distance(pairs, i, x); });
            if (n % 13 != 0) continue;
            for (const Pair& pair : everything) {
                if (nearest(pair, corners(pair, x)).apart.norm() >=
                        REACH * fixed.greatest_thickness ||
                    crosses(pair, sheet.triangles, left_alone))
                    continue;
                ++near;
                REQUIRE(due.count(name(pair)) == 1);
            }
        }
    }
    CHECK(near > 100);
}

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
    Candidates pairs(fixed, REACH);
    const auto everything = all_pairs(sheet.triangles, flat.size());

    std::size_t near = 0, meeting = 0;
    for (int n = 0; n < 200; ++n) {
        const double t = n * dt;
        const Points x = place(t), next = place(t + dt);
        const Points v = support::velocity_between(x, next, dt);
        lead(pairs, n == 0, x, v, t, dt);
        std::set<Named> due, may_meet;
        pairs.for_each_meeting(0, pairs.size(), insert_into(may_meet, pairs));
        pairs.for_each_due(0, pairs.size(), insert_into(due, pairs));
        pairs.for_each_due(0, pairs.size(), [&](std::size_t i) { tell_distance(pairs, i, x); });
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

TEST_CASE("nodes that dash off are predicted anew and nothing that they come near is missed",
          "[contact]") {
    support::Sheet sheet = support::square_sheet(12, 0.12);
    sheet.append(support::square_sheet(12, 0.12), {0.001, 0.002, 4e-3});
    const Cloth fixed = support::cloth_of(sheet);
    const auto everything = all_pairs(sheet.triangles, sheet.x.size());
    Candidates pairs(fixed, REACH);
    std::size_t near = 0, missed = 0;
    for (int n = 0; n < 200; ++n) {
        // four nodes stand, dash to the other sheet, stand there, and dash back, one after the
        // other
        const auto place = [&](double t) {
            Points x = sheet.x;
            for (const std::size_t node : {40, 97, 200, 260}) {
                const double at = std::fmod(t / DT + 0.1 * static_cast<double>(node), 80.0);
                const double a = std::clamp(0.1 * (at - 30.0), 0.0, 1.0) -
                                 std::clamp(0.1 * (at - 70.0), 0.0, 1.0);
                x[node].z() += (node < 169 ? 1.0 : -1.0) * 3.4e-3 * a;
                x[node].x() += 8e-3 * a;
            }
            return x;
        };
        const Points x = place(n * DT), next = place((n + 1) * DT);
        const Points v = support::velocity_between(x, next, DT);
        lead(pairs, n == 0, x, v, n * DT, DT);
        std::map<Named, int> due;
        pairs.for_each_due(0, pairs.size(), [&](std::size_t i) { ++due[name(pairs[i])]; });
        for (const Pair& pair : everything) {
            if (nearest(pair, corners(pair, x)).apart.norm() >= REACH * fixed.greatest_thickness)
                continue;
            ++near;
            missed += due[name(pair)] != 1;  // and none is listed twice
        }
    }
    CHECK(near > 100);
    CHECK(missed == 0);
    CHECK(pairs.renewals() > 3);
}
