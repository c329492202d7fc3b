// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <atomic>
#include <map>
#include <set>

#include "contact/response/column_colouring.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

/// A sheet, and a contact of each triangle with the next one's node, with one some triangles on, or with
/// one far off.
struct Pile {
    support::Sheet sheet = support::square_sheet(30, 0.6);
    support::SpringCloth cloth{sheet};
    Cloth fixed{cloth.setup({}, sheet.x)};
    ContactList contacts;
    ColumnColouring columns{fixed};

    Pile() {
        const std::size_t count = sheet.triangles.size();
        contacts.lay_out(3 * ContactList::CHUNK);
        columns.lay(sheet.x);
        for (std::size_t t = 0; t < count; ++t) {
            const Triangle& a = sheet.triangles[t];
            const std::size_t on = t % 7 == 0 ? 6 : 1;
            const std::size_t other = t % 17 == 0 ? count - 1 - t : (t + on) % count;
            Contact contact{};
            contact.node = {sheet.triangles[other][0], a[0], a[1], a[2]};
            contact.on_body = t % 29 == 0;
            contacts.add(t % 3, columns.of(contact, sheet.x), contact, {});
        }
        columns.sort(contacts);
    }
};

}  // namespace

TEST_CASE("columns of one colour have no node in common, and each contact is met once",
          "[contact]") {
    Pile pile;
    REQUIRE(pile.columns.size() == pile.sheet.triangles.size());
    std::map<const Contact*, int> met;
    std::map<Index, std::set<std::size_t>> column_of;  // of a colour, by node
    std::size_t alone = 0, narrow = 0, wide = 0;
    unsigned colour = 0;
    parallel::set_threads(1);
    pile.columns.for_each(pile.contacts, [&](const Contact& c) {
        ++met[&c];
        if (c.column == Contact::ALONE) {
            ++alone;
            return;
        }
        REQUIRE_FALSE(c.on_body);
        const unsigned now = ColumnColouring::colour(c.column);
        ++(now < 4 ? narrow : wide);
        if (now != colour) {
            REQUIRE(now > colour);
            colour = now;
            column_of.clear();
        }
        for (const Index n : c.node) {
            column_of[n].insert(c.column);
            REQUIRE(column_of[n].size() == 1);
        }
    });
    CHECK(met.size() == pile.sheet.triangles.size());
    CHECK(std::all_of(met.begin(), met.end(), [](const auto& m) { return m.second == 1; }));
    CHECK(alone > 100);
    CHECK(narrow > 1000);
    CHECK(wide > 100);
}

TEST_CASE("sums over contacts by columns are the same bits on any number of threads", "[contact]") {
    Pile pile;
    const auto sums = [&](int threads) {
        parallel::set_threads(threads);
        std::vector<double> sum(pile.sheet.x.size(), 0.1);
        pile.columns.for_each(pile.contacts, [&](const Contact& c) {
            for (std::size_t k = 0; k < 4; ++k)
                sum[c.node[k]] = 1.0 / (sum[c.node[k]] + 0.3 * static_cast<double>(c.node[0] + k));
        });
        return sum;
    };
    const auto once = sums(1);
    CHECK(sums(2) == once);
    CHECK(sums(4) == once);
    parallel::set_threads(2);
}
