// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>

#include "fabric/element_frequency.hpp"
#include "fabric/elements/quad_four_point.hpp"
#include "fabric/elements/quad_one_point.hpp"
#include "fabric/elements/triangle.hpp"
#include "sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

Sheet jittered(const MaterialCard& card, Mesh mesh, unsigned seed) {
    Sheet sheet = rectangle(card, mesh, 4, 3, 0.4, 0.3);
    jitter(sheet, 0.03, seed);
    return sheet;
}

/// Highest frequency of the whole mesh, by the slope of its force at rest. [rad/s]
double mesh_frequency(Sheet& sheet) {
    Membranes membranes = sheet.membranes();
    const std::vector<double> mass = lumped_mass(sheet.setup());
    const auto size = static_cast<Eigen::Index>(3 * sheet.x.size());
    Eigen::MatrixXd k(size, size);
    const double step = 1e-7;
    for (Eigen::Index j = 0; j < size; ++j) {
        const auto n = static_cast<std::size_t>(j / 3);
        Points ahead = sheet.x, back = sheet.x;
        ahead[n][j % 3] += step;
        back[n][j % 3] -= step;
        const Points more = force(membranes, ahead), less = force(membranes, back);
        for (Eigen::Index i = 0; i < size; ++i) {
            const auto m = static_cast<std::size_t>(i / 3);
            k(i, j) = (less[m][i % 3] - more[m][i % 3]) / (2 * step) / std::sqrt(mass[m] * mass[n]);
        }
    }
    k = 0.5 * (k + k.transpose()).eval();
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues().maxCoeff());
}

/// Greatest kinetic energy of many steps after a small disturbance in the plane, over that at the
/// start. Loads that do not change hold x as it is.
double growth(Sheet& sheet, double dt, int steps, Points x) {
    Membranes membranes = sheet.membranes();
    const std::vector<double> mass = lumped_mass(sheet.setup());
    const Points held = force(membranes, x);
    Points v = noise(x.size(), 1e-6, 21);
    for (Vec3& at : v) at.z() = 0.0;
    const auto kinetic = [&] {
        double sum = 0.0;
        for (std::size_t n = 0; n < x.size(); ++n) sum += 0.5 * mass[n] * v[n].squaredNorm();
        return sum;
    };
    const double start = kinetic();
    double most = start;
    for (int i = 0; i < steps && most < 1e20 * start; ++i) {
        const Points f = force(membranes, x, v);
        for (std::size_t n = 0; n < x.size(); ++n) {
            v[n] += dt / mass[n] * (f[n] - held[n]);
            x[n] += dt * v[n];
        }
        most = std::max(most, kinetic());
    }
    return most / start;
}

/// In a stable mode K(t + dt/2) may reach 1/(1 - (ω dt/2)²) times its start: 50 at 0.99 of the
/// limit.
constexpr double STABLE = 60.0, UNSTABLE = 1e6;

}  // namespace

TEST_CASE("a triangle's frequency is that of its closed form", "[fabric][step]") {
    // ω² = (3/(rho h)) λmax(D^½ B Bᵀ D^½)
    const FabricCard c = fabric_card();
    const Shell shell{1, 0, {0, 1, 2, 2}};
    const std::array<Vec3, 4> x{Vec3(0, 0, 0), Vec3(0.01, 0.001, 0), Vec3(0.004, 0.008, 0),
                                Vec3(0.004, 0.008, 0)};
    std::string fault;
    const ReferenceShape r = lay_flat(shell, x, c, fault);
    const double h = 0.3e-3;
    const PlaneModuli d = orthotropic_moduli(c.E_warp, c.E_weft, c.nu_ba, c.G);
    const Triangle<double> t = make_triangle(r, h);
    Eigen::Matrix<double, 3, 6> B;
    const double b01 = -t.b11 - t.b21, b02 = -t.b12 - t.b22;
    B << b01, 0, t.b11, 0, t.b21, 0,  //
        0, b02, 0, t.b12, 0, t.b22,   //
        b02, b01, t.b12, t.b11, t.b22, t.b21;
    Eigen::Matrix3d D;
    D << d.warp, d.cross, 0, d.cross, d.weft, 0, 0, 0, d.shear;
    const Eigen::Matrix3d root = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(D).operatorSqrt();
    const double expected =
        3 / c.density *
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(root * B * B.transpose() * root)
            .eigenvalues()
            .maxCoeff();
    const std::vector<double> mass(3, c.density * h * r.area / 3);
    CHECK(highest_frequency_squared(rest_stiffness(t, r, d), mass.data()) ==
          Approx(expected).epsilon(1e-12));
}

