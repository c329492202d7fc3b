// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/facet_load.hpp"

#include <catch2/catch.hpp>

#include <numeric>

#include "tests/support/geometry/shapes.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::SpringCloth;

namespace {

double sum_of(const std::vector<double>& all) {
    return std::accumulate(all.begin(), all.end(), 0.0);
}

/// A node against a triangle, with an impulse of 6 along z.
Contact pushing(const std::array<Index, 4>& node) {
    Contact c{};
    c.node = node;
    c.weight = {1.0, -0.5, -0.25, -0.25};
    c.normal = Vec3::UnitZ();
    c.impulse = 6.0;
    return c;
}

}  // namespace

TEST_CASE("a node's load goes to the facets that its contacts face, and adds up", "[contact]") {
    const shapes::Shape box = shapes::box(Vec3(2, 3, 1));
    support::Sheet sheet{box.x, box.triangles};
    SpringCloth cloth(sheet);
    const ContactSetup setup = cloth.setup({}, cloth.x);
    const Cloth surface(setup);
    FacetLoad load(surface);
    CHECK(sum_of(load.forces(cloth.x)) == 0.0);
    // corner 0 at the bottom is pressed along z; the others as the places of its partner
    load.add(pushing({0, 1, 2, 3}));
    load.pass(2.0);
    const std::vector<double> forces = load.forces(cloth.x);
    CHECK(sum_of(forces) == Approx(2.0 * 6.0 / 2.0).epsilon(1e-14));
    for (std::size_t t = 0; t < forces.size(); ++t) {
        const auto& [a, b, c] = cloth.triangles[t];
        const Vec3 normal = vector_area(cloth.x[a], cloth.x[b], cloth.x[c]).normalized();
        if (std::abs(normal.z()) < 0.5) CHECK(forces[t] == 0.0);  // the sides
    }
    load.add(pushing({0, 1, 2, 3}));
    load.pass(4.0);  // a mean over all of the time
    CHECK(sum_of(load.forces(cloth.x)) == Approx(2.0 * 12.0 / 6.0).epsilon(1e-14));
    load.clear();
    load.pass(1.0);
    CHECK(sum_of(load.forces(cloth.x)) == 0.0);
}

TEST_CASE("what meets cloth edge on is shared by area", "[contact]") {
    SpringCloth cloth(support::square_sheet(2, 0.1));
    const ContactSetup setup = cloth.setup({}, cloth.x);
    const Cloth surface(setup);
    FacetLoad load(surface);
    Contact c = pushing({0, 6, 7, 8});
    c.normal = Vec3::UnitX();
    load.add(c);
    load.pass(1.0);
    CHECK(sum_of(load.forces(cloth.x)) == Approx(12.0).epsilon(1e-14));
}

TEST_CASE("a needle stopped at once: its load is the momentum that it lost", "[contact]") {
    constexpr double H = SpringCloth::THICKNESS;
    support::Sheet both = support::square_sheet(5, 0.05);
    const auto first = both.x.size(), first_triangle = both.triangles.size();
    const support::Sheet needle{{{0, 0, 0}, {0.002, 0, 0.05}, {0, 0.002, 0.05}}, {{0, 1, 2}}};
    both.append(needle, Vec3(0.0233, 0.0247, 10.0 * H));
    SpringCloth cloth(both);
    for (std::size_t i = 0; i < first; ++i) cloth.held[i] = 1;  // so that it stays flat
    SurfaceContact contact(cloth.setup({}, cloth.x));
    const double dt = cloth.stable_step();
    for (std::size_t i = first; i < cloth.x.size(); ++i) cloth.v[i].z() = -30.0 * H / dt;
    const Points before = cloth.v;
    contact.find(cloth.x, cloth.v, 0.0, dt);
    contact.respond(cloth.x, dt, cloth.v);
    double lost = 0.0;
    for (std::size_t i = first; i < cloth.x.size(); ++i)
        lost += cloth.mass[i] * (cloth.v[i].z() - before[i].z());
    CHECK(lost > 0.0);
    const std::vector<double> forces = contact.take_facet_forces(cloth.x);
    const double span = 0.5 * dt;  // of the first step's kick
    const auto upper = forces.begin() + static_cast<std::ptrdiff_t>(first_triangle);
    const double above = span * std::accumulate(upper, forces.end(), 0.0);
    const double below = span * std::accumulate(forces.begin(), upper, 0.0);
    CHECK(above == Approx(below).epsilon(1e-9));
    CHECK(above >= (1.0 - 1e-9) * lost);  // the needle's flanks press aside too
    CHECK(above < 1.1 * lost);
    CHECK(sum_of(contact.take_facet_forces(cloth.x)) == 0.0);  // it has begun anew
}

TEST_CASE("penetration is what is missing of the contact thickness", "[contact]") {
    constexpr double H = SpringCloth::THICKNESS;
    support::Sheet both = support::square_sheet(5, 0.05);
    both.append(support::square_sheet(3, 0.02), Vec3(0.0133, 0.0147, 1.2 * H));
    SpringCloth cloth(both);
    SurfaceContact contact(cloth.setup({}, cloth.x));
    contact.find(cloth.x, cloth.v, 0.0, 1e-6);
    CHECK(contact.depth(0).pairs == 0);
    CHECK(contact.depth(0).greatest == 0.0);
    for (std::size_t i = 36; i < cloth.x.size(); ++i) cloth.x[i].z() -= 0.5 * H;
    contact.find(cloth.x, cloth.v, 1e-6, 1e-6);
    CHECK(contact.depth(0).pairs == contact.counts().touching);
    CHECK(contact.depth(0).pairs > 0);
    CHECK(contact.depth(0).greatest == Approx(0.3).epsilon(1e-9));
}
