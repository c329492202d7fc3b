// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "contact/candidates/candidates.hpp"
#include "contact/response/column_colouring.hpp"
#include "contact/response/impulse_books.hpp"
#include "contact/surface/rigid_proxies.hpp"

namespace corpuscle::contact {

/// Contact as a law of the cloth, taken between the step's two ends [theta method].
///
/// Law: pressure on the area A of a contact (overlap_area.hpp), and its energy,
///
///     p = E_t (rest / gap - 1),   U = E_t A (rest ln(rest / gap) - (rest - gap)),
///
/// with the modulus E_t through the thickness: cloth stiffens as it is pressed, and no load
/// closes the gap. A dashpot C = 2 zeta sqrt(K m), VDC = 100 zeta, K = E_t A rest / gap²,
/// acts beside it on the mass m that the contact moves. For the impulse J >= 0 of the step,
///
///     J = span · (A ((1 - theta) p(gap) + theta p(gap + dt r)) - C r),
///     theta = max(0.2, 1/2 - 1/(8 k span dt / m)),   k = E_t A_own rest / gap²,
///
/// r the rate after all impulses, A_own the cloth round the lesser of its two places: a quadratic
/// for the gap at the end. No impulse takes a gap beyond rest; no gap shrinks in a step
/// below the middle between it, or rest, and a quarter of rest; nearer, pairs that do not push part
/// at rest over the cloth's growth time. Rows are solved one after the other
/// [projected Gauss-Seidel], in sweeps, from the impulses of the step before, until a sweep changes
/// little; friction is the same row along the surface, |J_t| <= mu J. The scheme asks nothing of
/// the time step.
///
/// Restitution: a pair that closes in a step by more than a quarter of its rest gap, and faster than
/// a quarter of sqrt(E_t A_own rest / m), owes what it takes from the motion beyond what law and
/// dashpot account for,
///
///     taken = -J (r_0 + r)/2 - (U(gap + dt r) - U(gap)),
///
/// r_0 the rate before the kick, J without the dashpot's part, times the share that a dashpot leaves.
/// Once the pair closes no faster than at half the speed that this could give it, it gives at least
/// the impulse that pays, J (r_0 + r)/2 = owed. Pairs whose rest gap grows owe nothing; one that owes
/// owes more by each step in which it closes so far, however slowly.
///
/// As the impulse acts at the beginning of the step, an oscillation of frequency w loses the share
/// theta (w dt)² of its energy in a step; it is stable for (w dt)² (1 - 2 theta) < 4, w² = K/m of
/// all contacts that act alike, taken for 8 k/m. Areas that change and pairs that appear between
/// cloth that is pressed already change energy (docs/theory/contact.md, Limits).
class ImplicitResponse {
public:
    explicit ImplicitResponse(const Cloth& cloth);

    /// Changes velocities, and writes into contacts and memories what each has given.
    /// @param span  time for which the impulses stand                                         [s]
    /// @param dt    the step ahead                                                            [s]
    /// @param columns  in which the contacts are sorted, then those too that this takes up
    /// @param books    by card
    /// @param hold     what else holds nodes, after each sweep and after the last
    void apply(double span, double dt, ContactList& contacts, ColumnColouring& columns,
               Candidates& pairs, VelocityState& motion, std::vector<ImpulseBooks>& books,
               const std::function<void(bool is_last)>& hold = {});

    /// Convergence of the sweeps: change by a step's last sweep, over all its impulses.
    struct Convergence {
        std::size_t steps = 0;   ///< with contacts, so far
        std::size_t sweeps = 0;  ///< so far
        double sum = 0.0;        ///< of the steps' residuals                              [-]
        double worst = 0.0;      ///< of them                                              [-]
    };
    [[nodiscard]] const Convergence& convergence() const { return convergence_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(step_, convergence_);
    }

private:
    /// Least gap at the end of a step that begins with `gap`.                                [m]
    /// @param opening  by which the step opens a pair that its law does not, up to there     [m]
    [[nodiscard]] static double least_gap(double gap, double rest, double opening) {
        const double bound = 0.25 * rest;
        return gap > bound ? 0.5 * (std::min(gap, rest) + bound) : std::min(gap + opening, bound);
    }
    /// Of a pair without exposure.                                                           [m]
    [[nodiscard]] double opening(double dt, double rest) const {
        return dt * rest / cloth_.growth_time;
    }
    struct Row {
        std::array<Index, 4> node;
        std::array<double, 4> weight;
        Vec3 normal;
        double gap, rest;  ///< now; at the end of the step                               [m]
        double floor;      ///< least gap at the end of the step                          [m]
        double stiff;      ///< E_t A                                                     [N]
        double push;       ///< theta · span · E_t A                                    [N s]
        double given;      ///< (1 - theta) span · A p(gap): what the gap of now gives  [N s]
        double dt;         ///< [s]
        double heft;       ///< (mass + span C) / dt                                   [kg/s]
        double mass;       ///< 1 / (n M⁻¹ n)                                            [kg]
        double rub_mass;   ///< likewise along the surface, or less                    [kg]
        double zeta;       ///< share of critical damping                               [-]
        double rate;       ///< r_0                                                    [m/s]
        double owed;       ///< energy to be given back; 0: not now                     [J]
        double impulse;    ///< J                                                          [N s]
        Vec3 rubbed;       ///< J_t on the first place                                     [N s]
        Vec3 before;       ///< velocity of the first place against the second, kicked     [m/s]
        Contact* contact;
        const ContactCard* card;

