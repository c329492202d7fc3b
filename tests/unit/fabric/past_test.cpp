// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "fabric/materials/plane_stress.hpp"
#include "sheet.hpp"
#include "solver/base/archive.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

/// A sheet that lies stretched by 10 % along x and drawn in by 20 % along y at the start.
struct Stretched {
    Sheet sheet;
    Points start;

    explicit Stretched(const FabricCard& card, Mesh mesh)
        : sheet(rectangle(card, mesh, 3, 2, 0.3, 0.2)),
          start(moved(sheet.x, [](const Vec3& p) { return Vec3(1.1 * p.x(), 0.8 * p.y(), 0); })) {}
    Membranes membranes() {
        MembraneSetup setup = sheet.setup();
        setup.start = start;
        return Membranes(setup);
    }
};

FabricCard unloading_card() {
    FabricCard card = fabric_card();
    card.form = 4;
    card.curves.load = {0, 0, -1};
    card.curves.unload = {1, 1, -1};
    card.liner_E = 50e6;
    card.liner_ratio = 0.1;
    card.liner_waits = true;
    card.restoration.share = 0.05;
    return card;
}

}  // namespace

TEST_CASE("strains in tension at the start come back by a share in every step", "[fabric][past]") {
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    FabricCard card = fabric_card();
    card.axes = 2;
    Stretched plain(card, mesh);
    Membranes all = plain.sheet.membranes();
    card.restoration.share = 0.1;
    Stretched relieved(card, mesh);
    Membranes membranes = relieved.membranes();

    // What is left of E11 = (1.1² - 1)/2; E22 < 0 counts from the first step on
    const double E_0 = 0.5 * (1.1 * 1.1 - 1), E_2 = 0.5 * (0.8 * 0.8 - 1);
    const PlaneModuli d = orthotropic_moduli(card.E_warp, card.E_weft, card.nu_ba, card.G);
    const double volume = 0.3 * 0.2 * 0.3e-3;
    const auto energy = [&](double left) {
        const double e = (1 - left) * E_0;
        return volume * 0.5 * (d.warp * e * e + 2 * d.cross * e * E_2 + d.weft * E_2 * E_2);
    };
    double left = 1.0;
    for (int step = 0; step < 40; ++step) {
        membranes.restore_strains(1e-6 * step);
        force(membranes, relieved.start);
        CHECK(membranes.strain_energy() == Approx(energy(left)).epsilon(1e-12));
        left *= 0.9;
    }
    CHECK(membranes.restored_energy() == Approx(energy(left / 0.9) - energy(1.0)).epsilon(1e-9));
    // In the end nothing is left, and the sheet is the plain one
    for (int step = 0; step < 400; ++step) membranes.restore_strains(0);
    const Points f = force(membranes, relieved.start), expected = force(all, relieved.start);
    for (std::size_t n = 0; n < f.size(); ++n)
        CHECK((f[n] - expected[n]).norm() < 1e-9 * greatest(expected));
}

TEST_CASE("a course of time says what has come back", "[fabric][past]") {
    FabricCard card = fabric_card();
    card.axes = 2;
    const bool by_course = GENERATE(false, true);
    (by_course ? card.restoration.course_curve : card.restoration.share_curve) = 0;
    Stretched sheet(card, Mesh::TRIANGLES);
    sheet.sheet.curves = {{1, {0.0, 1.0, 2.0}, {0.0, 0.5, 0.5}}};
    for (Vec3& p : sheet.start) p.y() /= 0.8;  // pulled along the warp only
    Membranes membranes = sheet.membranes();
    double energy[4];
    for (int t = 0; t < 4; ++t) {
        membranes.restore_strains(t);
        force(membranes, sheet.start);
        energy[t] = membranes.strain_energy();
    }
    CHECK(energy[0] == 0.0);
    CHECK(energy[1] > 0.0);
    if (by_course) CHECK(energy[2] == Approx(energy[1]));          // half, and half
    if (!by_course) CHECK(energy[2] == Approx(2.25 * energy[1]));  // a half, then three quarters
}

TEST_CASE("with a part of the start's strain relieved the force is the energy's slope",
          "[fabric][past]") {
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    FabricCard card = fabric_card();
    card.no_compression = GENERATE(false, true);
    card.restoration.share = 0.3;
    card.liner_E = 50e6;
    card.liner_ratio = 0.2;
    card.liner_waits = true;
    Stretched sheet(card, mesh);
    const Points at = plus(sheet.start, noise(sheet.start.size(), 0.004, 3));
    Membranes membranes = sheet.membranes();
    for (int i = 0; i < 3; ++i) membranes.restore_strains(0);
    force(membranes, at);
    const Points f = force(membranes, at);
    const double step = 1e-7;
    for (std::size_t n = 0; n < at.size(); n += 3)
        for (int i = 0; i < 3; ++i) {
            const auto energy = [&](double by) {
                Points x = at;
                x[n][i] += by;
                force(membranes, x);
                return membranes.strain_energy();
            };
            CHECK(-(energy(step) - energy(-step)) / (2 * step) ==
                  Approx(f[n][i]).margin(2e-6 * greatest(f)));
        }
}

