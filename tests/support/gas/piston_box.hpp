// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <utility>

#include "gas/collisions/collide.hpp"
#include "tests/unit/gas/random_gas.hpp"

namespace corpuscle::gas {

/// A box whose wall at x = length moves: mirrors everywhere, collisions between flights.
class PistonBox {
public:
    /// @param edge  of a cell; a little less where that makes them fit the box at the start [m]
    PistonBox(const Vec3& size, const Mixture& mixture, CollisionModel model, Particles particles,
              double edge, std::uint64_t seed = 3, double mean_free_path = NaN)
        : gas(std::move(particles)),
          length(size.x()),
          size_(size),
          mixture_(mixture),
          collider_(mixture.species(), mixture.moles_each(), seed, model, mean_free_path),
          edge_(edge) {}

    /// One collision step and one flight.
    void step(double dt, double piston_speed = 0.0) {
        const Vec3 now(length, size_.y(), size_.z());
        collider_.find_groups(Grid::over(Vec3::Zero(), now - Vec3::Constant(1e-12), edge_, 1000000),
                              {}, gas);
        collider_.collide(step_++, dt, 1.0, gas);
        for (std::size_t i = 0; i < gas.size(); ++i) {
            fly_along_x(i, dt, piston_speed);
            for (const int a : {1, 2}) fly_between_mirrors(i, a, dt);
        }
        length += piston_speed * dt;
    }

    [[nodiscard]] double edge() const { return edge_; }
    [[nodiscard]] double area() const {
        return 2.0 * (length * size_.y() + size_.y() * size_.z() + size_.z() * length);
    }
    [[nodiscard]] double volume() const { return length * size_.y() * size_.z(); }

    Particles gas;
    double length;                ///< of the box along x                                   [m]
    double impulse = 0.0;         ///< given to all walls, along their normals              [N s]
    double piston_impulse = 0.0;  ///< of which to the piston                        [N s]

private:
    void fly_along_x(std::size_t i, double dt, double u) {
        double left = dt, wall = length;
        const double m = mixture_.particle_mass(gas.species[i]);
        for (;;) {
            double& x = gas.x[i].x();
            double& v = gas.v[i].x();
            const double to_piston = v > u ? (wall - x) / (v - u) : INF;
            const double to_end = v < 0.0 ? -x / v : INF;
            const double time = std::min(to_piston, to_end);
            if (time >= left) {
                x += v * left;
                return;
            }
            x = to_end < to_piston ? 0.0 : wall + u * time;
            const double after = to_end < to_piston ? -v : 2.0 * u - v;
            impulse += m * std::abs(after - v);
            if (to_piston <= to_end) piston_impulse += m * (v - after);
            v = after;
            wall += u * time;
            left -= time;
        }
    }
    void fly_between_mirrors(std::size_t i, int a, double dt) {
        double& x = gas.x[i][a];
        double& v = gas.v[i][a];
        x += v * dt;
        while (x < 0.0 || x > size_[a]) {
            x = x < 0.0 ? -x : 2.0 * size_[a] - x;
            impulse += 2.0 * mixture_.particle_mass(gas.species[i]) * std::abs(v);
            v = -v;
        }
    }

    Vec3 size_;
    const Mixture& mixture_;
    Collider collider_;
    double edge_;
    std::uint64_t step_ = 0;
};

}  // namespace corpuscle::gas
