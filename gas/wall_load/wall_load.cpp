// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/wall_load.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Share of its energy that a particle pays, or is paid, at one hit at most; the rest waits for the
/// next. More: single particles take on debts that their group can hardly share.
constexpr double MOST_PAID = 0.25;

/// Internal energy below nothing that a particle takes on, in its energy of motion: a monatomic gas
/// has no other, and its group shares the debt at the next collision. Where a wall takes the motion
/// that was to pay for it, the wall takes the debt back, too, as far as it took motion.
constexpr double MOST_DEBT = 0.1;

constexpr std::size_t LISTS_A_CHUNK = 8;
constexpr std::size_t FEW_HITS = 128;  ///< that one thread is done with sooner

/// What a particle can bear to have less of, its debt included: below zero where motion that was
/// to pay for it is gone.                                                                    [J]
double bearable(double internal, double motion) {
    return internal + MOST_DEBT * motion;
}

/// What a particle pays of `due`, or is paid where that is above zero, after so many hits.    [J]
double paid_of(double due, double internal, double motion, int hits = 1) {
    const double most = hits * MOST_PAID * std::max(0.0, motion + internal);
    return std::clamp(due, -std::min(most, std::max(0.0, bearable(internal, motion))), most);
}

/// By wall point: is its node held?
std::vector<std::uint8_t> held_at(const WettedSurface& surface,
                                  std::span<const std::uint8_t> held) {
    std::vector<std::uint8_t> at(surface.points());
    for (std::size_t p = 0; p < at.size(); ++p) at[p] = held[surface.node(p)];
    return at;
}

}  // namespace

WallLoad::WallLoad(std::shared_ptr<const WettedSurface> surface, std::span<const std::uint8_t> held,
                   std::span<const Index> jet_nodes, LoadTimes times, double extra_damping,
                   std::span<const Index> body)
    : surface_(std::move(surface)),
      smoother_(*surface_),
      recoil_(held_at(*surface_, held)),
      times_(times),
      extra_damping_(extra_damping),
      by_node_(*surface_, jet_nodes, held.size()),
      at_held_{{}, BodyCouples(*surface_, body)},
      hits_(*surface_) {
    const std::size_t points = surface_->points();
    held_ = held_at(*surface_, held);
    jets_.nodes.assign(jet_nodes.begin(), jet_nodes.end());
    for (const Index n : jets_.nodes) jets_.held.push_back(held[n]);
    jets_.room.assign(jets_.nodes.size(), 0);
    jets_.account.assign(surface_->rooms(), 0.0);
    takes_part_.assign(points, 0);
    for (Points* all : {&area_, &deferred_.along, &released_.force, &arrived_})
        all->assign(points, Vec3::Zero());
    for (auto* all : {&size_, &deferred_.normal, &deferred_.answered, &deferred_.mass, &account_,
                      &fresh_, &released_.pressure, &arrived_mass_})
        all->assign(points, 0.0);
    brought_.resize(points);
    deferred_.age.assign(points, INF);
    released_.on_node.assign(held.size(), Vec3::Zero());
    owed_.resize(surface_->rooms());
    released_.swept.assign(owed_.size(), 0.0);
    jets_.owed.assign(jets_.nodes.size(), Vec3::Zero());
    jets_.force.assign(jets_.nodes.size(), Vec3::Zero());
}

// ---- what comes

void WallLoad::receive(FlightResult& flight, std::span<const double> mass, Particles& particles) {
    constexpr int DEALT_FOR = 32;
    set_right(flight, mass, particles);
    const SidePatches& patches = hits_.patches();
    receiving_.tally.resize(patches.size());
    const auto receive_patch = [&](std::size_t place) {
        const auto patch = static_cast<std::size_t>(patches.by_colour()[place]);
        if (hits_.of(patch).empty()) return;
        Tally tally;
        for (const WallHits::Met& met : hits_.of(patch)) take_in(met, mass, particles, tally);
        receiving_.tally[patch] = tally;
    };
    const auto before = [&](std::size_t place, auto&& visit) {
        for (const Index other : patches.before(place)) visit(static_cast<std::size_t>(other));
    };
    const auto hits_at = [&](std::size_t place) {
        return hits_.of(static_cast<std::size_t>(patches.by_colour()[place])).size();
    };
    if (receiving_.since-- <= 0 || receiving_.shares.members() != parallel::threads()) {
        receiving_.since = DEALT_FOR;
        receiving_.shares.deal(
            patches.size(), [&](std::size_t patch) { return patches.place(patch); },
            [&](std::size_t place) { return static_cast<double>(hits_at(place)); });
    }
    receiving_.tasks.run(receiving_.shares, before, receive_patch, hits_.size() > FEW_HITS,
                         parallel::Cut().where);
    for (std::size_t p = 0; p < patches.size(); ++p)
        if (!hits_.of(p).empty()) add(receiving_.tally[p], patches.room(p));
}

