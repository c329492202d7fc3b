// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/reference_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "solver/base/error.hpp"

namespace corpuscle {

namespace {

std::array<Vec3, 4> corners_of(const Shell& shell, const Points& place) {
    std::array<Vec3, 4> out;
    for (std::size_t c = 0; c < 4; ++c) out[c] = place[shell.nodes[c]];
    return out;
}

/// The reference geometry of the nodes that have one, later keywords before earlier ones.
struct NodeReference {
    Points place;
    std::vector<std::uint8_t> listed;
    std::vector<double> birth;

    explicit NodeReference(const Model& model)
        : place(model.x), listed(model.x.size(), 0), birth(model.x.size(), 0.0) {
        for (const ReferenceGeometry& reference : model.references)
            for (const auto& [node, at] : reference.nodes) {
                place[node] = at;
                listed[node] = 1;
                birth[node] = reference.birth;
            }
    }
    [[nodiscard]] bool has(const Shell& shell) const {
        return std::all_of(shell.nodes.begin(), shell.nodes.end(),
                           [&](Index n) { return listed[n] != 0; });
    }
    [[nodiscard]] double born(const Shell& shell) const {
        double latest = 0.0;
        for (const Index n : shell.nodes) latest = std::max(latest, birth[n]);
        return latest;
    }
};

double birth_of_material(const Model& model, const Shell& shell) {
    const auto& card = model.materials[model.parts[shell.part].material].card;
    const auto* fabric = std::get_if<fabric::FabricCard>(&card);
    return fabric != nullptr ? fabric->reference_birth : 0.0;
}

}  // namespace

std::vector<std::array<Vec3, 4>> reference_corners(const Model& model) {
    const NodeReference of_nodes(model);
    std::vector<std::array<Vec3, 4>> corners;
    for (const Shell& shell : model.shells)
        corners.push_back(corners_of(shell, of_nodes.has(shell) ? of_nodes.place : model.x));
    for (const ShellReference& reference : model.shell_references)
        corners[reference.shell] = reference.corners;
    return corners;
}

std::vector<double> reference_births(const Model& model) {
    const NodeReference of_nodes(model);
    std::vector<double> births(model.shells.size(), 0.0);
    std::vector<std::uint8_t> has_own(model.shells.size(), 0);
    for (const ShellReference& reference : model.shell_references) has_own[reference.shell] = 1;
    for (std::size_t s = 0; s < births.size(); ++s) {
        const Shell& shell = model.shells[s];
        if (!has_own[s] && !of_nodes.has(shell)) continue;
        const double own = birth_of_material(model, shell);
        births[s] = own > 0.0 ? own : has_own[s] ? 0.0 : of_nodes.born(shell);
    }
    if (std::none_of(births.begin(), births.end(), [](double t) { return t > 0.0; }))
        births.clear();
    return births;
}

void check_births(const Model& model, const std::vector<double>& births) {
    if (births.empty()) return;
    std::vector<Fault> faults;
    if (model.step_mass_scaled != 0.0)
        faults.push_back(
            {.of = "the run",
             .property = Property::MASS_SCALED_STEP,
             .value = model.step_mass_scaled,
             .why =
                 "expected 0 where a reference geometry is born later: mass cannot change then"});
    for (const fabric::Material& material : model.materials) {
        const auto* cloth = std::get_if<fabric::FabricCard>(&material.card);
        if (cloth != nullptr && cloth->restoration.any())
            faults.push_back({.of = "material " + std::to_string(material.id),
                              .property = Property::REFERENCE_RESTORATION,
                              .why = "expected none where a reference geometry is born later"});
    }
    if (!faults.empty()) throw InputError(std::move(faults));
}

std::vector<std::array<Vec3, 4>> corners_before(double next, const std::vector<double>& births,
                                                const std::vector<std::array<Vec3, 4>>& corners,
                                                const Model& model) {
    std::vector<std::array<Vec3, 4>> out = corners;
    for (std::size_t s = 0; s < births.size(); ++s)
        if (births[s] >= next) out[s] = corners_of(model.shells[s], model.x);
    return out;
}

bool is_strained(const Model& model, const std::vector<std::uint8_t>& active,
                 const std::vector<std::array<Vec3, 4>>& corners, double least) {
    const auto is_edge_strained = [&](const std::array<Vec3, 4>& now,
                                      const std::array<Vec3, 4>& rest, std::size_t k) {
        const std::size_t next = (k + 1) % 4;
        const double length = (rest[next] - rest[k]).norm();
        return std::abs((now[next] - now[k]).norm() - length) > least * length;
    };
    for (std::size_t s = 0; s < model.shells.size(); ++s) {
        if (!active[s]) continue;
        const std::array<Vec3, 4> now = corners_of(model.shells[s], model.x);
        for (std::size_t k = 0; k < 4; ++k)
            if (is_edge_strained(now, corners[s], k)) return true;
    }
    return false;
}

double next_birth(double t, const std::vector<double>& births) {
    double next = INF;
    for (const double birth : births)
        if (birth > t) next = std::min(next, birth);
    return next;
}

}  // namespace corpuscle
