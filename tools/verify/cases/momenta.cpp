// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Momentum: a free bag and a free rigid box that fly and spin, a jet that strikes a plate, a jet in
// air.

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "solver/base/constants.hpp"
#include "tools/verify/case_list.hpp"

namespace corpuscle::verify {
namespace {

/// Linear, and angular about the origin.
struct Momentum {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();

    void add(double mass, const Vec3& x, const Vec3& v) {
        linear += mass * v;
        angular += mass * x.cross(v);
    }
    [[nodiscard]] Momentum change_from(const Momentum& start) const {
        return {linear - start.linear, angular - start.angular};
    }
};

/// Masses of the nodes of a bag of triangles: a third of each.                            [kg]
std::vector<double> node_masses(const MeasuredRun& run, double mass_by_area) {
    const auto x = run.vectors("/mesh/coordinates");
    const auto nodes = run.read("/mesh/shell_nodes");
    std::vector<double> mass(x.size(), 0.0);
    for (std::size_t s = 0; s + 3 < nodes.size(); s += 4) {
        const auto at = [&](std::size_t k) { return static_cast<std::size_t>(nodes[s + k]); };
        const Vec3 normal = (x[at(1)] - x[at(0)]).cross(x[at(2)] - x[at(0)]);
        for (const std::size_t k : {0u, 1u, 2u})
            mass[at(k)] += mass_by_area * 0.5 * normal.norm() / 3.0;
    }
    return mass;
}

Momentum momentum_of_gas(const MeasuredRun& run, const std::string& frame) {
    const auto x = run.vectors(frame + "particles/position"),
               v = run.vectors(frame + "particles/velocity");
    const auto mass = run.read(frame + "particles/mass");
    Momentum gas;
    for (std::size_t i = 0; i < mass.size(); ++i) gas.add(mass[i], x[i], v[i]);
    return gas;
}

/// Walls at a frame, with what the gas has given up and they have not yet got, and gas keep both
/// momenta: the worst change, of what there is at the start. A row of the history is a frame.
/// @param walls  Momentum(frame's row, frame's path)
template <class Walls>
std::map<std::string, double> changes(const MeasuredRun& run, Walls&& walls) {
    const auto owed = run.vectors("/history/airbag/1/owed_momentum"),
               owed_angular = run.vectors("/history/airbag/1/owed_angular_momentum");
    const auto frames = run.frames();
    Momentum start;
    double linear = 0.0, angular = 0.0;
    for (std::size_t f = 0; f < frames.size(); ++f) {
        Momentum all = momentum_of_gas(run, frames[f]);
        const Momentum of_walls = walls(f, frames[f]);
        all.linear += of_walls.linear + owed.at(f);
        all.angular += of_walls.angular + owed_angular.at(f);
        if (f == 0) start = all;
        const Momentum change = all.change_from(start);
        linear = std::max(linear, change.linear.norm() / start.linear.norm());
        angular = std::max(angular, change.angular.norm() / start.angular.norm());
    }
    return {{"linear", linear}, {"angular", angular}};
}

/// Impulse of the gas on a part of `area` from the inside.                              [N s]
double impulse_on(const MeasuredRun& run, int part, double area) {
    const auto time = run.time(),
               p = run.read("/history/airbag/1/part/" + std::to_string(part) + "/pressure");
    double sum = 0.0;
    for (std::size_t i = 1; i < time.size(); ++i) sum += p[i] * area * (time[i] - time[i - 1]);
    return sum;
}

}  // namespace

/// A bag spins about an axis that it is not round about.
Findings spinning_bag(const Runs& runs) {
    constexpr double MASS_BY_AREA = 750.0 * 0.3e-3;
    return by_run(runs, [&](const MeasuredRun& run) {
        const std::vector<double> mass = node_masses(run, MASS_BY_AREA);
        const auto momentum = run.vectors("/history/part/1/momentum");
        return changes(run, [&](std::size_t f, const std::string& frame) {
            const auto x = run.vectors(frame + "coordinates"), v = run.vectors(frame + "velocity");
            Momentum cloth{momentum.at(f)};
            for (std::size_t n = 0; n < mass.size(); ++n)
                cloth.angular += mass[n] * x[n].cross(v[n]);
            return cloth;
        });
    });
}

/// A rigid box spins about an axis that it does not keep: x_c × P + L of the box.
Findings spinning_box(const Runs& runs) {
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto momentum = run.vectors("/history/part/1/momentum"),
                   centre = run.vectors("/history/rigid_body/1/position"),
                   turning = run.vectors("/history/rigid_body/1/angular_momentum");
        return changes(run, [&](std::size_t f, const std::string&) {
            return Momentum{momentum.at(f), centre.at(f).cross(momentum.at(f)) + turning.at(f)};
        });
    });
}

