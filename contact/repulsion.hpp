// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/cloth.hpp"
#include "contact/contact_list.hpp"
#include "contact/movers.hpp"

namespace corpuscle::contact {

/// Share of the stability limit that contact takes: its stiffness keeps (omega dt)² <= STIFFNESS,
/// and with a step of 0.9 of the membrane's limit (3.24) the sum stays below the 4 of central
/// differences.
inline constexpr double STIFFNESS = 0.5;

/// Elastic repulsion of contacts, linear in the missing gap:
///
///     F = k max(0, rest - gap),   k = STIFFNESS / dt² · min over its nodes of m / N,
///     N = sum of 2 |weight| over the contacts that push the node
///
/// The row sums of M⁻¹K are then at most STIFFNESS / dt² [Gershgorin 1931], however many contacts
/// share a node. A rigid body counts as one node, with the mass that it has at the contact and N
/// twice the number of its contacts.
class Repulsion {
public:
    explicit Repulsion(const Cloth& cloth);

    /// Sets stiffness and force of all contacts.
    void find(double dt, const Points& x, std::span<const RigidMover> bodies,
              ContactList& contacts);

    /// Adds the forces to f; their sum is zero.
    void add(const ContactList& contacts, Points& f) const;

private:
    void count_sharers(const ContactList& contacts);
    [[nodiscard]] double softest_node(const Contact& contact) const;

    const Cloth& cloth_;
    std::vector<double> shared_by_;       ///< N of each node row
    std::vector<double> body_shared_by_;  ///< N of each rigid body
};

/// Sum of k (rest - gap)² / 2, of one card's contacts.                                          [J]
[[nodiscard]] double stored_energy(const ContactList& contacts, int card);

}  // namespace corpuscle::contact
