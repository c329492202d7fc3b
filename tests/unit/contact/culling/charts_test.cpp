// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <bit>
#include <set>

#include "contact/culling/charts.hpp"
#include "tests/support/shapes.hpp"
#include "tests/support/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

Charts charts_of(const Cloth& cloth) {
    return {cloth, std::vector<double>(cloth.triangles.size(), 0.75e-3)};
}

bool have_common_node(const Cloth& cloth, std::size_t p, std::size_t q) {
    std::set<Index> nodes;
    for (const Index t : cloth.patches[p])
        nodes.insert(cloth.triangles[t].begin(), cloth.triangles[t].end());
    for (const Index t : cloth.patches[q])
        for (const Index n : cloth.triangles[t])
            if (nodes.contains(n)) return true;
    return false;
}

}  // namespace

TEST_CASE("of flat cloth, patches beside each other have a chart in common", "[contact]") {
    const Cloth cloth = support::cloth_of(support::square_sheet(24, 0.24));
    const Charts charts = charts_of(cloth);
    std::size_t beside = 0;
    for (std::size_t p = 0; p < charts.size(); ++p)
        for (std::size_t q = p; q < charts.size(); ++q) {
            if (!have_common_node(cloth, p, q)) continue;
            ++beside;
            const auto link = charts.link(static_cast<Index>(p), static_cast<Index>(q));
            REQUIRE(link.chart >= 0);
            // the ways between the two cross both
            std::set<Index> crossed;
            const auto& sheets = charts[link.chart].sheets;
            for (std::size_t s = 0; s < sheets.size(); ++s)
                if (link.cover >> s & 1U) crossed.insert(sheets[s].patch);
            CHECK(crossed.contains(static_cast<Index>(p)));
            CHECK(crossed.contains(static_cast<Index>(q)));
        }
    CHECK(beside > 3 * charts.size());
}

TEST_CASE("of a sphere, too, and no chart holds what lies behind", "[contact]") {
    const auto ball = shapes::sphere(0.3, 5);
    const Cloth cloth = support::cloth_of({ball.x, ball.triangles});
    const Charts charts = charts_of(cloth);
    for (std::size_t p = 0; p < charts.size(); ++p)
        for (std::size_t q = p; q < charts.size(); ++q) {
            const auto link = charts.link(static_cast<Index>(p), static_cast<Index>(q));
            if (have_common_node(cloth, p, q)) CHECK(link.chart >= 0);
            const Vec3 a =
                ball.x[static_cast<std::size_t>(cloth.triangles[cloth.patches[p][0]][0])];
            const Vec3 b =
                ball.x[static_cast<std::size_t>(cloth.triangles[cloth.patches[q][0]][0])];
            if (a.dot(b) < 0.0) CHECK(link.chart < 0);
        }
}

TEST_CASE("panels that lie on each other have no chart in common but across their seam, nor there",
          "[contact]") {
    const support::Sheet bag = support::two_panels(24, 0.24, 0.0, true);
    const Cloth cloth = support::cloth_of(bag);
    const Charts charts = charts_of(cloth);
    const auto panel = static_cast<Index>(bag.triangles.size() / 2);
    const auto side = [&](std::size_t p) {  // -1: patches of both
        const bool first = cloth.patches[p].front() < panel, last = cloth.patches[p].back() < panel;
        return first != last ? -1 : first ? 0 : 1;
    };
    std::size_t within = 0;
    for (std::size_t p = 0; p < charts.size(); ++p)
        for (std::size_t q = p; q < charts.size(); ++q) {
            const bool is_linked =
                charts.link(static_cast<Index>(p), static_cast<Index>(q)).chart >= 0;
            if (side(p) < 0 || side(p) != side(q))
                CHECK_FALSE(is_linked);
            else
                within += is_linked;
        }
    CHECK(within > charts.size());
}

TEST_CASE("no way leads over a hole in the cloth, nor over an edge of three triangles",
          "[contact]") {
    support::Sheet sheet = support::square_sheet(24, 0.24);
    const auto is_over = [&](const support::Sheet& of, double x, double y) {
        // pairs that have a triangle left and right of the place
        const Cloth cloth = support::cloth_of(of);
        const Charts charts = charts_of(cloth);
        std::size_t found = 0;
        for (std::size_t p = 0; p < charts.size(); ++p)
            for (std::size_t q = p; q < charts.size(); ++q) {
                bool left = false, right = false;
                for (const std::size_t patch : {p, q})
                    for (const Index t : cloth.patches[patch]) {
                        const Triangle& c = cloth.triangles[t];
                        const Vec3 at = (of.x[c[0]] + of.x[c[1]] + of.x[c[2]]) / 3.0;
                        if (std::abs(at.y() - y) > 0.01) continue;
                        left |= at.x() < x && at.x() > x - 0.03;
                        right |= at.x() > x && at.x() < x + 0.03;
                    }
                if (!left || !right) continue;
                found += charts.link(static_cast<Index>(p), static_cast<Index>(q)).chart >= 0;
            }
        return found;
    };
    CHECK(is_over(sheet, 0.12, 0.12) > 0);
    support::Sheet holed = sheet;
    std::erase_if(holed.triangles, [&](const Triangle& t) {
        const Vec3 at = (sheet.x[t[0]] + sheet.x[t[1]] + sheet.x[t[2]]) / 3.0;
        return std::abs(at.x() - 0.12) < 0.011 && std::abs(at.y() - 0.12) < 0.021;
    });
    CHECK(is_over(holed, 0.12, 0.12) == 0);
    support::Sheet finned = sheet;  // a fin stands on the middle line
    for (Index j = 0; j < 24; ++j) {
        const auto node = [&](double x, double y) {
            for (std::size_t n = 0; n < sheet.x.size(); ++n)
                if ((sheet.x[n] - Vec3(x, y, sheet.x[n].z())).norm() < 1e-6)
                    return static_cast<Index>(n);
            throw std::logic_error("no node there");
        };
        const Index a = node(0.12, 0.01 * j), b = node(0.12, 0.01 * (j + 1));
        finned.x.push_back(sheet.x[a] + Vec3(0, 0.005, 0.01));
        finned.triangles.push_back({a, b, static_cast<Index>(finned.x.size() - 1)});
    }
    CHECK(is_over(finned, 0.12, 0.12) == 0);
}
