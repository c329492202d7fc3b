// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <span>
#include <utility>

#include "contact/surface/cloth.hpp"
#include "contact/surface/contact_list.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// What a rigid body takes.
struct BodyImpulse {
    Vec3 linear = Vec3::Zero();   ///< [N s]
    Vec3 turning = Vec3::Zero();  ///< moment about the centre                             [N m s]
};

/// A rigid body as contact sees it: what hits one of its places moves all of it at once.
struct RigidProxy {
    Vec3 centre = Vec3::Zero();           ///< of mass, at t                               [m]
    Mat3 inverse_mass = Mat3::Zero();     ///< zero along what supports and motions hold   [1/kg]
    Mat3 inverse_inertia = Mat3::Zero();  ///< about the centre, global axes; likewise [1/(kg m^2)]
    Vec3 velocity = Vec3::Zero();         ///< of the centre, as nodes have it             [m/s]
    Vec3 spin = Vec3::Zero();             ///< likewise                                    [rad/s]
    Vec3 held_velocity = Vec3::Zero();    ///< of the centre, along what is held           [m/s]
    Vec3 held_spin = Vec3::Zero();        ///< about what is held                          [rad/s]

    Vec3 impulse = Vec3::Zero();          ///< taken since the last kick                   [N s]
    Vec3 turning = Vec3::Zero();          ///< its moment about the centre                 [N m s]
    Vec3 velocity_change = Vec3::Zero();  ///< by it, as far as nodes do not have it       [m/s]
    Vec3 spin_change = Vec3::Zero();      ///< likewise                                    [rad/s]

    /// Velocity at a place of it by what it has taken and its nodes do not have.            [m/s]
    [[nodiscard]] Vec3 change_at(const Vec3& x) const {
        return velocity_change + spin_change.cross(x - centre);
    }
    /// Velocity at a place of it, all told.                                                 [m/s]
    [[nodiscard]] Vec3 velocity_at(const Vec3& x) const {
        return velocity + spin.cross(x - centre) + change_at(x);
    }
    /// Velocity that a unit impulse at one place gives to another: a 3 × 3 matrix.          [1/kg]
    [[nodiscard]] Mat3 mobility(const Vec3& at) const;
    /// Whether impulses change its motion at all.
    [[nodiscard]] bool is_movable() const {
        return !inverse_mass.isZero(0.0) || !inverse_inertia.isZero(0.0);
    }
    /// Takes an impulse; returns the work that supports and motions do thereby.            [J]
    double push(const Vec3& by, const Vec3& at) { return take({by, (at - centre).cross(by)}); }
    /// The same of an impulse and its moment about the centre:
    ///
    ///     work = - impulse · held_velocity - moment · held_spin                            [J]
    double take(const BodyImpulse& by);
};

/// visit(number) for each body that has nodes of the contact: two at most.
template <class Visit>
void for_bodies_of(const Cloth& cloth, const Contact& c, Visit&& visit) {
    Index known = -1;
    for (const Index node : c.node) {
        const Index body = cloth.body[node];
        if (body < 0 || body == known) continue;
        visit(body);
        if (known >= 0) return;
        known = body;
    }
}

/// 1 / (what an impulse of one along `direction` makes of the rate along it); INF where nothing can
/// move the pair.                                                                          [kg]
[[nodiscard]] double mass_along(const Cloth& cloth, std::span<const RigidProxy> bodies,
                                const Points& x, const Contact& c, const Vec3& direction);

/// Contact between the nearest places of a pair that do not quite touch.
[[nodiscard]] Contact contact_at(const Cloth& cloth, std::span<const RigidProxy> bodies,
                                 const Points& x, const Pair& pair, const Nearest& nearest,
                                 double gap);

