// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <Eigen/Eigenvalues>
#include <functional>
#include <random>
#include "fabric/materials/law.hpp"
#include "sheet.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/fabric/curves_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;
using namespace curves_setup;

TEST_CASE("the step bounds a mesh with curves in any state", "[fabric][curves]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const int form = GENERATE(4, 14);
    const Vec3 map = GENERATE(Vec3(1, 1, 0), Vec3(1.2, 1.1, 0), Vec3(1.05, 1, 0.8),
                              Vec3(1, 0.6, 1.5), Vec3(0.4, 0.3, 0.1), Vec3(0.3, 1.2, -3));
    FabricCard card = curved_card(form, false);
    card.axes = 2;
    Sheet sheet = sheet_of(card, mesh);
    Membranes membranes = sheet.membranes();
    const std::vector<double> mass = lumped_mass(sheet.setup());
    const Points x = plus(moved(sheet.x,
                                [&](const Vec3& p) {
                                    return Vec3(map.x() * p.x() + map.z() * p.y(), map.y() * p.y(),
                                                0.1 * p.x() * p.y());
                                }),
                          noise(sheet.x.size(), 0.01, 4));
    force(membranes, x);
    const double dt = membranes.stable_step().dt;
    const auto size = static_cast<Eigen::Index>(3 * x.size());
    Eigen::MatrixXd k(size, size);
    const double step = 1e-9;
    for (Eigen::Index j = 0; j < size; ++j) {
        const auto n = static_cast<std::size_t>(j / 3);
        Points ahead = x, back = x;
        ahead[n][j % 3] += step;
        back[n][j % 3] -= step;
        const Points more = force(membranes, ahead), less = force(membranes, back);
        for (Eigen::Index i = 0; i < size; ++i) {
            const auto m = static_cast<std::size_t>(i / 3);
            k(i, j) = (less[m][i % 3] - more[m][i % 3]) / (2 * step) / std::sqrt(mass[m] * mass[n]);
        }
    }
    k = 0.5 * (k + k.transpose()).eval();
    const double most = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(k, Eigen::EigenvaluesOnly)
                            .eigenvalues()
                            .maxCoeff();
    CAPTURE(form, map.transpose(), dt * std::sqrt(most) / 2);
    CHECK(dt * std::sqrt(most) <= 2 * (1 + 1e-4));
}

TEST_CASE("loops lose what the ledger of a sheet misses, never less than nothing",
          "[fabric][curves]") {
    const Mesh mesh = GENERATE(from_range(std::begin(MESHES), std::end(MESHES)));
    const int form = GENERATE(4, 14);
    const double reload = GENERATE(0.0, 0.7);
    if (form == 4 && reload > 0) return;
    Sheet sheet = sheet_of(curved_card(form, true, reload), mesh);
    const std::vector<double> mass = lumped_mass(sheet.setup());
    const auto worst = [&](double share) {
        Membranes membranes = sheet.membranes();
        const double dt = share * membranes.stable_step().dt;
        Points x = sheet.x, v = noise(x.size(), 60.0, 3);
        double start = NaN, most = 0.0, lost = 0.0;
        for (int i = 0; i < 600 / share; ++i) {
            const Points f = force(membranes, x, v);
            CHECK(membranes.lost_energy() >= lost * (1 - 1e-12));
            lost = membranes.lost_energy();
            double energy = membranes.strain_energy() + lost;
            for (std::size_t n = 0; n < x.size(); ++n) {
                const Vec3 kicked = v[n] + dt / mass[n] * f[n];
                energy += 0.5 * mass[n] * (0.5 * (v[n] + kicked)).squaredNorm();
                v[n] = kicked;
                x[n] += dt * v[n];
            }
            if (i == 0) start = energy;
            most = std::max(most, std::abs(energy / start - 1));
        }
        CHECK(lost > 0.05 * start);
        return most;
    };
    const double coarse = worst(0.4), fine = worst(0.1);
    CAPTURE(coarse, fine);
    CHECK(coarse < 0.02);
    CHECK(fine < 0.5 * coarse);
}