void WallLoad::add(const Tally& tally, Index room) {
    owed_[room] += tally.owed;
    at_held_.owed += tally.held;
    taken_ += tally.taken;
}

/// Where cloth recoils: the hits of each particle, in their order.
void WallLoad::set_right(FlightResult& flight, std::span<const double> mass,
                         Particles& particles) const {
    const auto of_list = [&](std::size_t l) {
        std::vector<Hit>& hits = flight.hits[l];
        std::span<const Index> sides = hits_.sides(l);
        for (auto first = hits.begin(); first != hits.end();) {
            const auto last = std::find_if(first, hits.end(),
                                           [&](const Hit& hit) { return hit.who != first->who; });
            const std::span<Hit> own(first, last);  // of one particle
            const std::size_t row = first->row();
            if (!first->has_left())
                recoil_.set_right(*surface_, smoother_, own, sides.first(own.size()),
                                  mass[particles.species[row]], particles.x[row], particles.v[row]);
            sides = sides.subspan(own.size());
            first = last;
        }
    };
    parallel::for_each(flight.hits.size(), of_list, LISTS_A_CHUNK);
}

void WallLoad::charge(std::span<const Index> points, double energy) {
    double all = 0.0;
    for (const Index p : points) all += size_[p];
    for (const Index p : points) account_[p] -= energy * size_[p] / all;
    taken_ -= energy;
}

void WallLoad::take_in(const WallHits::Met& met, std::span<const double> mass, Particles& particles,
                       Tally& tally) {
    const Hit& hit = *met.hit;
    const std::size_t row = hit.row();
    const double m = mass[particles.species[row]];
    const std::array<Index, 3>& points = surface_->points(static_cast<std::size_t>(met.side));
    double due = 0.0, free = 0.0;
    for (int c = 0; c < 3; ++c) {
        const Index p = points[c];
        const Vec3 own = hit.at[c] * hit.impulse;
        arrived_[p] += own;
        arrived_mass_[p] += hit.at[c] * m;
        fresh_[p] += hit.at[c] * hit.energy;
        due += hit.at[c] * account_[p];
        if (held_[p] == 0) free += hit.at[c];
    }
    if (at_held_.couples.carries_any(points)) {
        take_in_of_body(hit, points, tally);
    } else {
        tally.owed.add(hit.where, free * hit.impulse);
        tally.held.add(hit.where, (1.0 - free) * hit.impulse);
    }
    tally.owed.angular += hit.moment;
    tally.taken += hit.energy;
    if (met.settles > 0 && !hit.has_left()) settle(met, m, due, particles, tally);
}

/// Where bodies and others share a facet, each corner has its part of the moment.
void WallLoad::take_in_of_body(const Hit& hit, const std::array<Index, 3>& points, Tally& tally) {
    const bool is_bodys = at_held_.couples.carries_all(points);
    const std::array<Vec3, 3> places =
        is_bodys ? std::array{hit.where, hit.where, hit.where} : hits_.corners(hit);
    for (int c = 0; c < 3; ++c) {
        const Index p = points[c];
        const Vec3 own = hit.at[c] * hit.impulse;
        (held_[p] != 0 ? tally.held : tally.owed).add(places[c], own);
        at_held_.couples.take(p, places[c], own);
    }
}

/// A particle's last hit in a flight pays, and is paid, for all of them: of hits at points of
/// several patches, which are taken in at once, one alone changes the particle.
/// @param due  that the points where it hits are owed, each in its share                   [J]
void WallLoad::settle(const WallHits::Met& met, double m, double due, Particles& particles,
                      Tally& tally) {
    const Hit& hit = *met.hit;
    double& internal = particles.e[hit.row()];
    const double motion = 0.5 * m * particles.v[hit.row()].squaredNorm();
    const double paid = paid_of(due, internal, motion, met.settles),
                 back = std::clamp(-bearable(internal, motion) - paid, 0.0,
                                   std::max(0.0, met.energy()));
    if (paid == 0.0 && back == 0.0) return;
    internal += paid + back;
    tally.taken -= paid + back;
    const double cleared = due != 0.0 ? paid / due : 0.0;
    const std::array<Index, 3>& points = surface_->points(static_cast<std::size_t>(met.side));
    for (int c = 0; c < 3; ++c)
        account_[points[c]] -= hit.at[c] * (cleared * account_[points[c]] + back);
}

