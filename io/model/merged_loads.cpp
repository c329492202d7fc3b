// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/merged_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/model/loose_ends.hpp"

namespace corpuscle::io {
namespace {

/// Scales of the loads on bodies that name a part, by axis and curve.
std::map<std::pair<int, Index>, double> gravity_of(const Model& model, Index part) {
    std::map<std::pair<int, Index>, double> scales;
    for (const BodyLoad& load : model.body_loads)
        if (std::find(load.parts.begin(), load.parts.end(), part) != load.parts.end())
            scales[{load.axis, load.curve}] += load.scale;
    return scales;
}

/// Has shells, skins of solids among them, or a mass of its own.
bool has_mass(const Model& model, Index part) {
    const auto is_its = [&](const auto& of) { return of.part == part; };
    return std::any_of(model.shells.begin(), model.shells.end(), is_its) ||
           std::any_of(model.rigid_inertia.begin(), model.rigid_inertia.end(), is_its);
}

}  // namespace

void check_merged_loads(const Draft& draft, Faults& faults) {
    constexpr double ROUNDING = 1e-9;
    const Model& model = draft.model;
    for (const RigidMerge& merge : model.rigid_merges) {
        if (!has_mass(model, merge.part)) continue;
        auto led = gravity_of(model, merge.part);
        double most = 0.0, apart = 0.0;
        for (const auto& [how, scale] : gravity_of(model, keywords::lead_of(draft, merge.part))) {
            led[how] -= scale;
            most += std::abs(scale);
        }
        for (const auto& [how, scale] : led) apart += std::abs(scale);
        if (!(apart > ROUNDING * most)) continue;
        faults.fault(place_of(draft, merge.part),
                     fmt::format("*PART {} is merged with others, expected the same *LOAD_ on all "
                                 "of them or on none",
                                 model.parts[static_cast<std::size_t>(merge.part)].id));
    }
}

}  // namespace corpuscle::io
