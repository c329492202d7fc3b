// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/collisions/cell_grid.hpp"
#include "gas/collisions/collide.hpp"
#include "gas/enclosure/chambers.hpp"
#include "gas/enclosure/enclosure.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/flight/facet_lists.hpp"
#include "gas/flight/flight.hpp"
#include "gas/inflow/inflator.hpp"
#include "gas/inflow/orifices.hpp"
#include "gas/outflow/heat_loss.hpp"
#include "gas/outflow/openings.hpp"
#include "gas/outflow/wall_samples.hpp"
#include "gas/particles.hpp"
#include "gas/thermo/initial_air.hpp"
#include "gas/thermo/species.hpp"
#include "gas/uniform_gas.hpp"
#include "gas/wall_load/roughness.hpp"
#include "gas/wall_load/wall_load.hpp"
#include "solver/base/curve.hpp"

namespace corpuscle::gas {

/// A snapshot of the gas in one bag.
struct GasState {
    double volume = 0, pressure = 0, temperature = 0, area = 0;
    double mass = 0, mass_in = 0;
    double mass_out_vent = 0, mass_out_fabric = 0, particles_out = 0;  ///< so far
    double energy = 0;         ///< all that the gas inside holds
    double translational = 0;  ///< of which makes pressure, p = 2/3 translational / volume
    struct Share {
        double mass = 0, temperature = 0, energy = 0;
    };
    std::vector<Share> species;  ///< initial air first, if any
};

/// The gas in one chamber of a bag.
struct ChamberState {
    double volume = 0, pressure = 0, temperature = 0, mass = 0, energy = 0;
};

/// What the gas does to each part.
struct PartState {
    std::vector<double> pressure;  ///< absolute, mean since the last look   [Pa]
    std::vector<double> area;      ///< now                                  [m^2]
    std::vector<double> mass_out;  ///< so far                               [kg]
    std::vector<double> heat;      ///< lost to it so far                    [J]
};

/// The gas of one bag: particles, inflators, initial air, and what they do to the walls.
class BagGas {
public:
    /// @param held  N: 1 for nodes that supports, motions or rigid bodies carry
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
        Vec3 push = load_.force(node) - card_.p_atm * area_[node];
        if (uniform_) return push + uniform_->force(node);
        if (!air_force_.empty()) push += air_force_[node];
        return push;
    }

    /// Does contact close holes of this bag?
    [[nodiscard]] bool asks_for_contact() const { return card_.block.any() && !openings_.empty(); }
    /// Nodes that touch something now, and what contact does to them, N × 3 [N]: takes effect in
    /// the next flight (bag_touch.cpp).
    void set_touching(std::span<const std::uint8_t> nodes, std::span<const Vec3> force);

    void prepare(double dt, const Points& x_0, const Points& x_1);  ///< facet lists for the step
    void inject(double t, double dt, const Points& x_0, const Points& x_1);
    void collide(double dt, const Points& x);
    void fly(double t, double dt, const Points& x_0, const Points& x_1);

    /// Is it time (TSW) to go over to uniform pressure?
    [[nodiscard]] bool switches(double t) const;
    /// Sums up all particles, which freeze where they are (bag_uniform.cpp).
    void become_uniform(const Points& x);
    [[nodiscard]] bool is_uniform() const { return uniform_.has_value(); }

    /// Step in which a typical particle crosses half a cell: longer ones blur waves. [s]
    [[nodiscard]] double stable_step() const;

    [[nodiscard]] GasState state(const Points& x) const;
    /// Of each chamber, in the order of the cards (bag_chambers.cpp).
    [[nodiscard]] std::vector<ChamberState> chamber_states(const Points& x) const;
    [[nodiscard]] double energy() const;  ///< particles and initial air         [J]
    [[nodiscard]] double inflow_energy() const { return inflow_energy_; }
    [[nodiscard]] double lost_energy() const { return lost_energy_; }
    /// By hits and jets, less what came back and what the gas owes to others.                [J]
    [[nodiscard]] double smoothing_taken() const { return load_.taken(); }
    [[nodiscard]] double smoothing_given() const { return given_; }  ///< to the fabric
    [[nodiscard]] double ambient_work() const { return ambient_work_; }

