// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/verification/dsmc/hard_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace corpuscle::dsmc {
namespace {

using std::numbers::pi;

/// (sigma g)_max that a cell begins with, in sigma sqrt(k T / m) of gas 0: it grows where pairs are faster.
constexpr double FIRST_MOST = 4.0;

/// y as mirrors at 0 and `size` bring it back; `v` turns with it.
void mirror(double size, double& x, double& v) {
    while (x < 0.0 || x >= size) {
        x = x < 0.0 ? -x : 2.0 * size - x;
        v = -v;
        if (x == size) x = std::nextafter(size, 0.0);
    }
}

}  // namespace

HardSpheres::HardSpheres(const Plane& plane, std::vector<Spheres> gases, double density,
                         double mean_free_path, std::uint64_t seed)
    : plane_(plane),
      gases_(std::move(gases)),
      sigma_(1.0 / (std::numbers::sqrt2 * density * mean_free_path)),
      cell_area_(plane.size[0] / plane.cells[0] * plane.size[1] / plane.cells[1]),
      most_(static_cast<std::size_t>(plane.cells[0] * plane.cells[1]), FIRST_MOST * sigma_),
      random_(seed) {
    if (plane.slit && plane.cells[0] % 2 != 0)
        throw std::invalid_argument("a cell reaches through the plate");
}

double HardSpheres::normal() {
    const double r = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return r * std::cos(2.0 * pi * uniform());
}

void HardSpheres::fill(int gas, std::size_t n, double x_0, double x_1) {
    const double spread = 1.0 / std::sqrt(gases_[static_cast<std::size_t>(gas)].mass);
    for (std::size_t i = 0; i < n; ++i) {
        Particle p{{x_0 + (x_1 - x_0) * uniform(), plane_.size[1] * uniform()}, {}, gas, 0};
        for (double& v : p.v) v = spread * normal();
        particles_.push_back(p);
    }
}

void HardSpheres::step(double dt) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        Particle p = particles_[i];
        if (fly(dt, p)) particles_[kept++] = p;
    }
    particles_.resize(kept);
    if (slot_) enter(dt);
    sort();
    collide(dt);
}

/// False for who leaves.
bool HardSpheres::fly(double span, Particle& p) const {
    const std::array<double, 2> from = p.x;
    for (const int a : {0, 1}) p.x[a] += span * p.v[a];
    const auto y_where_x_is = [&](double x) {
        double y = from[1] + p.v[1] * (x - from[0]) / p.v[0], turned = 0.0;
        mirror(plane_.size[1], y, turned);
        return y;
    };
    if (plane_.slit) {
        const double plate = 0.5 * plane_.size[0];
        if ((from[0] < plate) != (p.x[0] < plate) && y_where_x_is(plate) >= *plane_.slit) {
            p.x[0] = 2.0 * plate - p.x[0];
            p.v[0] = -p.v[0];
            if (from[0] < plate && p.x[0] == plate) p.x[0] = std::nextafter(plate, 0.0);
        }
    }
    if (p.x[0] >= plane_.size[0] && plane_.outlet > 0.0 &&
        y_where_x_is(plane_.size[0]) < plane_.outlet)
        return false;
    mirror(plane_.size[0], p.x[0], p.v[0]);
    if (plane_.is_periodic_in_y)
        p.x[1] -= plane_.size[1] * std::floor(p.x[1] / plane_.size[1]);
    else
        mirror(plane_.size[1], p.x[1], p.v[1]);
    return true;
}

/// As many as are due, at instants even over the step.
void HardSpheres::enter(double dt) {
    owed_ += slot_->flux * slot_->height * dt;
    for (; owed_ >= 1.0; owed_ -= 1.0) {
        const double low = std::cos(slot_->half_angle), along = low + (1.0 - low) * uniform();
        const double aside = std::sqrt(1.0 - along * along), turn = 2.0 * pi * uniform();
        Particle p{{0.0, slot_->height * uniform()}, {}, 0, 0};
        p.v = {slot_->speed * along, slot_->speed * aside * std::cos(turn),
               slot_->speed * aside * std::sin(turn)};
        if (fly(dt * uniform(), p)) particles_.push_back(p);
    }
}

/// Rows in the order of cells.
void HardSpheres::sort() {
    first_.assign(most_.size() + 1, 0);
    for (Particle& p : particles_) {
        std::array<int, 2> at{};
        for (const int a : {0, 1})
            at[a] = std::min(plane_.cells[a] - 1,
                             static_cast<int>(p.x[a] / plane_.size[a] * plane_.cells[a]));
        p.cell = at[0] * plane_.cells[1] + at[1];
        ++first_[static_cast<std::size_t>(p.cell) + 1];
    }
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    sorted_.resize(particles_.size());
    for (const Particle& p : particles_) sorted_[first_[static_cast<std::size_t>(p.cell)]++] = p;
    std::copy_backward(first_.begin(), first_.end() - 1, first_.end());
    first_[0] = 0;
    particles_.swap(sorted_);
}

void HardSpheres::collide(double dt) {
    for (std::size_t c = 0; c < most_.size(); ++c) {
        const std::size_t n = first_[c + 1] - first_[c];
        if (n < 2) continue;
        const auto count = static_cast<double>(n);
        const double pairs = 0.5 * count * (count - 1.0) * most_[c] * dt / cell_area_;
        auto left = static_cast<std::size_t>(pairs + uniform());
        for (; left > 0; --left) {
            const auto a = static_cast<std::size_t>(count * uniform());
            auto b = static_cast<std::size_t>((count - 1.0) * uniform());
            if (b >= a) ++b;
            collisions_ += meet(particles_[first_[c] + a], particles_[first_[c] + b], most_[c]);
        }
    }
}

/// Whether a pair that was drawn collides: then it leaves with g in any direction.
bool HardSpheres::meet(Particle& a, Particle& b, double& most) {
    const Spheres &of_a = gases_[static_cast<std::size_t>(a.gas)],
                  &of_b = gases_[static_cast<std::size_t>(b.gas)];
    double square = 0.0;
    for (int k = 0; k < 3; ++k) square += (a.v[k] - b.v[k]) * (a.v[k] - b.v[k]);
    const double g = std::sqrt(square), d = 0.5 * (of_a.diameter + of_b.diameter);
    const double rate = sigma_ * d * d * g;
    const double chance = rate / most;
    most = std::max(most, rate);
    if (uniform() >= chance) return false;
    const double along = 2.0 * uniform() - 1.0, aside = std::sqrt(1.0 - along * along);
    const double turn = 2.0 * pi * uniform();
    const std::array<double, 3> out{g * along, g * aside * std::cos(turn),
                                    g * aside * std::sin(turn)};
    const double mass = of_a.mass + of_b.mass;
    for (int k = 0; k < 3; ++k) {
        const double mean = (of_a.mass * a.v[k] + of_b.mass * b.v[k]) / mass;
        a.v[k] = mean + of_b.mass / mass * out[k];
        b.v[k] = mean - of_a.mass / mass * out[k];
    }
    return true;
}

}  // namespace corpuscle::dsmc