/// 5 g of air fly along a closed duct that was empty, in a cone of 30 degrees:
///     J_end - J_inlet = m sqrt(3 R T / M) (1 + cos 30°) / 2 - (momentum of the gas)
Findings jet_on_plate(const Runs& runs) {
    constexpr double MASS = 5e-3, T = 300.0, M = 0.028, AREA = 0.01;
    const double pi = std::acos(-1.0);
    const double jet =
        MASS * std::sqrt(3.0 * GAS_CONSTANT * T / M) * 0.5 * (1.0 + std::cos(pi / 6.0));
    return by_run(runs, [&](const MeasuredRun& run) {
        const double gas = momentum_of_gas(run, run.frames().back()).linear.x();
        const double impulse = impulse_on(run, 3, AREA) - impulse_on(run, 2, AREA);
        return std::map<std::string, double>{{"impulse", (impulse + gas) / jet - 1.0}};
    });
}

/// Air enters air at rest. Momentum: that of the gas and the impulses on both ends. Flux: of the mean
/// flow, x = 0.1 to 0.4 m,
///     J = int rho u² dA,   rho u² = (sum m v_x)² / (sum m V) less what chance adds, (sum m²) c² / (sum m V)
Findings free_jet(const Runs& runs) {
    constexpr double RATE = 1.0, T = 300.0, M = 0.028, AREA = 0.16, MIDDLE = 0.2, STEADY = 6e-3;
    constexpr double SLAB = 0.05, FIRST = 0.1;
    constexpr std::size_t SLABS = 6;
    // a jet is some 0.02 m wide at the first slab
    constexpr std::array<double, 12> RADIUS{0.01,  0.02, 0.03, 0.04, 0.05, 0.06,
                                            0.075, 0.09, 0.11, 0.13, 0.15, 0.2};
    const double pi = std::acos(-1.0);
    const double jet =
        RATE * std::sqrt(3.0 * GAS_CONSTANT * T / M) * 0.5 * (1.0 + std::cos(pi / 18.0));
    return by_run(runs, [&](const MeasuredRun& run) {
        struct Sums {
            double m = 0.0, mm = 0.0, mv = 0.0, mvv = 0.0;
        };
        std::array<std::array<Sums, SLABS>, RADIUS.size()> rings{};
        const auto time = run.read("/frames/time");
        const auto frames = run.frames();
        double count = 0.0;
        for (std::size_t f = 0; f < frames.size(); ++f) {
            if (time[f] < STEADY) continue;
            count += 1.0;
            const std::string of = frames[f] + "particles/";
            const auto x = run.vectors(of + "position"), v = run.vectors(of + "velocity");
            const auto mass = run.read(of + "mass");
            for (std::size_t i = 0; i < mass.size(); ++i) {
                const double r = std::hypot(x[i].y() - MIDDLE, x[i].z() - MIDDLE);
                const auto ring = static_cast<std::size_t>(
                    std::upper_bound(RADIUS.begin(), RADIUS.end(), r) - RADIUS.begin());
                const double along = (x[i].x() - FIRST) / SLAB;
                if (ring == RADIUS.size() || along < 0.0 || along >= SLABS) continue;
                Sums& s = rings[ring][static_cast<std::size_t>(along)];
                s.m += mass[i];
                s.mm += mass[i] * mass[i];
                s.mv += mass[i] * v[i].x();
                s.mvv += mass[i] * v[i].x() * v[i].x();
            }
        }
        double flux = 0.0;
        for (const auto& ring : rings)
            for (const Sums& s : ring) {
                if (s.m == 0.0) continue;
                const double u = s.mv / s.m, c_squared = s.mvv / s.m - u * u;
                flux += (s.m * u * u - s.mm / s.m * c_squared) / (count * SLAB * SLABS);
            }
        const double gas = momentum_of_gas(run, frames.back()).linear.x();
        const double impulse = impulse_on(run, 3, AREA) - impulse_on(run, 2, AREA);
        return std::map<std::string, double>{
            {"impulse", (impulse + gas) / (jet * time.back()) - 1.0}, {"flux", flux / jet - 1.0}};
    });
}

}  // namespace corpuscle::verify