    /// Mean pressure on each part over the time `since` the last call: impulse as delivered, and
    /// the air's.
    [[nodiscard]] PartState part_state(const Points& x, double since);
    /// Mean mass flow in since the last call.                                              [kg/s]
    [[nodiscard]] double mass_rate_in(double since);
    [[nodiscard]] double mass_rate_out(double since);  ///< the same, out                 [kg/s]
    /// Adds to each shell's `force` the mean gauge pressure since the last call times its area, and
    /// the area to `area`.                                                              E [N], E
    /// [m^2]
    void add_shell_load(const Points& x, double since, std::span<double> force,
                        std::span<double> area);

    [[nodiscard]] const BagCard& card() const { return card_; }
    [[nodiscard]] const BagWalls& walls() const { return walls_; }
    [[nodiscard]] const Enclosure& enclosure() const { return enclosure_; }
    [[nodiscard]] const Chambers& chambers() const { return chambers_; }
    [[nodiscard]] const Openings& openings() const { return openings_; }
    [[nodiscard]] const Particles& particles() const { return particles_; }
    [[nodiscard]] std::span<const double> particle_mass() const { return mass_; }
    /// Of particle i alone (Mixture::particle_temperature).                                [K]
    [[nodiscard]] double particle_temperature(std::size_t i) const {
        return collider_.mixture().particle_temperature(particles_.species[i], particles_.e[i],
                                                        particles_.v[i].squaredNorm());
    }
    [[nodiscard]] double moles_each() const { return inflators_.moles_each(); }  ///< [mol]
    /// Of air that is no particles (IAIR 1, -1).                                           [Pa]
    [[nodiscard]] double initial_air_pressure() const { return uniform_ ? 0.0 : air_pressure(); }
    [[nodiscard]] std::size_t lost() const { return lost_; }
    /// Who was lost, when and where: the first few.
    [[nodiscard]] const std::vector<std::string>& losses() const { return losses_; }
    [[nodiscard]] std::size_t hits() const { return hits_; }
    [[nodiscard]] std::size_t flights() const { return flights_; }
    [[nodiscard]] std::size_t unrelaxed() const { return unrelaxed_; }
    [[nodiscard]] std::uint64_t collision_steps() const { return collisions_; }
    [[nodiscard]] std::size_t list_builds() const { return lists_.builds() + side_lists_.builds(); }
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// What the gas has given up at walls and the fabric has not yet got, when it has got `done` of
    /// the last load.
    [[nodiscard]] Wrench owed(double done = 1.0) const { return load_.owed(done); }
    [[nodiscard]] double expected_share_in(double end_time) const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        bool is_uniform = uniform_.has_value();
        archive(is_uniform);
        if (is_uniform && !uniform_) open_rooms();
        if (uniform_) archive(*uniform_);
        archive(inflators_, air_, lists_, side_lists_, load_, particles_, samples_, openings_,
                heat_loss_, roughness_, pressed_, rooms_, looked_at_, area_, volumes_, cell_,
                wanted_cell_, speed_, since_collision_, collisions_, unrelaxed_, time_);
        archive(part_impulse_, triangle_impulse_, part_air_, triangle_air_, given_, ambient_work_,
                inflow_energy_, lost_energy_, mass_in_, mass_in_seen_, mass_out_seen_, lost_, hits_,
                flights_, losses_);
    }

