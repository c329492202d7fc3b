#include <catch2/catch.hpp>
#include <iostream>
#include "tests/support/spring_cloth.hpp"
using namespace corpuscle;
using namespace corpuscle::contact;

namespace {
/// A small free sheet between two held ones, 4 mm apart.
support::SpringCloth sandwich(Index n) {
    support::Sheet all = support::square_sheet(6, 0.06);
    const std::size_t plate = all.x.size();
    all.append(support::square_sheet(6, 0.06), {0, 0, 4e-3});
    all.append(support::square_sheet(n, 0.02), {0.0203, 0.0207, 2e-3});
    support::SpringCloth cloth(all);
    for (std::size_t i = 0; i < 2 * plate; ++i) cloth.held[i] = 1;
    return cloth;
}
}
TEST_CASE("frictionless bouncing without damping never gains energy", "[contact]") {
    support::SpringCloth cloth = sandwich(2);
    const double speed = GENERATE(2.0, 5.0, 20.0);
    const double frac = GENERATE(1.0, 0.5, 0.2);
    for (std::size_t i = 0; i < cloth.x.size(); ++i)
        if (!cloth.held[i]) cloth.v[i] = Vec3(0, 0, speed);
    SelfContactCard card;
    card.damping = 0.0;
    SelfContact contact(cloth.setup(card, cloth.x));
    double most = 0, start = cloth.kinetic_energy();
    double flips=0, last=1;
    support::run_cloth(cloth, contact, frac*cloth.stable_step(), 2000/frac, {}, [&](int) {
        most = std::max(most, cloth.kinetic_energy());
        double m = cloth.momentum().z(); if (m*last<0) {flips++; last=m;}
    });
    std::cout << speed << " dt " << frac*cloth.stable_step() << " bounces " << flips << " E/E0 " << cloth.kinetic_energy()/start << " most " << most/start << " damp " << contact.damping_energy()/start << " builds " << contact.counts().builds << " least " << contact.counts().least_gap << "\n";
    CHECK(most <= start * 1.001);
}
