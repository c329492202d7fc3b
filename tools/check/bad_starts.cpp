// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/check/bad_starts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <unordered_map>

#include "solver/simulation.hpp"
#include "tools/check/crossing_depth.hpp"
#include "tools/everyday.hpp"

namespace corpuscle::tools {
namespace {

/// Thickness of facets that have none, over their longest edge.
constexpr double THIN = 1e-3;

/// Pairs whose depth is worked out, of each two parts.
constexpr std::size_t MEASURED = 2000;

Prism prism_of(const Model& model, Index row) {
    const Shell& shell = model.shells[row];
    const Part& part = model.parts[shell.part];
    Prism out;
    double longest = 0.0;
    for (int k = 0; k < (shell.is_triangle() ? 3 : 4); ++k) {
        out.corners.push_back(model.x[shell.nodes[k]]);
        longest = std::max(longest, (out.corners.back() - out.corners.front()).norm());
    }
    out.thickness = std::isnan(part.contact_thickness) ? part.thickness : part.contact_thickness;
    if (!(out.thickness > 0.0)) out.thickness = THIN * longest;
    return out;
}

struct Crossing {
    std::size_t pairs = 0;
    double depth = 0.0;
    Index shell = -1, other = -1;  ///< of the deepest pair, rows
};

std::string told(const Model& model, Index row) {
    const Part& part = model.parts[row];
    const bool is_rigid =
        std::holds_alternative<fabric::RigidCard>(model.materials[part.material].card);
    return fmt::format("{}part {}{}", is_rigid ? "rigid " : "", part.id,
                       part.title.empty() ? "" : fmt::format(" \"{}\"", part.title));
}

}  // namespace

std::vector<std::string> crossings_at_start(const Simulation& simulation) {
    const Model& model = simulation.model();
    std::unordered_map<int, Index> row;
    for (std::size_t s = 0; s < model.shells.size(); ++s)
        row.emplace(model.shells[s].id, static_cast<Index>(s));
    std::map<std::pair<Index, Index>, Crossing> all;
    for (const auto& [a, b] : simulation.bad_starts().crossing) {
        const Index one = row.at(a), other = row.at(b);
        Crossing& of = all[std::minmax(model.shells[one].part, model.shells[other].part)];
        if (++of.pairs > MEASURED) continue;
        const double depth = crossing_depth(prism_of(model, one), prism_of(model, other));
        if (of.shell >= 0 && !(depth > of.depth)) continue;
        of.depth = depth;
        of.shell = one;
        of.other = other;
    }
    const Everyday unit(model.unit_system);
    std::vector<std::string> lines;
    for (const auto& [parts, of] : all) {
        const Vec3& at = model.x[model.shells[of.shell].nodes[0]];
        const std::string whom = parts.first == parts.second
                                     ? told(model, parts.first) + " crosses itself"
                                     : fmt::format("{} and {} cross", told(model, parts.first),
                                                   told(model, parts.second));
        lines.push_back(fmt::format(
            "{} at the start: {} pairs of shells, up to {} deep (shells {} and {}, near ({:.6g}, "
            "{:.6g}, {:.6g})); contact cannot know which side is the right one, they stay as they "
            "are until they come apart by themselves",
            whom, of.pairs, unit.length(of.depth), model.shells[of.shell].id,
            model.shells[of.other].id, at.x(), at.y(), at.z()));
    }
    return lines;
}

}  // namespace corpuscle::tools
