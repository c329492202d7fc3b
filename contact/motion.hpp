// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "contact/cloth.hpp"

namespace corpuscle::contact {

/// How each patch moves, as bounds. Motion that all of the cloth has in common is left out of
/// everything, so a bag that flies freely spends nothing.
///
/// Two nodes of patches a and b cannot have come nearer to each other, since the ways were looked
/// at, than by what way(a) + way(b) has grown. And a node of patch a is no farther than stray(a)
/// from where it would be, had it kept the velocity that the patch had at the last restart.
class Motion {
public:
    explicit Motion(const Cloth& cloth);

    /// Starts at x and t, expecting a first step of v·dt.
    void start(const Points& x, const Points& v, double t, double dt);

    /// Adds the motion since the last call.
    void follow(const Points& x, double t);

    /// Predicts from here on: each patch keeps the mean velocity of its last step.
    void restart();

    [[nodiscard]] double time_step() const { return dt_; }                   ///< last one      [s]
    [[nodiscard]] double age() const { return age_; }                        ///< since restart [s]
    [[nodiscard]] double way(Index patch) const { return way_[patch]; }      ///< since start   [m]
    [[nodiscard]] double step(Index patch) const { return step_[patch]; }    ///< last one's    [m]
    [[nodiscard]] double stray(Index patch) const { return stray_[patch]; }  ///< since restart [m]
    [[nodiscard]] double stray_step(Index patch) const {
        return stray_step_[patch];
    }  ///< last's [m]
    [[nodiscard]] const Vec3& velocity(Index patch) const {
        return velocity_[patch];
    }  ///< kept [m/s]

private:
    template <class Displacement>
    void measure_step(Displacement&& of);

    const Cloth& cloth_;
    std::vector<Index> nodes_;  ///< of the cloth, ascending
    Points base_, last_;  ///< positions at the restart and at the last call, N × 3          [m]
    Vec3 common_ = Vec3::Zero();  ///< displacement of all since the restart                 [m]
    Vec3 common_step_ = Vec3::Zero();  ///< and in the last step [m]
    double t_ = 0.0, dt_ = 0.0, age_ = 0.0;
    std::vector<double> way_, step_, stray_, stray_step_;
    Points velocity_,
        mean_step_;  ///< by patch: kept since the restart; mean of the last step's displacement
};

}  // namespace corpuscle::contact
