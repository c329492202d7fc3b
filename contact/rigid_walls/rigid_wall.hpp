// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/rigid_walls/wall_card.hpp"
#include "contact/surface/rigid_proxies.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// Rigid bodies that walls may meet.
struct WallBodies {
    std::span<const Index> of_node;  ///< by node row: number of its body, or -1; empty: no bodies
    std::span<RigidProxy> proxies;   ///< by number

    /// Whether the node is one of a body.
    [[nodiscard]] bool has(Index node) const { return !of_node.empty() && of_node[node] >= 0; }
    /// That body; only of a node that has() one.
    [[nodiscard]] RigidProxy& of(Index node) const { return proxies[of_node[node]]; }
};

/// *RIGIDWALL: a convex shape that nodes cannot enter, whatever their speed. The impact is
/// perfectly plastic: a node that would come in during the step ahead arrives at the wall and has
/// the wall's normal velocity from then on.
///
/// The path of a node in a step is straight; where it enters the shape first, at the share s, the
/// tangent plane n keeps it out, for a convex shape lies behind its tangent planes:
///
///     n·(v - w) >= s n·(v_0 - w),   friction impulse <= mu · normal impulse (FRIC = 1: sticks)
///
/// w is the wall's velocity. A wall of mass M gets it from M w + sum m n·v = const.
class RigidWall {
public:
    /// @param curve     of the card's motion; nullptr when it has none
    /// @param end_time  of the run, beyond which a curve that reaches it goes on               [s]
    explicit RigidWall(const WallCard& card, const Curve* curve = nullptr, double end_time = INF);

    /// Stops nodes, between the kick and the drift from t to t + dt, and moves the wall likewise.
    ///
    /// Nodes inside (behind a plane) at its birth, beyond rounding, are let alone until they come
    /// out. A node of a rigid body passes its impulse on to the body; v is then left to the body.
    void hold(const Points& x, std::span<const double> mass, double t, double dt, Points& v,
              const WallBodies& bodies = {});

    /// Stops nodes that something else has sent in since hold(), in the same step.
    /// @param is_whole  all nodes; else those alone that were near in hold()
    void hold_again(bool is_whole, const Points& x, std::span<const double> mass, double t,
                    double dt, Points& v, const WallBodies& bodies = {});

    /// What it lets alone where it is at the start; of a plate, what lies behind its face.
    struct Inside {
        std::size_t nodes = 0;  ///< how many
        Index deepest = -1;     ///< row of the one that is deepest
        double depth = 0.0;     ///< of that                                               [m]
    };
    /// @param x  N × 3                                                                      [m]
    [[nodiscard]] Inside inside(const Points& x) const;

    /// On the wall in the last step: impulse / dt.                                              [N]
    [[nodiscard]] const Vec3& force() const { return force_; }
    /// On the wall in the last step.                                                          [N s]
    [[nodiscard]] const Vec3& impulse() const { return impulse_; }
    /// Nodes that the last hold() stopped.
    [[nodiscard]] std::span<const Index> touching() const { return touching_; }
    /// Lost so far by plastic impact along the normal.                                          [J]
    [[nodiscard]] double stopping_energy() const { return stopping_energy_; }
    /// Lost so far by friction.                                                                 [J]
    [[nodiscard]] double friction_energy() const { return friction_energy_; }
    /// Done so far on nodes by a wall whose motion is given, and on a mass that is born later.  [J]
    [[nodiscard]] double driving_work() const { return driving_work_; }
    /// Done so far by what holds or drives bodies that it pushed.                             [J]
    [[nodiscard]] double held_work() const { return held_work_; }
    [[nodiscard]] double kinetic_energy() const;  ///< of its mass                              [J]

    /// Whether its card gives it a motion.
    [[nodiscard]] bool moves() const { return !card_.motion.direction.isZero(0.0); }
    /// Since the start, at t.                                                                   [m]
    [[nodiscard]] const Vec3& displacement() const { return shift_; }
    [[nodiscard]] const Vec3& velocity() const { return velocity_; }  ///< at t + dt/2       [m/s]
    /// At t, between the steps before and ahead.
    /// @param weight  of the step ahead, Clock::weight()                                       [-]
    [[nodiscard]] Vec3 velocity_at_t(double weight) const {
        return velocity_before_ + weight * (velocity_ - velocity_before_);
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(shift_, next_shift_, velocity_, velocity_before_, is_behind_, last_, touching_,
                force_, stopping_energy_, friction_energy_, driving_work_, held_work_);
    }

private:
    /// A node that would come in.
    struct Stop {
        Index node;
        Vec3 normal;
        double spare;  ///< n·v + gap / dt: the wall's speed at which it is just not stopped
        bool has_met;  ///< it was
    };
    struct Bump {  ///< of a body's node
        Index node;
        Vec3 normal;
        double gap_rate;             ///< gap / dt                                       [m/s]
        double taken = 0.0;          ///< along the normal                               [N s]
        Vec3 rubbed = Vec3::Zero();  ///< by friction                                    [N s]
    };
    struct Plane {
        Vec3 normal;
        double gap;  ///< from the node to it [m]
    };

    void set_out(double t, double dt);
    void launch(double t, double dt);
    void note_nodes_behind(const Points& x);
    [[nodiscard]] double rounding(const Points& x) const;
    [[nodiscard]] bool passes(std::size_t i, const Vec3& at, double gap);
    [[nodiscard]] std::optional<Plane> plane_before(std::size_t i, const Vec3& at,
                                                    const Vec3& travel);
    [[nodiscard]] bool is_on(double t) const { return t >= card_.birth && t <= card_.death; }
    void find_stops(const Points& x, double dt, const Points& v, const WallBodies& bodies);
    [[nodiscard]] std::optional<Stop> stop_of(std::size_t i, const Points& x, double dt,
                                              const Points& v, const WallBodies& bodies);
    void find_near(const Points& x, double dt, const Points& v);
    void take(const Vec3& impulse, double dt);
    void slow_down(std::span<const double> mass);
    void stop(std::span<const double> mass, Points& v, Vec3& impulse);
    double find_bumps(const Points& x, double dt, const Points& v, const WallBodies& bodies);
    void stop_bodies(const Points& x, double dt, const Points& v, const WallBodies& bodies,
                     Vec3& impulse);
    [[nodiscard]] Vec3 rubbed(const Vec3& v, const Vec3& normal, double stop) const;

    WallCard card_;
    std::optional<Curve> curve_;
    Vec3 shift_ = Vec3::Zero(), next_shift_ = Vec3::Zero();  ///< since the start, at t, t + dt [m]
    Vec3 velocity_ = Vec3::Zero();                           ///< [m/s]
    Vec3 velocity_before_ = Vec3::Zero();                    ///< in the last step         [m/s]
    std::vector<std::uint8_t> is_behind_;  ///< by row in card_.nodes; empty before birth
    Points last_;                          ///< of a plate: where the nodes were, seen from it  [m]
    std::vector<Stop> stops_;
    parallel::Gathered<Stop> found_stops_;
    parallel::Gathered<std::size_t> found_near_;
    std::vector<std::size_t> near_;                      ///< rows in card_.nodes
    std::optional<std::vector<std::size_t>> of_bodies_;  ///< rows of bodies' nodes in card_.nodes
    std::vector<Bump> bumps_;
    std::vector<Index> touching_;
    Vec3 force_ = Vec3::Zero(), impulse_ = Vec3::Zero();
    double stopping_energy_ = 0.0, friction_energy_ = 0.0, driving_work_ = 0.0, held_work_ = 0.0;
};

}  // namespace corpuscle::contact
