// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gas/bag_state.hpp"
#include "gas/cards/bag.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/wall_load/wrench.hpp"
#include "solver/base/curve.hpp"

namespace corpuscle {
class StateReader;
class StateWriter;
}  // namespace corpuscle

/// Gas of airbags: particles that obey kinetic theory, or a uniform gas; inflow, vents, leaks.
namespace corpuscle::gas {

class Chambers;
class Enclosure;
class GasPhase;
class Openings;
class ParticleGas;
class UniformGas;
struct Envelope;
struct Particles;

/// The gas of one bag and its load on the walls: particles, from TSW on a uniform gas.
///
///     bag.add_load(x, v, mass, span, f);                     // forces at t
///     bag.book_load(v_mid, span);                            // once nodes have been kicked
///     bag.prepare(dt, x_0, x_1);                             // nodes go from x_0 to x_1
///     bag.collide(dt, x_0);
///     bag.inject(t, dt, x_0, x_1);
///     bag.fly(t, dt, x_0, x_1);
class BagGas {
public:
    /// @param walls    of the bag, with the shells and parts that they are of
    /// @param curves   to which the card's curve rows refer
    /// @param node_id  N: the deck's, for messages
    /// @param held     N: 1 for nodes moved by supports, prescribed motions or rigid bodies
    /// @param x        N × 3, at the start                                              [m]
    /// @param seed     of its random numbers: bags of one seed draw the same
    /// @param body     N: row of a node's rigid body that can rotate, or -1; empty: none
    /// @throws InputError  for walls that are not closed, orifices outside, impossible gases
    BagGas(const BagCard& card, BagWalls walls, std::span<const Curve> curves,
           std::span<const int> node_id, std::span<const std::uint8_t> held, const Points& x,
           std::uint64_t seed, std::span<const Index> body = {});
    /// What was moved from may only be assigned to or destroyed.
    BagGas(BagGas&&) noexcept;
    /// Likewise.
    BagGas& operator=(BagGas&&) noexcept;
    ~BagGas();

    /// f += impulse released over `span`, air pressure inside, atmosphere outside, at t.
    /// @throws PhysicsError  at uniform pressure, for an impossible volume or energy
    /// v: at the last half step [m/s]; mass: of the nodes [kg]
    void add_load(const Points& x, const Points& v, std::span<const double> mass, double span,
                  Points& f);
    /// Books the work that the load has just done over `span` [s] on nodes that moved at v_mid, the
    /// mean of before and after the kick.                                                 [m/s]
    void book_load(const Points& v_mid, double span);

    /// Force of gas and atmosphere on a node at t.                                            [N]
    [[nodiscard]] Vec3 force(Index node) const;

    /// Whether contact closes holes of this bag (BLOCK).
    [[nodiscard]] bool asks_for_contact() const;
    /// Takes the nodes in contact now, and the contact forces on nodes, N × 3 [N], for the next
    /// flight.
    void set_touching(std::span<const std::uint8_t> nodes, std::span<const Vec3> force);

    /// Prepares the facet lists of the step; rebuilds them if the fabric has moved too far.
    /// @throws PhysicsError  for fabric that moves many times the bag's size in the step
    void prepare(double dt, const Points& x_0, const Points& x_1);
    /// Collides particles within their groups and exchanges heat with the initial air; not in every
    /// step, but once a typical particle has crossed an eighth of a cell. After TSW nothing.
    /// @throws PhysicsError  for a particle that is not finite
    void collide(double dt, const Points& x);
    /// Inflow from t to t + dt; after TSW also outflow.
    /// @throws PhysicsError  for fabric that passes over an orifice, inflow that is not finite
    void inject(double t, double dt, const Points& x_0, const Points& x_1);
    /// Moves particles over dt with reflections at the walls, gives their impulse to the walls, and
    /// removes outflow and heat loss. After TSW nothing.
    /// @throws PhysicsError  for a particle that is not finite
    void fly(double t, double dt, const Points& x_0, const Points& x_1);

    /// Whether TSW, the time of the switch to uniform pressure, is reached.
    [[nodiscard]] bool switches(double t) const;
    /// Switches to uniform pressure: sums up all particles, which freeze in place; nodes move from
    /// x_0 to x_1 in dt. The energy of motion with the walls, P·w - m w²/2, w their mean velocity
    /// in each room, is booked as lost.
    void become_uniform(double dt, const Points& x_0, const Points& x_1);
    /// Whether become_uniform() has taken place.
    [[nodiscard]] bool is_uniform() const { return uniform_ != nullptr; }

    /// Time in which a typical particle crosses an eighth of a cell: longer steps blur waves. INF
    /// after TSW.                                                                               [s]
    [[nodiscard]] double stable_step() const;

