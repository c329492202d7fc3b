// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/model.hpp"

namespace corpuscle {

/// Whether a part is of *MAT_RIGID.
[[nodiscard]] bool is_rigid(const Model& model, Index part);

/// A part and all that are merged with it, it being their lead; rows.
[[nodiscard]] std::vector<Index> merged_parts(const Model& model, Index lead);

/// Of their shells, and extra ones; ascending.
[[nodiscard]] std::vector<Index> nodes_of_rigid_parts(const Model& model,
                                                      const std::vector<Index>& parts);

/// Of parts that move as one body, those whose mass is that of their nodes: for the others
/// *PART_INERTIA, solids or beams speak.
[[nodiscard]] std::vector<Index> parts_of_nodes(const Model& model,
                                                const std::vector<Index>& parts);

/// Mass, centre and inertia of parts that move as one body: what *PART_INERTIA or solids say, and
/// of the others the nodes' masses, each of which counts once;
///
///     m = sum m_i,   c = sum m_i c_i / m,   I = sum I_i + m_i (|d|² 1 - d dᵀ),   d = c_i - c.
///
/// A part that a merge leaves out (RigidMerge::keeps_inertia) is in its lead's *PART_INERTIA.
[[nodiscard]] RigidInertia inertia_of_parts(const Model& model, const std::vector<Index>& parts,
                                            const std::vector<double>& node_mass);

/// By part: its share of the mass of parts that move as one body; together 1. What one
/// *PART_INERTIA speaks for, and what the nodes' masses do, is shared as the nodes' masses are, a
/// node that several have counting for the first; without any mass all is the first part's.                                           [-]
[[nodiscard]] std::vector<double> mass_shares(const Model& model, const std::vector<Index>& parts,
                                              const std::vector<double>& node_mass);

}  // namespace corpuscle
