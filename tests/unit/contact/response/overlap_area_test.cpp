// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/overlap_area.hpp"

#include <Eigen/Geometry>

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <utility>

#include "contact/surface/rigid_proxies.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

constexpr double GAP = 1e-3;

/// A sheet of 40 mm above one of 60 mm, turned and moved.
struct Pressed {
    Pressed(double angle, const Vec3& shift) : sheets(support::square_sheet(6, 0.06)) {
        support::Sheet upper = support::square_sheet(7, 0.04);
        const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
        const Vec3 middle(0.02, 0.02, 0.0);
        for (Vec3& x : upper.x) x = turn * (x - middle) + middle;
        below = static_cast<Index>(sheets.x.size());
        sheets.append(upper, shift + Vec3(0.0, 0.0, GAP));
    }
    support::Sheet sheets;
    Index below = 0;  ///< nodes of the larger one
};

using Edges = std::set<std::pair<Index, Index>>;

Edges edges_of(const support::Sheet& sheet) {
    Edges edges;
    for (const Triangle& t : sheet.triangles)
        for (int k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
    return edges;
}

/// All pairs of the two sheets whose nearest places lie above each other.
std::vector<Contact> contacts_of(const Pressed& pressed, const Cloth& cloth) {
    std::vector<Contact> contacts;
    const Points& x = pressed.sheets.x;
    const auto try_pair = [&](const Pair& pair) {
        const Nearest places = nearest(pair, x);
        if (!places.is_inside || places.apart.head<2>().norm() > 1e-12) return;
        contacts.push_back(contact_at(cloth, {}, x, pair, places, GAP));
    };
    const auto is_above = [&](Index n) { return n >= pressed.below; };
    for (Index n = 0; n < static_cast<Index>(x.size()); ++n)
        for (const Triangle& t : pressed.sheets.triangles)
            if (is_above(n) != is_above(t[0])) try_pair({{n, t[0], t[1], t[2]}, false});
    for (const auto& [a, b] : edges_of(pressed.sheets))
        for (const auto& [c, d] : edges_of(pressed.sheets))
            if (!is_above(a) && is_above(c)) try_pair({{a, b, c, d}, true});
    return contacts;
}

/// A third of the triangles of each node.                                               [m^2]
std::vector<double> node_areas(const support::Sheet& sheet) {
    std::vector<double> area(sheet.x.size(), 0.0);
    for (const Triangle& t : sheet.triangles)
        for (const Index n : t)
            area[n] += vector_area(sheet.x[t[0]], sheet.x[t[1]], sheet.x[t[2]]).norm() / 3.0;
    return area;
}

/// What contacts of one pressure give to each node, over that pressure.                 [m^2]
std::vector<double> pressed_areas(const Pressed& pressed, const Cloth& cloth) {
    std::vector<double> sum(pressed.sheets.x.size(), 0.0);
    for (const Contact& c : contacts_of(pressed, cloth)) {
        const double area = overlap_area(cloth, pressed.sheets.x, c).area;
        for (int k = 0; k < 4; ++k) sum[c.node[k]] += std::abs(c.weight[k]) * area;
    }
    return sum;
}

}  // namespace

