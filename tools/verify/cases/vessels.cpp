// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Cloth under pressure, damped to rest: Hencky's membrane, bags, a tube, a sphere; patches of cloth
// in uniform strain.

#include <algorithm>
#include <cmath>

#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/ball_on_disc.hpp"
#include "tools/verify/exact/membranes.hpp"

namespace corpuscle::verify {
namespace {

/// Volume between the shells and the origin: a bag's, or the part of it between its mirrors.
double volume_inside(const MeasuredRun& run) {
    const auto x = run.vectors(run.frames().back() + "coordinates");
    const auto nodes = run.read("/mesh/shell_nodes");
    double sum = 0.0;
    for (std::size_t s = 0; s + 3 < nodes.size(); s += 4) {
        const auto at = [&](std::size_t k) -> const Vec3& {
            return x[static_cast<std::size_t>(nodes[s + k])];
        };
        const auto cone = [&](std::size_t a, std::size_t b, std::size_t c) {
            return at(a).dot(at(b).cross(at(c))) / 6.0;
        };
        // a quad: the mean of both ways to cut it
        sum += nodes[s + 2] == nodes[s + 3]
                   ? cone(0, 1, 2)
                   : 0.5 * (cone(0, 1, 2) + cone(0, 2, 3) + cone(0, 1, 3) + cone(1, 2, 3));
    }
    return sum;
}

double height_of_middle(const MeasuredRun& run) {
    return run.vectors("/history/node/1/coordinates").back().z();
}

constexpr double RADIUS = 0.1;  ///< of discs, tube and sphere                              [m]
/// p R / h of tube and sphere.                                                            [Pa]
constexpr double PULL = 50e3 * RADIUS / 0.33e-3;

}  // namespace

/// p a / E h = 0.01.
Findings hencky(const Runs& runs) {
    const double exact = oracle::HenckyDisc(RADIUS, 1e-3, 1e8, 0.3, 1e4).rise();
    return by_run(runs, [&](const MeasuredRun& run) {
        return std::map<std::string, double>{{"rise", height_of_middle(run) / exact - 1.0}};
    });
}

/// A ball of 0.04 m, 0.02 m deep in the middle of Hencky's disc: a quarter of its force is felt.
Findings ball_on_disc(const Runs& runs) {
    const double exact = oracle::BallOnDisc(RADIUS, 1e-3, 1e8, 0.3, 0.04).force(0.02);
    constexpr double RESTS = 0.03;  // the sheet
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto time = run.time();
        const auto force = run.vectors("/history/rigidwall/1/force");
        double sum = 0.0, count = 0.0;
        for (std::size_t i = 0; i < time.size(); ++i) {
            if (time[i] < RESTS) continue;
            sum += 4.0 * std::abs(force[i].z());
            count += 1.0;
        }
        return std::map<std::string, double>{{"force", sum / count / exact - 1.0}};
    });
}

/// Two discs that stretch little and wrinkle freely: Mylar's bag.
Findings mylar(const Runs& runs) {
    constexpr double VOLUME = 1.2185242, THICKNESS = 0.9138932;  // of a³, of a
    return by_run(runs, [&](const MeasuredRun& run) {
        return std::map<std::string, double>{
            {"volume", 8.0 * volume_inside(run) / std::pow(RADIUS, 3) / VOLUME - 1.0},
            {"thickness", 2.0 * height_of_middle(run) / RADIUS / THICKNESS - 1.0}};
    });
}

/// Half the height of the middle, and the volume.
Findings square_bag(const Runs& runs) {
    return by_run(runs, [&](const MeasuredRun& run) {
        return std::map<std::string, double>{{"height", height_of_middle(run) / 0.2165 - 1.0},
                                             {"volume", 8.0 * volume_inside(run) / 0.1249 - 1.0}};
    });
}

Findings tube_vessel(const Runs& runs) {
    const auto [around, along] =
        oracle::tube_stretch(oracle::cloth_moduli(400e6, 300e6, 0.1125), PULL);
    return by_run(runs, [&, around = around, along = along](const MeasuredRun& run) {
        const auto start = run.vectors("/mesh/coordinates"),
                   now = run.vectors(run.frames().back() + "coordinates");
        double top = 0.0, radius = 0.0, middles = 0.0, height = 0.0, tops = 0.0;
        for (const Vec3& x : start) top = std::max(top, x.z());
        for (std::size_t n = 0; n < now.size(); ++n) {
            if (start[n].z() > 0.75 * top) {
                height += now[n].z();
                tops += 1.0;
            } else if (start[n].z() > 0.25 * top) {
                radius += std::hypot(now[n].x(), now[n].y());
                middles += 1.0;
            }
        }
        return std::map<std::string, double>{{"radius", radius / middles / (RADIUS * around) - 1.0},
                                             {"length", height / tops / (top * along) - 1.0}};
    });
}

Findings sphere_vessel(const Runs& runs) {
    const double stretch = oracle::sphere_stretch(oracle::cloth_moduli(400e6, 400e6, 0.2), PULL);
    const double pi = std::acos(-1.0);
    return by_run(runs, [&](const MeasuredRun& run) {
        const double radius = std::cbrt(0.75 * volume_inside(run) / pi);
        return std::map<std::string, double>{{"radius", radius / (RADIUS * stretch) - 1.0}};
    });
}

/// A sheet of irregular cells that is stretched to SX and SY of its reference shape, warp along
/// (WX, WY): uniform strain E, energy V D E E / 2, and nothing moves.
Findings patch(const Runs& runs) {
    constexpr double VOLUME = 0.1 * 0.1 * 0.3e-3, G = 4e6;
    const oracle::ClothModuli D = oracle::cloth_moduli(400e6, 300e6, 0.1125);
    return by_run(runs, [&](const MeasuredRun& run) {
        const double sx = run.parameter("SX"), sy = run.parameter("SY"), wx = run.parameter("WX"),
                     wy = run.parameter("WY");
        const double l = std::hypot(wx, wy), c = wx / l, s = wy / l;
        const double ex = 0.5 * (sx * sx - 1.0), ey = 0.5 * (sy * sy - 1.0);
        const double warp = c * c * ex + s * s * ey, weft = s * s * ex + c * c * ey,
                     shear = 2.0 * c * s * (ey - ex);
        const double energy = 0.5 * VOLUME *
                              (D.warp * warp * warp + 2.0 * D.cross * warp * weft +
                               D.weft * weft * weft + G * shear * shear);
        const auto found = run.read("/history/part/1/strain_energy");
        double worst = 0.0, moved = 0.0;
        for (const double e : found) worst = std::max(worst, std::abs(e / energy - 1.0));
        for (const std::string& node : run.names("/history/node")) {
            const auto x = run.vectors("/history/node/" + node + "/coordinates");
            for (const Vec3& at : x) moved = std::max(moved, (at - x.front()).norm() / 0.1);
        }
        return std::map<std::string, double>{{"energy", worst}, {"moved", moved}};
    });
}

}  // namespace corpuscle::verify
