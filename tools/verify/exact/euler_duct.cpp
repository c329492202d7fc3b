// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/verify/exact/euler_duct.hpp"

#include <algorithm>
#include <cmath>

#include "tools/verify/exact/exact_riemann.hpp"

namespace corpuscle::oracle {

namespace {

constexpr double COURANT = 0.4;  // Heun's method with linear reconstruction is stable to 0.5

double limited(double before, double after) {
    const double product = before * after;
    return product > 0.0 ? 2.0 * product / (before + after) : 0.0;
}

double sound_speed(double gamma, const Gas1D& gas) {
    return std::sqrt(gamma * gas.pressure / gas.density);
}

}  // namespace

EulerDuct::EulerDuct(double gamma, double length, std::size_t cells, const Gas1D& initial,
                     double p_out, double source_length)
    : gamma_(gamma),
      width_(length / static_cast<double>(cells)),
      p_out_(p_out),
      source_cells_(
          std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(source_length / width_)))),
      cells_(cells) {
    for (Conserved& cell : cells_)
        cell = {initial.density, initial.density * initial.velocity,
                initial.pressure / (gamma - 1.0) +
                    0.5 * initial.density * initial.velocity * initial.velocity};
}

Gas1D EulerDuct::primitive(const Conserved& cell) const {
    const double u = cell[1] / cell[0];
    return {cell[0], u, (gamma_ - 1.0) * (cell[2] - 0.5 * cell[1] * u)};
}

EulerDuct::Conserved EulerDuct::flux_of(const Gas1D& gas) const {
    const double mass = gas.density * gas.velocity;
    const double enthalpy =
        gamma_ / (gamma_ - 1.0) * gas.pressure / gas.density + 0.5 * gas.velocity * gas.velocity;
    return {mass, mass * gas.velocity + gas.pressure, mass * enthalpy};
}

Gas1D EulerDuct::at_opening(const Gas1D& inside) const {
    const double c = sound_speed(gamma_, inside), half = 0.5 * (gamma_ - 1.0);
    if (inside.velocity >= c) return inside;
    const double leaving = inside.velocity + c / half;  // the characteristic's invariant
    double c_out = c * std::pow(p_out_ / inside.pressure, half / gamma_);
    double u = leaving - c_out / half;
    if (u > c_out) u = c_out = leaving * half / (1.0 + half);
    if (u < 0.0) {  // a wall: gas that would flow inward is brought to rest
        const Gas1D mirrored{inside.density, -inside.velocity, inside.pressure};
        return exact_riemann(gamma_, inside, mirrored, 0.0);
    }
    const double ratio = c_out / c;
    return {inside.density * std::pow(ratio, 1.0 / half), u,
            inside.pressure * std::pow(ratio, gamma_ / half)};
}

std::vector<EulerDuct::Conserved> EulerDuct::rates(const std::vector<Conserved>& cells,
                                                   const DuctInflow& inflow) const {
    const std::size_t n = cells.size();
    std::vector<Gas1D> mean(n), left(n), right(n);
    for (std::size_t i = 0; i < n; ++i) mean[i] = primitive(cells[i]);
    for (std::size_t i = 0; i < n; ++i) {
        left[i] = right[i] = mean[i];
        if (i == 0 || i + 1 == n) continue;
        for (double Gas1D::*q : {&Gas1D::density, &Gas1D::velocity, &Gas1D::pressure}) {
            const double slope = limited(mean[i].*q - mean[i - 1].*q, mean[i + 1].*q - mean[i].*q);
            left[i].*q -= 0.5 * slope;
            right[i].*q += 0.5 * slope;
        }
    }
    const Gas1D mirrored{left[0].density, -left[0].velocity, left[0].pressure};
    const Gas1D wall = exact_riemann(gamma_, mirrored, left[0], 0.0);
    Conserved in{0.0, wall.pressure, 0.0};
    std::vector<Conserved> rate(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
        const Gas1D face =
            i + 1 < n ? exact_riemann(gamma_, right[i], left[i + 1], 0.0) : at_opening(right[i]);
        const Conserved out = flux_of(face);
        for (int k = 0; k < 3; ++k) rate[i][k] = (in[k] - out[k]) / width_;
        in = out;
    }
    rate[n] = in;
    const double length = width_ * static_cast<double>(source_cells_);
    for (std::size_t i = 0; i < source_cells_; ++i) {
        rate[i][0] += inflow.mass / length;
        rate[i][1] += inflow.momentum / length;
        rate[i][2] += inflow.energy / length;
    }
    return rate;
}

void EulerDuct::advance(double until, const DuctInflow& inflow) {
    const std::size_t n = cells_.size();
    while (time_ < until) {
        double fastest = 0.0;
        for (const Conserved& cell : cells_) {
            const Gas1D gas = primitive(cell);
            fastest = std::max(fastest, std::abs(gas.velocity) + sound_speed(gamma_, gas));
        }
        const double left = until - time_;
        const double dt = std::min(left, COURANT * width_ / fastest);
        const auto rate_0 = rates(cells_, inflow);
        auto ahead = cells_;
        for (std::size_t i = 0; i < n; ++i)
            for (int k = 0; k < 3; ++k) ahead[i][k] += dt * rate_0[i][k];
        const auto rate_1 = rates(ahead, inflow);
        for (std::size_t i = 0; i < n; ++i)
            for (int k = 0; k < 3; ++k) cells_[i][k] += 0.5 * dt * (rate_0[i][k] + rate_1[i][k]);
        for (int k = 0; k < 3; ++k) out_[k] += 0.5 * dt * (rate_0[n][k] + rate_1[n][k]);
        time_ = dt < left ? time_ + dt : until;
    }
}

std::vector<Gas1D> EulerDuct::gas() const {
    std::vector<Gas1D> all;
    for (const Conserved& cell : cells_) all.push_back(primitive(cell));
    return all;
}

double EulerDuct::total(int k) const {
    double sum = 0.0;
    for (const Conserved& cell : cells_) sum += width_ * cell[k];
    return sum;
}

}  // namespace corpuscle::oracle
