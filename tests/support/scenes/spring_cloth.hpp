// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include "contact/surface_contact.hpp"
#include "tests/support/geometry/cloth.hpp"

namespace corpuscle::support {

/// Point masses and linear springs along the edges of a sheet: the least cloth that contact can be
/// tried on. Airbag fabric: E 300 MPa, 750 kg/m³, 0.33 mm.
class SpringCloth {
public:
    static constexpr double THICKNESS = 0.33e-3;   ///< [m]
    static constexpr double GROWTH_TIME = 200e-6;  ///< of gaps below the thickness            [s]

    /// @param rest  node positions at which the springs are free of force
    SpringCloth(const Sheet& sheet, const Points& rest)
        : x(sheet.x),
          v(sheet.x.size(), Vec3::Zero()),
          f(v),
          mass(x.size(), 0.0),
          held(x.size(), 0),
          triangles(sheet.triangles) {
        std::set<std::pair<Index, Index>> edges;
        for (const Triangle& t : triangles) {
            const double area = vector_area(rest[t[0]], rest[t[1]], rest[t[2]]).norm();
            for (std::size_t k = 0; k < 3; ++k) {
                mass[t[k]] += 750.0 * THICKNESS * area / 3.0;
                edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
            }
        }
        for (const auto& [a, b] : edges) springs_.push_back({a, b, (rest[a] - rest[b]).norm()});
    }
    explicit SpringCloth(const Sheet& sheet) : SpringCloth(sheet, sheet.x) {}

    /// Row sums of the springs' M⁻¹K: no node vibrates faster by them.                 [1/s^2]
    [[nodiscard]] std::vector<double> own_rates() const {
        std::vector<double> rate(x.size(), 0.0);
        for (const Spring& s : springs_) {
            rate[s.a] += 2.0 * STIFFNESS / mass[s.a];
            rate[s.b] += 2.0 * STIFFNESS / mass[s.b];
        }
        return rate;
    }
    /// 0.9 of the stable step of the springs alone.                                        [s]
    [[nodiscard]] double stable_step() const {
        double most = 0.0;
        for (const double rate : own_rates()) most = std::max(most, rate);
        return 0.9 * 2.0 / std::sqrt(most);
    }
    /// @param card  with all of the cloth as its part 0
    [[nodiscard]] contact::ContactSetup setup(contact::ContactCard card,
                                              const Points& reference_x) const {
        card.parts = {0};
        contact::ContactSetup setup;
        setup.cards = {card};
        setup.triangles = triangles;
        setup.part.assign(triangles.size(), 0);
        setup.thickness.assign(triangles.size(), THICKNESS);
        setup.node_mass = mass;
        setup.reference_x = reference_x;
        setup.x0 = x;
        setup.held = held;
        setup.growth_time = GROWTH_TIME;
        return setup;
    }
    void add_spring_force() {
        for (const Spring& s : springs_) {
            const Vec3 d = x[s.b] - x[s.a];
            const double length = d.norm();
            if (length == 0.0) continue;
            const Vec3 force = STIFFNESS * (1.0 - s.length / length) * d;
            f[s.a] += force;
            f[s.b] -= force;
        }
    }
    /// v += dt f / m and x += dt v, held nodes keep their velocity.
    void kick(double dt) {
        for (std::size_t i = 0; i < x.size(); ++i)
            if (!held[i]) v[i] += dt / mass[i] * f[i];
    }
    void drift(double dt) {
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += dt * v[i];
    }
    [[nodiscard]] double kinetic_energy() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * mass[i] * v[i].squaredNorm();
        return sum;
    }
    [[nodiscard]] double strain_energy() const {
        double sum = 0.0;
        for (const Spring& s : springs_) {
            const double stretch = (x[s.b] - x[s.a]).norm() - s.length;
            sum += 0.5 * STIFFNESS * stretch * stretch;
        }
        return sum;
    }
    [[nodiscard]] Vec3 momentum() const {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 0; i < x.size(); ++i) sum += mass[i] * v[i];
        return sum;
    }

    Points x, v, f;
    std::vector<double> mass;
    std::vector<std::uint8_t> held;
    std::vector<Triangle> triangles;

private:
    struct Spring {
        Index a, b;
        double length;
    };
    static constexpr double STIFFNESS =
        300e6 * THICKNESS * 0.6;  ///< about that of the fabric   [N/m]
    std::vector<Spring> springs_;
};

/// What a run with contact has come to.
struct ClothRun {
    double work_of_loads = 0.0;  ///< sum of f · (v before + after) / 2 dt                   [J]
    double work_of_springs =
        0.0;  ///< likewise: what leapfrog makes of them, not their energy's change  [J]
    double work_of_springs_on_free = 0.0;  ///< the same, held nodes left out  [J]
    double peak_strain = 0.0;              ///< greatest strain energy [J]
};

/// n steps of dt and a last half kick, so that velocities live at the same time as positions at
/// both ends. `load` adds forces to f at t, `watch` sees every state before it moves on.
inline ClothRun run_cloth(SpringCloth& cloth, contact::SurfaceContact& contact, double dt,
                          int steps, const std::function<void(double, SpringCloth&)>& load,
                          const std::function<void(int)>& watch) {
    ClothRun run;
    Points loads(cloth.x.size()), before;
    for (int n = 0; n <= steps; ++n) {
        const double span = n == 0 || n == steps ? 0.5 * dt : dt;
        watch(n);
        std::fill(cloth.f.begin(), cloth.f.end(), Vec3::Zero());
        if (load) load(n * dt, cloth);
        loads = cloth.f;
        cloth.add_spring_force();
        contact.find(cloth.x, cloth.v, n * dt, dt);
        before = cloth.v;
        cloth.kick(span);
        for (std::size_t i = 0; i < loads.size(); ++i) {
            const Vec3 way = 0.5 * span * (before[i] + cloth.v[i]);
            const Vec3 spring = cloth.f[i] - loads[i];
            run.work_of_loads += loads[i].dot(way);
            run.work_of_springs += spring.dot(way);
            if (cloth.held[i]) continue;
            run.work_of_springs_on_free += spring.dot(way);
        }
        run.peak_strain = std::max(run.peak_strain, cloth.strain_energy());
        if (n == steps) break;
        contact.respond(cloth.x, dt, cloth.v);
        cloth.drift(dt);
    }
    return run;
}

/// A sheet as contact knows it, 1 mm thick for it.
inline contact::Cloth cloth_of(const Sheet& sheet) {
    SpringCloth cloth(sheet);
    contact::ContactCard card;
    card.thickness = 1e-3;
    return contact::Cloth(cloth.setup(card, sheet.x));
}

}  // namespace corpuscle::support
