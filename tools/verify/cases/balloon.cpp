// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// A soft sphere that is filled and vents, against equations of its own.

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/membranes.hpp"
#include "tools/verify/exact/vented_balloon.hpp"

namespace corpuscle::verify {
namespace {

/// Share of part 2 in the area of all shells, triangles.
double share_of_vents(const MeasuredRun& run) {
    const auto x = run.vectors("/mesh/coordinates");
    const auto nodes = run.read("/mesh/shell_nodes"), part = run.read("/mesh/shell_part");
    double vents = 0.0, all = 0.0;
    for (std::size_t s = 0; s < part.size(); ++s) {
        const auto at = [&](std::size_t k) {
            return x[static_cast<std::size_t>(nodes[4 * s + k])];
        };
        const double area = (at(1) - at(0)).cross(at(2) - at(0)).norm();
        all += area;
        if (part[s] == 2.0) vents += area;
    }
    return vents / all;
}

/// Of models/verification/vented_bag, its sphere as large as the mesh.
oracle::VentedBalloon balloon_of(const MeasuredRun& run) {
    constexpr double DENSITY = 750.0, THICKNESS = 0.3e-3, E = 30e6, NU = 0.2, C23 = 0.03;
    constexpr double P_ATM = 101325.0, T = 300.0, M = 0.028, CP = 28.0;
    const auto D = oracle::cloth_moduli(E, E, NU);
    const double pi = std::acos(-1.0), volume = run.read("/history/airbag/1/volume").front();
    oracle::VentedBalloon balloon{std::cbrt(0.75 * volume / pi),
                                  DENSITY * THICKNESS,
                                  THICKNESS * (D.warp + D.cross),
                                  C23 * share_of_vents(run),
                                  P_ATM,
                                  M,
                                  CP};
    balloon.mass = P_ATM * volume * M / (GAS_CONSTANT * T);
    balloon.energy = balloon.mass / M * (CP - GAS_CONSTANT) * T;
    return balloon;
}

}  // namespace

/// 100 g of 600 K enter until 50 ms.
Findings vented_bag(const Runs& runs) {
    constexpr double T_IN = 600.0, MOST = 4.0, RISES = 10e-3, ENDS = 50e-3;
    constexpr double FROM = 20e-3, TO = 60e-3, P_ATM = 101325.0;
    const auto inflow = [](double t) {
        return MOST * std::max(0.0, std::min(t / RISES, (ENDS - t) / (ENDS - RISES)));
    };
    return by_run(runs, [&](const MeasuredRun& run) {
        const std::string bag = "/history/airbag/1/";
        const auto time = run.time(), m = run.read(bag + "mass"), T = run.read(bag + "temperature"),
                   V = run.read(bag + "volume"), p = run.read(bag + "pressure");
        oracle::VentedBalloon exact = balloon_of(run);
        double mass = 0.0, heat = 0.0, volume = 0.0, found = 0.0, expected = 0.0;
        const auto keep = [](double& worst, double a, double b) {
            worst = std::max(worst, std::abs(a / b - 1.0));
        };
        for (std::size_t i = 0; i < time.size(); ++i) {
            if (i > 0) exact.advance(time[i - 1], time[i], 200, inflow, T_IN);
            keep(mass, m[i], exact.mass);
            keep(heat, T[i], exact.temperature());
            keep(volume, V[i], exact.volume());
            if (time[i] < FROM || time[i] > TO) continue;
            found += p[i] - P_ATM;
            expected += exact.pressure() - P_ATM;
        }
        return std::map<std::string, double>{{"mass", mass},
                                             {"temperature", heat},
                                             {"volume", volume},
                                             {"pressure", found / expected - 1.0}};
    });
}

}  // namespace corpuscle::verify
