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
    /// @param walls    of the bag, with the shells and parts that they are of
    /// @param curves   that the card's rows mean
    /// @param node_id  N: the deck's, for messages
    /// @param held     N: 1 for nodes that supports, motions or rigid bodies carry
    /// @param x        N × 3, at the start                                              [m]
    /// @param seed     of the run
    /// @param body     N: row of the rigid body that carries a node and can turn, or -1; empty: none
    /// @throws InputError  for walls that do not close, orifices outside, gases that are none
    BagGas(const BagCard& card, BagWalls walls, std::span<const Curve> curves,
           std::span<const int> node_id, std::span<const std::uint8_t> held, const Points& x,
           std::uint64_t seed, std::span<const Index> body = {});
    /// What was moved from may only be assigned to or destroyed.
    BagGas(BagGas&&) noexcept;
    /// Likewise.
    BagGas& operator=(BagGas&&) noexcept;
    ~BagGas();

    /// f += impulse released over `span`, air pressure inside, atmosphere outside, at t.
    /// @throws PhysicsError  at uniform pressure, for a volume or an energy that no gas has
    /// v: at the last half step [m/s]; mass: of the nodes [kg]
    void add_load(const Points& x, const Points& v, std::span<const double> mass, double span,
                  Points& f);
    /// Books the work that the load has just done over `span` [s] on nodes that moved at v_mid, the
    /// mean of before and after the kick.                                                 [m/s]
    void book_load(const Points& v_mid, double span);

    /// All that the gas and the atmosphere do to a node at t.                                 [N]
    [[nodiscard]] Vec3 force(Index node) const;

    /// Does contact close holes of this bag?
    [[nodiscard]] bool asks_for_contact() const;
    /// Nodes that touch something now, and what contact does to them, N × 3 [N]: takes effect in
    /// the next flight.
    void set_touching(std::span<const std::uint8_t> nodes, std::span<const Vec3> force);

    /// Facet lists for the step, made anew when the fabric has moved too far for the last ones.
    /// @throws PhysicsError  for fabric that goes many times the bag's size in the step
    void prepare(double dt, const Points& x_0, const Points& x_1);
    /// Particles trade momentum and energy within their groups, and heat with the initial air; not
    /// in every step, but once a typical particle has crossed an eighth of a cell. After TSW nothing.
    /// @throws PhysicsError  for a particle that is not finite
    void collide(double dt, const Points& x);
    /// Lets in what the inflators give from t to t + dt; after TSW it lets out as well.
    /// @throws PhysicsError  for fabric that passes over an orifice, inflow that is not finite
    void inject(double t, double dt, const Points& x_0, const Points& x_1);
    /// Moves particles over dt, from wall to wall, hands their impulse to the walls, and takes out
    /// what leaves and the heat lost. After TSW nothing.
    /// @throws PhysicsError  for a particle that is not finite
    void fly(double t, double dt, const Points& x_0, const Points& x_1);

    /// Is it time (TSW) to go over to uniform pressure?
    [[nodiscard]] bool switches(double t) const;
    /// Sums up all particles, which freeze where they are; nodes go on from x_0 to x_1 in dt. What
    /// the gas has as motion with the walls, at their mean velocity w in each room, leaves the bag:
    /// P·w - m w²/2 is booked as lost.
    void become_uniform(double dt, const Points& x_0, const Points& x_1);
    /// Whether become_uniform() has taken place.
    [[nodiscard]] bool is_uniform() const { return uniform_ != nullptr; }

    /// Step in which a typical particle crosses an eighth of a cell: longer ones blur waves. INF
    /// after TSW.                                                                               [s]
    [[nodiscard]] double stable_step() const;

    /// The gas of all rooms together, nodes at x.
    [[nodiscard]] GasState state(const Points& x) const;
    /// Of each chamber, in the order of the cards; empty without chambers.
    [[nodiscard]] std::vector<ChamberState> chamber_states(const Points& x) const;
    [[nodiscard]] double energy() const;  ///< all gas inside  [J]
    /// That inflow and ambient air have brought so far.                                       [J]
    [[nodiscard]] double inflow_energy() const;
    /// That has left so far: through openings, as heat, with lost particles.                  [J]
    [[nodiscard]] double lost_energy() const;
    /// By hits and jets, less what came back and what the gas owes to others.                [J]
    [[nodiscard]] double smoothing_taken() const;
    /// To the fabric.                                                                        [J]
    [[nodiscard]] double smoothing_given() const;
    /// Of the walls against the atmosphere so far: p_atm times the volume that they swept.    [J]
    [[nodiscard]] double ambient_work() const;

    /// Mean pressure on each part over the time `since` the last call: impulse as delivered, and
    /// the air's.
    [[nodiscard]] PartState part_state(const Points& x, double since);
    /// Mean mass flow in since the last call.                                              [kg/s]
    [[nodiscard]] double mass_rate_in(double since);
    [[nodiscard]] double mass_rate_out(double since);  ///< the same, out               [kg/s]
    /// Adds to each shell's `force` the mean gauge pressure since the last call times its area,
    /// and the area to `area`.                                                E [N], E [m^2]
    void add_shell_load(const Points& x, double since, std::span<double> force,
                        std::span<double> area);

    /// As the bag was built with it.
    [[nodiscard]] const BagCard& card() const;
    /// As the bag was built with them.
    [[nodiscard]] const BagWalls& walls() const;
    /// The surface of the closing facets.
    [[nodiscard]] const Enclosure& enclosure() const;
    /// Empty: the bag has none.
    [[nodiscard]] const Chambers& chambers() const;
    /// Vents and fabric that leaks.
    [[nodiscard]] const Openings& openings() const;
    /// Those inside; after TSW where they froze.
    [[nodiscard]] const Particles& particles() const;
    /// Of one particle, by row in Particles::species.                                        [kg]
    [[nodiscard]] std::span<const double> particle_mass() const;
    /// Of particle i alone (Mixture::particle_temperature).                                [K]
    [[nodiscard]] double particle_temperature(std::size_t i) const;
    [[nodiscard]] double moles_each() const;  ///< [mol]
    /// Of air that is no particles (IAIR 1, -1).                                           [Pa]
    [[nodiscard]] double initial_air_pressure() const;
    /// The gas while it is particles; after TSW as it was then.
    [[nodiscard]] const ParticleGas& particle_gas() const;
    /// Particles taken out so far because closing facets had caught them between each other.
    [[nodiscard]] std::size_t lost() const;
    /// Particle, time and place of the first of them, a sentence each.
    [[nodiscard]] const std::vector<std::string>& losses() const;
    /// Hits of particles on facets so far.
    [[nodiscard]] std::size_t hits() const;
    /// Flights so far: a particle's way through one step counts once.
    [[nodiscard]] std::size_t flights() const;
    /// Groups so far whose energy belonged to no temperature; it stayed as it was.
    [[nodiscard]] std::size_t unrelaxed() const;
    /// Steps so far in which particles collided.
    [[nodiscard]] std::uint64_t collision_steps() const;
    /// Lists of facets in cells built so far, for flight and for collisions.
    [[nodiscard]] std::size_t list_builds() const;
    /// What the user should know of the bag as it was built, a sentence each.
    [[nodiscard]] const std::vector<std::string>& warnings() const;
    /// What the gas has given up at walls and the fabric has not yet got, when it has got `done` of
    /// the last load.
    [[nodiscard]] Wrench owed(double done = 1.0) const;
    [[nodiscard]] double load_delay() const;  ///< of particles' impulse (LoadTimes)           [s]
    /// Mass that inflators bring until `end_time` [s], over all they bring; 1 without any.    [-]
    [[nodiscard]] double expected_share_in(double end_time) const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
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

    std::unique_ptr<Envelope> bag_;
    std::unique_ptr<ParticleGas> particles_;
    std::unique_ptr<UniformGas> uniform_;  ///< after TSW
    std::vector<std::uint8_t> pressed_;    ///< N: nodes that contact presses harder than the gas
};

}  // namespace corpuscle::gas
