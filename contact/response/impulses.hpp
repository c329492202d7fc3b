// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "contact/candidates/candidates.hpp"
#include "contact/response/columns.hpp"
#include "contact/surface/movers.hpp"

namespace corpuscle::contact {

/// Energy that the impulses of one card have taken from the motion since the start.
struct ImpulseBooks {
    double friction = 0.0;   ///< rubbed away                                                  [J]
    double normal = 0.0;     ///< damped, stopped short of crossing                            [J]
    double held_work = 0.0;  ///< given by what is held, which impulses do not move            [J]
    Vec3 given = Vec3::Zero();  ///< in the last step, repulsion too: to SURFA, or of a single
                                ///< surface to the free nodes [N s]

    ImpulseBooks& operator+=(const ImpulseBooks& other) {
        friction += other.friction;
        normal += other.normal;
        held_work += other.held_work;
        given += other.given;
        return *this;
    }
};

/// All of contact that loses energy: impulses on the velocities between the kick and the drift.
///
/// Each goes to the two places of one contact in opposite directions (momentum is kept) and can
/// only take energy; one contact after the other [Gauss-Seidel], so any number may share a node;
/// those that share none are worked on at once (contact/response/columns.hpp).
/// Being implicit, they ask nothing of the time step.
///
/// 1. Damping with the fraction VDC of critical, and repayment: each pair has an account of what
/// repulsion and
///    damping have taken; what it has given beyond that (a contact that begins or ends within a
///    step does, or one that stiffens) is taken back while it parts.
/// 2. Friction, Coulomb with FS, FD, DC: full stop of sliding if mu times the normal impulse allows
///    it. A rigid body that rests on many places is looked at again and again, until it sticks.
/// 3. Limit of approach: in the step ahead no gap may shrink by more than half of what it has above
/// a quarter of
///    its rest value.
class Impulses {
public:
    explicit Impulses(const Cloth& cloth);

    /// @param span  time for which the last kick's forces acted                               [s]
    /// @param dt    the step ahead                                                            [s]
    /// @param columns  in which the contacts are sorted, then those too that this takes up
    void apply(double span, double dt, ContactList& contacts, Columns& columns, Candidates& pairs,
               Movement& motion);

    /// Changes a contact's rate, and rubs.
    /// @param rate  wanted, not below the present one                                         [m/s]
    void raise_rate(double rate, Contact& contact, Movement& motion);

    /// Gives nodes one velocity, that of their momentum, or the held ones' if there are any: a
    /// rigid clump. Nodes that touch a rigid body move with it.
    void clump(std::span<const Index> nodes, std::span<const double> mass, Movement& motion);

    /// By card.
    [[nodiscard]] const std::vector<ImpulseBooks>& books() const { return books_; }
    [[nodiscard]] std::vector<ImpulseBooks>& books() { return books_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(books_, pool_);
    }

private:
    void settle(double span, Contact& contact, double& account, Movement& motion);
    double repay_debt(double rate, const Contact& contact, double& account);
    void book_kick(double span, ContactList& contacts, Candidates& pairs, const Movement& motion);
    void draw(double& account);
    void share_debt(ContactList& contacts, const Columns& columns);
    void limit_approach(double dt, ContactList& contacts, const Columns& columns, Movement& motion);
    void take_up(double dt, ContactList& contacts, const Columns& columns, const Candidates& pairs,
                 const Movement& motion);
    void close_columns();
    [[nodiscard]] bool has_changed(const std::array<Index, 4>& nodes) const;
    [[nodiscard]] static double approach_limit(double dt, double gap, double rest);
    void rub(Contact& contact, Movement& motion);
    double push(double impulse, const Vec3& direction, double mass, const Contact& contact,
                Movement& motion);
    void note_given(const Contact& contact, const Vec3& impulse);
    void clump_round(Index body, std::span<const Index> nodes, Movement& motion);
    [[nodiscard]] const ContactCard& card(const Contact& c) const {
        return cloth_.rules.card(c.card);
    }

    /// What the contacts of a column change beside their nodes; the last is of those that stand
    /// alone, which write into the books themselves.
    struct alignas(64) Column {
        std::vector<ImpulseBooks> books;  ///< of this step, by card; no two in one cache line
        double debt = 0.0;                ///< of the pool, its part, <= 0                 [J]
        std::vector<Contact*> too_fast;   ///< in this sweep
    };
    [[nodiscard]] ImpulseBooks& book(const Contact& c) {
        return c.column == Contact::ALONE ? books_[c.card] : columns_[c.column].books[c.card];
    }

    const Cloth& cloth_;
    std::vector<ImpulseBooks> books_;
    std::array<Column, Columns::COUNT + 1> columns_;
    std::vector<Contact*> on_body_;  ///< that push, in this step
    /// By chunk: without an account, or in debt; and what is too fast in this sweep.
    std::vector<std::vector<Contact*>> unsettled_, too_fast_;
    std::vector<unsigned> changed_;  ///< by node: sweep of its last change
    unsigned sweep_ = 0;             ///< counted over all steps
    double pool_ = 0.0;  ///< what pairs that have parted took, less what they gave back         [J]
};

}  // namespace corpuscle::contact
