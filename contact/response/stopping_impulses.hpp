// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "contact/response/impulse_books.hpp"
#include "contact/surface/rigid_proxies.hpp"

namespace corpuscle::contact {

/// What the CCD limiter does to velocities: impulses between the two places of a pair, and impact
/// zones. Both keep momentum, and what they take of the energy is booked exactly.
class StoppingImpulses {
public:
    /// @param books  by card; what is taken goes there
    StoppingImpulses(const Cloth& cloth, std::vector<ImpulseBooks>& books)
        : cloth_(cloth), books_(books) {}

    /// Changes a contact's rate, and rubs.
    /// @param rate  wanted, not below the present one                                         [m/s]
    void raise_rate(double rate, Contact& contact, VelocityState& motion);

    /// Gives nodes one velocity, that of their momentum, or the held ones' if there are any: a
    /// rigid impact zone. Nodes that touch a rigid body move with it.
    void join_zone(std::span<const Index> nodes, std::span<const double> mass,
                   VelocityState& motion);

private:
    void rub(Contact& contact, VelocityState& motion);
    double push(double impulse, const Vec3& direction, double mass, const Contact& contact,
                VelocityState& motion);
    void join_to_body(Index body, std::span<const Index> nodes, VelocityState& motion);
    [[nodiscard]] ImpulseBooks& book(const Contact& c) { return books_[c.card]; }

    const Cloth& cloth_;
    std::vector<ImpulseBooks>& books_;
};

}  // namespace corpuscle::contact
