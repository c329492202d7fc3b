// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "contact/candidates.hpp"
#include "contact/cards.hpp"
#include "contact/contact_list.hpp"

namespace corpuscle::contact {

/// Energy that impulses have taken from the motion, since the start.
struct ImpulseBooks {
    double friction = 0.0;   ///< rubbed away                                                  [J]
    double normal = 0.0;     ///< damped, stopped short of crossing                            [J]
    double held_work = 0.0;  ///< given by held nodes, which impulses do not move              [J]
};

/// All of contact that loses energy: impulses on the velocities between the kick and the drift.
///
/// Each goes to the two places of one contact in opposite directions (momentum is kept) and can
/// only take energy; one contact after the other [Gauss-Seidel], so any number may share a node.
/// Being implicit, they ask nothing of the time step.
///
/// 1. Damping with the fraction VDC of critical, and repayment: each pair has an account of what
/// repulsion and
///    damping have taken; what it has given beyond that (a contact that begins or ends within a
///    step does, or one that stiffens) is taken back while it parts.
/// 2. Friction, Coulomb with FS, FD, DC: full stop of sliding if mu times the normal impulse allows
/// it.
/// 3. Limit of approach: in the step ahead no gap may shrink by more than half of what it has above
/// a quarter of
///    its rest value.
class Impulses {
public:
    Impulses(const Cloth& cloth, const ContactCard& card);

    /// @param span  time for which the last kick's forces acted                               [s]
    /// @param dt    the step ahead                                                            [s]
    void apply(double span, double dt, ContactList& contacts, Candidates& pairs, Points& v);

    /// Changes a contact's rate, and rubs.
    /// @param rate  wanted, not below the present one                                         [m/s]
    void raise_rate(double rate, Contact& contact, Points& v);

    /// Gives nodes one velocity, that of their momentum, or the held ones' if there are any: a
    /// rigid clump.
    void clump(std::span<const Index> nodes, std::span<const double> mass, Points& v);

    [[nodiscard]] const ImpulseBooks& books() const { return books_; }

private:
    void settle(double span, Contact& contact, double& account, Points& v);
    double repay_debt(double rate, const Contact& contact, double& account);
    bool limit_approach(double dt, Contact& contact, Points& v);
    void rub(double normal_impulse, const Contact& contact, Points& v);
    double push(double impulse, const Vec3& direction, const Contact& contact, Points& v);

    const Cloth& cloth_;
    const ContactCard card_;
    ImpulseBooks books_;
    double pool_ = 0.0;  ///< what pairs that have parted took, less what they gave back         [J]
};

}  // namespace corpuscle::contact