TEST_CASE("a liner that waits bears no compression until it has been taut", "[fabric][past]") {
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    FabricCard card = fabric_card();
    card.no_compression = true;
    card.liner_E = 50e6;
    card.liner_ratio = 0.1;
    const auto sheet_of = [&](bool waits) {
        card.liner_waits = waits;
        return rectangle(card, mesh, 3, 2, 0.3, 0.2);
    };
    Sheet waiting = sheet_of(true), plain = sheet_of(false);
    const auto drawn_in = [](const Vec3& p) { return Vec3(0.9 * p.x(), 0.7 * p.y(), 0); };
    const auto pulled = [](const Vec3& p) { return Vec3(1.02 * p.x(), 1.01 * p.y(), 0); };
    Membranes membranes = waiting.membranes(), other = plain.membranes();
    CHECK(membranes.stable_step().dt == Approx(other.stable_step().dt));
    CHECK(greatest(force(membranes, moved(waiting.x, drawn_in))) == 0.0);
    force(membranes, moved(waiting.x, pulled));
    force(other, moved(plain.x, pulled));
    CHECK(membranes.strain_energy() == Approx(other.strain_energy()));
    // Once taut it is the plain liner
    const Points f = force(membranes, moved(waiting.x, drawn_in));
    const Points expected = force(other, moved(plain.x, drawn_in));
    CHECK(greatest(expected) > 0.0);
    for (std::size_t n = 0; n < f.size(); ++n)
        CHECK((f[n] - expected[n]).norm() <= 1e-9 * greatest(expected));
}

TEST_CASE("membranes go on from their state as if nothing had been between", "[fabric][past]") {
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    Stretched sheet(unloading_card(), mesh);
    sheet.sheet.curves = {{1, {0, 0.02, 0.1, 0.3}, {0, 2e6, 20e6, 90e6}},
                          {2, {0, 0.1, 0.25, 0.3}, {0, 2e6, 50e6, 90e6}}};
    Membranes membranes = sheet.membranes();
    const auto place = [&](int i) {
        const double s = 1 + 0.1 * std::sin(0.7 * i);
        return moved(sheet.start, [&](const Vec3& p) {
            return Vec3(s * p.x(), (1.3 - 0.2 * s) * p.y(), 0.01 * i * p.x());
        });
    };
    const auto go = [&](Membranes& m, int i) {
        m.restore_strains(i);
        return force(m, place(i));
    };
    for (int i = 0; i < 20; ++i) go(membranes, i);
    StateWriter state;
    state(membranes);
    Membranes other = sheet.membranes();
    StateReader reader(state.bytes());
    reader(other);
    CHECK(reader.is_at_end());
    CHECK(membranes.lost_energy() > 0.0);
    for (int i = 20; i < 30; ++i) {
        CHECK(go(membranes, i) == go(other, i));
        CHECK(membranes.lost_energy() == other.lost_energy());
        CHECK(membranes.restored_energy() == other.restored_energy());
        CHECK(membranes.stable_step().dt == other.stable_step().dt);
    }
}

TEST_CASE("shells that begin anew forget, others go on", "[fabric][past]") {
    Stretched sheet(unloading_card(), Mesh::TRIANGLES);
    sheet.sheet.curves = {{1, {0, 0.02, 0.1, 0.3}, {0, 2e6, 20e6, 90e6}},
                          {2, {0, 0.1, 0.25, 0.3}, {0, 2e6, 50e6, 90e6}}};
    sheet.sheet.materials[0].card = [] {
        FabricCard card = unloading_card();
        card.restoration = {};
        return card;
    }();
    const auto pull = [&](double s) {
        return moved(sheet.sheet.x, [&](const Vec3& p) { return Vec3(s * p.x(), s * p.y(), 0); });
    };
    Membranes used = sheet.membranes(), fresh = sheet.membranes(), heir = sheet.membranes();
    force(used, pull(1.2));
    std::vector<std::uint8_t> none(sheet.sheet.shells.size(), 0), all(none.size(), 1);
    heir.inherit(used, none);
    const Points back = pull(1.1);
    CHECK(force(heir, back) == force(used, back));
    heir.inherit(fresh, none);
    Membranes other = sheet.membranes();
    other.inherit(used, all);
    CHECK(force(other, back) == force(fresh, back));
    CHECK(greatest(force(fresh, back)) > 1.2 * greatest(force(used, back)));
}
