// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Cloth that touches cloth: a pressed stack, sheets that slide and rub, a plate that bounces; the
// folded bag, whose layers must not pass each other.

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"
#include "tools/verify/case_list.hpp"
#include "tools/verify/frame_crossings.hpp"

namespace corpuscle::verify {
namespace {

constexpr double CLOTH_H = 0.33e-3, CLOTH_E = 300e6, CLOTH_RHO = 800.0;

/// Modulus through the thickness over that in the plane [docs/theory/contact.md].
constexpr double THROUGH = 1.0 / 30.0;

/// Share of the middle sheet's momentum along x that is left at the end.
double momentum_left(const MeasuredRun& run) {
    const auto momentum = run.vectors("/history/part/2/momentum");
    return momentum.back().x() / momentum.front().x();
}

}  // namespace

/// `layers` of cloth on a fixed plate under p. Between two middles of cloth p = E (h/g - 1), at the
/// plate, where one of the two gives way, p = 2 E (h/g - 1):
///     height = h ((layers - 1) / (1 + p/E) + 1 / (1 + p/2E)),   E = THROUGH CLOTH_E
Findings stack(const Runs& runs) {
    constexpr double PRESSURE = 200e3, RELATIVE = PRESSURE / (THROUGH * CLOTH_E);
    constexpr double MIDDLE = 0.025;  // away from the sheet's edges [m]
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto start = run.vectors("/mesh/coordinates");
        const auto now = run.vectors(run.frames().back() + "coordinates");
        double top = 0.0, sum = 0.0, nodes = 0.0;
        for (const Vec3& x : start) top = std::max(top, x.z());
        const double layers = std::round(top / CLOTH_H);
        for (std::size_t n = 0; n < start.size(); ++n) {
            if (start[n].z() < top - 0.5 * CLOTH_H) continue;
            if (std::max(std::abs(start[n].x()), std::abs(start[n].y())) > MIDDLE) continue;
            sum += now[n].z();
            nodes += 1.0;
        }
        const double exact =
            CLOTH_H * ((layers - 1.0) / (1.0 + RELATIVE) + 1.0 / (1.0 + 0.5 * RELATIVE));
        return std::map<std::string, double>{{"height", sum / nodes / exact - 1.0}};
    });
}

/// Pressed by 600 kPa without friction: it goes on at 20 m/s.
Findings sliding_sheet(const Runs& runs) {
    return by_run(runs, [](const MeasuredRun& run) {
        return std::map<std::string, double>{{"speed", momentum_left(run) - 1.0}};
    });
}

/// Pressed by p over A on both sides: J = 2 mu p A t.
Findings rubbing_sheet(const Runs& runs) {
    constexpr double PRESSURE = 5e3, AREA = 0.1 * 0.1, FRICTION = 0.2;
    constexpr double MASS = CLOTH_RHO * CLOTH_H * 0.16 * 0.16, SPEED = 20.0;
    return by_run(runs, [&](const MeasuredRun& run) {
        const double exact = 2.0 * FRICTION * PRESSURE * AREA * run.time().back();
        const double impulse = MASS * SPEED * (1.0 - momentum_left(run));
        return std::map<std::string, double>{{"impulse", impulse / exact - 1.0}};
    });
}

/// A plate of 0.5 kg leaves taut cloth of some grams with the speed that it came with.
Findings rebound(const Runs& runs) {
    return by_run(runs, [](const MeasuredRun& run) {
        const auto v = run.vectors("/history/rigid_body/2/velocity");
        return std::map<std::string, double>{
            {"speed", -v.back().z() / v.front().z() - 1.0},
            {"crossings", static_cast<double>(frame_crossings(run.file()).crossings)}};
    });
}

/// A strip slides over half a rod: T2 = T1 exp(mu pi) [Euler]. T = E h w e sqrt(1 + 2 e), e Green's
/// strain along the strip; a mean over each side's hanging part and over the frames of sliding.
Findings capstan(const Runs& runs) {
    constexpr double SLIDES = 20e-3, LOW = -0.06, HIGH = -0.01;  // all of it; heights [m]
    const double pi = std::acos(-1.0);
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto nodes = run.read("/mesh/shell_nodes"), frames = run.read("/frames/time");
        double pull[2] = {0.0, 0.0}, count[2] = {0.0, 0.0};  // at x < 0, x > 0
        for (std::size_t f = 0; f < frames.size(); ++f) {
            if (frames[f] < SLIDES) continue;
            const auto x = run.vectors(run.frames()[f] + "coordinates"),
                       strain = run.vectors(run.frames()[f] + "shell_strain");
            for (std::size_t s = 0; s < strain.size(); ++s) {
                Vec3 middle = Vec3::Zero();
                for (std::size_t k = 4 * s; k < 4 * s + 4; ++k)
                    middle += 0.25 * x[static_cast<std::size_t>(nodes[k])];
                if (middle.z() < LOW || middle.z() > HIGH) continue;
                const int side = middle.x() > 0.0 ? 1 : 0;
                const double e = strain[s].x();
                pull[side] += e * std::sqrt(1.0 + 2.0 * e);
                count[side] += 1.0;
            }
        }
        const double ratio = pull[1] / count[1] / (pull[0] / count[0]);
        return std::map<std::string, double>{
            {"tension", ratio / std::exp(run.parameter("MU") * pi) - 1.0}};
    });
}

/// Layers do not cross in any frame, each particle is in the bag or has left it, and what nobody
/// accounts for is little of what came in.
Findings folded_bag(const Runs& runs) {
    return by_run(runs, [](const MeasuredRun& run) {
        const std::string bag = "/history/airbag/1/";
        const double inside = run.last(bag + "particles"), out = run.last(bag + "particles_out");
        const double kept = run.last(bag + "species/1/mass") / run.last(bag + "mass_in");
        return std::map<std::string, double>{
            {"crossings", static_cast<double>(frame_crossings(run.file()).crossings)},
            {"lost", kept * (inside + out) / inside - 1.0},
            {"residual",
             run.last("/history/energy/residual") / run.last("/history/energy/inflow")}};
    });
}

}  // namespace corpuscle::verify
