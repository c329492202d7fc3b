// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gas/flight.hpp"

namespace corpuscle::gas {

/// Impulse on its way from particles to fabric.
///
/// One hit on a light facet is a kick of tens of m/s, so what hits bring is owed to the nodes and
/// released at the rate owed / time: dP = owed (1 - exp(-dt / time)). Nothing is lost: what is owed
/// goes to the node in the end. Each hit is shared among its facet's nodes by barycentric weight. A
/// held node moves as it is told, whatever hits it: there impulse is passed on at once, so that the
/// work is done where it arose.
class ImpulseStore {
public:
    /// @param held  N: 1 for nodes that supports, motions or rigid bodies carry
    ImpulseStore(std::size_t node_count, std::span<const Index> nodes,
                 std::span<const std::uint8_t> held, double time);

    /// Takes in a step's hits, in their order.
    void receive(const FlightResult& flight, std::span<const Triangle> triangles);

    /// Takes in one impulse more, for a node of nodes().
    void owe(Index node, const Vec3& impulse) { owed_[node] += impulse; }

    /// Force that releases this span's share; f has a row a node, rows of nodes() are added to.
    void release(double span, std::span<Vec3> f);

    /// Work that the last release did: sum of force · v_mid · span.                           [J]
    [[nodiscard]] double work(std::span<const Vec3> v_mid, double span) const;

    /// Force of the last release on a node.                                                   [N]
    [[nodiscard]] const Vec3& force(Index node) const { return force_[node]; }

    /// Impulse still owed, all nodes.                                                         [N s]
    [[nodiscard]] Vec3 owed() const;
    [[nodiscard]] double time() const { return time_; }

private:
    std::vector<Index> nodes_;
    std::vector<std::uint8_t> held_;  ///< by place in nodes_
    double time_;              ///< [s]
    std::vector<Vec3> owed_;   ///< N × 3   [N s]
    std::vector<Vec3> force_;  ///< N × 3, of the last release  [N]
};

}  // namespace corpuscle::gas
