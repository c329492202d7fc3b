// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <Eigen/Eigenvalues>

#include "fabric/materials/law.hpp"
#include "sheet.hpp"
#include "solver/base/error.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

/// Two coats of 0.1 mm on cloth of 0.3 mm, that only bend.
FabricCard coated() {
    FabricCard c = fabric_card();
    c.coat_E = 50e6;
    c.coat_thickness = 0.1e-3;
    c.coat_stretches = false;
    return c;
}
constexpr double STIFFNESS =
    2.0 / 3.0 * 50e6 * (0.25e-3 * 0.25e-3 * 0.25e-3 - 0.15e-3 * 0.15e-3 * 0.15e-3);  // [N·m]

Sheet jittered(const FabricCard& card, Mesh mesh, unsigned seed) {
    Sheet sheet = rectangle(card, mesh, 6, 5, 0.06, 0.05);
    jitter(sheet, 0.002, seed);
    return sheet;
}

CoatBending coat_of(Sheet& sheet) {
    return {sheet.setup(), lumped_mass(sheet.setup())};
}

double energy(CoatBending& coat, const Points& x) {
    Points f = zeros(x.size());
    coat.add_force(x, f);
    std::vector<double> parts(1, 0.0);
    coat.add_energy(parts);
    return parts[0];
}

Points bending_force(CoatBending& coat, const Points& x) {
    Points f = zeros(x.size());
    coat.add_force(x, f);
    return f;
}

Points crumpled(const Points& x, unsigned seed) {
    return plus(moved(x, [](const Vec3& p) { return Vec3(std::abs(p.x() - 0.03), p.y(), 0); }),
                noise(x.size(), 0.004, seed));
}

}  // namespace

TEST_CASE("a coat's force is the slope of its energy, however crumpled", "[fabric][coat]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet sheet = jittered(coated(), mesh, 1);
    CoatBending coat = coat_of(sheet);
    const Points x = crumpled(sheet.x, 2), f = bending_force(coat, x);
    const double h = 1e-5, scale = greatest(f);
    for (std::size_t n = 0; n < x.size(); ++n)
        for (int k = 0; k < 3; ++k) {
            Points more = x, less = x;
            more[n][k] += h;
            less[n][k] -= h;
            const double slope = (energy(coat, more) - energy(coat, less)) / (2 * h);
            CHECK(std::abs(f[n][k] + slope) < 1e-8 * scale);
        }
}

TEST_CASE("a coat pushes nowhere and turns nothing", "[fabric][coat]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet sheet = jittered(coated(), mesh, 3);
    CoatBending coat = coat_of(sheet);
    const Points x = crumpled(sheet.x, 4), f = bending_force(coat, x);
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (std::size_t n = 0; n < x.size(); ++n) {
        force += f[n];
        torque += x[n].cross(f[n]);
    }
    CHECK(force.norm() < 1e-12 * greatest(f) * static_cast<double>(x.size()));
    CHECK(torque.norm() < 1e-13 * greatest(f) * static_cast<double>(x.size()));
}

TEST_CASE("a coat is the same mirrored and renumbered", "[fabric][coat]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet sheet = jittered(coated(), mesh, 11);
    CoatBending coat = coat_of(sheet);
    const Points x = crumpled(sheet.x, 12), f = bending_force(coat, x);
    // Node n becomes count - 1 - n and x becomes -x; shells come in reverse, with their corners
    Sheet other = sheet;
    other.reference.clear();
    const std::size_t count = sheet.x.size();
    const auto mirrored = [](const Vec3& p) { return Vec3(-p.x(), p.y(), p.z()); };
    Points y(count);
    for (std::size_t n = 0; n < count; ++n) {
        other.x[count - 1 - n] = mirrored(sheet.x[n]);
        y[count - 1 - n] = mirrored(x[n]);
    }
    for (Shell& shell : other.shells) {
        for (Index& n : shell.nodes) n = static_cast<Index>(count) - 1 - n;
        if (shell.is_triangle())
            std::swap(shell.nodes[0], shell.nodes[1]);
        else
            std::swap(shell.nodes[1], shell.nodes[3]);
    }
    std::reverse(other.shells.begin(), other.shells.end());
    CoatBending twin = coat_of(other);
    const Points g = bending_force(twin, y);
    for (std::size_t n = 0; n < count; ++n)
        CHECK((mirrored(f[n]) - g[count - 1 - n]).norm() < 1e-11 * greatest(f));
}

