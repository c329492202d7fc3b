// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/surface_contact.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "contact/crossing_guard.hpp"
#include "contact/impulses.hpp"
#include "contact/repulsion.hpp"

namespace corpuscle::contact {
namespace {

/// Gap, in contact thicknesses, below which pairs are looked at in every step and remember their
/// sides.
constexpr double REACH = 1.5;

/// Time in which a gap that starts below the contact thickness grows to it, in steps like the
/// first: long against a step, so that nothing is thrown, and short against a deployment.
constexpr double GROWTH_STEPS = 50.0;

/// Approach in one step, in contact thicknesses, beyond which the step is asked to be shorter. The
/// limit of approach holds at any speed, but what it stops at once is stopped without rebound.
constexpr double APPROACH = 3.0;

}  // namespace

struct SurfaceContact::State {
    ContactCard card;
    std::optional<Curve> thickness_curve;
    Cloth cloth;
    Candidates pairs;
    Repulsion repulsion;
    Impulses impulses;
    CrossingGuard guard;
    ContactList contacts;
    ContactCounts counts;
    Vec3 force = Vec3::Zero();
    double t = 0.0, dt_last = 0.0, span = 0.0;  ///< [s]
    double growth_time = NaN;  ///< of gaps that start below the contact thickness  [s]
    bool is_started = false, is_on = false;

    explicit State(const ContactSetup& setup)
        : card(setup.card),
          thickness_curve(setup.thickness_curve ? std::optional(*setup.thickness_curve)
                                                : std::nullopt),
          cloth(setup),
          pairs(cloth, REACH),
          repulsion(cloth),
          impulses(cloth, setup.card),
          guard(cloth) {}

    void look_at_pairs(const Points& x, const Points& v);
    void set_rest_gap(double thickness, Contact& contact);
    void let_debtors_part();
    void count();
    [[nodiscard]] Vec3 force_on_free_nodes() const;
};

SurfaceContact::SurfaceContact(const ContactSetup& setup)
    : state_(std::make_unique<State>(setup)) {}
SurfaceContact::~SurfaceContact() = default;
SurfaceContact::SurfaceContact(SurfaceContact&&) noexcept = default;
SurfaceContact& SurfaceContact::operator=(SurfaceContact&&) noexcept = default;

void SurfaceContact::find(const Points& x, const Points& v, double t, double dt) {
    State& s = *state_;
    s.contacts.clear(0);
    s.t = t;
    s.is_on = !s.cloth.triangles.empty() && t >= s.card.birth && t <= s.card.death;
    if (!s.is_on) return;
    if (s.is_started) {
        s.pairs.follow(x, t);
    } else {
        s.pairs.start(x, v, t, dt);
        for (std::size_t i = 0; i < s.pairs.size(); ++i)
            s.counts.close_starts += s.pairs.memory(i) != nullptr;
        s.growth_time = GROWTH_STEPS * dt;
        s.is_started = true;
    }
    s.look_at_pairs(x, v);
    s.count();
}

void SurfaceContact::State::look_at_pairs(const Points& x, const Points& v) {
    const double most = thickness_curve ? (*thickness_curve)(t) : INF;
    contacts.clear(pairs.size());
    const auto look = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!pairs.is_due(i)) continue;
            const Nearest places = nearest(pairs[i], x);
            const double gap = places.apart.norm();
            pairs.tell_distance(i, gap);
            const double thickness = std::min(pairs.thickness(i), most);
            if (!places.is_inside || gap >= REACH * thickness || gap == 0.0) continue;
            Contact& contact = contacts.chunk(chunk).emplace_back(
                contact_at(pairs[i], places, gap, cloth.inverse_mass));
            contact.pair = i;
            contact.rate_before = contact.rate(v);
            set_rest_gap(thickness, contact);
        }
    };
    parallel::for_chunks(pairs.size(), look, ContactList::CHUNK);
}

