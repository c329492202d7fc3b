// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gas/bag_state.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/wall_load/wall_hits.hpp"

namespace corpuscle::gas {

/// What parts and shells feel of a bag's gas, as means between two looks: impulse as particles
/// deliver it, unsmoothed, and the pressure that no particles bring.
class WallMonitor {
public:
    /// @param is_rough  hits push along the fabric, too
    WallMonitor(std::shared_ptr<const WettedSurface> surface, const BagWalls& walls, bool is_rough);

    /// Adds up what a flight's hits give to triangles along their normals, outward on the closing
    /// ones.
    void record(const WallHits& hits, std::span<const Vec3> x_1);
    /// Adds up the pressure that no particles bring, by room at t, over the time since the last
    /// call.                                                                        [Pa], [s]
    void record(std::span<const double> room_pressure, double t);

    /// Mean pressure and area of each part since the last call; of a part without area 0.
    /// @param since          0: as `room_pressure` is now                              [s]
    void part_means(const BagWalls& walls, std::span<const Vec3> x, double since,
                    std::span<const double> room_pressure, PartState& parts);
    /// Adds to the load on each shell the mean gauge pressure since the last call times its area.
    void add_shell_means(const BagWalls& walls, double p_atm, std::span<const Vec3> x, double since,
                         std::span<const double> room_pressure, ShellLoad& load);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(impulse_, part_impulse_, triangle_impulse_, part_air_, triangle_air_, until_);
    }

private:
    [[nodiscard]] double across(std::size_t facet, std::span<const double> of_room) const;
    void share_out();

    std::shared_ptr<const WettedSurface> surface_;
    bool is_rough_;
    std::vector<Index> part_;                              ///< of each triangle
    std::vector<double> impulse_;                          ///< of each side, not yet in:     [N s]
    std::vector<double> part_impulse_, triangle_impulse_;  ///< since the last look   [N s]
    std::vector<double> part_air_, triangle_air_;          ///< by room, integral of pressure [Pa s]
    double until_ = 0.0;                                   ///< to which these go             [s]
};

}  // namespace corpuscle::gas