TEST_CASE("a coat stores nothing when it lies anywhere or stretches evenly", "[fabric][coat]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet sheet = jittered(coated(), mesh, 5);
    CoatBending coat = coat_of(sheet);
    const double bent = energy(coat, crumpled(sheet.x, 6));
    const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    Mat3 stretch = turn;
    stretch.col(0) *= 1.2;
    stretch.col(1) += 0.3 * stretch.col(0);
    for (const Mat3& map : {turn, stretch})
        CHECK(energy(coat, moved(sheet.x, [&](const Vec3& p) { return Vec3(map * p); })) <
              1e-24 * bent);
    CHECK(greatest(bending_force(coat, sheet.x)) <
          1e-12 * greatest(bending_force(coat, crumpled(sheet.x, 6))));
}

TEST_CASE("a coat wound up into a tube stores half its stiffness times curvature squared",
          "[fabric][coat]") {
    // 2H = 1/R everywhere: W = B/(2 R²) A, the cloth at the rims reckoned to the nodes beside them
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const auto error = [&](int n) {
        Sheet sheet = rectangle(coated(), mesh, n, n, 0.1, 0.1);
        CoatBending coat = coat_of(sheet);
        const double R = 0.05;
        const Points x = moved(sheet.x, [&](const Vec3& p) {
            return Vec3(R * std::sin(p.x() / R), p.y(), R * (1 - std::cos(p.x() / R)));
        });
        return energy(coat, x) / (STIFFNESS / (2 * R * R) * 0.01) - 1;
    };
    const double coarse = error(12), fine = error(24);
    CAPTURE(coarse, fine);
    CHECK(std::abs(coarse) < 0.02);
    CHECK(std::abs(fine) < 0.26 * std::abs(coarse));
}

TEST_CASE("the step bounds a mesh whose coat bends hard", "[fabric][coat][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    Sheet sheet = jittered(coated(), mesh, 7);
    CoatBending coat = coat_of(sheet);
    const std::vector<double> mass = lumped_mass(sheet.setup());
    const auto size = static_cast<Eigen::Index>(sheet.x.size());
    Eigen::MatrixXd k(size, size);
    for (Eigen::Index j = 0; j < size; ++j) {
        Points x = zeros(sheet.x.size());
        x[static_cast<std::size_t>(j)].z() = 1.0;
        const Points f = bending_force(coat, x);
        for (Eigen::Index i = 0; i < size; ++i)
            k(i, j) =
                -f[static_cast<std::size_t>(i)].z() /
                std::sqrt(mass[static_cast<std::size_t>(i)] * mass[static_cast<std::size_t>(j)]);
    }
    CHECK((k - k.transpose()).norm() < 1e-12 * k.norm());
    const double exact = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k).eigenvalues().maxCoeff();
    CHECK(coat.rate() >= exact);
    CHECK(coat.rate() < 3.5 * exact);
    CHECK(coat.lengthened(coat.shortened(1e-5)) == Approx(1e-5).epsilon(1e-12));
}

TEST_CASE("a coated sheet that flutters keeps its energy at 0.9 of the step",
          "[fabric][coat][step]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    FabricCard card = coated();
    card.coat_E = 20e9;  // bending matters to the step
    card.no_compression = true;
    card.damping = GENERATE(0.0, 0.1);
    Sheet sheet = jittered(card, mesh, 8);
    Membranes membranes = sheet.membranes();
    const std::vector<double> mass = lumped_mass(sheet.setup());
    CHECK(membranes.coat().rate() * std::pow(membranes.stable_step().dt, 2) > 0.25);
    Points x = sheet.x, v = noise(x.size(), 2.0, 9);
    double start = NaN, most = 0.0;
    for (int i = 0; i < 3000; ++i) {
        const Points f = force(membranes, x, v);
        const double dt = 0.9 * membranes.stable_step().dt;
        double total = membranes.strain_energy();
        for (std::size_t n = 0; n < x.size(); ++n) {
            const Vec3 kicked = v[n] + dt / mass[n] * f[n];
            total += 0.5 * mass[n] * (0.5 * (v[n] + kicked)).squaredNorm();
            v[n] = kicked;
            x[n] += dt * v[n];
        }
        if (i == 0) start = total;
        most = std::max(most, total / start);
    }
    CHECK(most < 2.0);
}