TEST_CASE("contacts of flat sheets press each node as a uniform pressure does, however they lie",
          "[contact]") {
    const auto [angle, shift] = GENERATE(table<double, Vec3>({{0.3, {0.0107, 0.0113, 0.0}},
                                                              {1.1, {0.0031, 0.0077, 0.0}},
                                                              {2.9, {0.0202, 0.0051, 0.0}},
                                                              {0.0, {0.0043, 0.0061, 0.0}}}));
    const Pressed pressed(angle, shift);
    const Cloth cloth = support::cloth_of(pressed.sheets);
    const std::vector<double> sum = pressed_areas(pressed, cloth),
                              area = node_areas(pressed.sheets);
    const auto is_over_other = [&](Index n) {
        Vec3 x = pressed.sheets.x[n];
        double size = 0.06;
        if (n < pressed.below) {
            const Vec3 middle = shift + Vec3(0.02, 0.02, 0.0);
            x = Eigen::AngleAxisd(-angle, Vec3::UnitZ()) * (x - middle) + Vec3(0.02, 0.02, 0.0);
            size = 0.04;
        }
        return std::min(x.x(), x.y()) >= 0.0 && std::max(x.x(), x.y()) <= size;
    };
    std::vector<char> is_covered(sum.size(), 1);  // with all triangles round it
    for (const Triangle& t : cloth.triangles)
        for (const Index n : t)
            for (const Index other : t) is_covered[n] &= is_over_other(other) ? 1 : 0;
    int below = 0, above = 0;
    for (Index n = 0; n < static_cast<Index>(sum.size()); ++n) {
        CHECK(sum[n] <= area[n] * (1.0 + 1e-5));
        if (is_covered[n] == 0) continue;
        (n < pressed.below ? below : above) += 1;
        CHECK(sum[n] == Approx(area[n]).epsilon(1e-5));
    }
    CHECK(below > 0);
    CHECK(above > 30);
}

TEST_CASE("a small sheet on a large one is pressed whole, and its weight lies where it lies",
          "[contact]") {
    const Pressed pressed(0.37, {0.0107, 0.0113, 0.0});
    const Cloth cloth = support::cloth_of(pressed.sheets);
    const std::vector<double> sum = pressed_areas(pressed, cloth),
                              area = node_areas(pressed.sheets);
    Vec3 above = Vec3::Zero(), below = Vec3::Zero();
    double most = 0.0;
    for (Index n = 0; n < static_cast<Index>(sum.size()); ++n) {
        const Vec3& x = pressed.sheets.x[n];
        (n < pressed.below ? below : above) += sum[n] * Vec3(x.x(), x.y(), 1.0);
        if (n >= pressed.below) most = std::max(most, std::abs(sum[n] / area[n] - 1.0));
    }
    CHECK(most < 1e-5);
    CHECK(above.z() == Approx(0.04 * 0.04).epsilon(1e-5));
    CHECK((above - below).norm() < 1e-12 * above.norm());
}

TEST_CASE("areas change evenly as a sheet slides over another", "[contact]") {
    std::vector<double> last;
    for (int step = 0; step < 200; ++step) {
        const Pressed pressed(0.37, {0.009 + 1e-5 * step, 0.0113, 0.0});
        const Cloth cloth = support::cloth_of(pressed.sheets);
        std::vector<double> sum = pressed_areas(pressed, cloth);
        if (!last.empty())
            for (std::size_t n = 0; n < sum.size(); ++n)
                CHECK(std::abs(sum[n] - last[n]) < 1e-5 * 0.015);  // the way times a width
        last = std::move(sum);
    }
}

TEST_CASE("a rim that stands on a sheet has some of its own area", "[contact]") {
    support::Sheet both = support::square_sheet(2, 0.02);
    support::Sheet rim = support::square_sheet(2, 0.01);
    for (Vec3& x : rim.x) x = Vec3(x.x(), 0.0, x.y());
    both.append(rim, {0.0031, 0.0072, GAP});
    const Cloth cloth = support::cloth_of(both);
    const Index foot = 10;  // the middle node of its lower edge
    double most = 0.0;
    for (const Triangle& t : cloth.triangles) {
        if (t[0] >= 9) continue;
        const Pair pair{{foot, t[0], t[1], t[2]}, false};
        const Nearest places = nearest(pair, both.x);
        if (places.apart.norm() > 1.001 * GAP) continue;
        const Contact c = contact_at(cloth, {}, both.x, pair, places, GAP);
        most = std::max(most, overlap_area(cloth, both.x, c).area);
    }
    const double own = node_areas(both)[foot];
    CHECK(most > 0.2 * own);
    CHECK(most < 0.3 * own);
}
