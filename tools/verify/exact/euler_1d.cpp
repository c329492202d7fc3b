// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/exact/euler_1d.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::oracle {

namespace {

constexpr double COURANT = 0.4;  // Heun's method with linear reconstruction is stable to 0.5

/// Van Leer's slope: harmonic mean of the two differences, none at an extremum.
double limited(double before, double after) {
    const double product = before * after;
    return product > 0.0 ? 2.0 * product / (before + after) : 0.0;
}

Gas1D shifted(const Gas1D& gas, const Gas1D& slope, double share) {
    return {gas.density + share * slope.density, gas.velocity + share * slope.velocity,
            gas.pressure + share * slope.pressure};
}

bool is_gas(const Gas1D& gas) {
    return gas.density > 0.0 && gas.pressure > 0.0;
}

double sound_speed(double gamma, const Gas1D& gas) {
    return std::sqrt(gamma * gas.pressure / gas.density);
}

std::array<double, 3> conserved(double gamma, const Gas1D& gas) {
    const double momentum = gas.density * gas.velocity;
    return {gas.density, momentum, gas.pressure / (gamma - 1.0) + 0.5 * momentum * gas.velocity};
}

}  // namespace

EulerTube::EulerTube(double gamma, double length, std::size_t cells,
                     const std::function<Gas1D(double)>& initial)
    : gamma_(gamma), length_(length), cells_(cells) {
    const double width = length / static_cast<double>(cells);
    for (std::size_t i = 0; i < cells; ++i) {
        cells_[i] = conserved(gamma, initial(centre(i)));
        for (double& total : cells_[i]) total *= width;
    }
}

void EulerTube::advance(double until, const std::function<double(double)>& piston_velocity) {
    while (time_ < until) {
        const double left = until - time_;
        // the piston may speed up within the step: the faster of its ends bounds it
        double dt = std::min(left, stable_step(piston_velocity(time_)));
        dt = std::min(dt, stable_step(piston_velocity(time_ + dt)));
        const double w_0 = piston_velocity(time_);
        const double w_1 = piston_velocity(time_ + dt);

        const auto rate_0 = rate(cells_, length_, w_0);
        auto ahead = cells_;
        for (std::size_t i = 0; i < cells_.size(); ++i)
            for (int k = 0; k < 3; ++k) ahead[i][k] += dt * rate_0[i][k];
        const auto rate_1 = rate(ahead, length_ + dt * w_0, w_1);
        for (std::size_t i = 0; i < cells_.size(); ++i)
            for (int k = 0; k < 3; ++k) cells_[i][k] += 0.5 * dt * (rate_0[i][k] + rate_1[i][k]);

        length_ += 0.5 * dt * (w_0 + w_1);
        piston_velocity_ = w_1;
        time_ = dt < left ? time_ + dt : until;
    }
}

Gas1D EulerTube::gas(const Conserved& cell, double width) const {
    const double velocity = cell[1] / cell[0];
    return {cell[0] / width, velocity,
            (gamma_ - 1.0) * (cell[2] - 0.5 * cell[1] * velocity) / width};
}

/// Gas at both ends of each cell. The outermost cells take the one difference that they have; a
/// cell whose line would leave no gas at an end keeps its average (strong rarefactions off the
/// piston).
std::vector<EulerTube::Faces> EulerTube::reconstruct(const std::vector<Conserved>& cells,
                                                     double length) const {
    const std::size_t n = cells.size();
    const double width = length / static_cast<double>(n);
    std::vector<Gas1D> mean(n);
    for (std::size_t i = 0; i < n; ++i) mean[i] = gas(cells[i], width);

    std::vector<Faces> faces(n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t before = i > 0 ? i - 1 : i;
        const std::size_t after = i + 1 < n ? i + 1 : i;
        const auto slope = [&](double Gas1D::*q) {
            const double back = mean[i].*q - mean[before].*q;
            const double on = mean[after].*q - mean[i].*q;
            if (before == i) return on;
            return after == i ? back : limited(back, on);
        };
        const Gas1D line{slope(&Gas1D::density), slope(&Gas1D::velocity), slope(&Gas1D::pressure)};
        faces[i] = {shifted(mean[i], line, -0.5), shifted(mean[i], line, 0.5)};
        if (!is_gas(faces[i].left) || !is_gas(faces[i].right)) faces[i] = {mean[i], mean[i]};
    }
    return faces;
}

std::vector<EulerTube::Conserved> EulerTube::rate(const std::vector<Conserved>& cells,
                                                  double length, double piston_velocity) const {
    const std::size_t n = cells.size();
    const auto faces = reconstruct(cells, length);
    const double closed = wall_pressure(faces.front().left, faces.front().left.velocity);
    const double piston =
        wall_pressure(faces.back().right, piston_velocity - faces.back().right.velocity);

    std::vector<Conserved> rates(n);
    Conserved in{0.0, closed, 0.0};
    for (std::size_t i = 0; i < n; ++i) {
        const double share = static_cast<double>(i + 1) / static_cast<double>(n);
        const Conserved out = i + 1 < n
                                  ? flux(faces[i].right, faces[i + 1].left, share * piston_velocity)
                                  : Conserved{0.0, piston, piston * piston_velocity};
        for (int k = 0; k < 3; ++k) rates[i][k] = in[k] - out[k];
        in = out;
    }
    if (leak_) take_leak(cells, length, rates);
    return rates;
}