TEST_CASE("mass scaling knows of the coat", "[fabric][coat][step]") {
    FabricCard card = coated();
    card.coat_E = 5e9;
    Sheet sheet = jittered(card, Mesh::MIXED, 10);
    Membranes membranes = sheet.membranes();
    const double wish = 1.2 * membranes.stable_step().dt;
    static_cast<void>(membranes.scale_mass(wish, Membranes::Scaling::WHERE_NEEDED));
    CHECK(membranes.stable_step().dt == Approx(wish).epsilon(1e-12));
    const double too_long = 1.1 / std::sqrt(membranes.coat().rate());
    CHECK_THROWS_AS(membranes.scale_mass(too_long, Membranes::Scaling::WHERE_NEEDED), InputError);
}

TEST_CASE("a coat of positive TCOAT stretches with the cloth", "[fabric][coat]") {
    FabricCard card = coated();
    CHECK(layer_moduli(card, 0.3e-3).warp == 0.0);
    CHECK(std::holds_alternative<Linear>(make_law({1, "", card}, {}, 0.3e-3).law));
    card.coat_stretches = true;
    const PlaneModuli with = layer_moduli(card, 0.3e-3);
    CHECK(with.warp == Approx(2.0 * 50e6 / 3.0));
    CHECK(with.cross == 0.0);
    CHECK(with.shear == Approx(50e6 / 3.0));
    CHECK(std::holds_alternative<Lined<Linear>>(make_law({1, "", card}, {}, 0.3e-3).law));
}

TEST_CASE("rims and seams do not bend", "[fabric][coat]") {
    // Two panels of one part, sewn round their rim: their normals look away from each other
    Sheet sheet = rectangle(coated(), Mesh::ONE_POINT, 4, 4, 0.04, 0.04);
    const std::size_t nodes = sheet.x.size(), shells = sheet.shells.size();
    std::vector<Index> upper(nodes);
    for (std::size_t n = 0; n < nodes; ++n) {
        const Vec3 at = sheet.x[n];
        const bool is_rim =
            at.x() < 1e-9 || at.y() < 1e-9 || at.x() > 0.04 - 1e-9 || at.y() > 0.04 - 1e-9;
        upper[n] = static_cast<Index>(is_rim ? n : sheet.x.size());
        if (!is_rim) sheet.x.push_back(at);
    }
    for (std::size_t s = 0; s < shells; ++s) {
        Shell turned = sheet.shells[s];
        std::swap(turned.nodes[1], turned.nodes[3]);
        for (Index& n : turned.nodes) n = upper[static_cast<std::size_t>(n)];
        sheet.shells.push_back(turned);
    }
    CoatBending coat = coat_of(sheet);
    REQUIRE(coat.parts().size() == 1);
    CHECK(coat.parts()[0].inner == sheet.x.size());
    CHECK(coat.parts()[0].sewn == 16);
    // Opened along the seam both stay flat
    for (std::size_t n = nodes; n < sheet.x.size(); ++n) CHECK(sheet.x[n].z() == 0.0);
    CHECK(energy(coat, sheet.x) == Approx(0.0).margin(1e-20));
    // A part without any inner node does not bend, one without a coat costs nothing
    Sheet strip = rectangle(coated(), Mesh::ONE_POINT, 4, 1, 0.04, 0.01);
    CHECK(coat_of(strip).empty());
    Sheet plain = rectangle(fabric_card(), Mesh::ONE_POINT, 4, 4, 0.04, 0.04);
    CHECK(coat_of(plain).empty());
    CHECK(coat_of(plain).parts().empty());
}
