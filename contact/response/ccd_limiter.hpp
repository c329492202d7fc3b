// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "contact/candidates/candidates.hpp"
#include "contact/response/facet_load.hpp"
#include "contact/response/stopping_impulses.hpp"

namespace corpuscle::contact {

/// The last look before the cloth moves: no pair of nodes and triangles, or of edges, passes
/// through another between x and x + dt v.
///
/// Pairs with a time of impact in the step are stopped by impulses, for a few rounds; what still
/// collides then is joined into rigid impact zones for this step [Provot
/// 1997, impact zones], which always ends: nodes of one impact zone do not move against each other.
/// Momentum is kept, energy only lost. Pairs that touch exactly (gap 0) are beyond help.
class CcdLimiter {
public:
    explicit CcdLimiter(const Cloth& cloth);

    /// Changes velocities so that the step is safe. Pairs whose card is off at t are left alone.
    /// @param load  takes what stops the others
    void stop(double t, double dt, Candidates& pairs, StoppingImpulses& impulses, FacetLoad& load,
              VelocityState& motion);

    [[nodiscard]] std::size_t impacts() const { return impacts_; }  ///< stopped by impulses so far
    [[nodiscard]] std::size_t impact_zones() const { return zones_; }  ///< made so far

    /// Pairs that could not be stopped, summed over the steps: held nodes drive them through each
    /// other.
    [[nodiscard]] std::size_t unstopped() const { return unstopped_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(impacts_, zones_, unstopped_);
    }

private:
    struct Impact {
        std::size_t pair;  ///< candidate row
        double time;       ///< part of the step
    };

    bool stop_dangers(int rounds, double dt, Candidates& pairs, StoppingImpulses& impulses,
                      FacetLoad& load, VelocityState& motion);
    void list_dangers(double t, double dt, const Candidates& pairs, const VelocityState& motion);
    void find_impacts(std::size_t chunk, double dt, const Candidates& pairs,
                      const VelocityState& motion);
    [[nodiscard]] bool has_impacts() const;
    void stop_impacts(double dt, const Candidates& pairs, StoppingImpulses& impulses,
                      FacetLoad& load, VelocityState& motion);
    bool join_zones(const Candidates& pairs, StoppingImpulses& impulses, VelocityState& motion);
    Index root(Index node);
    /// @returns whether they were of two impact zones before
    bool unite(Index node, Index other) {
        const Index a = root(node), b = root(other);
        parent_[std::max(a, b)] = std::min(a, b);
        return a != b;
    }
    /// A body's nodes change together: its first one speaks for all.
    [[nodiscard]] Index speaker(Index node) const {
        const Index body = cloth_.body[node];
        return body < 0 ? node : cloth_.nodes_of_body(body).front();
    }
    void mark(Index node) { changed_[speaker(node)] = round_; }

    const Cloth& cloth_;
    std::vector<double> mass_;  ///< by node row; of free nodes                    [kg]
    std::vector<std::vector<std::size_t>> near_;  ///< by chunk: candidates that may meet
    std::vector<std::vector<Impact>> found_;      ///< by chunk
    std::vector<unsigned> changed_;  ///< round in which a node's velocity was changed last
    unsigned round_ = 0, checked_ = 0;
    std::vector<Index> parent_;  ///< of a node in its impact zone
    std::vector<Index> joined_;  ///< nodes in impact zones
    bool is_hub_ = false;        ///< all that hits a body, wherever, is one impact zone with it
    std::size_t impacts_ = 0, zones_ = 0, unstopped_ = 0;
};

}  // namespace corpuscle::contact
