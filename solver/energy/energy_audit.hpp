// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/records.hpp"
#include "solver/scene/scene_state.hpp"

namespace corpuscle {

/// Books what a kick's forces have done, and says what there is at t.
class EnergyAudit {
public:
    /// Takes in the kick from v.before to nodes.v, after obstacles.
    void book(SceneState& scene, double span);
    /// At t.
    [[nodiscard]] static EnergyBooks books(const SceneState& scene);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(rubbed_, restored_);
    }

private:
    void book_forces(SceneState& scene, double span);
    void book_contact(SceneState& scene);
    void book_airbags(SceneState& scene, double span);
    void book_restored(SceneState& scene);
    static void book_impulses(SceneState& scene, double span);

    double rubbed_ = 0.0;    ///< by friction in contact, so far                       [J]
    double restored_ = 0.0;  ///< by TSRFAC                                            [J]
};

}  // namespace corpuscle