void EulerTube::take_leak(const std::vector<Conserved>& cells, double length,
                          std::vector<Conserved>& rates) const {
    const double width = length / static_cast<double>(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const Gas1D here = gas(cells[i], width);
        const double share = leak_((static_cast<double>(i) + 0.5) * width, here);
        rates[i][0] -= share * cells[i][0];
        rates[i][1] -= share * cells[i][1];
        rates[i][2] -= share * (cells[i][2] + here.pressure * width);
    }
}

/// HLLC flux through a face that moves: F(U) - w U of the state that the face w finds itself in.
EulerTube::Conserved EulerTube::flux(const Gas1D& left, const Gas1D& right, double w) const {
    const double c_l = sound_speed(gamma_, left), c_r = sound_speed(gamma_, right);
    const double s_l = std::min(left.velocity - c_l, right.velocity - c_r);
    const double s_r = std::max(left.velocity + c_l, right.velocity + c_r);
    const double mass_l = left.density * (s_l - left.velocity);
    const double mass_r = right.density * (s_r - right.velocity);
    const double s_star =
        (right.pressure - left.pressure + mass_l * left.velocity - mass_r * right.velocity) /
        (mass_l - mass_r);

    const bool from_left = w < s_star;
    const Gas1D& side = from_left ? left : right;
    const double s = from_left ? s_l : s_r;
    Conserved state = conserved(gamma_, side);
    Conserved through = {state[1], state[1] * side.velocity + side.pressure,
                         (state[2] + side.pressure) * side.velocity};
    if (s_l < w && w < s_r) {  // between the two waves
        const double squeeze = (s - side.velocity) / (s - s_star);
        const double density = side.density * squeeze;
        const double energy =
            squeeze * (state[2] + (s_star - side.velocity) * (side.density * s_star +
                                                              side.pressure / (s - side.velocity)));
        const Conserved star = {density, density * s_star, energy};
        for (int k = 0; k < 3; ++k) through[k] += s * (star[k] - state[k]);
        state = star;
    }
    for (int k = 0; k < 3; ++k) through[k] -= w * state[k];
    return through;
}

/// Pressure on a wall that recedes from the gas: an isentropic rarefaction, or a shock when it
/// approaches.
double EulerTube::wall_pressure(const Gas1D& gas, double receding) const {
    if (receding > 0.0) {
        const double base = 1.0 - 0.5 * (gamma_ - 1.0) * receding / sound_speed(gamma_, gas);
        return base > 0.0 ? gas.pressure * std::pow(base, 2.0 * gamma_ / (gamma_ - 1.0)) : 0.0;
    }
    // Hugoniot: (p* - p)^2 A = u^2 (p* + B), solved for p* - p  [Toro, section 4.2]
    const double a = 2.0 / ((gamma_ + 1.0) * gas.density);
    const double b = (gamma_ - 1.0) / (gamma_ + 1.0) * gas.pressure;
    const double u2 = receding * receding;
    return gas.pressure + 0.5 * (u2 + std::sqrt(u2 * u2 + 4.0 * a * u2 * (gas.pressure + b))) / a;
}

double EulerTube::stable_step(double piston_velocity) const {
    const double width = length_ / static_cast<double>(cells_.size());
    double fastest = std::abs(piston_velocity);
    for (std::size_t i = 0; i < cells_.size(); ++i) {
        const Gas1D here = gas(cells_[i], width);
        const double mesh = piston_velocity * centre(i) / length_;
        fastest = std::max(fastest, std::abs(here.velocity - mesh) + sound_speed(gamma_, here));
    }
    return COURANT * width / fastest;
}

double EulerTube::piston_pressure() const {
    const Gas1D at = reconstruct(cells_, length_).back().right;
    return wall_pressure(at, piston_velocity_ - at.velocity);
}

std::vector<Gas1D> EulerTube::gas() const {
    const double width = length_ / static_cast<double>(cells_.size());
    std::vector<Gas1D> all;
    for (const Conserved& cell : cells_) all.push_back(gas(cell, width));
    return all;
}

double EulerTube::centre(std::size_t cell) const {
    return length_ * (static_cast<double>(cell) + 0.5) / static_cast<double>(cells_.size());
}

double EulerTube::mass() const {
    double sum = 0.0;
    for (const Conserved& cell : cells_) sum += cell[0];
    return sum;
}

double EulerTube::energy() const {
    double sum = 0.0;
    for (const Conserved& cell : cells_) sum += cell[2];
    return sum;
}

}  // namespace corpuscle::oracle
