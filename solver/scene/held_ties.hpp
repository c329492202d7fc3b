// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "solver/model.hpp"

namespace corpuscle {

/// What supports and motions say of tied nodes. These go where their edges' ends go (TiedNodes), so
/// what holds one counts where it holds both ends too, and nowhere else.
class HeldTies {
public:
    /// @param model  whose supports and motions it asks; not copied
    explicit HeldTies(const Model& model);

    /// Whether a support or a motion of the tied node is not one of both ends.
    [[nodiscard]] bool is_lost(const TiedNode& tie) const;

private:
    [[nodiscard]] bool is_moved_alike(Index node, const PrescribedMotion& motion) const;

    const Model& model_;
    std::vector<DofMask> held_;                          ///< N: bits 0-2
    std::map<Index, std::vector<std::size_t>> motions_;  ///< by node: rows
};

/// Takes the supports and motions of a node away.
void release(Model& model, Index node);

}  // namespace corpuscle
