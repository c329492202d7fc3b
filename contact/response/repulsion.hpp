// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/response/columns.hpp"
#include "contact/surface/movers.hpp"

namespace corpuscle::contact {

/// What the membranes take of the nodes' stability: K <= diag(m · rate · stiffening). Without rates
/// they are held to take all that a step of 0.9 of their limit leaves them, 3.24 / dt².
struct OwnRates {
    std::span<const double> rate = {};  ///< by node row; of free nodes                    [1/s^2]
    double stiffening = 1.0;            ///< [-]
};

/// Elastic repulsion of contacts, linear in the missing gap:
///
///     F = k max(0, rest - gap),   k = 1 / dt² · min over its nodes of s m d / N,
///     N = sum of 2 d |weight| over the contacts that push the node,
///     d = 1 - gap / rest; 1 of a contact with a rigid body,
///     s = min(2, 3.74 - dt² · rate · stiffening), at least 0.5
///
/// The row sums of M⁻¹K are then at most s / dt² [Gershgorin 1931], however many contacts share a
/// node, and with the membrane's own stay below the 4 / dt² of central differences. What is nearly
/// pressed through gets the most of it: of many that share a node alike, none would hold. Of a pair
/// alone s is (omega dt)²: with 2 it parts two steps after it has met, as fast as it came. A rigid
/// body counts as one node, with the mass that it has at the contact and N twice the number of
/// its contacts; s of a contact with it is 0.5.
class Repulsion {
public:
    explicit Repulsion(const Cloth& cloth);

    /// Sets stiffness and force of all contacts.
    void find(double dt, const Points& x, std::span<const RigidMover> bodies, const OwnRates& own,
              const Columns& columns, ContactList& contacts);

    /// Adds the forces to f; their sum is zero.
    void add(const Columns& columns, const ContactList& contacts, Points& f) const;

private:
    void count_sharers(const Columns& columns, const ContactList& contacts);
    void share_limits(double dt, const OwnRates& own);
    void set_stiffness(const Points& x, std::span<const RigidMover> bodies, Contact& c) const;

    const Cloth& cloth_;
    std::vector<double> shared_by_;       ///< N of each node row
    std::vector<double> share_;           ///< s of each node row, over dt²                [1/s^2]
    double body_share_ = 0.0;             ///< s of rigid bodies: the least, over dt²      [1/s^2]
    std::vector<double> body_shared_by_;  ///< N of each rigid body
};

/// Sum of k (rest - gap)² / 2, of one card's contacts.                                          [J]
[[nodiscard]] double stored_energy(const ContactList& contacts, int card);

}  // namespace corpuscle::contact