    /// State of the gas of all rooms together, nodes at x.
    [[nodiscard]] GasState state(const Points& x) const;
    /// State of each chamber, in the order of the cards; empty without chambers.
    [[nodiscard]] std::vector<ChamberState> chamber_states(const Points& x) const;
    /// State of the room that a place in the bag lies in.
    [[nodiscard]] ChamberState room_state(const Vec3& at, const Points& x) const;
    [[nodiscard]] double energy() const;  ///< all gas inside  [J]
    /// Energy brought by inflow and ambient air so far.                                       [J]
    [[nodiscard]] double inflow_energy() const;
    /// All energy that the gas ever had: at the start, and what came in since.             [J]
    [[nodiscard]] double energy_had() const { return energy_at_start_ + inflow_energy(); }
    /// Energy lost so far: through openings, as heat, with lost particles.                    [J]
    [[nodiscard]] double lost_energy() const;
    /// Energy taken by hits and jets, less what was paid back and the gas's other debts.     [J]
    [[nodiscard]] double smoothing_taken() const;
    /// Work of the released load on the fabric.                                              [J]
    [[nodiscard]] double smoothing_given() const;
    /// Work against the atmosphere so far: p_atm times the change of volume.                  [J]
    [[nodiscard]] double ambient_work() const;

    /// Mean pressure on each part over the time `since` the last call: unsmoothed impulse of hits,
    /// and the initial air's pressure; of a part without area 0.
    [[nodiscard]] PartState part_state(const Points& x, double since);
    /// The same, without becoming the last call.
    [[nodiscard]] PartState part_state_so_far(const Points& x, double since) const;
    /// Adds to the load on each shell the mean gauge pressure since the last call times its area.
    void add_shell_load(const Points& x, double since, ShellLoad& load);

    /// The card of the bag.
    [[nodiscard]] const BagCard& card() const;
    /// The walls of the bag.
    [[nodiscard]] const BagWalls& walls() const;
    /// The surface of the closing facets.
    [[nodiscard]] const Enclosure& enclosure() const;
    /// Chambers; empty without *DEFINE_CPM_CHAMBER.
    [[nodiscard]] const Chambers& chambers() const;
    /// Vents and porous fabric.
    [[nodiscard]] const Openings& openings() const;
    /// Particles inside; after TSW where they froze.
    [[nodiscard]] const Particles& particles() const;
    /// Mass of one particle, by row in Particles::species.                                   [kg]
    [[nodiscard]] std::span<const double> particle_mass() const;
    /// Temperature of particle i alone (Mixture::particle_temperature).                    [K]
    [[nodiscard]] double particle_temperature(std::size_t i) const;
    [[nodiscard]] double moles_each() const;  ///< [mol]
    /// Pressure of initial air without particles (IAIR 1, -1) in the room of a place.      [Pa]
    [[nodiscard]] double initial_air_pressure(const Vec3& at, const Points& x) const;
    /// The gas while it is particles; after TSW as it was then.
    [[nodiscard]] const ParticleGas& particle_gas() const;
    /// Particles removed so far because closing facets had caught them.
    [[nodiscard]] std::size_t lost() const;
    /// Particle, time and place of the first of them, a sentence each.
    [[nodiscard]] const std::vector<std::string>& losses() const;
    /// Hits of particles on facets so far.
    [[nodiscard]] std::size_t hits() const;
    /// Flights so far: one a particle and step.
    [[nodiscard]] std::size_t flights() const;
    /// Groups so far whose energy had no temperature; they were left unchanged.
    [[nodiscard]] std::size_t unrelaxed() const;
    /// Steps so far in which particles collided.
    [[nodiscard]] std::uint64_t collision_steps() const;
    /// Lists of facets in cells built so far, for flight and for collisions.
    [[nodiscard]] std::size_t list_builds() const;
    /// Remarks for the user about the bag as it was built, a sentence each.
    [[nodiscard]] const std::vector<std::string>& warnings() const;
    /// Deferred momentum: given up by the gas at walls, not yet released to the fabric, after the
    /// share `done` of the last load.
    [[nodiscard]] Wrench owed(double done = 1.0) const;
    [[nodiscard]] double load_delay() const;  ///< of particles' impulse (LoadTimes)           [s]
    /// Share of the inflators' total mass that enters until `end_time` [s]; 1 without any.    [-]
    [[nodiscard]] double expected_share_in(double end_time) const;

    /// State for a checkpoint (solver/base/archive.hpp).
    void visit_state(StateWriter& archive);
    /// Reads the state of a bag that was built from the same card, walls and nodes.
    /// @throws SystemError  where the bytes end too early or do not fit the bag
    void visit_state(StateReader& archive);

private:
    template <class Archive>
    void visit(Archive& archive);
    [[nodiscard]] GasPhase& now();
    [[nodiscard]] const GasPhase& now() const;
    [[nodiscard]] std::vector<double> room_pressures() const;
    [[nodiscard]] PartState part_losses() const;

    std::unique_ptr<Envelope> bag_;
    std::unique_ptr<ParticleGas> particles_;
    std::unique_ptr<UniformGas> uniform_;  ///< after TSW
    std::vector<std::uint8_t> pressed_;    ///< N: nodes that contact presses harder than the gas
    double energy_at_start_ = 0.0;         ///< [J]
};

}  // namespace corpuscle::gas
