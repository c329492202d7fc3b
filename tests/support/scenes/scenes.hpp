// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <numeric>

#include "solver/model.hpp"
#include "tests/support/geometry/shapes.hpp"

/// Scenes built without a deck. SI units.
namespace corpuscle::scenes {

/// Nodes and triangles of a shape as shells of one part of the given material.
inline Model of(const shapes::Shape& shape, const fabric::MaterialCard& material,
                double thickness) {
    Model model;
    model.title = "test";
    model.deck = "none";
    model.unit_system = "SI";
    model.x = shape.x;
    model.velocity.assign(shape.x.size(), Vec3::Zero());
    model.node_id.resize(shape.x.size());
    std::iota(model.node_id.begin(), model.node_id.end(), 1);
    for (const auto& [a, b, c] : shape.triangles)
        model.shells.push_back({static_cast<int>(model.shells.size()) + 1, 0, {a, b, c, c}});
    model.parts.resize(1);
    model.parts[0].id = 1;
    model.parts[0].material = 0;
    model.parts[0].thickness = thickness;
    model.materials = {{1, "", material}};
    model.end_time = 1.0;
    return model;
}

inline void fix_all_nodes(Model& model) {
    for (std::size_t n = 0; n < model.x.size(); ++n)
        model.supports.push_back({static_cast<Index>(n), 7U});
}

inline fabric::NullCard null_material() {
    return {1000.0};
}

inline fabric::ElasticCard cloth() {
    return {750.0, 300e6, 0.3};
}

/// Air, Cp = 28 J/(mol K), of the notes' examples.
inline gas::SpeciesCard air() {
    return {0.028, 28.0, 0.0, 0.0};
}
inline gas::SpeciesCard helium() {
    return {0.003, 20.79, 0.0, 0.0};
}

/// A bag over all parts that takes in `mass` of a gas evenly until `until`, stagnation temperature
/// T, from a new node at `orifice`.
inline void fill(Model& model, const gas::SpeciesCard& species, double mass, double until, double T,
                 const Vec3& orifice, std::size_t particles) {
    const auto curve = [&](std::vector<double> x, std::vector<double> y) {
        model.curves.push_back(
            {static_cast<int>(model.curves.size()) + 1, std::move(x), std::move(y)});
        return static_cast<Index>(model.curves.size() - 1);
    };
    if (model.bags.empty()) {
        gas::BagCard bag;
        bag.id = 1;
        bag.p_atm = 0.0;
        for (std::size_t p = 0; p < model.parts.size(); ++p)
            bag.external_parts.push_back(static_cast<Index>(p));
        bag.particles = particles;
        gas::OrificeCard at;
        at.node = static_cast<Index>(model.x.size());
        bag.orifices = {at};
        model.bags = {bag};
        model.x.push_back(orifice);
        model.velocity.push_back(Vec3::Zero());
        model.node_id.push_back(static_cast<int>(model.x.size()));
    }
    const double gamma = species.A / (species.A - GAS_CONSTANT);
    model.bags[0].inflow.push_back({species, curve({0.0, until}, {mass / until, mass / until}),
                                    curve({0.0, 1.0}, {T / gamma, T / gamma}), 1});
}

}  // namespace corpuscle::scenes