private:
    /// What the particles of one gas hold in one room.
    struct Holding {
        double count = 0, translational = 0, internal = 0;  ///< [-], [J], [J]
        [[nodiscard]] double all() const { return translational + internal; }
    };
    /// Rooms × species.
    [[nodiscard]] std::vector<Holding> holdings() const;
    static void build(FacetLists& lists, double edge, double margin, double reach,
                      const Points& x_0, const Points& x_1);
    void find_groups(const Points& x);
    void find_open_facets();
    void exchange_heat_with_air(std::vector<Heat>& heat);
    [[nodiscard]] bool loses() const { return !openings_.empty() || !heat_loss_.empty(); }
    void look_inside(const Points& x);
    void look_at_openings();
    void pass_on();
    void let_out(double dt);
    void cool(double t, double dt);
    void fit_cells(std::size_t occupied_cells);
    void measure_speed();
    void fill_with_air(const Points& x, std::uint64_t seed);
    void push_back(std::size_t orifice, const Vec3& at, const Vec3& impulse, const Vec3& moving);
    void record_hits(const Points& x_1);
    void book_lost(double t);
    [[noreturn]] void stop_for(std::size_t particle, const char* when) const;
    void check_collided(double thermal) const;
    /// Pressure that does not come from particles: that of the initial air, or after TSW of all.
    [[nodiscard]] double air_pressure(std::size_t room) const {
        if (uniform_) return (*uniform_)[room].pressure();
        return air_.empty() ? 0.0 : air_[room].pressure(volumes_[room]);
    }
    [[nodiscard]] double air_pressure() const;  ///< mean over rooms by volume           [Pa]
    void press_with_air(Points& f);
    [[nodiscard]] std::vector<char> passing_facets() const;

    // After TSW (bag_uniform.cpp)
    void open_rooms();
    void sum_up();
    void settle(const Points& x);
    void flow_uniform(double t, double dt, const Points& x, const Points& x_1);
    void thrust(std::size_t inflow, double mass, double t, double dt, const Points& x_0,
                const Points& x_1);
    void let_out_uniform(double t, double dt, const Points& x);
    [[nodiscard]] Inside inside_of(std::size_t room) const;
    void let_out_of_room(std::size_t room, double dt);
    void pass_between_rooms(double t, double dt);
    /// Pressure that no particles bring, on a facet's inside; and that across an internal one.
    [[nodiscard]] double air_on(std::size_t facet, std::span<const double> of_room) const;
    void note_air(double span);
    [[nodiscard]] GasState uniform_state(const Points& x) const;

    BagCard card_;
    BagWalls walls_;
    Enclosure enclosure_;
    Chambers chambers_;
    std::vector<Index> chamber_of_room_;  ///< where there are chambers
    Inflators inflators_;
    std::vector<double> mass_;     ///< of one particle of each gas                 [kg]
    std::vector<InitialAir> air_;  ///< of each room, or none
    FacetLists lists_;             ///< for flight: cells of the facets' size
    FacetLists side_lists_;        ///< for collisions: cells that hold enough particles
    double facet_size_ = 0.0;      ///< mean edge of a facet                           [m]
    Orifices orifices_;
    std::vector<Index> orifice_room_;
    std::shared_ptr<const WettedSurface> surface_;
    WallLoad load_;
    Collider collider_;

    std::vector<std::uint8_t> is_open_;  ///< by facet, or empty: none                  [-]
    Particles particles_;
    std::vector<Vec3> axes_;      ///< of the orifices
    std::vector<Entry> entries_;  ///< of this step
    std::vector<double> born_;    ///< shares of the step at which they enter
    FlightResult flight_;
    std::vector<std::size_t> gone_;  ///< rows that left in this step
    WallSamples samples_;            ///< where there are openings or heat is lost
    Openings openings_;
    HeatLoss heat_loss_;
    Roughness roughness_;
    std::vector<std::uint8_t> pressed_;  ///< N: nodes that contact presses harder than the gas
    std::vector<Inside> rooms_;          ///< mean states at collision step looked_at_
    std::vector<Inside> at_opening_;     ///< in this step
    std::uint64_t looked_at_ = 0;
    Points area_;                            ///< N × 3, node areas at t                      [m^2]
    Points air_force_;                       ///< N × 3, of initial air                       [N]
    std::vector<double> volumes_;            ///< of rooms, at t                              [m^3]
    double cell_ = 0.0, wanted_cell_ = 0.0;  ///< edge of the cells of collisions    [m]
    double speed_ = 0.0;            ///< thermal, sqrt(R T / M) of the gas as a whole  [m/s]
    double since_collision_ = 0.0;  ///< [s]
    std::uint64_t collisions_ = 0;  ///< collision steps so far
    std::size_t unrelaxed_ = 0;     ///< groups whose energy belonged to no temperature

    std::optional<UniformGas> uniform_;  ///< after TSW; the initial air is its last species
    double time_ = 0.0;  ///< to which gas has come in                              [s]

    std::vector<double> part_impulse_, triangle_impulse_;  ///< since the last look   [N s]
    std::vector<double> part_air_, triangle_air_;  ///< by room, integral of air pressure [Pa s]

    double given_ = 0.0;  ///< work of what hits brought                   [J]
    double ambient_work_ = 0.0, inflow_energy_ = 0.0, lost_energy_ = 0.0;  ///<           [J]
    double mass_in_ = 0.0, mass_in_seen_ = 0.0, mass_out_seen_ = 0.0;      ///<           [kg]
    std::size_t lost_ = 0, hits_ = 0, flights_ = 0;
    std::vector<std::string> warnings_, losses_;
};

}  // namespace corpuscle::gas
