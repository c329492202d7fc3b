// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/held_ties.hpp"

#include <algorithm>

#include "solver/bodies/rigid_parts.hpp"

namespace corpuscle {
namespace {

constexpr DofMask ALL_MOVES = 7U;

/// Rigid parts that lead a body which nothing moves: held in all six directions.
bool is_at_rest(const Model& model, std::size_t part) {
    const auto* card =
        std::get_if<fabric::RigidCard>(&model.materials[model.parts[part].material].card);
    return card != nullptr && card->fixed_moves == ALL_MOVES && card->fixed_turns == ALL_MOVES &&
           std::none_of(model.motions.begin(), model.motions.end(),
                        [&](const PrescribedMotion& motion) {
                            return motion.rigid_part == static_cast<Index>(part);
                        }) &&
           std::none_of(
               model.rigid_merges.begin(), model.rigid_merges.end(),
               [&](const RigidMerge& merge) { return merge.part == static_cast<Index>(part); });
}

/// Of two motions, whatever they move.
bool are_alike(const PrescribedMotion& a, const PrescribedMotion& b) {
    return a.kind == b.kind && a.axis == b.axis && a.curve == b.curve && a.scale == b.scale &&
           a.birth == b.birth && a.death == b.death;
}

}  // namespace

HeldTies::HeldTies(const Model& model) : model_(model), held_(model.x.size(), 0) {
    for (const Support& support : model.supports) held_[support.node] |= support.fixed & ALL_MOVES;
    for (std::size_t k = 0; k < model.motions.size(); ++k)
        for (const Index node : model.motions[k].nodes) motions_[node].push_back(k);
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        if (!is_at_rest(model, p)) continue;
        const std::vector<Index> parts = merged_parts(model, static_cast<Index>(p));
        for (const Index node : nodes_of_rigid_parts(model, parts)) held_[node] = ALL_MOVES;
    }
}

bool HeldTies::is_moved_alike(Index node, const PrescribedMotion& motion) const {
    const auto of_node = motions_.find(node);
    return of_node != motions_.end() &&
           std::any_of(of_node->second.begin(), of_node->second.end(),
                       [&](std::size_t k) { return are_alike(model_.motions[k], motion); });
}

bool HeldTies::is_lost(const TiedNode& tie) const {
    if ((held_[tie.node] & ~(held_[tie.ends[0]] & held_[tie.ends[1]])) != 0) return true;
    const auto of_node = motions_.find(tie.node);
    return of_node != motions_.end() &&
           std::any_of(of_node->second.begin(), of_node->second.end(), [&](std::size_t k) {
               const PrescribedMotion& motion = model_.motions[k];
               return !is_moved_alike(tie.ends[0], motion) || !is_moved_alike(tie.ends[1], motion);
           });
}

void release(Model& model, Index node) {
    std::erase_if(model.supports, [&](const Support& support) { return support.node == node; });
    for (PrescribedMotion& motion : model.motions) std::erase(motion.nodes, node);
}

}  // namespace corpuscle