TEST_CASE("the step bounds the mesh, and closely", "[fabric][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const unsigned seed = GENERATE(1u, 2u, 3u);
    FabricCard c = fabric_card();
    c.liner_E = 100e6;
    c.liner_ratio = GENERATE(0.0, 0.3);
    Sheet sheet = jittered(c, mesh, seed);
    const double dt = sheet.membranes().stable_step().dt;
    const double exact = 2 / mesh_frequency(sheet);
    CHECK(dt <= exact * (1 + 1e-6));
    CHECK(dt > 0.8 * exact);
}

TEST_CASE("a mesh is stable just below its limit and not above", "[fabric][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const double damping = GENERATE(0.0, 0.05, 0.4);
    FabricCard c = fabric_card();
    c.damping = damping;
    Sheet sheet = jittered(c, mesh, 4);
    const double dt = sheet.membranes().stable_step().dt;
    CHECK(growth(sheet, 0.99 * dt, 2000, sheet.x) < STABLE);
    // One element is its own mesh: its bound is exact
    sheet.shells.resize(1);
    sheet.reference.clear();
    const Points all = sheet.x;
    sheet.x.clear();
    for (Index& n : sheet.shells[0].nodes) {
        sheet.x.push_back(all[static_cast<std::size_t>(n)]);
        n = static_cast<Index>(sheet.x.size()) - 1;
    }
    if (mesh == Mesh::TRIANGLES || mesh == Mesh::MIXED) {
        sheet.shells[0].nodes[3] = 2;
        sheet.x.pop_back();
    }
    const Membranes::Step one = sheet.membranes().stable_step();
    CHECK(one.shell == 0);
    CHECK(growth(sheet, 0.99 * one.dt, 2000, sheet.x) < STABLE);
    CHECK(growth(sheet, 1.01 * one.dt, 2000, sheet.x) > UNSTABLE);
}

TEST_CASE("a stretched or sheared mesh is stable just below the step that it then has",
          "[fabric][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const bool isotropic = GENERATE(false, true);
    // No compression: yarns of a plain fabric would buckle in their plane, at any step
    const auto map = GENERATE(Vec3(1.2, 1.2, 0), Vec3(1.3, 1.1, 0), Vec3(1.3, 1.3, 0.6));
    Sheet sheet =
        jittered(isotropic ? MaterialCard(ElasticCard{900, 200e6, 0.3}) : fabric_card(), mesh, 8);
    const Points x = moved(sheet.x, [&](const Vec3& p) {
        return Vec3(map.x() * p.x() + map.z() * p.y(), map.y() * p.y(), 0);
    });
    Membranes membranes = sheet.membranes();
    force(membranes, x);
    CHECK(growth(sheet, 0.99 * membranes.stable_step().dt, 2000, x) < STABLE);
}

