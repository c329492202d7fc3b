// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Waves in a sheet of orthotropic cloth.

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <cmath>
#include <Eigen/Eigenvalues>

#include "fabric/materials/plane_stress.hpp"
#include "tests/unit/fabric/sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

FabricCard woven_along() {
    FabricCard card = fabric_card();
    card.axes = 2;
    return card;
}

/// Christoffel's matrix of a plane wave along n, per density: its roots are the speeds squared.
Eigen::Matrix2d christoffel(const Eigen::Vector2d& n) {
    const FabricCard c = woven_along();
    const PlaneModuli d = orthotropic_moduli(c.E_warp, c.E_weft, c.nu_ba, c.G);
    Eigen::Matrix2d g;
    g(0, 0) = d.warp * n.x() * n.x() + d.shear * n.y() * n.y();
    g(1, 1) = d.weft * n.y() * n.y() + d.shear * n.x() * n.x();
    g(0, 1) = g(1, 0) = (d.cross + d.shear) * n.x() * n.y();
    return g / c.density;
}

/// Speed of the wave u = a sin(k·x) in a mesh of n × n cells, one wavelength wide: ω² = 2W/(M
/// a²/2), with the energies W of sine and cosine taken together, so that the sheet may end
/// anywhere.
double speed(Mesh mesh, int n, const Eigen::Vector2d& direction, const Eigen::Vector2d& a) {
    const double side = 0.1, k = 2 * M_PI / side, amplitude = 1e-7;
    Sheet sheet = rectangle(woven_along(), mesh, n, n, side, side);
    Membranes membranes = sheet.membranes();
    double mass = 0.0, energy = 0.0;
    for (const double m : lumped_mass(sheet.setup())) mass += m;
    for (const double shift : {0.0, 0.5 * M_PI}) {
        force(membranes, moved(sheet.x, [&](const Vec3& at) {
                  const double phase = k * (direction.x() * at.x() + direction.y() * at.y());
                  const double u = amplitude * std::sin(phase + shift);
                  return Vec3(at + u * Vec3(a.x(), a.y(), 0));
              }));
        energy += membranes.strain_energy();
    }
    return std::sqrt(2 * energy / (mass * amplitude * amplitude)) / k;
}

}  // namespace

TEST_CASE("waves run at the speed of their direction and kind, across the yarns too") {
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    for (const double degrees : {0.0, 15.0, 30.0, 45.0, 70.0}) {
        const Eigen::Vector2d n(std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> waves(christoffel(n));
        for (const int kind : {0, 1}) {  // the slow one, the fast one
            const double exact = std::sqrt(waves.eigenvalues()[kind]);
            double before = NaN, error = NaN;
            for (const int cells : {16, 32, 64}) {
                before = error;
                error = speed(mesh, cells, n, waves.eigenvectors().col(kind)) / exact - 1;
            }
            const double order = std::log2(std::abs(before / error));
            fmt::print(
                "Wave at {:g}° to the warp, {}, {}: {:.2f} m/s, error {:+.3f} % (64 cells a "
                "wavelength), order {:.2f}\n",
                degrees, kind == 0 ? "slow" : "fast", name(mesh), exact, 100 * error, order);
            CHECK(std::abs(error) < 0.005);
            CHECK(order > 1.8);
        }
    }
}

TEST_CASE("a pulse runs along a sheet without changing its shape") {
    // u(x, t) = A exp(-(x - x0 - c t)²/w²), held across: c² = D11/rho
    const Mesh mesh = GENERATE(from_range(std::begin(PURE_MESHES), std::end(PURE_MESHES)));
    const FabricCard card = woven_along();
    const PlaneModuli d = orthotropic_moduli(card.E_warp, card.E_weft, card.nu_ba, card.G);
    const double c = std::sqrt(d.warp / card.density), length = 1.0, A = 1e-7, w = 0.05;
    const auto pulse = [&](double x, double t) {
        const double s = (x - 0.25 - c * t) / w;
        return A * std::exp(-s * s);
    };
    double before = NaN, error = NaN, arrival = NaN;
    for (const int n : {100, 200, 400}) {
        Sheet sheet = rectangle(card, mesh, n, 1, length, length / n);
        Membranes membranes = sheet.membranes();
        const std::vector<double> mass = lumped_mass(sheet.setup());
        // A tenth of the stable step on the coarse mesh: the mesh's own error is looked at
        const double travel = 0.5, dt = travel / c / std::ceil(travel / c / (1e-3 * length / c));
        const int steps = static_cast<int>(std::lround(travel / c / dt));
        Points x = sheet.x, v = zeros(x.size()), f(x.size());
        for (std::size_t k = 0; k < x.size(); ++k) {
            const double at = sheet.x[k].x();
            v[k].x() = (pulse(at, 0) - pulse(at, -dt)) / dt;
            x[k].x() += pulse(at, 0);
        }
        for (int i = 0; i < steps; ++i) {
            std::fill(f.begin(), f.end(), Vec3::Zero());
            REQUIRE(membranes.add_force(x, v, f) == -1);
            for (std::size_t k = 0; k < x.size(); ++k) {
                v[k].x() += dt / mass[k] * f[k].x();
                x[k].x() += dt * v[k].x();
            }
        }
        double sum = 0.0, all = 0.0, first = 0.0, weight = 0.0;
        for (int k = 0; k <= n; ++k) {
            const double at = sheet.x[k].x(), u = x[k].x() - at, exact = pulse(at, travel / c);
            sum += (u - exact) * (u - exact);
            all += exact * exact;
            first += u * at;
            weight += u;
        }
        before = error;
        error = std::sqrt(sum / all);
        arrival = (first / weight - 0.25) / travel - 1;
        fmt::print("Pulse, {}, {} cells: error {:.3f} %, speed {:+.4f} %, order {:.2f}\n",
                   name(mesh), n, 100 * error, 100 * arrival, std::log2(before / error));
    }
    CHECK(error < 0.01);
    CHECK(std::abs(arrival) < 0.005);
    CHECK(std::log2(before / error) > 1.8);
}
