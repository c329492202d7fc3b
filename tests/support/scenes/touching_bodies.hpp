// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>

#include <functional>

#include "contact/broad_phase/intersections.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

/// Scenes of several parts, rigid or of cloth, that touch. SI units.
namespace corpuscle::scenes {

inline fabric::RigidCard rigid(double density) {
    fabric::RigidCard card;
    card.density = density;
    card.E = 1e9;
    return card;
}

/// Adds a shape as a part of its own; returns the part's row.
inline Index add(Model& model, const Points& x, const std::vector<Triangle>& triangles,
                 const fabric::MaterialCard& material, double thickness, const Vec3& at) {
    const auto base = static_cast<Index>(model.x.size());
    const auto part = static_cast<Index>(model.parts.size());
    for (const Vec3& p : x) {
        model.x.push_back(p + at);
        model.velocity.push_back(Vec3::Zero());
        model.node_id.push_back(static_cast<int>(model.x.size()));
    }
    for (const auto& [a, b, c] : triangles)
        model.shells.push_back({static_cast<int>(model.shells.size()) + 1,
                                part,
                                {a + base, b + base, c + base, c + base}});
    model.parts.push_back({});
    model.parts.back().id = part + 1;
    model.parts.back().thickness = thickness;
    model.parts.back().material = part;
    model.materials.push_back({part + 1, "", material});
    return part;
}

inline Index add(Model& model, const shapes::Shape& shape, const fabric::MaterialCard& material,
                 double thickness, const Vec3& at) {
    return add(model, shape.x, shape.triangles, material, thickness, at);
}

inline Model empty(double end_time) {
    Model model;
    model.title = model.deck = "test";
    model.unit_system = "SI";
    model.end_time = end_time;
    return model;
}

inline void touch(Model& model, contact::ContactCard card = {}) {
    card.id = 1;
    for (std::size_t p = 0; p < model.parts.size(); ++p)
        card.parts.push_back(static_cast<Index>(p));
    model.contacts = {card};
}

inline void pull(Model& model, const Vec3& gravity) {
    for (int axis = 0; axis < 3; ++axis) {
        model.curves.push_back({axis + 1, {0.0, 100.0}, {-gravity[axis], -gravity[axis]}});
        model.body_loads.push_back({axis, static_cast<Index>(model.curves.size()) - 1, 1.0, {}});
    }
}

struct Totals {
    Vec3 momentum = Vec3::Zero(), turning = Vec3::Zero();
    double kinetic = 0.0;
};
inline Totals totals(const Simulation& simulation) {
    Totals all;
    const fabric::Nodes& nodes = simulation.nodes();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        all.momentum += nodes.mass[n] * nodes.v[n];
        all.turning += nodes.mass[n] * nodes.x[n].cross(nodes.v[n]);
    }
    for (const RigidBody& body : simulation.bodies()) {
        all.momentum += body.mass() * body.velocity();
        all.turning +=
            body.mass() * body.position().cross(body.velocity()) + body.angular_momentum();
        all.kinetic += body.kinetic_energy();
    }
    return all;
}

/// Runs to the end; looks for crossings in every `interval`-th step; returns the last books.
inline EnergyBooks run(Simulation& simulation, const std::function<void(Simulation&)>& watch = {},
                       int interval = 50) {
    parallel::set_threads(1);
    std::vector<Triangle> triangles;
    for (const Shell& shell : simulation.model().shells)
        triangles.push_back({shell.nodes[0], shell.nodes[1], shell.nodes[2]});
    const contact::Patches patches = contact::make_patches(simulation.model().x, triangles);
    EnergyBooks books;
    const auto observe = [&](Simulation& s) {
        books = s.books();
        if (watch) watch(s);
        if (s.steps() % interval == 0)
            REQUIRE(contact::crossings(triangles, patches, s.nodes().x).empty());
    };
    while (!simulation.is_over()) simulation.step(observe);
    simulation.close(observe);
    return books;
}

}  // namespace corpuscle::scenes
