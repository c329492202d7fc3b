// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/area_shares.hpp"

#include <catch2/catch.hpp>

#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

constexpr double GAP = 0.99e-3, REST = 1e-3;

/// All contacts of nodes of the upper sheet with triangles of the lower one, which is larger.
ContactList contacts_of(const Cloth& cloth, const Points& x, Index below,
                        ColumnColouring& columns) {
    ContactList contacts;
    contacts.clear(1);
    columns.lay(x);
    for (Index n = below; n < static_cast<Index>(x.size()); ++n)
        for (const Triangle& t : cloth.triangles) {
            if (t[0] >= below) continue;
            const Pair pair{{n, t[0], t[1], t[2]}, false};
            const Nearest places = nearest(pair, x);
            if (std::abs(places.apart.norm() - GAP) > 1e-9) continue;
            const Contact found = contact_at(pair, places, GAP, cloth.inverse_mass);
            Contact& c = contacts.add(0, columns.of(found, x), found);
            c.rest = REST;
            c.area = 0.0;
        }
    columns.sort(contacts);
    return contacts;
}

/// A sheet of 40 mm that lies on one of 60 mm.
struct Pressed {
    support::Sheet sheets = two_sheets();
    Cloth cloth = support::cloth_of(sheets);
    ColumnColouring columns{cloth};
    ContactList contacts = contacts_of(cloth, sheets.x, BELOW, columns);
    AreaShares areas{cloth};

    static constexpr Index BELOW = 49;  ///< nodes of the larger one
    static support::Sheet two_sheets() {
        support::Sheet both = support::square_sheet(6, 0.06);
        both.append(support::square_sheet(8, 0.04), {0.0107, 0.0113, GAP});
        return both;
    }
};

}  // namespace

TEST_CASE("areas of contacts come to what the finer sheet's nodes have", "[contact]") {
    Pressed pressed;
    auto& [sheets, cloth, columns, contacts, areas] = pressed;
    for (int step = 0; step < 40; ++step) areas.find(sheets.x, columns, contacts);
    double sum = 0.0;
    contacts.for_each([&](const Contact& c) {
        CHECK(c.area > 0.0);
        sum += c.area;
    });
    CHECK(sum == Approx(0.04 * 0.04).epsilon(0.01));
}

TEST_CASE("places that are hidden have no area of their nodes'", "[contact]") {
    Pressed pressed;
    auto& [sheets, cloth, columns, contacts, areas] = pressed;
    bool is_hidden = false;
    contacts.for_each([&](Contact& c) { c.exposure = (is_hidden = !is_hidden) ? 0.0 : 1.0; });
    for (int step = 0; step < 40; ++step) areas.find(sheets.x, columns, contacts);
    double open = 0.0;
    contacts.for_each([&](const Contact& c) { open += c.area * c.exposure; });
    double nodes = 0.0;  // of the upper nodes that have an open contact
    std::vector<double> area(sheets.x.size(), 0.0);
    for (const Triangle& t : cloth.triangles)
        for (const Index n : t)
            area[n] += vector_area(sheets.x[t[0]], sheets.x[t[1]], sheets.x[t[2]]).norm() / 3.0;
    contacts.for_each([&](const Contact& c) {
        if (c.exposure > 0.0) nodes += std::exchange(area[c.node[0]], 0.0);
    });
    CHECK(open == Approx(nodes).epsilon(0.01));
}