void WallLoad::press(std::span<const double> pressure, Points& f, Points& sum) const {
    parallel::for_each(by_node_.nodes.size(), [&](std::size_t i) {
        Vec3 force = Vec3::Zero();
        for (Index k = by_node_.start[i]; k < by_node_.start[i + 1]; ++k) {
            const Index p = by_node_.points[k];
            force += pressure[surface_->room_of_point(p)] * area_[p];
        }
        f[by_node_.nodes[i]] = force;
        sum[by_node_.nodes[i]] += force;
    });
}

void WallLoad::owe_jet(Index node, Index room, const Vec3& at, const Vec3& impulse, double energy) {
    const auto j = static_cast<std::size_t>(
        std::find(jets_.nodes.begin(), jets_.nodes.end(), node) - jets_.nodes.begin());
    jets_.room[j] = room;
    jets_.owed[j] += impulse;
    jets_.wrench.add(at, impulse);
    jets_.account[room] += energy;
    taken_ += energy;
}

double WallLoad::pay_jets(Index room, double internal, double motion) {
    const double paid = paid_of(jets_.account[room], internal, motion);
    jets_.account[room] -= paid;
    taken_ -= paid;
    return paid;
}

double WallLoad::pay_jets(Index room) {
    taken_ -= jets_.account[room];
    return std::exchange(jets_.account[room], 0.0);
}

void WallLoad::measure(std::span<const Vec3> x) {
    surface_->point_areas(x, area_);
    parallel::for_each(size_.size(), [&](std::size_t p) { size_[p] = area_[p].norm(); });
}

void WallLoad::begin_with(double pressure, double mass_flux, std::span<const Vec3> x) {
    measure(x);
    released_.share = WallRelease::BEGINS;
    for (std::size_t p = 0; p < size_.size(); ++p) {
        deferred_.age[p] = 0.0;
        deferred_.mass[p] = mass_flux * size_[p] * times_.memory;
        if (held_[p] == 0) owe(p, pressure * size_[p] * times_.release, x);
    }
}

/// A point is owed so much more along its normal.                                        [N s]
void WallLoad::owe(std::size_t p, double impulse, std::span<const Vec3> x) {
    deferred_.normal[p] += impulse;
    owed_[surface_->room_of_point(p)].add(x[surface_->node(p)], impulse * normal(p));
}

/// A first release whose span is above the times of load gets what hits would have brought in it.
void WallLoad::fill_first_span(double span, std::span<const Vec3> x) {
    const double missing = std::max(0.0, span / times_.release - 1.0),
                 hits = std::max(1.0, span / times_.memory);
    for (std::size_t p = 0; p < size_.size(); ++p) {
        deferred_.mass[p] *= hits;
        if (held_[p] == 0 && missing > 0.0) owe(p, missing * deferred_.normal[p], x);
    }
}

/// The first release spans half a step, the hits that follow it a whole one: the other half's share
/// is not owed, else it would push the wall by p dt / 2.
void WallLoad::take_half_step(double share, std::span<const Vec3> x) {
    for (std::size_t p = 0; p < size_.size(); ++p) {
        if (held_[p] != 0) continue;
        const double rest = deferred_.normal[p];
        const double half = share < 0.5 ? share / (1.0 - share) * rest : rest;
        owe(p, -half, x);
    }
}

void WallLoad::end_of_hits(std::span<const double> pressure, std::span<const Vec3> x) {
    measure(x);
    since_hits_ = 0.0;
    // what steady hits leave to be owed, once a step's share is given
    const double time = times_.release * (1.0 - std::max(0.0, std::exchange(released_.share, 0.0)));
    for (std::size_t p = 0; p < size_.size(); ++p) {
        deferred_.mass[p] = 0.0;
        deferred_.age[p] = 0.0;  // all that is owed goes to all of the wall
        if (held_[p] == 0) owe(p, -pressure[surface_->room_of_point(p)] * size_[p] * time, x);
    }
}

}  // namespace corpuscle::gas
