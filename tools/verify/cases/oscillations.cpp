// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Gas as a spring and as a carrier of sound: a plate that swings on it, a wave in a closed tube.

#include <cmath>

#include <Eigen/Dense>

#include "solver/base/constants.hpp"
#include "solver/base/curve.hpp"
#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/euler_1d.hpp"

namespace corpuscle::verify {
namespace {

constexpr double P_REST = 101325.0, T_REST = 300.0, M_AIR = 0.028, CP_AIR = 28.0;
constexpr double GAMMA_AIR = CP_AIR / (CP_AIR - GAS_CONSTANT),
                 RHO_REST = P_REST * M_AIR / (GAS_CONSTANT * T_REST);

struct Swing {
    double omega, decay;  ///< both                                                      [1/s]
};

/// Least squares of exp(-decay t) (a cos(omega t) + b sin(omega t)) + c by Gauss and Newton.
/// @param omega  to begin with
Swing fitted_swing(const std::vector<double>& t, const std::vector<double>& y, double omega) {
    const auto rows = static_cast<Eigen::Index>(t.size());
    Swing swing{omega, 0.0};
    Eigen::Vector3d linear = Eigen::Vector3d::Zero();
    for (int pass = 0; pass < 20; ++pass) {
        Eigen::MatrixXd J(rows, 5);
        Eigen::VectorXd value(rows);
        for (Eigen::Index i = 0; i < rows; ++i) {
            const double at = t[static_cast<std::size_t>(i)], e = std::exp(-swing.decay * at);
            const double c = e * std::cos(swing.omega * at), s = e * std::sin(swing.omega * at);
            J.row(i) << c, s, 1.0, at * (linear[1] * c - linear[0] * s),
                -at * (linear[0] * c + linear[1] * s);
            value[i] = y[static_cast<std::size_t>(i)];
        }
        if (pass == 0) {  // amplitudes first
            linear = J.leftCols<3>().colPivHouseholderQr().solve(value);
            continue;
        }
        const Eigen::VectorXd step =
            J.colPivHouseholderQr().solve(value - J.leftCols<3>() * linear);
        linear += step.head<3>();
        swing.omega += step[3];
        swing.decay += step[4];
    }
    return swing;
}

/// Amplitude that a swing loses in a period.
double lost(const Swing& swing) {
    return 1.0 - std::exp(-swing.decay * 2.0 * std::acos(-1.0) / swing.omega);
}

/// Way of a plate of `mass` on a column of air, from rest of the air, p V^gamma:
///     m x'' = p A ((1 + x / L)^-gamma - 1),   m the plate's mass and a third of the air's
std::vector<double> way_on_air(const std::vector<double>& time, double mass, double length,
                               double area, double speed) {
    const auto a = [&](double x) {
        return P_REST * area / mass * (std::pow(1.0 + x / length, -GAMMA_AIR) - 1.0);
    };
    double x = 0.0, v = speed;
    std::vector<double> way{x};
    for (std::size_t i = 1; i < time.size(); ++i) {
        constexpr int STEPS = 100;
        const double dt = (time[i] - time[i - 1]) / STEPS;
        for (int k = 0; k < STEPS; ++k) {  // velocity Verlet
            v += 0.5 * dt * a(x);
            x += dt * v;
            v += 0.5 * dt * a(x);
        }
        way.push_back(x);
    }
    return way;
}

struct Stretch {
    double speed, decay;  ///< [-], [1/s]
};

/// Least squares of scale exp(-decay t) exact(speed t) for t > `from` by Gauss and Newton, t from
/// the top of the piston's speed, at `from`.
Stretch fitted_stretch(const std::vector<double>& time, const std::vector<double>& exact,
                       const std::vector<double>& found, double from) {
    const Curve wave{0, time, exact};
    const double h = time[1] - time[0];
    double scale = 1.0;
    Stretch stretch{1.0, 0.0};
    for (int pass = 0; pass < 10; ++pass) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        for (std::size_t i = 0; i < time.size(); ++i) {
            const double t = time[i] - from, at = from + stretch.speed * t;
            if (t <= from || at > time.back() - h) continue;  // the piston moves; beyond the end
            const double e = std::exp(-stretch.decay * t), y = e * wave(at);
            const double slope = e * (wave(at + h) - wave(at - h)) / (2.0 * h);
            const Eigen::Vector3d row(y, scale * t * slope, -scale * t * y);
            normal += row * row.transpose();
            right += row * (found[i] - scale * y);
        }
        const Eigen::Vector3d step = normal.ldlt().solve(right);
        scale += step[0];
        stretch.speed += step[1];
        stretch.decay += step[2];
    }
    return stretch;
}

/// The tube's piston pressure less that of the closed end, mean of each sample.
std::vector<double> difference_of_ends(const std::vector<double>& time, double speed, double ramp) {
    oracle::EulerTube tube(GAMMA_AIR, 1.0, 400, [](double) {
        return oracle::Gas1D{RHO_REST, 0.0, P_REST};
    });
    const auto piston = [&](double t) {
        return -speed * std::max(0.0, 1.0 - std::abs(t / ramp - 1.0));
    };
    const auto now = [&] { return tube.piston_pressure() - tube.gas().front().pressure; };
    std::vector<double> mean{0.0};
    for (std::size_t i = 1; i < time.size(); ++i) {
        constexpr int PARTS = 4;
        double sum = 0.5 * now();
        for (int k = 1; k <= PARTS; ++k) {
            tube.advance(time[i - 1] + (time[i] - time[i - 1]) * k / PARTS, piston);
            sum += (k < PARTS ? 1.0 : 0.5) * now();
        }
        mean.push_back(sum / PARTS);
    }
    return mean;
}

}  // namespace

