// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "tests/support/decks/box_deck.hpp"
#include "tests/support/gas/air.hpp"
#include "tests/support/geometry/shapes.hpp"
#include "tests/support/runs/deck_run.hpp"

/// Decks of closed bags of air in the open, and the momenta of a run's frames. SI units.
namespace corpuscle::test::free_bag {

constexpr double DENSITY = 750.0, THICKNESS = 3e-4;  ///< of the cloth         [kg/m^3], [m]

struct Bag {
    shapes::Shape shape;
    double p = 2.0 * air::P_ATM, T = 300.0;  ///< inside, at the start            [Pa], [K]
    double stiffness = 5e9;                  ///< of the cloth                    [Pa]
    int particles = 20000;
    double spin = 0.0;             ///< about x                              [rad/s]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    bool is_uniform = false;       ///< a control volume from the start, filled in a millisecond
    double end = 28e-3, frames = 1e-3;  ///< [s]
};

/// Air that is there from the start as particles, at p and T.
inline std::string particle_gas(const Bag& bag) {
    return fmt::format("*AIRBAG_PARTICLE\n1, 0\n{}, 1, 1, {}, {}\n2\n{}, {}, {}, {}\n",
                       bag.particles, bag.T, air::P_ATM, bag.p, bag.T, air::MOLAR_MASS,
                       air::MOLAR_CP);
}

/// Air at uniform pressure; what brings a litre to p flows in until 1 ms.
inline std::string uniform_gas(const Bag& bag) {
    const double rate = air::density(bag.p - air::P_ATM, bag.T) * 1e-3 / 1e-3;
    return set_card(12, {1}) + curve_card(1, {{0.0, rate}, {1e-3, rate}, {1e-3, 0.0}, {1.0, 0.0}}) +
           fmt::format("*AIRBAG_SIMPLE_AIRBAG_MODEL\n12, 1\n{}, {}, {}, 1, 0, 0, {}, {}\n0\n",
                       air::energy(1.0), air::MOLAR_CP / air::MOLAR_MASS, bag.T, air::P_ATM,
                       air::density(air::P_ATM, bag.T));
}

inline std::string deck(const Bag& bag) {
    DeckMesh mesh{bag.shape.x, {}};
    for (const auto& [a, b, c] : bag.shape.triangles)
        mesh.quads.push_back({1, {a + 1, b + 1, c + 1, c + 1}});
    constexpr double POISSON = 0.3;
    return "*KEYWORD\n*TITLE\nfree bag\n" + mesh.cards([](const Vec3&) { return false; }) +
           part_card(1, 1) + section_card(1, THICKNESS) +
           fmt::format("*MAT_FABRIC\n1, {}, {}, , , {}\n{}\n,\n,\n,\n", DENSITY, bag.stiffness,
                       POISSON, bag.stiffness / (2.0 * (1.0 + POISSON))) +
           (bag.is_uniform ? uniform_gas(bag) : particle_gas(bag)) +
           fmt::format("*INITIAL_VELOCITY_GENERATION\n1, 2, {}, {}, {}, {}\n0, 0, 0, 1, 0, 0\n",
                       bag.spin, bag.velocity.x(), bag.velocity.y(), bag.velocity.z()) +
           fmt::format(
               "*CONTROL_TERMINATION\n{0},\n*DATABASE_ABSTAT\n{1},\n*DATABASE_BINARY_D3PLOT\n"
               "{1},\n*END\n",
               bag.end, bag.frames);
}

/// Masses of the nodes: a third of each of their triangles.                            [kg]
inline std::vector<double> node_masses(const shapes::Shape& shape) {
    std::vector<double> mass(shape.x.size(), 0.0);
    for (const auto& [a, b, c] : shape.triangles) {
        const double area = 0.5 * (shape.x[b] - shape.x[a]).cross(shape.x[c] - shape.x[a]).norm();
        for (const Index n : {a, b, c}) mass[n] += DENSITY * THICKNESS * area / 3.0;
    }
    return mass;
}

/// Linear, and angular about the origin.                                 [kg m/s], [kg m^2/s]
struct Momentum {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();

    void add(double mass, const Vec3& x, const Vec3& v) {
        linear += mass * v;
        angular += mass * x.cross(v);
    }
};

inline Vec3 row(const std::vector<double>& all, std::size_t i) {
    return {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
}

/// Cloth and gas of a frame.
struct FrameMomenta {
    Momentum cloth, gas;
};
inline FrameMomenta momenta(const DeckRun& run, std::size_t frame,
                            const std::vector<double>& masses) {
    const std::string path = fmt::format("/frames/{:05d}/", frame);
    FrameMomenta found;
    const auto x = run.read(path + "coordinates"), v = run.read(path + "velocity");
    for (std::size_t n = 0; n < masses.size(); ++n)
        found.cloth.add(masses[n], row(x, n), row(v, n));
    if (!run.has(path + "particles/mass")) return found;  // at uniform pressure
    const auto y = run.read(path + "particles/position"), w = run.read(path + "particles/velocity"),
               m = run.read(path + "particles/mass");
    for (std::size_t i = 0; i < m.size(); ++i) found.gas.add(m[i], row(y, i), row(w, i));
    return found;
}

}  // namespace corpuscle::test::free_bag
