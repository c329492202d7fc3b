// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/cards/collision_model.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace corpuscle::gas {
namespace {

/// THE list of names.
constexpr std::pair<std::string_view, CollisionModel> NAMES[] = {
    {"lin", CollisionModel::LIN},
    {"pairs", CollisionModel::PAIRS},
    {"ntc", CollisionModel::NTC},
    {"spheres", CollisionModel::SPHERES},
};

bool is_same(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char p, unsigned char q) {
        return std::tolower(p) == std::tolower(q);
    });
}

}  // namespace

std::optional<CollisionModel> collision_model(std::string_view name) {
    for (const auto& [known, model] : NAMES)
        if (is_same(name, known)) return model;
    return {};
}

std::string_view name_of(CollisionModel model) {
    for (const auto& [name, known] : NAMES)
        if (known == model) return name;
    return "a model without a name";
}

std::string collision_names() {
    std::string all;
    for (const auto& [name, model] : NAMES) all.append(all.empty() ? "" : ", ").append(name);
    return all;
}

}  // namespace corpuscle::gas