/// A pair that began nearer than its thickness starts with the gap that it had.
void SurfaceContact::State::set_rest_gap(double thickness, Contact& contact) {
    contact.rest = thickness;
    PairMemory* const memory = pairs.memory(contact.pair);
    if (memory == nullptr || memory->short_by == 0.0) return;
    const double missing = memory->short_by * std::exp(-(t - memory->born) / growth_time);
    if (missing < 1e-6 * thickness) {
        memory->short_by = 0.0;
    } else if (missing < thickness) {
        contact.rest = thickness - missing;
        contact.rest_rate = missing / growth_time;
    } else {
        contact.rest = 0.0;
    }
}

void SurfaceContact::State::count() {
    counts.builds = pairs.builds();
    counts.candidates = pairs.size();
    counts.near = counts.touching = 0;
    counts.impacts = guard.impacts();
    counts.clumps = guard.clumps();
    counts.unstopped = guard.unstopped();
    contacts.for_each([&](const Contact& c) {
        ++counts.near;
        counts.touching += c.gap < c.rest;
        if (c.rest > 0.0) counts.least_gap = std::min(counts.least_gap, c.gap / c.rest);
    });
}

void SurfaceContact::add_force(const Points& /*x*/, const Points& /*v*/, double dt, Points& f) {
    State& s = *state_;
    s.repulsion.find(std::max(dt, s.dt_last), s.contacts);
    s.let_debtors_part();
    s.repulsion.add(s.contacts, f);
    s.span = 0.5 * (s.dt_last + dt);
    s.dt_last = dt;
}

void SurfaceContact::filter(const Points& x, double dt, Points& v) {
    State& s = *state_;
    if (!s.is_on) return;
    s.impulses.apply(s.span, dt, s.contacts, s.pairs, v);
    s.guard.stop(x, s.t, dt, s.pairs, s.impulses, v);
    s.force = s.force_on_free_nodes();
}

/// A pair that has given more energy than it took, and is parting, does not push on.
void SurfaceContact::State::let_debtors_part() {
    contacts.for_each([&](Contact& c) {
        const PairMemory* const memory = pairs.memory(c.pair);
        if (memory != nullptr && memory->account < 0.0 && c.rate_before > 0.0)
            c.force = c.stiffness = 0.0;
    });
}

/// Normal impulses alone; friction on held nodes is not in it.
Vec3 SurfaceContact::State::force_on_free_nodes() const {
    Vec3 sum = Vec3::Zero();
    contacts.for_each([&](const Contact& c) {
        for (int i = 0; i < 4; ++i)
            if (cloth.inverse_mass[c.node[i]] > 0.0) sum += c.impulse * c.weight[i] * c.normal;
    });
    return span > 0.0 ? Vec3(sum / span) : sum;
}

double SurfaceContact::stable_step(const Points& v) const {
    double least = INF;
    state_->contacts.for_each([&](const Contact& c) {
        const double approach = -c.rate(v);
        if (approach > 0.0) least = std::min(least, APPROACH * c.rest / approach);
    });
    return least;
}

const std::vector<std::pair<Index, Index>>& SurfaceContact::crossing() const {
    return state_->pairs.crossing();
}
double SurfaceContact::stored_energy() const {
    return contact::stored_energy(state_->contacts);
}
double SurfaceContact::friction_energy() const {
    return state_->impulses.books().friction;
}
double SurfaceContact::damping_energy() const {
    return state_->impulses.books().normal;
}
double SurfaceContact::held_work() const {
    return state_->impulses.books().held_work;
}
const Vec3& SurfaceContact::force() const {
    return state_->force;
}
void SurfaceContact::mark_touching(std::span<std::uint8_t> nodes) const {
    state_->contacts.for_each([&](const Contact& c) {
        if (c.gap >= c.rest) return;
        for (int i = 0; i < 4; ++i)
            if (std::abs(c.weight[i]) > 0.5) nodes[c.node[i]] = 1;
    });
}
const ContactCounts& SurfaceContact::counts() const {
    return state_->counts;
}

}  // namespace corpuscle::contact
