// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what lies on the border of parts touches by any of them, whatever the order of triangles.
#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

#include "contact/surface_contact.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::SpringCloth;

namespace {

constexpr double H = SpringCloth::THICKNESS, EDGE = 0.01;
constexpr Index LEFT = 0, RIGHT = 1, PLATE = 2;

/// A sheet of two parts that a seam along y joins, above a large triangle that is held.
struct Seamed {
    SpringCloth cloth;
    ContactSetup setup;

    static support::Sheet sheets() {
        support::Sheet all = support::square_sheet(4, 4 * EDGE);
        all.append({{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}}, {{0, 1, 2}}}, {0.0, 0.0, -0.9 * H});
        return all;
    }
    explicit Seamed(bool is_right_first, std::vector<ContactCard> cards) : cloth(sheets()) {
        if (is_right_first) std::reverse(cloth.triangles.begin(), cloth.triangles.end());
        for (std::size_t n = 25; n < 28; ++n) cloth.held[n] = 1;
        setup = cloth.setup({}, cloth.x);
        setup.cards = std::move(cards);
        setup.parts = 3;
        for (std::size_t t = 0; t < setup.part.size(); ++t) {
            double middle = 0.0;
            for (const Index n : cloth.triangles[t]) middle += cloth.x[n].x() / 3.0;
            const bool is_plate = cloth.triangles[t][0] >= 25;
            setup.part[t] = is_plate ? PLATE : middle < 2 * EDGE ? LEFT : RIGHT;
        }
    }
    /// What the nodes' velocities become when the sheet, `tilt` steep along x, is pressed on.
    Points pressed(double tilt) {
        SurfaceContact contact(setup);
        contact.find(cloth.x, cloth.v, 0.0, 1e-6);
        for (std::size_t n = 0; n < 25; ++n)
            cloth.x[n].z() -= 0.2 * H + tilt * (cloth.x[n].x() - 2 * EDGE);
        Points v(cloth.x.size(), Vec3::Zero());
        contact.find(cloth.x, v, 1e-6, 1e-6);
        contact.respond(cloth.x, 1e-6, v);
        return v;
    }
};

ContactCard against_plate(Index part, double thickness) {
    ContactCard card;
    card.kind =
        GENERATE(ContactCard::Kind::SURFACE_TO_SURFACE, ContactCard::Kind::NODES_TO_SURFACE);
    card.parts = {part};
    card.other_parts = {PLATE};
    card.thickness = card.other_thickness = thickness;
    return card;
}

}  // namespace

TEST_CASE("a seam touches by the card of either part, in any order of triangles", "[contact]") {
    std::vector<ContactCard> cards{against_plate(LEFT, H)};
    const bool has_other = GENERATE(false, true);
    if (has_other) {  // first in the deck, it has nothing to say of the plate
        ContactCard other;
        other.parts = {RIGHT};
        cards.insert(cards.begin(), other);
    }
    const double tilt = GENERATE(0.0, 0.003);  // the right side hangs lower
    const Points v = Seamed(false, cards).pressed(tilt), turned = Seamed(true, cards).pressed(tilt);
    double fastest = 0.0;
    for (const Vec3& u : v) fastest = std::max(fastest, u.norm());
    REQUIRE(fastest > 0.0);
    for (std::size_t n = 0; n < 25; ++n) {
        CAPTURE(n);
        CHECK((v[n] - turned[n]).norm() < 1e-2 * fastest);
        const auto column = n % 5;
        if (column == 2) CHECK(v[n].z() > 0.1 * fastest);     // the seam
        if (column > 2) CHECK(v[n].norm() < 1e-3 * fastest);  // no card has it touch
    }
}

TEST_CASE("a seam has the thickness of the part by which it touches", "[contact]") {
    const double left = GENERATE(0.9, 3.0);  // over that of the right side's card
    const std::vector<ContactCard> cards{against_plate(LEFT, left * H), against_plate(RIGHT, H)};
    for (const bool is_right_first : {false, true}) {
        const Cloth cloth(Seamed(is_right_first, cards).setup);
        const auto plate = static_cast<Index>(
            std::find(cloth.part.begin(), cloth.part.end(), PLATE) - cloth.part.begin());
        constexpr Index ON_SEAM = 12, BESIDE = 13;
        for (const Index n : {ON_SEAM, BESIDE}) {
            const std::pair parts(cloth.node_part[n], PLATE);
            CHECK(cloth.rules.is_combined(parts.first) == (n == ON_SEAM));
            const int card = cloth.rules.nodes_against(parts.first, parts.second);
            CHECK(card == (n == ON_SEAM ? 0 : 1));
            CHECK(cloth.rules.side_of(card, parts.first, parts.second) == 1);
            const Triangle& t = cloth.triangles[plate];
            const Pair pair{{n, t[0], t[1], t[2]}, false};
            CHECK(cloth.gap(card, parts, pair, cloth.triangles_of(n).front(), plate) ==
                  Approx(n == ON_SEAM ? left * H : H));
        }
    }
}
