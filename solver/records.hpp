// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

/// @file
/// What a run hands to its results: plain numbers in deck units. io writes them, nothing reads them
/// back. Simulation::layout() says once who is who; Simulation::sample() and frame() give, inside
/// an observer, the numbers at t in the same order. io/FORMAT.md has the paths where they lie.

namespace corpuscle {

/// Ids and names of the entries of a Sample and a Frame; constant in a run.
struct RecordLayout {
    /// A bag, of particles or of uniform pressure.
    struct Airbag {
        int id = 0;                    ///< of the card, else the bag's order in the deck from 1
        bool has_initial_air = false;  ///< species 0 is the initial air
        std::vector<int> species;      ///< numbers K of /species/K, in Sample order
        std::vector<int> parts;        ///< part ids of /part/PID, in Sample order
        std::vector<int> chambers{};   ///< ids of /chamber/ID, in Sample order
        bool has_particles = true;     ///< false: of uniform pressure from the start
    };
    std::vector<Airbag> airbags;           ///< in the order of Sample::airbags
    std::vector<int> parts;                ///< part ids
    std::vector<double> part_mass;         ///< of the parts' shells, or of the rigid body     [kg]
    std::vector<int> rigid_bodies;         ///< part ids of the rigid bodies
    std::vector<int> walls,                ///< ids of rigid walls
        contacts;                          ///< ids of contacts
    Points wall_normals;                   ///< of the walls, unit, 0 of one that is not plane
    std::vector<int> moving_walls;         ///< ids of those of the walls that can move
    std::vector<int> joints;               ///< ids of the joints between rigid bodies
    std::size_t sensors = 0;               ///< numbered from 1
    std::vector<int> history_nodes;        ///< node ids
    std::vector<Index> history_node_rows;  ///< of the same

    // mesh
    std::vector<int> node_id;                       ///< N
    Points coordinates;                             ///< N × 3, initial
    std::vector<int> shell_id,                      ///< E
        shell_part;                                 ///< E: part ids
    std::vector<std::array<Index, 4>> shell_nodes;  ///< E × 4 rows
};

/// The ledger at one instant: start + inflow + external = all others + residual.              [J]
struct EnergyBooks {
    double kinetic = 0;    ///< of nodes, bodies and walls of mass
    double strain = 0;     ///< of membranes, coats, hourglass control and springs of joints
    double gas = 0;        ///< all that the gas inside holds, initial air too
    double contact = 0;    ///< stored in contact, or lost there, friction apart; never below 0
    double friction = 0;   ///< lost by friction in contact, at walls and in joints
    double damping = 0;    ///< lost by DAMP, *DAMPING_, dampers of joints and loops of loading
    double smoothing = 0;  ///< given by particles to the wall, not yet passed on to the fabric
    double ambient = 0;    ///< p_atm · (V - V at the start)
    double inflow = 0;     ///< brought by inflators and ambient air
    double outflow = 0;    ///< taken by what left, and heat to walls
    double external = 0;   ///< by loads, supports, driven bodies and walls
    double total = 0;      ///< what is there now and what was spent
    double residual = 0;   ///< total - (start + inflow + external)
};

/// The gas of a bag at t.
struct AirbagSample {
    double volume = 0;           ///< [m^3]
    double pressure = 0;         ///< absolute, 2/3 of the translational energy by volume   [Pa]
    double temperature = 0;      ///< at which the gas at rest would hold `energy`          [K]
    double mass = 0;             ///< inside                                                [kg]
    double mass_in = 0;          ///< that has come in so far                               [kg]
    double mass_out_vent = 0;    ///< gone through vents so far                             [kg]
    double mass_out_fabric = 0;  ///< gone through fabric so far                            [kg]
    double particles = 0;        ///< inside                                                [-]
    double particles_out = 0;    ///< gone so far                                           [-]
    double energy = 0;           ///< translation, spin, vibration, initial air             [J]
    double translational_energy = 0;            ///< [J]
    Vec3 owed_momentum = Vec3::Zero();          ///< taken at walls, not given yet       [N s]
    Vec3 owed_angular_momentum = Vec3::Zero();  ///< about the origin                  [N m s]
    double mass_rate_in = 0,                    ///< of a uniform bag, in the last step [kg/s]
        mass_rate_out = 0;                      ///< likewise                           [kg/s]
    double surface_area = 0;                    ///< of what closes the bag              [m^2]
    double static_pressure = 0;     ///< about the mean velocity of each room's gas         [Pa]
    double static_temperature = 0;  ///< likewise                                            [K]
    /// One gas of the bag.
    struct Species {
        double mass = 0;         ///< [kg]
        double temperature = 0;  ///< [K]
        double energy = 0;       ///< [J]
    };
    /// The inside of one part.
    struct Part {
        double pressure = 0;   ///< impulse of hits by area and time since the last row  [Pa]
        double area = 0;       ///< [m^2]
        double mass_out = 0;   ///< so far                                                  [kg]
        double heat_lost = 0;  ///< to it, so far                                            [J]
    };
    /// *DEFINE_CPM_CHAMBER: quantities as those of the bag.
    struct Chamber {
        double volume = 0;           ///< [m^3]
        double pressure = 0;         ///< absolute                                              [Pa]
        double temperature = 0;      ///< [K]
        double mass = 0;             ///< [kg]
        double energy = 0;           ///< [J]
        double static_pressure = 0;  ///< [Pa]
        double static_temperature = 0;  ///< [K]
    };
    std::vector<Species> species;   ///< as RecordLayout::Airbag::species
    std::vector<Part> parts;        ///< as RecordLayout::Airbag::parts
    std::vector<Chamber> chambers;  ///< as RecordLayout::Airbag::chambers

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(volume, pressure, temperature, mass, mass_in, mass_out_vent, mass_out_fabric,
                particles, particles_out, energy, translational_energy, owed_momentum,
                owed_angular_momentum, mass_rate_in, mass_rate_out, surface_area, static_pressure,
                static_temperature, species, parts, chambers);
    }
};

