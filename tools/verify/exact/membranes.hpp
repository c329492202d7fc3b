// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

/// Membranes of cloth under pressure in large strain, S = D E of Green and Lagrange's strain.
namespace corpuscle::oracle {

/// Stiffness along warp and weft, and their cross term.                                  [Pa]
struct ClothModuli {
    double warp, weft, cross;
};

/// D11 = E1 / (1 - nu12 nu21), D12 = nu21 D11, D22 = E2 / (1 - nu12 nu21), nu12 = nu21 E1 / E2.
inline ClothModuli cloth_moduli(double E_1, double E_2, double nu_21) {
    const double scale = 1.0 / (1.0 - nu_21 * nu_21 * E_1 / E_2);
    return {scale * E_1, scale * E_2, scale * nu_21 * E_1};
}

/// Clamped disc under a pressure that follows it, by shooting from the middle. Forces by angle:
///     d(N cos)/dR = P2 - p r l1 sin,   N sin = p r²/2,   N = R h l1 S1,   r' = l1 cos, z' = -l1 sin
/// @returns rise of the middle                                                            [m]
class HenckyDisc {
public:
    HenckyDisc(double radius, double thickness, double E, double nu, double pressure)
        : a_(radius), p_(pressure), nu_(nu), Dh_(E * thickness / (1.0 - nu * nu)) {}

    [[nodiscard]] double rise() const {
        double low = 1.0 + 1e-9, high = 1.5;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (shoot(middle).first > a_ ? high : low) = middle;
        }
        return shoot(low).second;
    }

private:
    struct State {
        double r, H, z;  ///< place; N cos; height
    };

    /// l1 (E1 + nu E2) = P, by Newton's rule.
    [[nodiscard]] double stretch(double P, double across) const {
        const double e = 0.5 * nu_ * (across * across - 1.0);
        double l = 1.1;
        for (int i = 0; i < 20; ++i)
            l -=
                (Dh_ * l * (0.5 * (l * l - 1.0) + e) - P) / (Dh_ * (0.5 * (3.0 * l * l - 1.0) + e));
        return l;
    }
    [[nodiscard]] State rate(double R, const State& s) const {
        const double V = 0.5 * p_ * s.r * s.r, N = std::hypot(s.H, V), l2 = s.r / R;
        const double l1 = stretch(N / R, l2);
        const double P2 = Dh_ * l2 * (0.5 * (l2 * l2 - 1.0) + 0.5 * nu_ * (l1 * l1 - 1.0));
        return {l1 * s.H / N, P2 - p_ * s.r * l1 * V / N, -l1 * V / N};
    }
    /// Radius and fall of the rim for the stretch of the middle.
    [[nodiscard]] std::pair<double, double> shoot(double l) const {
        constexpr int STEPS = 2000;
        const double h = a_ / STEPS, P = Dh_ * l * 0.5 * (l * l - 1.0) * (1.0 + nu_);
        double R = 0.01 * h;
        State s{R * l, R * P, 0.0};
        const auto moved = [](const State& at, const State& k, double dt) {
            return State{at.r + dt * k.r, at.H + dt * k.H, at.z + dt * k.z};
        };
        for (int i = 0; i < STEPS; ++i) {
            const double dt = (i + 1) * h - R;
            const State k1 = rate(R, s), k2 = rate(R + 0.5 * dt, moved(s, k1, 0.5 * dt)),
                        k3 = rate(R + 0.5 * dt, moved(s, k2, 0.5 * dt)),
                        k4 = rate(R + dt, moved(s, k3, dt));
            s = moved(s, k1, dt / 6.0);
            s = moved(s, k2, dt / 3.0);
            s = moved(s, k3, dt / 3.0);
            s = moved(s, k4, dt / 6.0);
            R = (i + 1) * h;
        }
        return {s.r, -s.z};
    }

    double a_, p_, nu_, Dh_;
};

/// A closed tube, warp around: h S1 = p R l2, h S2 l2 = p R l1² / 2.
/// @returns stretch around and along
inline std::pair<double, double> tube_stretch(const ClothModuli& D, double p_R_over_h) {
    const double det = D.warp * D.weft - D.cross * D.cross;
    double l1 = 1.0, l2 = 1.0;
    for (int i = 0; i < 200; ++i) {
        const double s1 = p_R_over_h * l2, s2 = p_R_over_h * l1 * l1 / (2.0 * l2);
        l1 = std::sqrt(1.0 + 2.0 * (D.weft * s1 - D.cross * s2) / det);
        l2 = std::sqrt(1.0 + 2.0 * (D.warp * s2 - D.cross * s1) / det);
    }
    return {l1, l2};
}

/// A sphere of cloth as stiff along warp as along weft: equal pull shears nothing, so
/// h (D11 + D12) (l² - 1) / 2 = p R l / 2.
inline double sphere_stretch(const ClothModuli& D, double p_R_over_h) {
    const double q = p_R_over_h / (2.0 * (D.warp + D.cross));
    return q + std::sqrt(q * q + 1.0);
}

}  // namespace corpuscle::oracle
