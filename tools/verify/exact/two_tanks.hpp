// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "tools/verify/exact/stirred_tank.hpp"

/// Two rigid tanks of ideal gases, both always mixed, that give gas to each other and to the
/// outside: ordinary differential equations.
///
///     out of a tank, of each gas:   dm/dt = -(across + out) m,   dE/dt = -across H_k - out H,
///     into the other:               across m,                    across H_k
///     H = sum n cp T,   H_k = sum n (cp - k R) T
namespace corpuscle::oracle {

struct TwoTanks {
    /// What leaves a tank per time, of what is in it.                                      [1/s]
    struct Share {
        double across = 0.0;  ///< to the other tank
        double out = 0.0;     ///< to the outside, with its enthalpy
        double less = 0.0;    ///< k of what goes across: 0 enthalpy, 1/2 effusing molecules
    };
    using Rule = std::function<Share(double t, const StirredTank& from, const StirredTank& to)>;

    std::array<StirredTank, 2> tanks;  ///< of the same gases in the same order

    /// Goes on by the midpoint rule.
    void advance(double from, double to, int steps, const std::array<Rule, 2>& rules) {
        const double dt = (to - from) / steps;
        for (int k = 0; k < steps; ++k) {
            const double t = from + k * dt;
            TwoTanks middle = *this;
            middle.exchange(t, 0.5 * dt, tanks, rules);
            exchange(t + 0.5 * dt, dt, middle.tanks, rules);
        }
    }

private:
    void exchange(double t, double dt, const std::array<StirredTank, 2>& at,
                  const std::array<Rule, 2>& rules) {
        for (std::size_t r = 0; r < 2; ++r) {
            const Share share = rules[r](t, at[r], at[1 - r]);
            const double T = at[r].temperature();
            for (std::size_t g = 0; g < at[r].gases.size(); ++g) {
                const double crosses = dt * share.across * at[r].gases[g].mass;
                tanks[r].gases[g].mass -= crosses + dt * share.out * at[r].gases[g].mass;
                tanks[1 - r].gases[g].mass += crosses;
            }
            const double carried = dt * share.across * at[r].heat_capacity(share.less) * T;
            tanks[r].energy -= carried + dt * share.out * at[r].heat_capacity(0.0) * T;
            tanks[1 - r].energy += carried;
        }
    }
};

}  // namespace corpuscle::oracle