/// Velocities between the kick and the drift, which impulses change: those of free nodes in v, and
/// of rigid bodies' nodes in v and what their bodies have taken since. Held nodes stay as they are.
class VelocityState {
public:
    /// @param bodies    by the numbers that cloth.body has for their nodes
    /// @param v_before  gets the velocities that are about to change, if it is not null
    /// @param unkicked  velocities before the kick; null: as they are
    VelocityState(const Cloth& cloth, const Points& x, Points& v, std::span<RigidProxy> bodies,
                  Points* v_before, const Points* unkicked = nullptr)
        : cloth_(cloth),
          x_(x),
          v_(v),
          bodies_(bodies),
          v_before_(v_before),
          unkicked_(unkicked != nullptr ? *unkicked : v) {}

    /// To be called before any velocity changes.
    void begin() {
        if (!std::exchange(has_begun_, true) && v_before_) parallel::copy(v_, *v_before_);
    }

    /// Of a node, with what its body has taken.                                             [m/s]
    [[nodiscard]] Vec3 velocity(Index node) const {
        const Index body = cloth_.body[node];
        return body < 0 ? v_[node] : Vec3(v_[node] + bodies_[body].change_at(x_[node]));
    }
    /// Of the first place of a contact against the second, likewise.                        [m/s]
    [[nodiscard]] Vec3 relative(const Contact& c) const {
        return c.weight[0] * velocity(c.node[0]) + c.weight[1] * velocity(c.node[1]) +
               c.weight[2] * velocity(c.node[2]) + c.weight[3] * velocity(c.node[3]);
    }
    /// The same along the normal, > 0 as the gap opens.                                     [m/s]
    [[nodiscard]] double rate(const Contact& c) const { return c.normal.dot(relative(c)); }
    /// The rate before the kick, until velocities change.                                    [m/s]
    [[nodiscard]] double unkicked_rate(const Contact& c) const { return c.rate(unkicked_); }
    /// 1 / (what an impulse of one along `direction` makes of the rate along it); of free nodes the
    /// same in all directions.                                                               [kg]
    [[nodiscard]] double mass(const Contact& c, const Vec3& direction) const {
        return c.on_body ? mass_along(cloth_, bodies_, x_, c, direction) : c.mass;
    }

    /// Gives a node an impulse; returns the work that what is held does thereby.           [J]
    double push(Index node, const Vec3& impulse);
    /// Gives a body an impulse.
    void push_body(std::size_t body, const BodyImpulse& by) { bodies_[body].take(by); }
    /// Gives a node that is no body's a velocity.
    void set(Index node, const Vec3& velocity) {
        assert(has_begun_);
        for (int k = 0; k < 3; ++k)
            if (cloth_.mobility[node][k] > 0.0) v_[node][k] = velocity[k];
    }
    /// What join() did.
    struct Joined {
        double taken = 0.0;      ///< energy                                               [J]
        double held_work = 0.0;  ///< of what is held                                      [J]
    };
    /// Joins a node to a body's place where it is: an impulse that leaves no velocity between them.
    /// Of two that nothing can move it does nothing.
    Joined join(Index node, Index body);

    /// Velocities of nodes, those of bodies without what these have taken since.             [m/s]
    [[nodiscard]] Points& node_velocities() { return v_; }
    /// Work that what holds a node does against an impulse on it.                             [J]
    [[nodiscard]] double held_work(Index node, const Vec3& impulse) const;

    /// Hands what bodies have taken to their nodes' v.
    void settle();
    /// Whether any velocity may have changed.
    [[nodiscard]] bool has_begun() const { return has_begun_; }
    /// By node row, as node_velocities()  [m/s]
    [[nodiscard]] const Points& v() const { return v_; }
    /// By node row, at t                  [m]
    [[nodiscard]] const Points& x() const { return x_; }
    /// By number.
    [[nodiscard]] std::span<const RigidProxy> bodies() const { return bodies_; }

private:
    const Cloth& cloth_;
    const Points& x_;
    Points& v_;
    std::span<RigidProxy> bodies_;
    Points* v_before_;
    const Points& unkicked_;
    bool has_begun_ = false;
};

}  // namespace corpuscle::contact
