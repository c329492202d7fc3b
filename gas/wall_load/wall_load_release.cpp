// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What the wall is given of what it is owed.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gas/wall_load/rigid_field.hpp"
#include "gas/wall_load/wall_load.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Answer of a gas to a wall that moves: dp/dw = -4 times the mass that hits it per area and time,
/// since p = 2 int (v - w)² f dv over all that come.
constexpr double ANSWER = 4.0;

/// Share of a room's free wall that must be wet to bear the correction of momentum alone.
constexpr double LEAST_WET = 0.25;

/// Share of the correction of momentum that all of the wall bears, wherever smoothing moves load.
constexpr double EVERYWHERE = 0.01;

/// Unevenness, of the load's square and by itself [N^2 s^2/m^2], below which it is rounding.
constexpr double EVEN = 1e-12, NOTHING = 1e-250;

/// Of a room's wall: what it was given and keeps, and the lever that its points have, by area and
/// by unevenness.
struct Sums {
    Wrench given, kept;
    Lever wet, dry, uneven;
    double square = 0.0;  ///< of what is kept, per area                        [N^2 s^2/m^2]
    Sums& operator+=(const Sums& o) {
        given += o.given;
        kept += o.kept;
        wet += o.wet;
        dry += o.dry;
        uneven += o.uneven;
        square += o.square;
        return *this;
    }
};

}  // namespace

void WallLoad::release(double span, std::span<const Vec3> x, std::span<const Vec3> v,
                       std::span<const double> mass, std::span<Vec3> f) {
    const bool was_at_rest = is_at_rest();
    if (hits_are_over()) since_hits_ += span;
    if (is_at_rest() && !was_at_rest) come_to_rest();
    const bool begins = released_.share == WallRelease::BEGINS;
    if (begins) fill_first_span(span, x);
    released_.wrench = owed();
    // F = Q / t, with what has come in this step: late by t on average in steps of any length up to
    // that.
    const double share = std::min(1.0, span / times_.release);
    if (!is_at_rest()) release_hits(share, span, x, v, mass, f);
    release_jets(share, span, x);
    at_held_.owed = {};
    released_.wrench -= owed();
    if (begins) take_half_step(share, x);
    released_.share = begins ? std::min(1.0, 2.0 * share) : share;
    if (is_at_rest())
        for (const Index node : jets_.nodes) released_.on_node[node].setZero();
    for (std::size_t j = 0; j < jets_.nodes.size(); ++j) {
        released_.on_node[jets_.nodes[j]] += jets_.force[j];
        f[jets_.nodes[j]] += jets_.force[j];
    }
}

void WallLoad::release_hits(double share, double span, std::span<const Vec3> x,
                            std::span<const Vec3> v, std::span<const double> mass,
                            std::span<Vec3> f) {
    find_brought(span, x, mass);
    smoother_.prepare(*surface_, area_, size_, takes_part_);
    smoother_.spread(*surface_, brought_);
    release_points(share, span, v, mass);
    at_held_.couples.give(span, *surface_, x, size_, released_.force);
    balance_momentum(share, span, x);
    parallel::for_each(by_node_.nodes.size(), [&](std::size_t i) {
        Vec3 sum = Vec3::Zero();
        for (Index k = by_node_.start[i]; k < by_node_.start[i + 1]; ++k)
            sum += released_.force[by_node_.points[k]];
        released_.on_node[by_node_.nodes[i]] = sum;
        f[by_node_.nodes[i]] += sum;
    });
}

/// What is left to release is given up to the books, which have it as owed.
void WallLoad::come_to_rest() {
    for (Points* all : {&released_.force, &released_.on_node, &deferred_.along})
        std::fill(all->begin(), all->end(), Vec3::Zero());
    for (auto* all : {&released_.pressure, &deferred_.normal, &deferred_.answered})
        std::fill(all->begin(), all->end(), 0.0);
}

