// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "fabric/materials/linear.hpp"
#include "sheet.hpp"
#include "solver/base/error.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

/// Linear once more, as a user of the library would write it.
class Again final : public OwnLaw {
public:
    [[nodiscard]] PlaneModuli moduli() const override { return law_.moduli(); }
    [[nodiscard]] Stress<double> stress(const Strain<double>& e) const override {
        return law_.stress(e);
    }

private:
    Linear law_{orthotropic_moduli(300e6, 250e6, 0.1, 3e6)};
};

/// Moduli that no sheet has.
class Impossible final : public OwnLaw {
public:
    [[nodiscard]] PlaneModuli moduli() const override { return {1e8, 2e8, 1e8, -1.0}; }
    [[nodiscard]] Stress<double> stress(const Strain<double>&) const override { return {}; }
};

}  // namespace

TEST_CASE("a law of one's own is as good as one of the library's", "[fabric][own]") {
    const Mesh mesh = GENERATE(Mesh::TRIANGLES, Mesh::ONE_POINT, Mesh::FOUR_POINT);
    const double damping = GENERATE(0.0, 0.1);
    FabricCard card = fabric_card();
    card.density = 700.0;
    card.damping = damping;
    Sheet theirs = rectangle(card, mesh, 5, 3, 0.4, 0.3);
    Sheet own = rectangle(OwnCard{700.0, std::make_shared<Again>(), damping}, mesh, 5, 3, 0.4, 0.3);
    const Points moves = noise(own.x.size(), 0.02, 7), v = noise(own.x.size(), 3.0, 8);
    Points x = own.x;
    for (std::size_t n = 0; n < x.size(); ++n) x[n] += moves[n];

    Membranes a = theirs.membranes(), b = own.membranes();
    Points f_a(x.size(), Vec3::Zero()), f_b = f_a;
    REQUIRE(a.add_force(x, v, f_a) == -1);
    REQUIRE(b.add_force(x, v, f_b) == -1);
    for (std::size_t n = 0; n < x.size(); ++n)
        CHECK((f_a[n] - f_b[n]).norm() <= 1e-12 * f_a[n].norm());
    CHECK(a.strain_energy() > 0.0);
    CHECK(b.strain_energy() == Approx(a.strain_energy()).epsilon(1e-12));
    // Of damped cloth the library's law knows a sharper bound
    CHECK(b.stable_step().dt <= a.stable_step().dt * (1 + 1e-12));
    CHECK(b.stable_step().dt > (damping > 0.0 ? 0.9 : 1 - 1e-12) * a.stable_step().dt);
}

TEST_CASE("a law of one's own that cannot be is refused with every fault", "[fabric][own]") {
    Sheet sheet =
        rectangle(OwnCard{-1.0, std::make_shared<Impossible>()}, Mesh::TRIANGLES, 1, 1, 0.1, 0.1);
    try {
        static_cast<void>(sheet.membranes());
        FAIL("it was taken");
    } catch (const InputError& error) {
        REQUIRE(error.faults.size() == 3);
        CHECK(error.faults[0] == "material 10: density = -1, expected > 0");
        CHECK(error.faults[1] == "material 10: shear modulus = -1, expected > 0");
        CHECK(error.faults[2].starts_with("material 10: cross modulus = 2e+08, expected "));
    }
    Sheet none = rectangle(OwnCard{700.0, nullptr}, Mesh::TRIANGLES, 1, 1, 0.1, 0.1);
    CHECK_THROWS_AS(none.membranes(), InputError);
}
