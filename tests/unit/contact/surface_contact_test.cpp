// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "contact/broad_phase/intersections.hpp"
#include "solver/base/error.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::SpringCloth;

namespace {

constexpr double H = SpringCloth::THICKNESS;

/// A small sheet above a larger one.
support::Sheet pair_of_sheets(double gap) {
    support::Sheet both = support::square_sheet(5, 0.05);
    both.append(support::square_sheet(3, 0.02), Vec3(0.0133, 0.0147, gap));
    return both;
}

double lowest_above(const SpringCloth& cloth) {
    double lowest = INF;
    for (std::size_t i = 36; i < cloth.x.size(); ++i) lowest = std::min(lowest, cloth.x[i].z());
    return lowest;
}

}  // namespace

TEST_CASE("contact pushes apart and adds up to nothing, in momentum and in its moment",
          "[contact]") {
    SpringCloth cloth(pair_of_sheets(0.4 * H));
    SurfaceContact contact(cloth.setup({}, cloth.x));
    contact.find(cloth.x, cloth.v, 0.0, 1e-6);
    CHECK(contact.stored_energy() == 0.0);  // it starts with the gap that it has

    for (std::size_t i = 36; i < cloth.x.size(); ++i) cloth.x[i].z() -= 0.1 * H;
    contact.find(cloth.x, cloth.v, 1e-6, 1e-6);
    contact.respond(cloth.x, 1e-6, cloth.v);
    CHECK(contact.stored_energy() > 0.0);
    CHECK(contact.counts().close_starts > 0);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double upward = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < cloth.x.size(); ++i) {
        const Vec3 given = cloth.mass[i] * cloth.v[i];
        sum += given;
        moment += cloth.x[i].cross(given);
        scale += given.norm();
        if (i >= 36) upward += given.z();
    }
    CHECK(upward > 0.4 * scale);
    CHECK(sum.norm() < 1e-14 * scale);
    CHECK(moment.norm() < 1e-14 * scale);
}

TEST_CASE("a sheet that meets another at any step does not come through, nor faster back",
          "[contact]") {
    const double step_factor = GENERATE(1.0, 0.3, 0.1);
    SpringCloth cloth(pair_of_sheets(1.2 * H));
    ContactCard card;
    card.damping = 0.0;
    SurfaceContact contact(cloth.setup(card, cloth.x));
    const double speed = 2.0;
    for (std::size_t i = 36; i < cloth.x.size(); ++i) cloth.v[i].z() = -speed;
    const double start = cloth.kinetic_energy(), dt = step_factor * cloth.stable_step();
    double most = 0.0, lowest = INF;
    support::run_cloth(cloth, contact, dt, static_cast<int>(400 / step_factor), {}, [&](int) {
        most = std::max(most, cloth.kinetic_energy());
        lowest = std::min(lowest, lowest_above(cloth));
    });
    CHECK(most < 1.001 * start);
    CHECK(lowest > -4.0 * H);  // where the lower sheet, which gives way, has gone
    CHECK(contact.counts().least_gap > 0.5);
}

TEST_CASE("sheets that start too close part gently", "[contact]") {
    const double damping = GENERATE(0.0, 20.0);
    SpringCloth cloth(pair_of_sheets(0.3 * H));
    ContactCard card;
    card.damping = damping;
    SurfaceContact contact(cloth.setup(card, cloth.x));
    const double dt = 1e-6;
    double fastest = 0.0;
    support::run_cloth(cloth, contact, dt, 2000, {}, [&](int) {
        for (const Vec3& v : cloth.v) fastest = std::max(fastest, v.norm());
    });
    CHECK(lowest_above(cloth) > 0.9 * H);  // the contact thickness is there again
    CHECK(fastest > 0.0);
    // what is missing, in the time that it takes; the corners, which are light, some faster
    CHECK(fastest < 2.5 * 0.7 * H / SpringCloth::GROWTH_TIME);
}

TEST_CASE("triangles that cross at the start are named, and nothing is thrown", "[contact]") {
    support::Sheet both = pair_of_sheets(1e-3);
    both.x.back().z() = -1e-3;  // one corner is through
    SpringCloth cloth(both);
    SurfaceContact contact(cloth.setup({}, cloth.x));
    const Patches patches = make_patches(cloth.x, cloth.triangles);
    const double dt = 1e-6;
    contact.find(cloth.x, cloth.v, 0.0, dt);
    CHECK(contact.crossing() == crossings(cloth.triangles, patches, cloth.x));
    REQUIRE_FALSE(contact.crossing().empty());

    double fastest = 0.0;
    support::run_cloth(cloth, contact, dt, 500, {}, [&](int) {
        for (const Vec3& v : cloth.v) fastest = std::max(fastest, v.norm());
    });
    CHECK(fastest < 10.0);
}

