// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/enclosure/chambers.hpp"
#include "gas/enclosure/enclosure.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/gas_balance.hpp"
#include "gas/gas_phase.hpp"
#include "gas/inflow/inflator.hpp"
#include "gas/inflow/orifices.hpp"
#include "gas/outflow/gas_state.hpp"
#include "gas/outflow/heat_loss.hpp"
#include "gas/outflow/openings.hpp"
#include "gas/outflow/wall_samples.hpp"
#include "gas/thermo/initial_air.hpp"
#include "gas/wall_load/wall_load.hpp"
#include "gas/wall_load/wall_monitor.hpp"
#include "solver/base/curve.hpp"

namespace corpuscle::gas {

/// What particle gas and uniform gas of a bag share: walls, inflow and outflow, the load on the
/// fabric, the balances.
struct Envelope {
    /// Arguments and errors: those of BagGas.
    Envelope(const BagCard& bag, BagWalls bag_walls, std::span<const Curve> curves,
             std::span<const int> node_id, std::span<const std::uint8_t> held, const Points& x,
             std::uint64_t seed, std::span<const Index> body);
    Envelope(const Envelope&) = delete;
    Envelope& operator=(const Envelope&) = delete;

    [[nodiscard]] std::string name() const;  ///< in the user's words
    [[nodiscard]] bool loses() const { return !openings.empty() || !heat_loss.empty(); }
    /// Jet reaction (IMOM = 1) of an impulse at an orifice that moves at `moving`: deferred impulse
    /// on the orifice's nodes. Its work on moving nodes is the inflator's: gas ejected forward
    /// enters with m v·w more energy than at rest, and the reaction does m v·w less work.
    ///                                                                          [N s], [m/s]
    void push_back(std::size_t orifice, const Vec3& at, const Vec3& impulse, const Vec3& moving);
    /// What the gas of rooms comes to, each added to one of `count` sums.
    /// @param sum_of  row of the sum of each room, -1: none
    [[nodiscard]] std::vector<ChamberState> sums_of_rooms(const GasPhase& gas,
                                                          std::span<const Index> sum_of,
                                                          std::size_t count, const Points& x) const;

    BagCard card;
    BagWalls walls;
    Enclosure enclosure;
    Chambers chambers;
    std::vector<Index> chamber_of_room;  ///< -1: in none
    Inflators inflators;
    std::vector<double> particle_mass;  ///< of one particle of each gas                 [kg]
    std::shared_ptr<const WettedSurface> surface;
    Orifices orifices;
    std::vector<Index> orifice_room;
    std::vector<Vec3> axes;  ///< of the orifices, in this step
    WallLoad load;
    WallSamples samples;  ///< where there are openings or heat is lost
    Openings openings;
    HeatLoss heat_loss;
    WallMonitor monitor;
    GasBalance balance;
    std::vector<InitialAir> air;  ///< of each room, or none
    std::vector<Inside> rooms;    ///< mean states, as openings see them
    Points area;                  ///< N × 3, node areas at t                           [m^2]
    std::vector<double> volumes;  ///< of rooms, at t                                   [m^3]
    double time = 0.0;            ///< to which gas has come in                         [s]
    std::vector<std::string> warnings;

    /// State for a checkpoint (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(inflators, air, load, samples, openings, heat_loss, monitor, balance, rooms, area,
                volumes, time);
    }

private:
    void fill_with_air(double volume);
    [[nodiscard]] std::vector<char> rooms_that_fill() const;
    void tell_vacuum(double volume);
    [[nodiscard]] std::string name_of_room(std::size_t room) const;
};

}  // namespace corpuscle::gas
