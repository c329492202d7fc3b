// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "contact/broad_phase/intersections.hpp"
#include "solver/base/error.hpp"
#include "tests/support/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::PENALTY;
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

TEST_CASE("repulsion pushes apart and adds up to nothing, in force and in moment", "[contact]") {
    SpringCloth cloth(pair_of_sheets(0.4 * H));
    SurfaceContact contact(cloth.setup({}, cloth.x, PENALTY));
    Points f(cloth.x.size(), Vec3::Zero());
    contact.find(cloth.x, cloth.v, 0.0, 1e-6);
    contact.add_force(cloth.x, cloth.v, 1e-6, f);
    CHECK(contact.stored_energy() == 0.0);  // it starts with the gap that it has

    for (std::size_t i = 36; i < cloth.x.size(); ++i) cloth.x[i].z() -= 0.1 * H;
    contact.find(cloth.x, cloth.v, 1e-6, 1e-6);
    contact.add_force(cloth.x, cloth.v, 1e-6, f);
    CHECK(contact.stored_energy() > 0.0);
    CHECK(contact.counts().close_starts > 0);
    Vec3 sum = Vec3::Zero(), moment = Vec3::Zero();
    double upward = 0.0, scale = 0.0;
    for (std::size_t i = 0; i < f.size(); ++i) {
        sum += f[i];
        moment += cloth.x[i].cross(f[i]);
        scale += f[i].norm();
        if (i >= 36) upward += f[i].z();
    }
    CHECK(upward > 0.4 * scale);
    CHECK(sum.norm() < 1e-14 * scale);
    CHECK(moment.norm() < 1e-14 * scale);
}

TEST_CASE("contact stiffness keeps within its share of the stable step", "[contact]") {
    // released from rest below the contact thickness, in an undamped cloth, nothing explodes
    SpringCloth cloth(pair_of_sheets(1.2 * H));
    ContactCard card;
    card.damping = 0.0;
    SurfaceContact contact(cloth.setup(card, cloth.x, PENALTY));
    const double speed = 2.0;
    for (std::size_t i = 36; i < cloth.x.size(); ++i) cloth.v[i].z() = -speed;
    const double start = cloth.kinetic_energy();
    double most = 0.0;
    support::run_cloth(cloth, contact, cloth.stable_step(), 400, {},
                       [&](int) { most = std::max(most, cloth.kinetic_energy()); });
    CHECK(most < 1.001 * start);
    CHECK(lowest_above(cloth) > 1.5 * H);
}

TEST_CASE("sheets that start too close part gently", "[contact]") {
    const double damping = GENERATE(0.0, 20.0);
    SpringCloth cloth(pair_of_sheets(0.3 * H));
    ContactCard card;
    card.damping = damping;
    SurfaceContact contact(cloth.setup(card, cloth.x));
    const double dt = 1e-6;
    double fastest = 0.0;
    support::run_cloth(cloth, contact, dt, 500, {}, [&](int) {
        for (const Vec3& v : cloth.v) fastest = std::max(fastest, v.norm());
    });
    CHECK(lowest_above(cloth) > 0.9 * H);  // the contact thickness is there again
    CHECK(fastest > 0.0);
    // what is missing, in the 50 steps that it takes; the corners, which are light, some faster
    CHECK(fastest < 2.5 * 0.7 * H / (50 * dt));
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
    Points f(cloth.x.size(), Vec3::Zero());
    contact.find(cloth.x, cloth.v, 0.0, 1e-6);
    contact.add_force(cloth.x, cloth.v, 1e-6, f);
    CHECK(contact.counts().touching == 0);
    for (const Vec3& force : f) CHECK(force.isZero());
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
    SurfaceContact contact(cloth.setup({}, reference, PENALTY));
    const double dt = 1e-6;
    Points f(cloth.x.size(), Vec3::Zero());
    for (int step = 0; step <= 1000; ++step) contact.find(cloth.x, cloth.v, step * dt, dt);
    contact.add_force(cloth.x, cloth.v, dt, f);
    for (std::size_t i = 0; i < f.size(); ++i) {
        const bool is_beside_seam = std::abs(std::abs(sheet.x[i].x() - seam) - 0.005) < 1e-6;
        if (is_beside_seam) CHECK(std::abs(f[i].z()) > 0.0);
    }
    CHECK(contact.counts().touching > 0);
}

TEST_CASE("of the contacts that share a node the deeper one is the stiffer", "[contact]") {
    // Three sheets: the middle one is near the lower one, and a little too near the upper one
    support::Sheet all = support::square_sheet(3, 0.02);
    all.append(support::square_sheet(3, 0.02), Vec3(1.3e-3, 1.7e-3, 2.0 * H));
    all.append(support::square_sheet(3, 0.02), Vec3(2.6e-3, 3.1e-3, 4.0 * H));
    SpringCloth cloth(all);
    SurfaceContact contact(cloth.setup({}, cloth.x, PENALTY));
    contact.find(cloth.x, cloth.v, 0.0, 1e-6);
    const double low = 0.5, high = 0.1;  // depths, in contact thicknesses
    for (std::size_t i = 16; i < 32; ++i) cloth.x[i].z() = (1.0 - low) * H;
    for (std::size_t i = 32; i < 48; ++i) cloth.x[i].z() = (2.0 - low - high) * H;
    Points f(cloth.x.size(), Vec3::Zero());
    contact.find(cloth.x, cloth.v, 1e-6, 1e-6);
    contact.add_force(cloth.x, cloth.v, 1e-6, f);
    double below = 0.0, above = 0.0;
    for (std::size_t i = 0; i < 16; ++i) below -= f[i].z();
    for (std::size_t i = 32; i < 48; ++i) above += f[i].z();
    // Shared alike, forces would be as the depths
    CHECK(above > 0.0);
    CHECK(below > 1.5 * low / high * above);
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
    // free nodes: kinetic energy gained = springs + repulsion on them + what the impulses brought
    // in
    const double gained = cloth.kinetic_energy() - held_kinetic - start;
    const double given = run.work_of_springs_on_free + run.work_of_contact_on_free +
                         contact.held_work() - contact.damping_energy() - contact.friction_energy();
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
