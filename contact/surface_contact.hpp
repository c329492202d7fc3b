// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/surface/cloth.hpp"
#include "contact/surface/rigid_proxies.hpp"
#include "solver/base/archive.hpp"

/// Contact of fabric with itself, with rigid bodies and with rigid walls.
namespace corpuscle::contact {

/// Counts and residuals of contact.
struct ContactCounts {
    std::size_t builds = 0;        ///< of the pair lists, so far
    std::size_t renewals = 0;      ///< partial rebuilds, for a few nodes, so far
    std::size_t searched = 0;      ///< facets in the search; flat regions are left out
    std::size_t candidates = 0;    ///< pairs in the lists now
    std::size_t near = 0;          ///< pairs within reach in this step
    std::size_t touching = 0;      ///< pairs nearer than rest now: those with exposure push
    std::size_t close_starts = 0;  ///< pairs nearer than the contact thickness at the start
    double least_gap = INF;        ///< smallest gap over its rest value so far                 [-]
    std::size_t impacts = 0;       ///< pairs stopped by the CCD limiter, so far
    std::size_t impact_zones = 0;  ///< zones joined for a step, so far
    double residual = 0.0;         ///< last sweep's share of a step's impulses, mean so far     [-]
    double worst_residual = 0.0;   ///< the greatest so far                                    [-]
    double sweeps = 0.0;           ///< a step with contacts, mean so far
    std::size_t unstopped = 0;     ///< pairs driven through each other by held nodes, so far
};

/// Contact of fabric with itself and other fabric, and with rigid bodies: nodes against triangles
/// and edges against edges, on both sides. All cards are solved together, so that none undoes
/// another's impulses.
///
/// A step calls find() at t, then respond() between the kick and the drift. A card acts from its
/// birth to its death.
///
///     contact.find(x, v, t, dt);  kick;  contact.respond(x, dt, v);  drift;
class SurfaceContact {
public:
    /// Enforces supports and joints between the sweeps of respond(); see there.
    using Hold = std::function<void(bool is_last)>;

    /// @throws InputError for a contact thickness that is not positive or a free node without mass
    explicit SurfaceContact(const ContactSetup& setup);
    ~SurfaceContact();
    /// A moved-from object may only be assigned to or destroyed.
    SurfaceContact(SurfaceContact&&) noexcept;
    /// Likewise.
    SurfaceContact& operator=(SurfaceContact&&) noexcept;

    /// Finds the contacts at x; v is half a step older.
    /// @param dt      the step ahead                                                         [s]
    /// @param bodies  at t, in the order of the set-up's body numbers
    void find(const Points& x, const Points& v, double t, double dt,
              std::span<const RigidProxy> bodies = {});

    /// Applies contact law, damping and friction, and prevents crossing in the step ahead; changes
    /// velocities and the bodies' impulses only. Its impulses are for half the last step and half
    /// this one.
    /// @param v_before  gets the velocities before, unless null or without contacts
    /// @param hold      enforces supports: hold(false) after each sweep, on recently held nodes,
    ///                  hold(true) after the last one, on all; may be empty
    /// @param unkicked  velocities half a step before t; null: as v
    /// @returns whether velocities may have changed
    bool respond(const Points& x, double dt, Points& v, std::span<RigidProxy> bodies = {},
                 Points* v_before = nullptr, const Hold& hold = {},
                 const Points* unkicked = nullptr);

    /// Triangles that crossed at the start and still do, rows i < j; their pairs do not push.
    [[nodiscard]] const std::vector<std::pair<Index, Index>>& crossing() const;
    /// Pairs of triangles that are nearer at the start than their contact thickness, rows.
    [[nodiscard]] const std::vector<std::pair<Index, Index>>& close_starts() const;

    [[nodiscard]] double stored_energy() const;    ///< of the contact law, at find()            [J]
    [[nodiscard]] double friction_energy() const;  ///< dissipated by friction so far            [J]
    [[nodiscard]] double damping_energy() const;  ///< taken and not given back so far           [J]
    [[nodiscard]] double energy() const {         ///< sum of the three                          [J]
        return stored_energy() + friction_energy() + damping_energy();
    }
    /// Friction work at v_mid, the mean of velocities before the kick and after all impulses:
    /// - sum of friction impulse · relative velocity. It is zero for a place that sticks, while
    /// friction_energy() has the energy that the kick gave and friction took.                [J]
    [[nodiscard]] double friction_work(const Points& v_mid) const;
    /// Work of held nodes through these impulses so far.                                [J]
    [[nodiscard]] double held_work() const;

    /// Force of one card (row) in the last step: on SURFA, or of a single surface on free nodes,
    /// from held nodes and bodies. [N]
    [[nodiscard]] Vec3 force(int card = 0) const;
    [[nodiscard]] double energy_of(int card) const;  ///< stored and dissipated               [J]

    /// Pairs of one card nearer than their contact thickness now, and their greatest relative
    /// penetration of it.
    struct Depth {
        std::size_t pairs = 0;  ///< contacts with gap < rest
        double greatest = 0.0;  ///< 1 - gap / rest                                            [-]
    };
    /// Of a card (row), as the last find() saw it.
    [[nodiscard]] Depth depth(int card) const;

    /// Normal force on every triangle of the set-up, both sides together, mean since the last call
    /// (facet_load.hpp).                                                                      [N]
    [[nodiscard]] std::vector<double> take_facet_forces(const Points& x);

    /// Counts of the last step, and sums from the start.
    [[nodiscard]] const ContactCounts& counts() const;
    /// Sets a 1 for every node with more than half of its side's weight in a pushing contact.
    void mark_touching(std::span<std::uint8_t> nodes) const;  // N

    /// State for a checkpoint (solver/base/archive.hpp).
    void visit_state(StateWriter& archive);
    /// Reads the state of a contact that was built from the same set-up.
    /// @throws SystemError where the bytes end too early or do not fit the set-up
    void visit_state(StateReader& archive);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace corpuscle::contact
