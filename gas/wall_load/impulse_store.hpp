// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gas/wall_load/expected_pressure.hpp"
#include "gas/flight/flight.hpp"

namespace corpuscle::gas {

/// Impulse on its way from particles to fabric.
///
/// One hit on a light facet is a kick of tens of m/s, so what hits bring is owed to the nodes,
/// shared by barycentric weight, and released smoothly. Nothing is lost: what is owed goes to the
/// node in the end.
/// - On the bag's surface the pressure that hits make one expect (expected_pressure.hpp) is given,
/// and
///   what is owed beyond it corrects it slowly: dP = p A dt + owed (1 - exp(-dt / (PATIENCE
///   time))). The mean is as prompt as `time`, the noise of single hits as low as PATIENCE times
///   that.
/// - Inside (tethers, valves), and of what is not from hits: dP = owed (1 - exp(-dt / time)).
/// - A held node moves as it is told, whatever hits it: there impulse is passed on at once, so that
/// the
///   work is done where it arose.
class ImpulseStore {
public:
    static constexpr double PATIENCE = 40.0;

    /// @param nodes  of all facets
    /// @param held   N: 1 for nodes that supports, motions or rigid bodies carry
    /// @param is_quiet  false: no pressure is expected, all is released within `time`
    ImpulseStore(std::size_t node_count, std::span<const Index> nodes, const Enclosure& enclosure,
                 std::span<const std::uint8_t> held, double time, bool is_quiet = true);

    /// Takes in a step's hits, in their order.
    void receive(const FlightResult& flight, std::span<const Triangle> triangles);

    /// Takes in one impulse more, for a node of nodes().
    void owe(Index node, const Vec3& impulse) { owed_[node] += impulse; }

    /// As if a gas of this pressure had long been there.   area: N × 3 [m^2]
    void begin_with(double pressure, std::span<const Vec3> area);
    /// Fabric has moved from x_0 to x_1 in dt: the next release is the less the faster a node
    /// leaves its neighbours outward (ExpectedPressure::feel_motion).
    void feel_motion(std::span<const Vec3> x_0, std::span<const Vec3> x_1, double dt,
                     std::span<const Vec3> area, double share_per_speed) {
        if (expected_.is_on()) expected_.feel_motion(x_0, x_1, dt, area, share_per_speed);
    }
    /// No more hits will come: what is owed goes on to be released.
    void end_of_hits() { expected_.stop(); }

    /// Force that releases this span's share; f has a row a node, rows of nodes() are added to.
    /// area: N × 3, of the enclosure's nodes [m^2]
    void release(double span, std::span<const Vec3> area, std::span<Vec3> f);

    /// Work that the last release did: sum of force · v_mid · span.                           [J]
    [[nodiscard]] double work(std::span<const Vec3> v_mid, double span) const;

    /// Force of the last release on a node.                                                   [N]
    [[nodiscard]] const Vec3& force(Index node) const { return force_[node]; }

    /// Impulse still owed, all nodes.                                                         [N s]
    [[nodiscard]] Vec3 owed() const;
    [[nodiscard]] double time() const { return time_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(expected_, arrived_, owed_, beyond_, force_);
    }

private:
    std::vector<Index> nodes_, surface_;  ///< rows: all; those of the enclosure
    std::vector<std::uint8_t> held_;      ///< by place in nodes_
    std::vector<std::uint8_t> is_quiet_;  ///< N: pressure is expected there
    double time_;                         ///< [s]
    ExpectedPressure expected_;
    std::vector<Vec3> arrived_;  ///< N × 3, by hits since the last release      [N s]
    std::vector<Vec3> owed_;     ///< N × 3, to be released within `time`        [N s]
    std::vector<Vec3> beyond_;   ///< N × 3, beyond what was expected            [N s]
    std::vector<Vec3> force_;    ///< N × 3, of the last release                 [N]
};

}  // namespace corpuscle::gas
