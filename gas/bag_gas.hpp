// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gas/bag_state.hpp"
#include "gas/envelope.hpp"
#include "gas/particle_gas.hpp"
#include "gas/uniform_gas.hpp"

namespace corpuscle::gas {

/// The gas of one bag and what it does to the walls: particles, which TSW makes a uniform gas.
///
///     bag.add_load(x, v, mass, span, f);                     // forces at t
///     bag.book_load(v_mid, span);                            // once nodes have been kicked
///     bag.prepare(dt, x_0, x_1);                             // nodes go from x_0 to x_1
///     bag.collide(dt, x_0);
///     bag.inject(t, dt, x_0, x_1);
///     bag.fly(t, dt, x_0, x_1);
class BagGas {
public:
    /// @param held  N: 1 for nodes that supports, motions or rigid bodies carry
    /// @param x     N × 3, at the start                                                 [m]
    /// Errors: InputError for walls that do not close, orifices outside, gases that are none.
    BagGas(const BagCard& card, BagWalls walls, std::span<const Curve> curves,
           std::span<const int> node_id, std::span<const std::uint8_t> held, const Points& x,
           std::uint64_t seed);

    /// f += impulse released over `span`, air pressure inside, atmosphere outside, at t.
    /// v: at the last half step [m/s]; mass: of the nodes [kg]
    void add_load(const Points& x, const Points& v, std::span<const double> mass, double span,
                  Points& f);
    /// Books the work that the load has just done on nodes that moved at v_mid.
    void book_load(const Points& v_mid, double span);

    /// All that the gas and the atmosphere do to a node at t.                                 [N]
    [[nodiscard]] Vec3 force(Index node) const {
        return bag_->load.force(node) - bag_->card.p_atm * bag_->area[node] + now().load_on(node);
    }

    /// Does contact close holes of this bag?
    [[nodiscard]] bool asks_for_contact() const {
        return bag_->card.block.any() && !bag_->openings.empty();
    }
    /// Nodes that touch something now, and what contact does to them, N × 3 [N]: takes effect in
    /// the next flight.
    void set_touching(std::span<const std::uint8_t> nodes, std::span<const Vec3> force);

    /// Facet lists for the step.
    void prepare(double dt, const Points& x_0, const Points& x_1) { now().prepare(dt, x_0, x_1); }
    void collide(double dt, const Points& x) { now().collide(dt, x); }
    void inject(double t, double dt, const Points& x_0, const Points& x_1);
    void fly(double t, double dt, const Points& x_0, const Points& x_1) {
        now().fly(t, dt, x_0, x_1);
    }

    /// Is it time (TSW) to go over to uniform pressure?
    [[nodiscard]] bool switches(double t) const;
    /// Sums up all particles, which freeze where they are.
    void become_uniform(const Points& x);
    [[nodiscard]] bool is_uniform() const { return uniform_ != nullptr; }

    /// Step in which a typical particle crosses half a cell: longer ones blur waves. [s]
    [[nodiscard]] double stable_step() const { return now().stable_step(); }

    [[nodiscard]] GasState state(const Points& x) const;
    /// Of each chamber, in the order of the cards.
    [[nodiscard]] std::vector<ChamberState> chamber_states(const Points& x) const;
    [[nodiscard]] double energy() const { return now().energy(); }  ///< all gas inside  [J]
    [[nodiscard]] double inflow_energy() const { return bag_->balance.inflow_energy; }
    [[nodiscard]] double lost_energy() const { return bag_->balance.lost_energy; }
    /// By hits and jets, less what came back and what the gas owes to others.                [J]
    [[nodiscard]] double smoothing_taken() const { return bag_->load.taken(); }
    /// To the fabric.                                                                        [J]
    [[nodiscard]] double smoothing_given() const { return bag_->balance.load_work; }
    [[nodiscard]] double ambient_work() const { return bag_->balance.ambient_work; }