/// Areas of points, and what hits have brought each.
void WallLoad::find_brought(double span, std::span<const Vec3> x, std::span<const double> mass) {
    thread_local Points kept;  // no memory is asked for in each step
    Points& of_facet = kept;
    of_facet.resize(surface_->triangles().size());
    recoil_.set_points(size_.size());
    const auto measure_facet = [&](std::size_t t) { of_facet[t] = surface_->facet_area(t, x); };
    const auto bring = [&](std::size_t p) {
        area_[p] = surface_->point_area(p, of_facet);
        size_[p] = area_[p].norm();
        recoil_.weigh(p, mass[surface_->node(p)]);
        if (!hits_are_over())
            deferred_.age[p] = arrived_mass_[p] > 0.0 ? 0.0 : deferred_.age[p] + span;
        takes_part_[p] = held_[p] == 0 && is_wet(p) && size_[p] > 0.0;
        const double own = arrived_[p].dot(normal(p)), along = own + deferred_.answered[p];
        const Vec3 beside = arrived_[p] - own * normal(p);
        const double per_area = takes_part_[p] != 0 ? 1.0 / size_[p] : 0.0;
        brought_[p] = {along * per_area, arrived_mass_[p] * per_area, beside * per_area};
        if (held_[p] != 0 || takes_part_[p] != 0) return;
        deferred_.normal[p] += along;
        deferred_.along[p] += beside;
        deferred_.mass[p] += arrived_mass_[p];
    };
    parallel::in_turn(parallel::each(of_facet.size(), measure_facet),
                      parallel::each(size_.size(), bring));
}

/// Force of each point: what is kept is released, and the gas answers to its motion at once.
void WallLoad::release_points(double share, double span, std::span<const Vec3> v,
                              std::span<const double> mass) {
    const double answer = ANSWER + extra_damping_ * std::sqrt(2.0 * std::numbers::pi),
                 forgotten = std::min(1.0, span / times_.memory);
    parallel::for_each(size_.size(), [&](std::size_t p) {
        const Vec3 n = normal(p);
        if (held_[p] != 0) {
            deferred_.mass[p] += arrived_mass_[p];
            released_.force[p] = arrived_[p] / span;
        } else {
            if (takes_part_[p] != 0) {
                deferred_.normal[p] += size_[p] * brought_[p].push;
                deferred_.along[p] += size_[p] * brought_[p].beside;
                deferred_.mass[p] += size_[p] * brought_[p].mass;
            }
            // D A, implicit in the motion that it damps: stable in any step.
            const double damper = answer * forgotten * deferred_.mass[p] / span;
            const Index node = surface_->node(p);
            const double damped = damper / (1.0 + damper * span / mass[node]) * v[node].dot(n);
            deferred_.answered[p] = span * damped;
            const double given = share * deferred_.normal[p];
            const Vec3 beside = share * deferred_.along[p];
            deferred_.normal[p] -= given;
            deferred_.along[p] -= beside;
            released_.force[p] = (given / span - damped) * n + beside / span;
        }
        deferred_.mass[p] -= forgotten * deferred_.mass[p];
        released_.pressure[p] = size_[p] > 0.0 ? released_.force[p].dot(n) / size_[p] : 0.0;
        arrived_[p].setZero();
        arrived_mass_[p] = 0.0;
    });
}

void WallLoad::release_jets(double share, double span, std::span<const Vec3> x) {
    for (std::size_t j = 0; j < jets_.nodes.size(); ++j) {
        const Vec3 given = jets_.held[j] != 0 ? jets_.owed[j] : Vec3(share * jets_.owed[j]);
        jets_.owed[j] -= given;
        jets_.force[j] = given / span;
        Wrench done;
        done.add(x[jets_.nodes[j]], given);
        jets_.wrench -= done;
    }
}

