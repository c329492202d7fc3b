// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/inflow/flow_curve.hpp"
#include "gas/thermo/species.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/fault.hpp"

namespace corpuscle::gas {

/// A particle on its way into the bag.
struct Entry {
    double time;           ///< [s]
    Vec3 velocity;         ///< relative to the orifice                                    [m/s]
    double internal;       ///< spin + vibration energy                                    [J]
    double energy;         ///< all that it brings, m u(T_stag), seen from the orifice      [J]
    std::int32_t inflow;   ///< row of the gas in BagCard::inflow
    std::int32_t orifice;  ///< row in BagCard::orifices
    std::int32_t id;       ///< 0, 1, 2, ... in the order of entry (time, then inflow)
};

/// All that flows into a bag, as particles that stand for equal numbers of moles (eq. 28, 29).
///
/// The k-th particle of a gas enters when its mass-flow curve has brought in k + 1/2 particle
/// masses, so the curve is followed within one particle at every instant, and so is each orifice's
/// share. A particle enters with u(T_stag) = h(T_static): translation 3/2 R T_stag / M, all of it
/// in one direction drawn evenly from the orifice's cone, the rest internal.
///
/// What has entered is a function of time alone, however time is cut into steps.
class Inflators {
public:
    /// @param volume  of the bag at the start: air that is particles (IAIR = 2) is its last species
    /// Errors: InputError with every fault found: a gas without a curve, orifice or flow, negative
    /// flow, T <= 0, heat capacities that make no gas in the range in use, too few particles for a
    /// gas.
    Inflators(const BagCard& card, std::span<const Curve> curves, std::uint64_t seed,
              double volume = 0.0);

    /// Appends all particles that enter until t_1 and have not been handed out before, by id.
    /// @param axis  the jet's direction at each orifice; zero: into every direction    [-]
    void entering(double t_1, std::span<const Vec3> axis, std::vector<Entry>& out);

    /// One an inflow, and one for the initial air where it is particles.
    [[nodiscard]] const std::vector<Species>& species() const { return species_; }
    [[nodiscard]] std::size_t inflows() const { return gases_.size(); }
    /// Particles of initial air.
    [[nodiscard]] std::size_t resident() const { return resident_; }
    [[nodiscard]] double moles_each() const { return moles_each_; }  ///< [mol]
    [[nodiscard]] std::size_t particles(std::size_t inflow) const {
        return gases_[inflow].particles;
    }
    [[nodiscard]] std::size_t particles() const;

    /// By the curve, not by particles: mass that an inflow has brought until t.             [kg]
    [[nodiscard]] double mass_until(std::size_t inflow, double t) const {
        return gases_[inflow].flow.sum_until(t);
    }
    /// Of what an inflow brings at t.                                                    [J/kg]
    [[nodiscard]] double enthalpy(std::size_t inflow, double t) const {
        return species_[inflow].h(gases_[inflow].temperature(t));
    }
    /// Momentum over mass of what an inflow brings at t through an orifice, relative to it: the
    /// mean over the jet's cone, sqrt(3 R T_stag / M) (1 + cos(cone)) / 2 along `axis`. [m/s]
    [[nodiscard]] Vec3 jet(std::size_t inflow, std::size_t orifice, double t,
                           const Vec3& axis) const;
    /// Share of an inflow that an orifice gets.                                             [-]
    [[nodiscard]] double share(std::size_t inflow, std::size_t orifice) const {
        return gases_[inflow].share[orifice];
    }
    [[nodiscard]] double ends() const;  ///< when the last curve ends                          [s]

    /// Range of temperatures that the gases' heat capacities were checked for.             [K]
    [[nodiscard]] double lowest_temperature() const { return low_; }
    [[nodiscard]] double highest_temperature() const { return high_; }

    /// All that changes as gas enters: particles handed out, inflow × orifice, by rows.
    [[nodiscard]] const std::vector<std::int64_t>& state() const { return given_; }
    void restore(std::vector<std::int64_t> state);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(given_);
    }

private:
    struct Gas {
        FlowCurve flow;
        Curve temperature;          ///< static                                          [K]
        std::vector<double> share;  ///< of each orifice, sums to 1
        std::size_t particles = 0;  ///< that will have entered in the end
    };
    struct Due {
        double time;
        std::int32_t inflow, orifice;
    };
    void add_gas(const BagCard& card, const InflowCard& inflow, const std::string& name,
                 std::span<const Curve> curves, std::vector<Fault>& faults);
    void add_air(const BagCard& card, double volume, std::vector<Fault>& faults);
    void share_particles(const BagCard& card, std::vector<Fault>& faults);
    [[nodiscard]] std::int64_t entered(std::size_t inflow) const;
    [[nodiscard]] double entry_time(std::size_t inflow, std::int64_t k) const;
    [[nodiscard]] std::int32_t next_orifice(std::size_t inflow) const;
    [[nodiscard]] Entry make(const Due& due, const Vec3& axis, std::int32_t id) const;
    [[nodiscard]] Vec3 draw_direction(const Vec3& axis, double cone, std::int32_t id) const;

    std::uint64_t seed_;
    double gas_constant_;
    double moles_each_ = NaN;
    double resident_moles_ = 0.0;
    std::size_t resident_ = 0;
    double low_ = NaN, high_ = NaN;
    std::vector<Species> species_;
    std::vector<Gas> gases_;
    std::vector<double> cone_;         ///< half angle of each orifice                  [rad]
    std::vector<std::int64_t> given_;  ///< inflow × orifice
    std::vector<Due> due_;             ///< scratch of entering()
};

}  // namespace corpuscle::gas
