// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/bag_walls.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>
#include <variant>

#include "solver/scene/scene_surface.hpp"

namespace corpuscle {
namespace {

std::vector<bool> marked(const std::vector<Index>& parts, std::size_t count) {
    std::vector<bool> mark(count, false);
    for (const Index part : parts) mark[part] = true;
    return mark;
}

/// Numbers the parts that the walls' shells belong to.
void number_parts(const Model& model, gas::BagWalls& walls) {
    std::vector<Index> row(model.parts.size(), -1);
    for (const Index shell : walls.shell) {
        const Index part = model.shells[shell].part;
        if (row[part] < 0) {
            row[part] = static_cast<Index>(walls.part_ids.size());
            walls.part_ids.push_back(model.parts[part].id);
            walls.part_rows.push_back(part);
        }
        walls.part.push_back(row[part]);
    }
}

/// FVOPT 1, 2 without curves: an orifice of FLC · FAC of the area that there is at the time, A0 X1 rs.
gas::LeakCard orifice(Index part, const fabric::FabricCard& cloth) {
    gas::LeakCard leak;
    leak.part = part;
    leak.when_blocked = cloth.leak_when_blocked;
    leak.from_reference = cloth.leak_from_reference;
    const double share = cloth.leak_area * cloth.leak_velocity;
    leak.growth = cloth.leak_from_reference ? std::array{share, 0.0, 0.0, 0.0}
                                            : std::array{0.0, share, 0.0, 0.0};
    return leak;
}

gas::LeakLaw law_of(int option) {
    if (option == 1 || option == 2) return gas::LeakLaw::ORIFICE;
    if (option == 3 || option == 4) return gas::LeakLaw::HEAD;
    if (option == 5 || option == 6) return gas::LeakLaw::POROUS;
    return gas::LeakLaw::VELOCITY;
}

/// What the fabric of a part says of leaking, if it does.
std::optional<gas::LeakCard> leak_of(const Model& model, Index part) {
    const fabric::FabricCard* cloth = leakage_of(model, part);
    if (cloth == nullptr) return {};
    const bool has_curves = cloth->leak_area_curve >= 0 || cloth->leak_velocity_curve >= 0;
    const gas::LeakLaw law = law_of(cloth->leak_option);
    if (!cloth->leak_growth && law == gas::LeakLaw::ORIFICE && !has_curves)
        return orifice(part, *cloth);
    return gas::LeakCard{part,
                         cloth->leak_area,
                         cloth->leak_area_curve,
                         law,
                         cloth->leak_velocity,
                         cloth->leak_velocity_curve,
                         cloth->leak_by_component,
                         cloth->leak_when_blocked,
                         cloth->leak_from_reference,
                         cloth->leak_growth};
}

std::array<Index, 3> sorted_nodes(Triangle facet) {
    std::sort(facet.begin(), facet.end());
    return facet;
}

/// By closing facet: is it one of two that have all three nodes in common, at an edge where other
/// facets of the bag meet too? Such a pair encloses nothing at any time.
std::vector<bool> empty_pairs(const gas::BagWalls& walls) {
    std::map<std::array<Index, 3>, int> alike;
    std::map<std::pair<Index, Index>, int> at_edge;
    for (std::size_t f = 0; f < walls.closing; ++f) {
        const auto n = sorted_nodes(walls.triangles[f]);
        ++alike[n];
        for (const auto& edge :
             {std::pair(n[0], n[1]), std::pair(n[1], n[2]), std::pair(n[0], n[2])})
            ++at_edge[edge];
    }
    std::vector<bool> is_empty(walls.triangles.size(), false);
    for (std::size_t f = 0; f < walls.closing; ++f) {
        const auto n = sorted_nodes(walls.triangles[f]);
        is_empty[f] = alike[n] == 2 && std::max({at_edge[{n[0], n[1]}], at_edge[{n[1], n[2]}],
                                                 at_edge[{n[0], n[2]}]}) > 2;
    }
    return is_empty;
}

/// The corner of a flat bag whose panels share its three nodes is no wall of the gas.
void leave_out_empty_pairs(const Model& model, gas::BagWalls& walls) {
    if (!model.closes_bags) return;
    const std::vector<bool> is_empty = empty_pairs(walls);
    const auto count = static_cast<std::size_t>(std::count(is_empty.begin(), is_empty.end(), true));
    if (count == walls.closing) return;  // nothing would be left
    std::size_t kept = 0;
    for (std::size_t f = 0; f < walls.triangles.size(); ++f) {
        if (is_empty[f]) continue;
        walls.triangles[kept] = walls.triangles[f];
        walls.shell[kept++] = walls.shell[f];
    }
    walls.triangles.resize(kept);
    walls.shell.resize(kept);
    walls.closing -= count;
    walls.empty_pairs = count / 2;
}

}  // namespace

const fabric::FabricCard* leakage_of(const Model& model, Index part) {
    const Index material = model.parts[part].material;
    if (material < 0) return nullptr;
    const auto* cloth = std::get_if<fabric::FabricCard>(&model.materials[material].card);
    for (const AddedLeak& added : model.added_leaks)
        if (added.material == material) cloth = &added.says;
    return cloth != nullptr && cloth->leaks() ? cloth : nullptr;
}

gas::BagWalls bag_walls(const Model& model, const gas::BagCard& card,
                        const std::vector<std::array<Vec3, 4>>& reference) {
    const std::size_t count = model.parts.size();
    gas::BagWalls walls;
    SceneTriangles closing = triangles_of(model, marked(card.external_parts, count));
    const SceneTriangles internal = triangles_of(model, marked(card.internal_parts, count));
    walls.closing = closing.triangles.size();
    walls.triangles = std::move(closing.triangles);
    walls.shell = std::move(closing.shell);
    walls.triangles.insert(walls.triangles.end(), internal.triangles.begin(),
                           internal.triangles.end());
    walls.shell.insert(walls.shell.end(), internal.shell.begin(), internal.shell.end());
    leave_out_empty_pairs(model, walls);

    std::vector<Index> row(count, -1);
    for (const auto* parts : {&card.external_parts, &card.internal_parts})
        for (const Index part : *parts) {
            row[part] = static_cast<Index>(walls.part_ids.size());
            walls.part_ids.push_back(model.parts[part].id);
            walls.part_rows.push_back(part);
            if (const auto leak = leak_of(model, part)) walls.leaks.push_back(*leak);
        }
    for (const Index shell : walls.shell) walls.part.push_back(row[model.shells[shell].part]);
    walls.reference_area.assign(walls.part_ids.size(), 0.0);
    for (std::size_t s = 0; s < model.shells.size(); ++s) {
        if (row[model.shells[s].part] < 0) continue;
        const auto& [a, b, c, d] = reference[s];
        walls.reference_area[row[model.shells[s].part]] +=
            vector_area(a, b, c).norm() + vector_area(a, c, d).norm();
    }
    return walls;
}

gas::BagWalls bag_walls(const Model& model, const gas::UniformBagCard& card) {
    std::vector<bool> wanted(model.shells.size(), false);
    for (const Index shell : card.shells) wanted[shell] = true;
    SceneTriangles all = triangles_of(model, std::vector<bool>(model.parts.size(), true));
    gas::BagWalls walls;
    for (std::size_t t = 0; t < all.triangles.size(); ++t) {
        if (!wanted[all.shell[t]]) continue;
        walls.triangles.push_back(all.triangles[t]);
        walls.shell.push_back(all.shell[t]);
    }
    walls.closing = walls.triangles.size();
    leave_out_empty_pairs(model, walls);
    number_parts(model, walls);
    return walls;
}

}  // namespace corpuscle
