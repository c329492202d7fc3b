// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/exact/exact_riemann.hpp"

#include <cmath>

namespace corpuscle::oracle {

namespace {

struct Jump {
    double velocity;  ///< change of velocity across the wave that leads to pressure p
    double slope;     ///< its derivative with p
};

/// f(p) and f'(p) of one side: a shock above its pressure, a rarefaction below.
Jump jump_to(double gamma, const Gas1D& gas, double p) {
    const double c = std::sqrt(gamma * gas.pressure / gas.density);
    if (p > gas.pressure) {
        const double a = 2.0 / ((gamma + 1.0) * gas.density);
        const double b = (gamma - 1.0) / (gamma + 1.0) * gas.pressure;
        const double root = std::sqrt(a / (p + b));
        return {(p - gas.pressure) * root, root * (1.0 - 0.5 * (p - gas.pressure) / (p + b))};
    }
    const double ratio = p / gas.pressure;
    const double z = 0.5 * (gamma - 1.0) / gamma;
    return {2.0 * c / (gamma - 1.0) * (std::pow(ratio, z) - 1.0),
            std::pow(ratio, z - 1.0) / (gas.density * c)};
}

double star_pressure(double gamma, const Gas1D& left, const Gas1D& right) {
    double p = 0.5 * (left.pressure + right.pressure);
    for (int i = 0; i < 100; ++i) {
        const Jump l = jump_to(gamma, left, p), r = jump_to(gamma, right, p);
        const double change =
            (l.velocity + r.velocity + right.velocity - left.velocity) / (l.slope + r.slope);
        p = std::max(p - change, 1e-3 * p);  // Newton from above may aim below vacuum
        if (std::abs(change) < 1e-14 * p) break;
    }
    return p;
}

/// The side of the contact that faces `gas`, seen with the gas on the left.
Gas1D left_of_contact(double gamma, const Gas1D& gas, double p, double u, double speed) {
    const double c = std::sqrt(gamma * gas.pressure / gas.density);
    const double ratio = p / gas.pressure;
    if (ratio > 1.0) {
        const double g = (gamma - 1.0) / (gamma + 1.0);
        const double shock =
            gas.velocity - c * std::sqrt((gamma + 1.0) / (2.0 * gamma) * (ratio - 1.0) + 1.0);
        if (speed < shock) return gas;
        return {gas.density * (ratio + g) / (g * ratio + 1.0), u, p};
    }
    const double c_star = c * std::pow(ratio, 0.5 * (gamma - 1.0) / gamma);
    if (speed < gas.velocity - c) return gas;
    if (speed > u - c_star) return {gas.density * std::pow(ratio, 1.0 / gamma), u, p};
    const double u_fan = (2.0 * (c + speed) + (gamma - 1.0) * gas.velocity) / (gamma + 1.0);
    const double share = (u_fan - speed) / c;  // c of the fan over c
    return {gas.density * std::pow(share, 2.0 / (gamma - 1.0)), u_fan,
            gas.pressure * std::pow(share, 2.0 * gamma / (gamma - 1.0))};
}

}  // namespace

Gas1D exact_riemann(double gamma, const Gas1D& left, const Gas1D& right, double speed) {
    const double p = star_pressure(gamma, left, right);
    const double u = 0.5 * (left.velocity + right.velocity + jump_to(gamma, right, p).velocity -
                            jump_to(gamma, left, p).velocity);
    if (speed < u) return left_of_contact(gamma, left, p, u, speed);
    const Gas1D mirrored{right.density, -right.velocity, right.pressure};
    Gas1D here = left_of_contact(gamma, mirrored, p, -u, -speed);
    here.velocity = -here.velocity;
    return here;
}

}  // namespace corpuscle::oracle