TEST_CASE("neighbours on the cloth do not push each other, however thick it is", "[contact]") {
    SpringCloth cloth(support::square_sheet(8, 0.04));  // edges of 5 mm
    ContactCard card;
    card.thickness = 4e-3;
    SurfaceContact contact(cloth.setup(card, cloth.x));
    contact.find(cloth.x, cloth.v, 0.0, 1e-6);
    contact.respond(cloth.x, 1e-6, cloth.v);
    CHECK(contact.counts().touching == 0);
    for (const Vec3& v : cloth.v) CHECK(v.isZero());
}

TEST_CASE("sides of a shell whose end has shrunk to nothing part again, and slowly", "[contact]") {
    // The cloth itself lies between the sides: their law does not push.
    constexpr double LONG = 12e-3, WIDE = 4e-3, END = 1e-6;  // half of the ends' widths    [m]
    constexpr int SHRINKING = 100;                           // steps
    support::Sheet shell;
    shell.x = {{0, -WIDE, 0}, {0, WIDE, 0}, {LONG, -WIDE, 0}, {LONG, WIDE, 0}};
    shell.triangles = {{0, 2, 3}, {0, 3, 1}};
    SpringCloth cloth(shell);
    SurfaceContact contact(cloth.setup({}, cloth.x));
    const double dt = GENERATE(8e-6, 1e-6);
    const Pair sides{{0, 2, 1, 3}, true};
    const auto gap = [&] { return nearest(sides, corners(sides, cloth.x)).apart.norm(); };
    cloth.v[2] = Vec3(0, WIDE + END, 0) / (SHRINKING * dt);
    cloth.v[3] = Vec3(0, -WIDE - END, END) / (SHRINKING * dt);
    int step = 0;
    for (; step < SHRINKING; ++step) {
        contact.find(cloth.x, cloth.v, step * dt, dt);
        cloth.drift(dt);
    }
    REQUIRE(gap() < END);
    cloth.v.assign(4, Vec3::Zero());
    double last = gap(), fastest = 0.0;
    for (; step * dt < SHRINKING * dt + 0.3 * SpringCloth::GROWTH_TIME; ++step) {
        contact.find(cloth.x, cloth.v, step * dt, dt);
        contact.respond(cloth.x, dt, cloth.v);
        cloth.drift(dt);
        CHECK(gap() >= last);
        last = gap();
        for (const Vec3& v : cloth.v) fastest = std::max(fastest, v.norm());
    }
    CHECK(contact.stored_energy() == 0.0);
    CHECK(last > 0.2 * H);
    CHECK(fastest < 2.0 * H / SpringCloth::GROWTH_TIME);
    CHECK(contact.counts().impacts == 0);
}

TEST_CASE("panels that a seam joins keep their thickness next to it", "[contact]") {
    // Flat, the panels lie on each other: their distance there says nothing of the way round the
    // seam
    support::Sheet sheet = support::square_sheet(8, 0.04);
    const double seam = 0.02;
    Points reference = sheet.x;
    for (Vec3& x : reference)
        if (x.x() > seam) x.x() = 2.0 * seam - x.x();
    for (Vec3& x : sheet.x) {
        x.z() = x.x() > seam + 1e-9 ? 0.1 * H : 0.0;
        if (x.x() > seam) x.x() = 2.0 * seam - x.x();
    }
    SpringCloth cloth(sheet);
    SurfaceContact contact(cloth.setup({}, reference));
    const double dt = 1e-6;
    for (int step = 0; step <= 1000; ++step) contact.find(cloth.x, cloth.v, step * dt, dt);
    CHECK(contact.counts().touching > 0);
    contact.respond(cloth.x, dt, cloth.v);
    for (std::size_t i = 0; i < cloth.v.size(); ++i) {
        const bool is_beside_seam = std::abs(std::abs(sheet.x[i].x() - seam) - 0.005) < 1e-6;
        if (is_beside_seam) CHECK(std::abs(cloth.v[i].z()) > 0.0);
    }
}

TEST_CASE("there is no contact before its birth and after its death", "[contact]") {
    SpringCloth cloth(pair_of_sheets(0.5 * H));
    ContactCard card;
    card.birth = 1.0;
    card.death = 2.0;
    SurfaceContact contact(cloth.setup(card, cloth.x));
    Points moved = cloth.x;
    for (std::size_t i = 36; i < moved.size(); ++i) moved[i].z() -= 0.1 * H;
    const auto touching = [&](const Points& x, double t) {
        contact.find(x, cloth.v, t, 1e-6);
        return contact.counts().touching;
    };
    CHECK(touching(cloth.x, 0.5) == 0);
    CHECK(contact.counts().builds == 0);
    CHECK(touching(cloth.x, 1.0) == 0);
    CHECK(touching(moved, 1.5) > 0);
    contact.find(cloth.x, cloth.v, 2.5, 1e-6);
    CHECK(contact.stored_energy() == 0.0);
}

