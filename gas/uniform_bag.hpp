// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gas/bag_gas.hpp"
#include "gas/cards/uniform_card.hpp"
#include "gas/enclosure/enclosure.hpp"
#include "gas/gas_balance.hpp"
#include "gas/inflow/flow_curve.hpp"
#include "gas/thermo/control_volume.hpp"

namespace corpuscle::gas {

/// A bag that holds one gas at uniform pressure and never any particles.
///
///     dE = cp T_in dm_in - cp T dm_out - p dV,   V = VSCA V_mesh - VINI,
///     load on the fabric: PSCA (p - p_atm)
///
/// Gas flows out by orifice_flow(), or by a curve of gauge pressure. A bag with a VolumeLaw has no
/// gas: mass, temperature and energy are 0, and the work of its load comes from outside.
class UniformBag {
public:
    /// @param walls    all closing
    /// @param curves   to which the card's curve rows refer
    /// @param node_id  N: the deck's, for messages
    /// @param x        N × 3, at the start                                                    [m]
    /// @throws InputError  for a surface that is not closed, or no initial gas
    UniformBag(const UniformBagCard& card, BagWalls walls, std::span<const Curve> curves,
               std::span<const int> node_id, const Points& x);

    /// f += load at t.                                                                      [N]
    /// @throws PhysicsError  for an impossible volume or energy
    void add_load(double t, const Points& x, Points& f);
    /// Books the work that the load has just done over `span` [s] on nodes that moved at v_mid.
    void book_load(const Points& v_mid, double span);
    /// Inflow and outflow, t -> t + dt.
    void flow(double t, double dt);
    /// Moves gas with its enthalpy to another bag of the same gases.                    [kg]
    void give(double mass, double dt, UniformBag& to);

    /// Force of gas and atmosphere on a node at t.                                           [N]
    [[nodiscard]] Vec3 force(Index node) const { return gauge() * area_[node]; }
    /// Time in which a five-hundredth of the gas leaves. [s]
    [[nodiscard]] double stable_step() const;

    /// State of the bag at t, area with nodes at x; without outflow so far (mass_out()). With a
    /// VolumeLaw volume, area and gauge pressure alone.
    [[nodiscard]] GasState state(const Points& x) const;
    /// Of each part: its area with nodes at x, and PSCA times pressure(); mass out and heat are 0.
    [[nodiscard]] PartState part_state(const Points& x) const;
    /// Adds to the load on each shell the mean of PSCA (p - p_atm) since the last call times its
    /// area.
    void add_shell_load(const Points& x, double since, ShellLoad& load);

    [[nodiscard]] double energy() const { return gas_.energy(); }  ///< inside, at t        [J]
    /// Energy of the inflow so far.                                                         [J]
    [[nodiscard]] double inflow_energy() const { return inflow_energy_; }
    /// Energy of the outflow so far.                                                        [J]
    [[nodiscard]] double outflow_energy() const { return outflow_energy_; }
    /// Work against the atmosphere so far.                                                  [J]
    [[nodiscard]] double ambient_work() const { return ambient_work_; }
    /// Work created (or removed) by the factors VSCA, PSCA and by a VolumeLaw.              [J]
    [[nodiscard]] double scaling_work() const { return scaling_work_; }

    [[nodiscard]] double mass_in() const { return mass_in_; }    ///< come in so far  [kg]
    [[nodiscard]] double mass_out() const { return mass_out_; }  ///< gone out so far  [kg]
    [[nodiscard]] double rate_in() const { return rate_in_; }    ///< in the last step   [kg/s]
    [[nodiscard]] double rate_out() const { return rate_out_; }  ///< in the last step   [kg/s]

    /// The card of the bag.
    [[nodiscard]] const UniformBagCard& card() const { return card_; }
    /// The walls of the bag, all closing.
    [[nodiscard]] const BagWalls& walls() const { return walls_; }
    /// The closed surface of its walls.
    [[nodiscard]] const Enclosure& enclosure() const { return enclosure_; }
    [[nodiscard]] const ControlVolume& gas() const { return gas_; }  ///< none with a VolumeLaw
    /// Absolute, at t; that of a VolumeLaw is gauge.                                        [Pa]
    [[nodiscard]] double pressure() const { return card_.law ? law_pressure_ : gas_.pressure(); }
    /// Remarks for the user about the bag as it was built, a sentence each.
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

    /// State for a checkpoint (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(gas_, area_, exit_area_, leak_area_, is_open_, mass_in_, mass_out_, rate_in_,
                rate_out_, inflow_energy_, outflow_energy_, ambient_work_, scaling_work_,
                gauge_since_frame_);
    }

private:
    [[nodiscard]] double volume(const Points& x) const {
        return card_.volume_scale * enclosure_.volume(x) - card_.volume_taken;
    }
    [[nodiscard]] double gauge() const {  ///< load per area                                [Pa]
        return card_.pressure_scale * (pressure() - card_.p_atm);
    }
    [[nodiscard]] double value(const CurveOr& of, double at) const {
        return of.curve >= 0 ? curves_[of.curve](at) : of.value;
    }
    void fill(double V);
    void follow_law(double t, const Points& x);
    void measure_exits(const Points& x);
    [[nodiscard]] double leak_rate(double t) const;
    void flow_in(double t, double dt);
    void flow_out(double t, double dt);
    [[nodiscard]] double exit_rate(double t) const;

    UniformBagCard card_;
    BagWalls walls_;
    Enclosure enclosure_;
    std::vector<Curve> curves_;
    ControlVolume gas_;
    std::vector<double> exit_area_;  ///< of exits that are shells, at t; of others 0      [m^2]
    std::vector<double> leak_area_;  ///< of leaks of the walls, at t                      [m^2]
    std::vector<double> first_leak_area_;  ///< at the start                               [m^2]
    std::vector<UniformGasCard> gases_;
    std::vector<std::optional<FlowCurve>> inflow_;  ///< by gas
    Points area_;  ///< N × 3, node areas at t                                            [m^2]
    double first_volume_ = NaN, law_volume_ = NaN;  ///< at the start; at t, of a VolumeLaw [m^3]
    double law_pressure_ = 0.0;                     ///< [Pa]
    bool is_open_ = false;                          ///< PPOP has been reached
    double mass_in_ = 0.0, mass_out_ = 0.0, rate_in_ = 0.0, rate_out_ = 0.0;
    double inflow_energy_ = 0.0, outflow_energy_ = 0.0, ambient_work_ = 0.0, scaling_work_ = 0.0;
    TimeIntegral gauge_since_frame_;  ///< [Pa s]
    std::vector<std::string> warnings_;
};

}  // namespace corpuscle::gas
