// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "contact/culling/patch_pairs.hpp"
#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// How the cloth that is searched moves, as bounds. Motion that all of it has in common is left out
/// of everything, so a bag that flies freely spends nothing.
class Motion {
public:
    /// @param pieces  what is searched; may change at a restart
    Motion(const Cloth& cloth, const Pieces& pieces);

    /// Starts at x and t.
    void start(const Points& x, double t);

    /// Adds the motion since the last call, and expects each node to go on for the step ahead as it
    /// was foreseen last.
    void follow(const Points& x, double t, double dt);

    /// Looks at the step ahead, from x to x + dt v.
    void foresee(const Points& x, const Points& v, double dt);

    /// Predicts from x on: each node keeps its velocity, less that of all. Nodes that have used
    /// much of their part of the budget get more of it, others less.
    void restart(const Points& x, const Points& v, double budget);

    /// Predicts some nodes anew, from x on as they were foreseen last; they get more slack.
    void renew(std::span<const Index> nodes, const Points& x);

    /// Nodes that will be farther from their prediction after the step ahead than the budget and
    /// their slack allow, ascending.
    void list_strayed(double budget, std::vector<Index>& out) const;

    /// Where a node is predicted to be now, less the motion of all since the restart.        [m]
    [[nodiscard]] Vec3 predicted(Index node) const { return base_[node] + age_ * velocity_[node]; }

    /// Bound of how far a triangle's nodes have left their predictions, summed since the start: two
    /// triangles a and b cannot have come nearer to each other than predicted by more than what
    /// displacement(a) + displacement(b) has grown. [m]
    [[nodiscard]] double displacement(Index triangle) const { return displacement_[triangle]; }

    /// That of all triangles.                                                                 [m]
    [[nodiscard]] const std::vector<double>& displacements() const { return displacement_; }

    /// Likewise at the end of the step ahead, if nodes go on as they did (after follow()), age() then
    /// being age_ahead(); after foresee(), age() being what it is, for what they do.       [m]
    [[nodiscard]] const std::vector<double>& displacement_bounds() const {
        return displacement_bound_;
    }

    /// How far at most a node will be from its prediction after the step ahead, over its slack. [m]
    [[nodiscard]] double stray() const { return stray_; }
    /// Share of the budget that a node has for itself: above 1 where it flutters.             [-]
    [[nodiscard]] double slack(Index node) const { return slack_[node]; }
    [[nodiscard]] const Vec3& velocity(Index node) const {
        return velocity_[node];
    }                                                  ///< predicted [m/s]
    [[nodiscard]] double fastest() const;              ///< of them  [m/s]
    [[nodiscard]] double age() const { return age_; }  ///< of the prediction                  [s]
    /// Likewise at the end of the step that was followed last.                                [s]
    [[nodiscard]] double age_ahead() const { return age_ahead_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(base_, last_, velocity_, relative_, common_, t_, age_, stray_, displacement_,
                displacement_bound_, node_deviation_, age_ahead_, slack_, strays_);
    }

private:
    const Cloth& cloth_;
    const Pieces& pieces_;
    Points base_, last_;          ///< positions at the restart and at the last call, N × 3   [m]
    Points velocity_, relative_;  ///< predicted, and ahead; less that of all, N × 3          [m/s]
    Vec3 common_ = Vec3::Zero();  ///< mean displacement of all since the restart             [m]
    double t_ = 0.0, age_ = 0.0, age_ahead_ = 0.0;  ///< [s]
    double stray_ = 0.0;                            ///< [m]
    std::vector<double> displacement_,
        displacement_bound_;            ///< by triangle                                [m]
    std::vector<double> node_stepped_;  ///< by node: way from its prediction in the last step [m]
    /// By node, as foreseen last: speed, less that of all, and against its prediction.     [m/s]
    std::vector<double> node_speed_, node_deviation_;
    std::vector<double> chunk_stray_;
    std::vector<double> slack_, strays_;  ///< by node: share of the budget, and what it uses   [m]
};

}  // namespace corpuscle::contact
