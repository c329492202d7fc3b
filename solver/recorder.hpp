// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "solver/records.hpp"
#include "solver/scene/scene_state.hpp"

namespace corpuscle {

/// What a run hands to its results: means are over the time since the last sample or frame.
class Recorder {
public:
    /// Ids and names of the entries of samples and frames; constant in a run.
    [[nodiscard]] static RecordLayout layout(const SceneState& scene);
    /// One row of every history at t, inside an observer.
    [[nodiscard]] Sample sample(SceneState& scene);
    /// The same between two samples, of which the next one knows nothing; means are since the last.
    [[nodiscard]] Sample glance(const SceneState& scene) const;
    /// One state for pictures at t, inside an observer.
    [[nodiscard]] Frame frame(SceneState& scene);
    /// Of contact and gas on a body, in the kick at t.                               [N]
    [[nodiscard]] static Vec3 force_on(const SceneState& scene, const RigidBody& body);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(last_sample_, last_frame_);
    }

private:
    [[nodiscard]] static Sample row_at_t(const SceneState& scene,
                                         std::span<const gas::PartState> parts);

    double last_sample_ = 0.0, last_frame_ = 0.0;  ///< [s]
};

}  // namespace corpuscle
