// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "gas/bag_state.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// The gas of a bag: particles (ParticleGas), after TSW uniform in every room (UniformGas).
///
/// A step calls add_load() and book_load() at t, then prepare(), collide(), inject() and fly() from
/// t to t + dt.
class GasPhase {
public:
    virtual ~GasPhase() = default;

    /// f += load of gas without particles, at t.                                         [N]
    virtual void add_load(const Points& x, Points& f) = 0;
    /// That load on a node.                                                              [N]
    [[nodiscard]] virtual Vec3 load_on(Index node) const = 0;
    /// Takes from the gas the work that the load has done on nodes that moved at v_mid.
    virtual void book_load(const Points& v_mid, double span) = 0;

    virtual void prepare(double dt, const Points& x_0, const Points& x_1) = 0;
    virtual void collide(double dt, const Points& x) = 0;
    virtual void inject(double t, double dt, const Points& x_0, const Points& x_1) = 0;
    virtual void fly(double t, double dt, const Points& x_0, const Points& x_1) = 0;

    [[nodiscard]] virtual double stable_step() const = 0;               ///< [s]
    [[nodiscard]] virtual double energy() const = 0;                    ///< [J]
    [[nodiscard]] virtual double pressure(std::size_t room) const = 0;  ///< that no particles bring
    /// Fills in masses, energies, pressure and temperature; volume and flows are set already.
    virtual void describe(GasState& now) const = 0;
    /// Adds each room's gas to one of the sums.
    /// @param volume  of each room                                                     [m^3]
    /// @param sum_of  row of the sum of each room, -1: none
    virtual void add_rooms(std::span<const double> volume, std::span<const Index> sum_of,
                           std::span<ChamberSum> sums) const = 0;
};

}  // namespace corpuscle::gas