TEST_CASE("of several cards for the same parts the first that is on holds, and none kicks",
          "[contact]") {
    const double thicker = GENERATE(1.0, 1.5, 0.6);
    const bool is_pressed = GENERATE(true, false);
    SpringCloth cloth(pair_of_sheets(is_pressed ? 0.9 * H : 1.2 * H));
    ContactCard card;
    card.thickness = H;
    card.death = 1.0;
    ContactSetup setup = cloth.setup(card, cloth.x);
    setup.cards.push_back(setup.cards[0]);
    setup.cards[1].birth = GENERATE(0.0, 1.0, 1.2);
    setup.cards[1].death = INF;
    setup.cards[1].thickness = thicker * H;
    SurfaceContact contact(setup);
    const auto stored = [&](double t) {
        contact.find(cloth.x, cloth.v, t, 1e-6);
        Points v = cloth.v;
        contact.respond(cloth.x, 1e-6, v);
        return contact.stored_energy();
    };
    CHECK(stored(0.0) == 0.0);  // it starts with the gap that it has
    const double by_first = stored(1.0);
    CHECK((by_first > 0.0) == is_pressed);
    const bool has_gap = setup.cards[1].birth > 1.1;
    if (has_gap) CHECK(stored(1.1) == 0.0);
    const double by_second = stored(1.2);
    if (has_gap || thicker < 0.9)
        CHECK(by_second == Approx(0.0).margin(1e-15));
    else
        CHECK(by_second == Approx(by_first).epsilon(1e-6).margin(1e-15));
    CHECK((stored(2.0) > 0.0) ==
          (thicker > 1.2 || (is_pressed && thicker == 1.0)));  // it has grown
}

TEST_CASE("held cloth is not moved, and the work it does is booked", "[contact]") {
    SpringCloth cloth(pair_of_sheets(2.0 * H));
    for (std::size_t i = 0; i < 36; ++i) {
        cloth.held[i] = 1;
        cloth.v[i] = Vec3(0, 0, 20.0);  // a piston under the small sheet
    }
    SurfaceContact contact(cloth.setup({}, cloth.x));
    double held_kinetic = 0.0;
    for (std::size_t i = 0; i < 36; ++i)
        held_kinetic += 0.5 * cloth.mass[i] * cloth.v[i].squaredNorm();
    const double start = cloth.kinetic_energy() - held_kinetic;
    const auto run = support::run_cloth(cloth, contact, cloth.stable_step(), 100, {}, [](int) {});
    for (std::size_t i = 0; i < 36; ++i) REQUIRE(cloth.v[i] == Vec3(0, 0, 20.0));
    CHECK(lowest_above(cloth) > 20.0 * 100 * cloth.stable_step());
    CHECK(contact.held_work() != 0.0);
    // free nodes: kinetic energy gained = springs on them + what the impulses brought in
    const double gained = cloth.kinetic_energy() - held_kinetic - start;
    const double given = run.work_of_springs_on_free + contact.held_work() - contact.energy();
    CHECK(gained == Approx(given).epsilon(1e-9));
}

TEST_CASE("a contact thickness of zero and a free node without mass are refused", "[contact]") {
    SpringCloth cloth(pair_of_sheets(H));
    ContactCard card;
    card.id = 7;
    SECTION("thickness") {
        card.thickness = 0.0;
        CHECK_THROWS_AS(SurfaceContact(cloth.setup(card, cloth.x)), InputError);
    }
    SECTION("mass") {
        cloth.mass[3] = 0.0;
        CHECK_THROWS_WITH(SurfaceContact(cloth.setup(card, cloth.x)), Catch::Contains("contact 7"));
        cloth.held[3] = 1;
        CHECK_NOTHROW(SurfaceContact(cloth.setup(card, cloth.x)));
    }
}

TEST_CASE("the contact thickness follows its curve", "[contact]") {
    SpringCloth cloth(pair_of_sheets(2.0 * H));
    const std::vector<Curve> curves = {{1, {0.0, 1.0}, {H, 4.0 * H}}};
    ContactCard card;
    card.thickness_curve = 0;
    ContactSetup setup = cloth.setup(card, cloth.x);
    setup.curves = curves;
    SurfaceContact contact(setup);
    const auto touching = [&](double t) {
        contact.find(cloth.x, cloth.v, t, 1e-6);
        return contact.counts().touching;
    };
    CHECK(touching(0.0) == 0);
    CHECK(touching(0.2) == 0);
    CHECK(touching(0.9) > 0);
}
