// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "io/responses/body_responses.hpp"
#include "io/results/hdf5.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// A rigid body that can move, as it starts.
struct RigidTrack {
    int id = 0;                    ///< of its part
    double mass = 0.0;             ///< [kg]
    Vec3 position = Vec3::Zero(),  ///< of the mass centre                              [m]
        velocity = Vec3::Zero();   ///< of the mass centre                            [m/s]
};

/// A rigid body in a step, at t.
struct RigidState {
    Vec3 position = Vec3::Zero();  ///< of the mass centre at t                      [m]
    Vec3 velocity = Vec3::Zero();  ///< of the mass centre at t + dt/2               [m/s]
    Vec3 force = Vec3::Zero();     ///< contact and gas on it, from t - dt/2 to t + dt/2 [N]
};

/// Motion of the rigid bodies that can move, at a uniform rate whatever the steps are.
///
/// The leapfrog's velocity is a broken line: v(t_n + dt/2) after the force of t_n has acted from
/// t_n - dt/2 to t_n + dt/2. A row at t_k holds this line's v and the x below it, and what acted in
/// (t_(k-1), t_k]:
///
///     a_k = (v_k - v_(k-1)) / interval,   F_k = 1 / interval · ∫ F dt
///
/// so the impulse Σ F interval is the run's own to rounding, and steps shorter than the interval
/// alias nothing worth a name (a mean over 10 us passes 1 kHz at 0.9998).
class RigidHistory {
public:
    RigidHistory() = default;
    /// @param interval  between rows                                                   [s]
    /// @param tracks    bodies to record; empty: nothing is recorded
    RigidHistory(double interval, const std::vector<RigidTrack>& tracks);

    /// Once in every step, at t; `at_end`: the last time.
    /// @param states  of the tracks, in their order
    void observe(double t, const std::vector<RigidState>& states, bool at_end);

    /// Writes /history_fast, nothing if there are no tracks.
    void write(Hdf5Writer& file, const std::string& unit_system) const;

    /// What was followed so far.
    [[nodiscard]] std::vector<BodyMotion> motions() const;
    /// So far; the first is the start.
    [[nodiscard]] std::size_t rows() const { return rows_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp); rows stay as far apart as they were.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(interval_, tracks_, rows_, waits_, t_, t_half_);
    }

private:
    struct Track {
        int id = 0;
        double mass = 0.0;                               ///< [kg]
        Vec3 v_half = Vec3::Zero();                      ///< at t_half_            [m/s]
        RigidState next;                                 ///< of t_ and the half step after it
        Vec3 impulse = Vec3::Zero();                     ///< since the last row    [N s]
        Points position, velocity, acceleration, force;  ///< rows

        template <class Archive>
        void visit_state(Archive& archive) {
            archive(id, mass, v_half, next, impulse, position, velocity, acceleration, force);
        }
    };
    void pass(double t_half, double t_end);

    double interval_ = 0.0;  ///< [s]
    std::vector<Track> tracks_;
    std::size_t rows_ = 0;
    bool waits_ = false;   ///< a state for the end of its step
    double t_ = 0.0;       ///< of that state                                     [s]
    double t_half_ = 0.0;  ///< the half step before it                          [s]
};

/// 100 kHz; an interval that gives 5 000 rows where the deck's units are unknown, and never more
/// than 200 000 rows.                                                                       [s]
[[nodiscard]] double rigid_interval(const std::string& unit_system, double end_time);

}  // namespace corpuscle::io
