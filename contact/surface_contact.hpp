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

/// What contact has found and done.
struct ContactCounts {
    std::size_t builds = 0;        ///< of the pair lists, so far
    std::size_t renewals = 0;      ///< of the lists of a few nodes alone, so far
    std::size_t searched = 0;      ///< facets that these lists are for: others lie open
    std::size_t candidates = 0;    ///< pairs in the lists now
    std::size_t near = 0;          ///< pairs within reach in this step
    std::size_t touching = 0;      ///< pairs nearer than rest now: those with exposure push
    std::size_t close_starts = 0;  ///< pairs nearer than the contact thickness at the start
    double least_gap = INF;        ///< smallest gap over its rest value so far                 [-]
    std::size_t impacts = 0;       ///< pairs stopped at the last moment, so far
    std::size_t impact_zones = 0;  ///< tangles joined for a step, so far
    double residual = 0.0;         ///< that sweeps left of a step's impulses, mean so far       [-]
    double worst_residual = 0.0;   ///< the greatest so far                                    [-]
    double sweeps = 0.0;           ///< a step with contacts, mean so far
    std::size_t unstopped = 0;     ///< pairs that held nodes drove through each other, so far
};

/// Surfaces that touch: fabric itself and other fabric, and rigid bodies. Nodes against triangles
/// and edges against edges, both sides, for all cards at once, so that none undoes what another has
/// seen to.
///
/// A step calls find() at t, then respond() between the kick and the drift. Before a card's birth
/// and after its death nothing is found by it.
///
///     contact.find(x, v, t, dt);  kick;  contact.respond(x, dt, v);  drift;
class SurfaceContact {
public:
    /// Stops nodes that others hold, between the sweeps of respond(); see there.
    using Hold = std::function<void(bool is_last)>;

    /// @throws InputError for a contact thickness that is not positive or a free node without mass
    explicit SurfaceContact(const ContactSetup& setup);
    ~SurfaceContact();
    /// What was moved from may only be assigned to or destroyed.
    SurfaceContact(SurfaceContact&&) noexcept;
    /// Likewise.
    SurfaceContact& operator=(SurfaceContact&&) noexcept;

    /// Finds what is near at x, v being half a step old.
    /// @param dt      the step ahead                                                         [s]
    /// @param bodies  at t, by the numbers that the set-up has for their nodes
    void find(const Points& x, const Points& v, double t, double dt,
              std::span<const RigidProxy> bodies = {});

    /// Presses apart, damps, rubs, and stops what would pass through in the step ahead; changes
    /// velocities only, and what the bodies have taken. Its impulses stand for half the last step
    /// and half this one.
    /// @param v_before  gets v as it was, unless null or nothing is near
    /// @param hold      stops nodes that others hold: hold(false) after each sweep, on those it has
    ///                  held lately, hold(true) after the last one, on all; may be empty
    /// @param unkicked  velocities half a step before t; null: as v
    /// @returns whether it may have changed any
    bool respond(const Points& x, double dt, Points& v, std::span<RigidProxy> bodies = {},
                 Points* v_before = nullptr, const Hold& hold = {},
                 const Points* unkicked = nullptr);

    /// Triangles that crossed at the start and still do, rows i < j; their pairs do not push.
    [[nodiscard]] const std::vector<std::pair<Index, Index>>& crossing() const;
    /// Pairs of triangles that are nearer at the start than their contact thickness, rows.
    [[nodiscard]] const std::vector<std::pair<Index, Index>>& close_starts() const;

    [[nodiscard]] double stored_energy() const;    ///< in what is pressed, as it was found      [J]
    [[nodiscard]] double friction_energy() const;  ///< rubbed away so far                       [J]
    [[nodiscard]] double damping_energy() const;  ///< pressed in and not given back so far      [J]
    [[nodiscard]] double energy() const {         ///< all three                                 [J]
        return stored_energy() + friction_energy() + damping_energy();
    }
    /// What friction takes from places that move at v_mid, the mean of before the kick and after
    /// all impulses: - sum of friction impulse · relative velocity. Of a place that friction holds
    /// at rest it is nothing, while friction_energy() has what the kick gave it and lost again. [J]
    [[nodiscard]] double friction_work(const Points& v_mid) const;
    /// Work that what is held has done through these impulses so far.                  [J]
    [[nodiscard]] double held_work() const;

    /// By one card (row): in the last step to SURFA, or of a single surface to the free nodes,
    /// which is what held nodes and bodies gave. [N]
    [[nodiscard]] Vec3 force(int card = 0) const;
    [[nodiscard]] double energy_of(int card) const;  ///< stored, rubbed, damped              [J]

    /// Pairs of one card nearer than their contact thickness now, and the greatest part of their
    /// contact thickness that is missing between two places.
    struct Depth {
        std::size_t pairs = 0;  ///< contacts with gap < rest
        double greatest = 0.0;  ///< 1 - gap / rest                                            [-]
    };
    /// Of a card (row), as the last find() saw it.
    [[nodiscard]] Depth depth(int card) const;

    /// Normal force on every triangle of the set-up, mean since this was last asked for, both
    /// sides together (facet_load.hpp); and begins anew.                                      [N]
    [[nodiscard]] std::vector<double> take_facet_forces(const Points& x);

    /// Of the last step, and sums from the start.
    [[nodiscard]] const ContactCounts& counts() const;
    /// Sets a 1 for every node that carries more than half of its side of a contact that pushes.
    void mark_touching(std::span<std::uint8_t> nodes) const;  // N

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    void visit_state(StateWriter& archive);
    /// Reads the state of a contact that was built from the same set-up.
    /// @throws SystemError where the bytes end too early or do not fit the set-up
    void visit_state(StateReader& archive);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace corpuscle::contact
