// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/response/column_colouring.hpp"
#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// Area of cloth that each contact stands for, so that a pressure-thickness law gives the same
/// pressure on any mesh.
///
/// Contacts of one side of a node share out the node's area A_i, a third of its triangles':
///
///     sum over contacts c on that side of |w_ci| A_c <= A_i,
///
/// with equality on at least one side of each contact: a fine sheet on a coarse one is loaded as
/// its own area says. A_c is found by iterative proportional fitting [Deming & Stephan 1940],
///
///     A_c <- A_c · min over c's two places of (sum of |w_ci| A_i / S_i),  S_i = sum of |w_ci| A_c,
///
/// from the areas of the step before; each A_c counts with its exposure (exposure.hpp). A contact
/// that is pressed below half of its rest gap keeps its area, or grows to a quarter of its nodes'.
class AreaShares {
public:
    explicit AreaShares(const Cloth& cloth);

    /// Sets the areas of all contacts.
    void find(const Points& x, const ColumnColouring& columns, ContactList& contacts);

private:
    void set_sides(const Points& x, ContactList& contacts);
    void set_side(Contact& contact) const;
    bool is_first_look(Index node) { return std::exchange(looked_at_[node], look_) != look_; }
    [[nodiscard]] double first_area(const Contact& contact) const;
    void add_up(const ColumnColouring& columns, const ContactList& contacts);

    const Cloth& cloth_;
    std::vector<double> area_;                ///< by node                               [m^2]
    Points normal_;                           ///< by node: twice the area around it     [m^2]
    Points vector_area_;                      ///< by triangle that has such a node: twice [m^2]
    std::vector<std::uint8_t> in_contact_;    ///< by node
    std::vector<std::array<double, 2>> sum_;  ///< by node and side: S                   [m^2]
    std::vector<unsigned> looked_at_;         ///< by node: in which look last
    unsigned look_ = 0;
};

}  // namespace corpuscle::contact
