// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

/// Direct simulation of hard spheres in a plane, the tests' own: it shares no code with gas/.
///
/// Units: mass and sqrt(k T / m) of gas 0 at the start are 1. Lengths are the caller's. Each particle
/// is a molecule of a layer of depth 1, so n = particles / area.
namespace corpuscle::dsmc {

/// A gas of spheres; gas 0 has mass 1 and diameter 1.
struct Spheres {
    double mass, diameter;
};

/// A rectangle from the origin to `size`, cut into cells. All sides are mirrors.
struct Plane {
    std::array<double, 2> size;
    std::array<int, 2> cells;
    bool is_periodic_in_y = false;
    /// Below this y the side at x = size[0] takes whoever comes out of the plane.
    double outlet = 0.0;
    /// A thin mirror across x = size[0] / 2 where y is above this; cells[0] is even then.
    std::optional<double> slit{};
};

/// What enters through x = 0, y < height: cosines to the x axis even between cos(half_angle) and 1.
struct Slot {
    double height, flux;  ///< [length], particles by length and time
    double speed, half_angle;
};

struct Particle {
    std::array<double, 2> x;
    std::array<double, 3> v;
    std::int32_t gas, cell;
};

/// Flight and collisions by turns [Bird 1994, ch. 11]: in a cell of volume V with N particles
///     N (N - 1) / 2 · (sigma g)_max dt / V
/// pairs are drawn (no time counter), and collide with chance sigma g / (sigma g)_max.
class HardSpheres {
public:
    /// @param density         n that the mean free path is for, of gas 0 alone
    /// @param mean_free_path  1 / (sqrt 2 n pi d²)
    HardSpheres(const Plane& plane, std::vector<Spheres> gases, double density,
                double mean_free_path, std::uint64_t seed);

    /// Adds n at places even over x_0 <= x < x_1 with Maxwell's velocities of k T = 1.
    void fill(int gas, std::size_t n, double x_0, double x_1);
    void set_slot(const Slot& slot) { slot_ = slot; }
    /// From t to t + dt: enter, fly, collide.
    void step(double dt);

    [[nodiscard]] const std::vector<Particle>& particles() const { return particles_; }
    [[nodiscard]] std::vector<Particle>& particles() { return particles_; }
    [[nodiscard]] double mass(const Particle& p) const {
        return gases_[static_cast<std::size_t>(p.gas)].mass;
    }
    [[nodiscard]] std::size_t collisions() const { return collisions_; }

    double uniform() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
    double normal();

private:
    bool fly(double span, Particle& p) const;
    void enter(double dt);
    void sort();
    void collide(double dt);
    bool meet(Particle& a, Particle& b, double& most);

    Plane plane_;
    std::vector<Spheres> gases_;
    double sigma_;  ///< cross section of gas 0
    double cell_area_;
    std::optional<Slot> slot_;
    double owed_ = 0.0;  ///< particles that have not entered yet
    std::vector<Particle> particles_, sorted_;
    std::vector<std::size_t> first_;  ///< row of each cell's first particle
    std::vector<double> most_;        ///< (sigma g)_max by cell
    std::size_t collisions_ = 0;
    std::mt19937_64 random_;
};

}  // namespace corpuscle::dsmc