    /// Mean pressure on each part over the time `since` the last call: impulse as delivered, and
    /// the air's.
    [[nodiscard]] PartState part_state(const Points& x, double since);
    /// Mean mass flow in since the last call.                                              [kg/s]
    [[nodiscard]] double mass_rate_in(double since) { return bag_->balance.rate_in(since); }
    [[nodiscard]] double mass_rate_out(double since) {  ///< the same, out               [kg/s]
        return bag_->balance.rate_out(
            bag_->openings.mass_out(true) + bag_->openings.mass_out(false), since);
    }
    /// Adds to each shell's `force` the mean gauge pressure since the last call times its area,
    /// and the area to `area`.                                                E [N], E [m^2]
    void add_shell_load(const Points& x, double since, std::span<double> force,
                        std::span<double> area);

    [[nodiscard]] const BagCard& card() const { return bag_->card; }
    [[nodiscard]] const BagWalls& walls() const { return bag_->walls; }
    [[nodiscard]] const Enclosure& enclosure() const { return bag_->enclosure; }
    [[nodiscard]] const Chambers& chambers() const { return bag_->chambers; }
    [[nodiscard]] const Openings& openings() const { return bag_->openings; }
    [[nodiscard]] const Particles& particles() const { return particles_->particles(); }
    [[nodiscard]] std::span<const double> particle_mass() const { return bag_->particle_mass; }
    /// Of particle i alone (Mixture::particle_temperature).                                [K]
    [[nodiscard]] double particle_temperature(std::size_t i) const {
        const Particles& all = particles();
        return particles_->mixture().particle_temperature(all.species[i], all.e[i],
                                                          all.v[i].squaredNorm());
    }
    [[nodiscard]] double moles_each() const { return bag_->inflators.moles_each(); }  ///< [mol]
    /// Of air that is no particles (IAIR 1, -1).                                           [Pa]
    [[nodiscard]] double initial_air_pressure() const {
        return uniform_ ? 0.0 : particles_->pressure();
    }
    /// The gas while it is particles; after TSW as it was then.
    [[nodiscard]] const ParticleGas& particle_gas() const { return *particles_; }
    [[nodiscard]] std::size_t lost() const { return particles_->lost(); }
    [[nodiscard]] const std::vector<std::string>& losses() const { return particles_->losses(); }
    [[nodiscard]] std::size_t hits() const { return particles_->hits(); }
    [[nodiscard]] std::size_t flights() const { return particles_->flights(); }
    [[nodiscard]] std::size_t unrelaxed() const { return particles_->unrelaxed(); }
    [[nodiscard]] std::uint64_t collision_steps() const { return particles_->collision_steps(); }
    [[nodiscard]] std::size_t list_builds() const { return particles_->list_builds(); }
    [[nodiscard]] const std::vector<std::string>& warnings() const { return bag_->warnings; }
    /// What the gas has given up at walls and the fabric has not yet got, when it has got `done` of
    /// the last load.
    [[nodiscard]] Wrench owed(double done = 1.0) const { return bag_->load.owed(done); }
    [[nodiscard]] double expected_share_in(double end_time) const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        bool is_uniform = uniform_ != nullptr;
        archive(is_uniform);
        archive(*bag_, *particles_, pressed_);
        if (is_uniform && !uniform_) uniform_ = std::make_unique<UniformGas>(*bag_);
        if (uniform_) archive(*uniform_);
    }

private:
    [[nodiscard]] GasPhase& now() {
        return uniform_ ? static_cast<GasPhase&>(*uniform_) : *particles_;
    }
    [[nodiscard]] const GasPhase& now() const {
        return uniform_ ? static_cast<const GasPhase&>(*uniform_) : *particles_;
    }
    [[nodiscard]] std::vector<double> room_pressures() const;

    std::unique_ptr<Envelope> bag_;
    std::unique_ptr<ParticleGas> particles_;
    std::unique_ptr<UniformGas> uniform_;  ///< after TSW
    std::vector<std::uint8_t> pressed_;    ///< N: nodes that contact presses harder than the gas
};

}  // namespace corpuscle::gas