TEST_CASE("stretching shortens the step, folding does not", "[fabric][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    FabricCard card = fabric_card();
    card.damping = GENERATE(0.0, 0.02);
    Sheet sheet = jittered(card, mesh, 5);
    Membranes membranes = sheet.membranes();
    const double rest = membranes.stable_step().dt;
    force(membranes, moved(sheet.x, [](const Vec3& p) { return Vec3(1.1 * p); }));
    const double least = rest / std::sqrt(1 + 3 * 0.105), most = rest / std::sqrt(1 + 2 * 0.105);
    CHECK(membranes.stable_step().dt >= (1 - 1e-9) * least);
    CHECK(membranes.stable_step().dt <= (1 + 1e-9) * (card.damping > 0.0 ? most : least));
    const Points folded =
        moved(sheet.x, [](const Vec3& p) { return Vec3(0.5 * p.x(), 0, 0.3 * p.y()); });
    Membranes other = sheet.membranes();
    force(other, folded);
    CHECK(other.stable_step().dt == Approx(rest).epsilon(1e-12));
    // A step that has fallen is held for a while
    for (int i = 0; i < HeldStep::HELD; ++i) {
        CHECK(membranes.stable_step().dt < 0.9 * rest);
        force(membranes, folded);
    }
    for (int i = 0; i < HeldStep::HELD; ++i) force(membranes, folded);
    CHECK(membranes.stable_step().dt == Approx(rest).epsilon(1e-12));
}

TEST_CASE("mass scaling gives exactly the step that was asked for", "[fabric][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    FabricCard c = fabric_card();
    c.damping = GENERATE(0.0, 0.1);
    Sheet sheet = jittered(c, mesh, 6);
    Membranes membranes = sheet.membranes();
    const double rest = membranes.stable_step().dt, wish = 1.3 * rest;

    const auto needed = membranes.scale_mass(wish, Membranes::Scaling::WHERE_NEEDED);
    CHECK(membranes.stable_step().dt == Approx(wish).epsilon(1e-12));
    double total = 0.0;
    for (const double m : needed.node) {
        CHECK(m >= 0.0);
        total += m;
    }
    CHECK(total == Approx(needed.total));
    CHECK(total > 0.0);
    CHECK(sheet.membranes().scale_mass(0.5 * rest, Membranes::Scaling::WHERE_NEEDED).total == 0.0);
    CHECK(sheet.membranes().scale_mass(0.5 * rest, Membranes::Scaling::EVERYWHERE).total < 0.0);
}

TEST_CASE("a scene without active shells has no step", "[fabric][step]") {
    Sheet sheet = rectangle(fabric_card(), Mesh::MIXED, 2, 2, 1, 1);
    MembraneSetup setup = sheet.setup();
    sheet.active.assign(sheet.shells.size(), 0);
    Membranes membranes(setup);
    CHECK(membranes.stable_step().dt == INF);
    CHECK(membranes.stable_step().shell == -1);
    CHECK(greatest(force(membranes, sheet.x)) == 0.0);
    CHECK(membranes.strain_energy() == 0.0);
}

TEST_CASE("a sheet that flutters, wrinkles and folds keeps its energy", "[fabric][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    FabricCard c = fabric_card();
    c.no_compression = true;
    Sheet sheet = jittered(c, mesh, 9);
    const std::vector<double> mass = lumped_mass(sheet.setup());
    const auto worst = [&](double share) {
        Membranes membranes = sheet.membranes();
        const double dt = share * membranes.stable_step().dt;
        Points x = sheet.x, v = noise(x.size(), 20.0, 3);
        double start = NaN, most = 0.0;
        for (int i = 0; i < 1000 / share; ++i) {
            const Points f = force(membranes, x, v);
            double energy = membranes.strain_energy();
            for (std::size_t n = 0; n < x.size(); ++n) {
                const Vec3 kicked = v[n] + dt / mass[n] * f[n];
                energy += 0.5 * mass[n] * (0.5 * (v[n] + kicked)).squaredNorm();
                v[n] = kicked;
                x[n] += dt * v[n];
            }
            if (i == 0) start = energy;
            most = std::max(most, std::abs(energy / start - 1));
        }
        return most;
    };
    const double coarse = worst(0.4), fine = worst(0.2);
    CAPTURE(coarse, fine);
    CHECK(coarse < 0.02);
    CHECK(fine < 0.5 * coarse);
}