        /// U at the gap `at`.                                                                [J]
        [[nodiscard]] double stored(double at) const {
            if (at >= rest) return 0.0;
            return stiff * (rest * std::log(rest / at) - (rest - at));
        }
        /// Change of the impulse that brings the row to its law, or beyond it to what it owes, the
        /// rate being `after`.                                                              [N s]
        [[nodiscard]] double change(double after) const {
            const double by_law = change_by_law(after);
            if (owed == 0.0) return by_law;
            const double mean = 0.5 * (rate + after - impulse / mass);
            return std::max(by_law,
                            mass * (std::sqrt(mean * mean + 2.0 * owed / mass) - mean) - impulse);
        }
        /// That to its law alone.                                                          [N s]
        [[nodiscard]] double change_by_law(double after) const {
            if (impulse == 0.0 && gap + dt * after >= rest) return 0.0;
            if (push == 0.0) return std::max(mass * (floor - gap) / dt - mass * after, -impulse);
            const double half = 0.5 * (heft * gap + mass * after - push - (impulse - given));
            const double root = std::sqrt(half * half + heft * push * rest);
            const double end = half > 0.0 ? (half + root) / heft : push * rest / (root - half);
            const double at = std::min(end, rest);
            if (at < floor) return std::max(mass * (floor - gap) / dt - mass * after, -impulse);
            const double wanted = mass * (at - gap) / dt - mass * after;
            return std::max(wanted, -impulse);
        }
    };
    struct alignas(64) Share {
        std::vector<ImpulseBooks> books;
        std::vector<BodyImpulse> on_bodies;  ///< that do not move
        double changed = 0.0, all = 0.0;
        std::size_t active = 0;
    };
    void take_up(double dt, ContactList& contacts, const ColumnColouring& columns,
                 Candidates& pairs, const VelocityState& motion);
    [[nodiscard]] bool owes_still(const NearPair& near, Candidates& pairs) const;
    void set_rows(double span, double dt, ContactList& contacts, const ColumnColouring& columns,
                  Candidates& pairs, VelocityState& motion);
    void recall(double span, double dt, ContactList& contacts, Candidates& pairs,
                const VelocityState& motion);
    void measure(double dt, const VelocityState& motion, Contact& contact) const;
    [[nodiscard]] Row row_of(double span, double dt, Contact& contact,
                             const VelocityState& motion) const;
    static void warm(const Contact& before, Row& row);
    /// What a row owes to the motion after the step, the rate having become `after`.        [J]
    [[nodiscard]] static double owed_after(double after, const Row& row);
    void begin(Row& row, VelocityState& motion);
    /// Sweeps until little changes; returns what the last one did, over all impulses.
    double solve_all(const ColumnColouring& columns, VelocityState& motion,
                     const std::function<void(bool is_last)>& hold);
    /// @param is_whole  over all rows; else over those that the last such sweep found to push
    /// @returns what it changed, over all impulses
    double sweep(bool is_whole, const ColumnColouring& columns, VelocityState& motion);
    double solve(Row& row, VelocityState& motion);
    /// Gives an impulse to the free nodes of a row.
    void give(const Vec3& impulse, const Row& row, VelocityState& motion) const {
        Points& v = motion.node_velocities();
        for (int i = 0; i < 4; ++i)
            v[row.node[i]] += row.weight[i] * cloth_.mobility[row.node[i]].cwiseProduct(impulse);
    }
    double solve_on_body(Row& row, VelocityState& motion);
    void add_to_bodies(const Vec3& impulse, const Row& row, const VelocityState& motion,
                       std::vector<BodyImpulse>& taken) const;
    void close(double span, const ColumnColouring& columns, Candidates& pairs,
               VelocityState& motion, std::vector<ImpulseBooks>& books);

    const Cloth& cloth_;
    std::array<Share, ColumnColouring::COUNT + 1> share_;
    std::vector<Row> rows_;              ///< in the columns' order
    std::vector<std::uint32_t> active_;  ///< rows that push, from each column's first on
    std::vector<Contact*> fresh_;        ///< without a memory
    parallel::Gathered<Contact*> found_fresh_;
    Convergence convergence_;
    std::uint32_t step_ = 0;
};

/// U of all contacts, as they were found.                                                       [J]
[[nodiscard]] double stored_energy(const ContactList& contacts);

}  // namespace corpuscle::contact