/// A plate of 0.25 kg before air of 0.2 x 0.04 m² and before the atmosphere; nearly
///     w² = gamma p A² / (m V)                                              [Rayleigh, § 302]
/// Waves in the air take a third of its mass along, but for (air / plate)² / 45 of w²; air at uniform
/// pressure has none. Both by the same fit, for a swing of 5 % of the column is not harmonic.
Findings plate_on_gas(const Runs& runs) {
    constexpr double PLATE = 0.25, LENGTH = 0.2, AREA = 0.04, SPEED = 3.4;
    constexpr double AIR = RHO_REST * AREA * LENGTH;
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto time = run.time();
        const bool has_waves = run.parameter("IAIR") == 2.0 && run.parameter("TSW") > time.back();
        const double mass = PLATE + (has_waves ? AIR / 3.0 : 0.0);
        const double omega = std::sqrt(GAMMA_AIR * P_REST * AREA / (mass * LENGTH));
        const Swing exact = fitted_swing(time, way_on_air(time, mass, LENGTH, AREA, SPEED), omega);
        std::vector<double> x;
        for (const Vec3& at : run.vectors("/history/rigid_body/2/position")) x.push_back(at.x());
        const Swing swing = fitted_swing(time, x, omega);
        return std::map<std::string, double>{{"frequency", swing.omega / exact.omega - 1.0},
                                             {"amplitude", lost(swing) - lost(exact)}};
    });
}

/// Once the piston stands, the pressures at both ends differ by waves of odd order. What runs s
/// times as fast as by 1-D Euler's equations and loses more is exp(-decay t) exact(s t). By its
/// viscosity and heat LIN loses 3.7 % in a period with 20 000 particles, 2.4 % with 100 000
/// (docs/theory/collisions.md); random pairs would lose 15 %.
Findings standing_wave(const Runs& runs) {
    constexpr double SPEED = 20.0, RAMP = 1.4e-3, LENGTH = 1.0;
    const double period = 2.0 * LENGTH / std::sqrt(GAMMA_AIR * P_REST / RHO_REST);
    const auto time = runs.front().time();
    const auto exact = difference_of_ends(time, SPEED, RAMP);
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto near = run.read("/history/airbag/1/part/2/pressure"),
                   far = run.read("/history/airbag/1/part/3/pressure");
        std::vector<double> found;
        for (std::size_t i = 0; i < near.size(); ++i) found.push_back(near[i] - far[i]);
        const Stretch stretch = fitted_stretch(time, exact, found, RAMP);
        return std::map<std::string, double>{
            {"speed", stretch.speed - 1.0}, {"amplitude", 1.0 - std::exp(-stretch.decay * period)}};
    });
}

}  // namespace corpuscle::verify
