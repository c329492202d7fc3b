// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <numeric>

#include "sheet.hpp"
#include "solver/base/parallel.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

FabricCard everything() {
    FabricCard c = fabric_card();
    c.no_compression = true;
    c.damping = 0.05;
    c.liner_E = 20e6;
    c.liner_ratio = 0.1;
    c.axes = 2;
    c.a = {1, 0.3, 0};
    return c;
}

}  // namespace

TEST_CASE("one and two threads give the same bits", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet sheet = rectangle(everything(), mesh, 50, 30, 1.0, 0.6);
    const Points x = plus(sheet.x, noise(sheet.x.size(), 0.01, 1));
    const Points v = noise(sheet.x.size(), 5.0, 2);
    struct Answer {
        Points f;
        double energy, dissipated, dt;
        Index shell;
    };
    const auto run = [&](int threads) {
        parallel::set_threads(threads);
        Membranes membranes = sheet.membranes();
        const Points f = force(membranes, x, v);
        return Answer{f, membranes.strain_energy(), membranes.damping_energy(v, v, 1.0),
                      membranes.stable_step().dt, membranes.stable_step().shell};
    };
    const Answer one = run(1), two = run(2);
    parallel::set_threads(1);
    CHECK(one.f == two.f);
    CHECK(one.energy == two.energy);
    CHECK(one.dissipated == two.dissipated);
    CHECK(one.dt == two.dt);
    CHECK(one.shell == two.shell);
}

TEST_CASE("a mirrored mesh gives mirrored forces", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    FabricCard card = everything();
    Sheet sheet = rectangle(card, mesh, 5, 4, 0.5, 0.4);
    jitter(sheet, 0.02);
    Sheet mirrored = sheet;
    card.a.x() = -card.a.x();
    mirrored.materials[0].card = card;
    const auto mirror = [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); };
    mirrored.x = moved(sheet.x, mirror);
    const Points x = plus(sheet.x, noise(sheet.x.size(), 0.02, 3));
    Membranes one = sheet.membranes(), other = mirrored.membranes();
    const Points f = force(one, x), g = force(other, moved(x, mirror));
    for (std::size_t n = 0; n < f.size(); ++n)
        CHECK((mirror(f[n]) - g[n]).norm() < 1e-9 * greatest(f));
    CHECK(one.strain_energy() == Approx(other.strain_energy()).epsilon(1e-9));
}

TEST_CASE("numbering of nodes, shells and corners does not matter", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet sheet = rectangle(everything(), mesh, 5, 4, 0.5, 0.4);
    jitter(sheet, 0.02);
    const Points x = plus(sheet.x, noise(sheet.x.size(), 0.02, 3));

    std::vector<Index> to(sheet.x.size());
    std::iota(to.begin(), to.end(), 0);
    std::shuffle(to.begin(), to.end(), std::mt19937(1));
    const auto renumbered = [&](const Points& from) {
        Points out(from.size());
        for (std::size_t n = 0; n < from.size(); ++n)
            out[static_cast<std::size_t>(to[n])] = from[n];
        return out;
    };
    Sheet other = sheet;
    other.x = renumbered(sheet.x);
    int turn = 0;
    for (Shell& s : other.shells) {
        const std::size_t count = s.is_triangle() ? 3 : 4;
        for (Index& n : s.nodes) n = to[static_cast<std::size_t>(n)];
        std::rotate(s.nodes.begin(), s.nodes.begin() + turn++ % 3, s.nodes.begin() + count);
        if (count == 3) s.nodes[3] = s.nodes[2];
    }
    std::reverse(other.shells.begin(), other.shells.end());
    Membranes a = sheet.membranes(), b = other.membranes();
    const Points f = renumbered(force(a, x)), g = force(b, renumbered(x));
    for (std::size_t n = 0; n < f.size(); ++n) CHECK((f[n] - g[n]).norm() < 1e-9 * greatest(f));
}

TEST_CASE("only the reference geometry decides what is stress-free", "[fabric]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet flat = rectangle(everything(), mesh, 5, 4, 0.5, 0.4);
    Sheet folded = flat;
    const MembraneSetup setup = flat.setup();
    folded.reference = flat.reference;
    // Folded about x = 0.2, crumpled: where it lies is nothing but a position
    folded.x = moved(flat.x, [](const Vec3& p) { return Vec3(std::abs(p.x() - 0.2), p.y(), 0.0); });
    Membranes a(setup), b = folded.membranes();
    CHECK(a.stable_step().dt == b.stable_step().dt);
    CHECK(lumped_mass(setup) == lumped_mass(folded.setup()));
    CHECK(greatest(force(b, flat.x)) < 1e-9);
    const Points x = plus(flat.x, noise(flat.x.size(), 0.02, 3));
    CHECK(force(a, x) == force(b, x));
}

TEST_CASE("energies are kept by part", "[fabric]") {
    Sheet sheet = rectangle(everything(), Mesh::MIXED, 6, 4, 0.5, 0.4);
    add_part(sheet, ElasticCard{900.0, 100e6, 0.3}, Mesh::FOUR_POINT);
    for (std::size_t e = 0; e < sheet.shells.size(); e += 2) sheet.shells[e].part = 1;
    Membranes membranes = sheet.membranes();
    const Points x = plus(sheet.x, noise(sheet.x.size(), 0.02, 3));
    force(membranes, x);
    const double both = membranes.strain_energy();
    const std::vector<double> parts(membranes.part_strain_energy().begin(),
                                    membranes.part_strain_energy().end());
    CHECK(parts[0] + parts[1] == Approx(both).epsilon(1e-14));
    // Each alone holds its own
    for (Index part = 0; part < 2; ++part) {
        MembraneSetup setup = sheet.setup();
        for (std::size_t e = 0; e < sheet.shells.size(); ++e)
            sheet.active[e] = sheet.shells[e].part == part;
        Membranes alone(setup);
        force(alone, x);
        CHECK(alone.strain_energy() ==
              Approx(parts[static_cast<std::size_t>(part)]).epsilon(1e-12));
    }
}