/// One row of every history; lists are in the order of the RecordLayout.
struct Sample {
    double time = 0;                    ///< t                                               [s]
    double dt = 0;                      ///< of the step that led to t                       [s]
    std::int64_t step = 0;              ///< steps made so far
    EnergyBooks energy;                 ///< the ledger at t                                 [J]
    std::vector<AirbagSample> airbags;  ///< by bag
    /// Fabric of one part, or a rigid part.
    struct Part {
        double kinetic_energy = 0;     ///< [J]
        double strain_energy = 0;      ///< [J]
        Vec3 momentum = Vec3::Zero();  ///< [N s]
    };
    std::vector<Part> parts;  ///< by part
    /// Mass centre of one rigid body.
    struct Rigid {
        Vec3 position = Vec3::Zero();          ///< [m]
        Vec3 velocity = Vec3::Zero();          ///< [m/s]
        Vec3 acceleration = Vec3::Zero();      ///< [m/s^2]
        Vec3 force = Vec3::Zero();             ///< of contact and gas                           [N]
        Vec3 angular_momentum = Vec3::Zero();  ///< about it                     [kg m^2/s]
    };
    std::vector<Rigid> rigid_bodies;  ///< by body
    std::vector<Vec3> wall_impulse;   ///< that each has got so far                      [N s]
    /// A wall that can move.
    struct WallMotion {
        Vec3 displacement = Vec3::Zero();  ///< since the start                              [m]
        Vec3 velocity = Vec3::Zero();      ///< [m/s]
    };
    std::vector<WallMotion> moving_walls;  ///< by wall that can move
    /// All that one card's contacts did.
    struct Contact {
        Vec3 impulse = Vec3::Zero();  ///< that SURFA has got so far                    [N s]
        double energy = 0;            ///< stored, at t                                         [J]
        double pairs = 0;             ///< nearer than the contact thickness
        double penetration = 0;       ///< greatest part of the thickness that is missing        [-]
    };
    std::vector<Contact> contacts;  ///< by card
    /// A joint of two rigid bodies.
    struct Joint {
        Vec3 impulse = Vec3::Zero();  ///< that the body of N1 has got so far            [N s]
        Vec3 turning = Vec3::Zero();  ///< the same about the joint's (first) place    [N m s]
    };
    std::vector<Joint> joints;  ///< by joint
    /// *DATABASE_CPM_SENSOR: the gas in one sensor's volume.
    struct Sensor {
        double particles = 0;          ///< in it                                           [-]
        double pressure = 0;           ///< absolute                                       [Pa]
        double temperature = 0;        ///< [K]
        double density = 0;            ///< [kg/m^3]
        Vec3 velocity = Vec3::Zero();  ///< mean by mass                                  [m/s]
        Vec3 centre = Vec3::Zero();    ///< of the sensor                                   [m]
    };
    std::vector<Sensor> sensors;  ///< by sensor
    Points node_coordinates;      ///< of the history nodes, × 3                       [m]
    Points node_velocity;         ///< the same                                      [m/s]

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(time, dt, step, energy, airbags, parts, rigid_bodies, wall_impulse, moving_walls,
                contacts, joints, sensors, node_coordinates, node_velocity);
    }
};

/// Mean force between two samples, from the impulses up to them; 0 where no time has passed.   [N]
inline Vec3 mean_force(const Vec3& impulse, const Vec3& before, double span) {
    return span > 0.0 ? Vec3((impulse - before) / span) : Vec3(Vec3::Zero());
}

/// One state for pictures.
struct Frame {
    double time = 0;                                 ///< [s]
    Points coordinates,                              ///< N × 3, at t                    [m]
        velocity;                                    ///< N × 3, at t                  [m/s]
    std::vector<float> shell_pressure;               ///< E, gauge                     [Pa]
    std::vector<float> shell_contact_pressure;       ///< E; empty: no contact         [Pa]
    std::vector<std::array<float, 3>> shell_stress;  ///< E × 3, warp weft shear       [Pa]
    std::vector<std::array<float, 3>> shell_strain;  ///< E × 3                        [-]
    std::vector<std::uint8_t> shell_active;          ///< E, 1 alive
    /// All particles inside, P of them.
    struct Particles {
        std::vector<std::int64_t> id;         ///< P; of each bag, in the order of entry from 0
        std::vector<std::int32_t> bag;        ///< P, id of its airbag
        std::vector<std::int32_t> species;    ///< P, number K of its gas
        Points position,                      ///< P × 3, at t                            [m]
            velocity;                         ///< P × 3                                [m/s]
        std::vector<double> internal_energy;  ///< P, spin and vibration               [J]
        std::vector<double> mass;             ///< P                                  [kg]
        std::vector<float> temperature;       ///< at which it would hold its internal energy [K]
    };
    std::optional<Particles> particles;  ///< absent when no bag shows particles
};

}  // namespace corpuscle
