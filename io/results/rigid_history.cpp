// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/rigid_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "io/text/units.hpp"

namespace corpuscle::io {
namespace {

/// A time is met within the rounding of sums of steps.
constexpr double ROUNDING = 1e-12;

std::span<const double> components(const Points& x) {
    return {x.empty() ? nullptr : x.front().data(), 3 * x.size()};
}

}  // namespace

double rigid_interval(const std::string& unit_system, double end_time) {
    constexpr double RATE = 1e5;  // [Hz], what CFC 1000 wants ten times over
    constexpr double MOST_ROWS = 200000, ROWS_OF_UNKNOWN_UNITS = 5000;
    const auto scale = scale_of(unit_system);
    const double wanted = scale ? 1.0 / (RATE * scale->second) : end_time / ROWS_OF_UNKNOWN_UNITS;
    return std::max(wanted, end_time / MOST_ROWS);
}

RigidHistory::RigidHistory(double interval, const std::vector<RigidTrack>& tracks)
    : interval_(interval), rows_(1) {
    for (const RigidTrack& of : tracks) {
        Track& track = tracks_.emplace_back();
        track.id = of.id;
        track.mass = of.mass;
        track.v_half = of.velocity;
        track.position = {of.position};
        track.velocity = {of.velocity};
        track.acceleration = track.force = {Vec3::Zero()};
    }
}

void RigidHistory::observe(double t, const std::vector<RigidState>& states, bool at_end) {
    if (tracks_.empty()) return;
    assert(states.size() == tracks_.size() && "a state for every track");
    const double step = t - t_;
    if (waits_) pass(t_ + 0.5 * step, t);
    for (std::size_t b = 0; b < tracks_.size(); ++b) tracks_[b].next = states[b];
    t_ = t;
    waits_ = true;
    if (at_end) pass(t + 0.5 * step, t);
}

/// Rows up to the half step after t_, none beyond t_end.
void RigidHistory::pass(double t_half, double t_end) {
    const double span = t_half - t_half_;
    if (span <= 0.0) return;
    double from = t_half_;
    for (;; ++rows_) {
        const double t = static_cast<double>(rows_) * interval_;
        if (t > t_half * (1.0 + ROUNDING) || t > t_end * (1.0 + ROUNDING)) break;
        const double share = std::min(1.0, (t - t_half_) / span);
        for (Track& track : tracks_) {
            const Vec3 v = track.v_half + share * (track.next.velocity - track.v_half);
            track.impulse += (t - from) * track.next.force;
            track.acceleration.push_back((v - track.velocity.back()) / interval_);
            track.force.push_back(track.impulse / interval_);
            track.position.push_back(track.next.position +
                                     (t - t_) * (t < t_ ? track.v_half : track.next.velocity));
            track.velocity.push_back(v);
            track.impulse.setZero();
        }
        from = t;
    }
    for (Track& track : tracks_) {
        track.impulse += (t_half - from) * track.next.force;
        track.v_half = track.next.velocity;
    }
    t_half_ = t_half;
}

void RigidHistory::write(Hdf5Writer& file, const std::string& unit_system) const {
    using enum Quantity;
    if (tracks_.empty()) return;
    const auto unit = [&](Quantity quantity) { return unit_of(quantity, unit_system); };
    std::vector<double> time(rows_);
    for (std::size_t k = 0; k < rows_; ++k) time[k] = static_cast<double>(k) * interval_;
    file.dataset<double>("/history_fast/time", time, {rows_},
                         {unit(TIME), "uniform, whatever the steps and the other outputs are"});
    for (const Track& track : tracks_) {
        const std::string of = fmt::format("/history_fast/rigid_body/{}/", track.id);
        const auto rows = [&](const char* name, Quantity quantity, const char* text,
                              const Points& values) {
            file.dataset(of + name, components(values), {rows_, 3}, {unit(quantity), text});
        };
        file.dataset<double>(of + "mass", std::span(&track.mass, 1), {},
                             {unit(MASS), "of the body"});
        rows("position", LENGTH, "centre of mass", track.position);
        rows("velocity", VELOCITY, "of the centre of mass", track.velocity);
        rows("acceleration", ACCELERATION, "mean since the row before; 0 in the first",
             track.acceleration);
        rows("force", FORCE,
             "contact and gas on the body, mean since the row before; 0 in the first", track.force);
    }
}

std::vector<BodyMotion> RigidHistory::motions() const {
    std::vector<BodyMotion> all;
    for (const Track& track : tracks_)
        all.push_back({track.id, track.mass, interval_, track.position, track.velocity,
                       track.acceleration, track.force});
    return all;
}

}  // namespace corpuscle::io
