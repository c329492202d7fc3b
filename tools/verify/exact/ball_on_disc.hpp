// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace corpuscle::oracle {

/// A ball that presses into the middle of a clamped disc without friction; large strain, S = D E.
/// Forces by angle: N along the meridian, N = R h l1 S1, P2 = h l2 S2 around. With the slope t:
///     on the ball     dN/dR = P2 cos t,   dt/dR = l1 / ball,   r = ball sin t
///     off it          d(N cos t)/dR = P2,   N sin t = const,   r' = l1 cos t, z' = l1 sin t
/// by shooting for the stretch of the middle, then for the slope at which the disc leaves the ball.
class BallOnDisc {
public:
    BallOnDisc(double radius, double thickness, double E, double nu, double ball)
        : a_(radius), ball_(ball), nu_(nu), Dh_(E * thickness / (1.0 - nu * nu)) {}

    /// Of the ball, when its lowest point is `depth` below the rim.                          [N]
    [[nodiscard]] double force(double depth) const {
        double low = 0.01, high = 1.5;  // slope where the disc leaves the ball
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            (clamped(middle).depth > depth ? high : low) = middle;
        }
        return 2.0 * std::acos(-1.0) * clamped(low).V;
    }

private:
    /// Where a shot ends: radius and height of the rim; N sin t.
    struct Shot {
        double r, depth, V;
    };

    /// The shot that ends at the rim's radius.
    [[nodiscard]] Shot clamped(double leaves) const {
        double low = 1.0 + 1e-9, high = 2.0;
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (low + high);
            (shoot(middle, leaves).r > a_ ? high : low) = middle;
        }
        return shoot(low, leaves);
    }

    /// l1 (E1 + nu E2) = P / D h, by Newton's rule.
    [[nodiscard]] double stretch(double P, double across) const {
        const double e = 0.5 * nu_ * (across * across - 1.0);
        double l = 1.1;
        for (int i = 0; i < 20; ++i) {
            const double change =
                (l * (0.5 * (l * l - 1.0) + e) - P / Dh_) / (0.5 * (3.0 * l * l - 1.0) + e);
            l -= change;
            if (std::abs(change) < 1e-14) break;
        }
        return l;
    }
    [[nodiscard]] double around(double l1, double l2) const {
        return Dh_ * l2 * 0.5 * ((l2 * l2 - 1.0) + nu_ * (l1 * l1 - 1.0));
    }

    /// Slope and N on the ball; r, N cos t and z off it: the rates by R of a state of three.
    struct State {
        double a, b, c;
    };
    [[nodiscard]] State on_ball(double R, const State& s) const {
        const double l2 = ball_ * std::sin(s.a) / R, l1 = stretch(s.b / R, l2);
        return {l1 / ball_, around(l1, l2) * std::cos(s.a), 0.0};
    }
    [[nodiscard]] State off_ball(double R, const State& s, double V) const {
        const double N = std::hypot(s.b, V), l2 = s.a / R, l1 = stretch(N / R, l2);
        return {l1 * s.b / N, around(l1, l2), l1 * V / N};
    }
    /// One step of Runge and Kutta's rule.
    template <class Rate>
    static State step(double R, const State& s, double h, Rate&& rate) {
        const auto moved = [&](const State& k, double by) {
            return State{s.a + by * k.a, s.b + by * k.b, s.c + by * k.c};
        };
        const State k1 = rate(R, s), k2 = rate(R + 0.5 * h, moved(k1, 0.5 * h)),
                    k3 = rate(R + 0.5 * h, moved(k2, 0.5 * h)), k4 = rate(R + h, moved(k3, h));
        const auto mean = [&](double State::*m) {
            return s.*m + h / 6.0 * (k1.*m + 2.0 * k2.*m + 2.0 * k3.*m + k4.*m);
        };
        return {mean(&State::a), mean(&State::b), mean(&State::c)};
    }

    [[nodiscard]] Shot shoot(double l, double leaves) const {
        constexpr int STEPS = 200;
        const double h = a_ / STEPS;
        const auto ball = [&](double R, const State& s) { return on_ball(R, s); };
        double R = 0.01 * h;
        State s{R * l / ball_, R * around(l, l), 0.0};
        while (true) {
            const State next = step(R, s, h, ball);
            if (next.a > leaves || R + h > a_) break;
            s = next;
            R += h;
        }
        // the slope is all but straight in a step
        for (int i = 0; i < 4 && R < a_; ++i) {
            const double part = (leaves - s.a) / on_ball(R, s).a;
            s = step(R, s, part, ball);
            R += part;
        }
        const double V = s.b * std::sin(s.a);
        State free{ball_ * std::sin(s.a), s.b * std::cos(s.a), ball_ * (1.0 - std::cos(s.a))};
        const double rest = (a_ - R) / STEPS;
        for (int i = 0; i < STEPS; ++i, R += rest)
            free = step(R, free, rest,
                        [&](double at, const State& now) { return off_ball(at, now, V); });
        return {free.a, free.c, V};
    }

    double a_, ball_, nu_, Dh_;
};

}  // namespace corpuscle::oracle