/// What each room's free wall is owed, less what its points keep, is given as a weighted rigid
/// field,
///
///     F_p = w_p (a + b × (x_p - c)),   w_p = sum over q of k (u_q - u_p)² + w A_p,   u = Q / A,
///
/// c: their centre by weight; a and b such that force and moment are right. Smoothing moves load down
/// its slope, and most of what is amiss comes of that: there it is made good.
void WallLoad::balance_momentum(double share, double span, std::span<const Vec3> x) {
    const Vec3 origin = x[surface_->node(0)];
    std::vector<double>& uneven = released_.uneven;
    uneven.resize(size_.size());
    for (std::size_t r = 0; r < owed_.size(); ++r) {
        const auto room = static_cast<Index>(r);
        const auto counts = [&](std::size_t p) {
            return surface_->room_of_point(p) == room && held_[p] == 0;
        };
        const Sums sums = parallel::sum(size_.size(), Sums{}, [&](std::size_t p) {
            Sums own;
            if (!counts(p)) return own;
            const Vec3& at = x[surface_->node(p)];
            own.given.add(at, span * released_.force[p]);
            own.kept.add(
                at, (deferred_.normal[p] + deferred_.answered[p]) * normal(p) + deferred_.along[p]);
            (takes_part_[p] != 0 ? own.wet : own.dry).add(size_[p], at - origin);
            uneven[p] = smoother_.unevenness(*surface_, p, deferred_.normal);
            own.uneven.add(uneven[p], at - origin);
            if (size_[p] > 0.0) own.square = deferred_.normal[p] * deferred_.normal[p] / size_[p];
            return own;
        });
        Lever lever = sums.wet;
        lever += sums.dry;
        // A few wet points have no lever: then all of the wall bears it.
        const bool is_spread = sums.wet.weight > LEAST_WET * lever.weight;
        if (is_spread) lever = sums.wet;
        const bool is_even = !(sums.uneven.weight > EVEN * sums.square + NOTHING);
        const double per_area = is_even ? 1.0 : EVERYWHERE * sums.uneven.weight / lever.weight;
        const auto weight = [&](std::size_t p) {
            if (!counts(p) || !(size_[p] > 0.0)) return 0.0;
            return (is_even ? 0.0 : uneven[p]) +
                   (!is_spread || takes_part_[p] != 0 ? per_area * size_[p] : 0.0);
        };
        Wrench& owed = owed_[r];
        owed -= sums.given;
        if (!(lever.weight > 0.0)) continue;
        lever *= per_area;
        if (!is_even) lever += sums.uneven;
        Wrench rest = owed;
        rest -= sums.kept;
        rest *= share;
        const RigidField field(lever, origin, rest);
        parallel::for_each(size_.size(), [&](std::size_t p) {
            const double own = weight(p);
            if (own != 0.0) released_.force[p] += own / span * field.at(x[surface_->node(p)]);
        });
        owed -= field.whole();
    }
}

template <class Value>
double WallLoad::mean_over_points(Index node, Value&& value) const {
    const Index i = by_node_.place[node];
    if (i < 0 || by_node_.start[i] == by_node_.start[i + 1]) return 0.0;
    double sum = 0.0, size = 0.0;
    for (Index k = by_node_.start[i]; k < by_node_.start[i + 1]; ++k) {
        sum += size_[by_node_.points[k]] * value(by_node_.points[k]);
        size += size_[by_node_.points[k]];
    }
    return size > 0.0 ? sum / size : 0.0;
}

double WallLoad::pressure_at_node(Index node) const {
    return mean_over_points(node, [&](Index p) { return released_.pressure[p]; });
}

double WallLoad::mean_at_node(Index node, std::span<const double> by_room) const {
    return mean_over_points(node, [&](Index p) { return by_room[surface_->room_of_point(p)]; });
}

Wrench WallLoad::owed(double done) const {
    Wrench sum = released_.wrench;
    sum *= 1.0 - done;
    sum += jets_.wrench;
    sum += at_held_.owed;
    sum.angular += at_held_.couples.owed();
    for (const Wrench& room : owed_) sum += room;
    return sum;
}

}  // namespace corpuscle::gas
