// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gas/enclosure/node_points.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/thermo/control_volume.hpp"

namespace corpuscle::gas {

/// Rooms of a bag, a pressure of its own in each.
class UniformRooms {
public:
    /// @param rooms  one of each room of the surface
    UniformRooms(std::shared_ptr<const WettedSurface> surface, std::vector<ControlVolume> rooms,
                 std::size_t node_count);

    [[nodiscard]] std::size_t size() const { return rooms_.size(); }
    [[nodiscard]] ControlVolume& operator[](std::size_t room) { return rooms_[room]; }
    [[nodiscard]] const ControlVolume& operator[](std::size_t room) const { return rooms_[room]; }

    /// State of every room at t, of these volumes. False when one has none (ControlVolume::settle).
    [[nodiscard]] bool settle(std::span<const Vec3> x, std::span<const double> volume);
    void add_force(std::span<Vec3> f) const;  ///< p A of all rooms, as they were settled  [N]
    void work(std::span<const Vec3> v_mid, double span);  ///< books that of the force
    [[nodiscard]] const Vec3& force(Index node) const { return force_[node]; }  ///< [N]

    [[nodiscard]] double energy() const;                     ///< [J]
    [[nodiscard]] double mass() const;                       ///< [kg]
    [[nodiscard]] double moles(std::size_t species) const;   ///< of all rooms               [mol]
    [[nodiscard]] double energy(std::size_t species) const;  ///< of all rooms               [J]
    [[nodiscard]] double pressure() const;                   ///< sum of p V over that of V  [Pa]
    /// At which all rooms' gas at rest would hold its energy.                                [K]
    [[nodiscard]] double temperature() const;

    /// Takes a mass from one room to another, with its enthalpy.                            [kg]
    void pass(std::size_t from, std::size_t to, double mass);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        for (ControlVolume& room : rooms_) archive(room);
        archive(area_, force_);
    }

private:
    [[nodiscard]] Vec3 force_on(std::size_t row) const;

    std::shared_ptr<const WettedSurface> surface_;
    std::vector<ControlVolume> rooms_;
    NodePoints by_node_;
    Points area_;   ///< points × 3, at t                                                [m^2]
    Points force_;  ///< N × 3, at t                                                     [N]
};

/// Mass that evens out the pressures of two rooms of ideal gas, to first order.             [kg]
///
///     (p_1 - p_2) / (g R T_1 / M (1/V_1 + 1/V_2))
[[nodiscard]] double evening_mass(const ControlVolume& from, const ControlVolume& to);

}  // namespace corpuscle::gas
