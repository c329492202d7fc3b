// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

/// What a run hands to its results: plain numbers in deck units. io writes them, nothing reads them
/// back.
namespace corpuscle {

/// Who the entries of a Sample and a Frame are; fixed for the whole run.
struct RecordLayout {
    struct Airbag {
        int id = 0;
        bool has_initial_air = false;  ///< species 0 is the initial air
        std::vector<int> species;      ///< numbers K of /species/K, in Sample order
        std::vector<int> parts;        ///< part ids of /part/PID, in Sample order
        std::vector<int> chambers{};   ///< ids of /chamber/ID, in Sample order
        bool has_particles = true;     ///< false: of uniform pressure from the start
    };
    std::vector<Airbag> airbags;
    std::vector<int> parts;            ///< part ids
    std::vector<double> part_mass;     ///< of the parts' shells, or of the rigid body     [kg]
    std::vector<int> rigid_bodies;     ///< part ids of the rigid bodies
    std::vector<int> walls, contacts;  ///< ids
    Points wall_normals;               ///< of the walls, unit, 0 of one that is not plane
    std::vector<int> moving_walls;     ///< ids of those of the walls that can move
    std::vector<int> joints;           ///< ids of the joints between rigid bodies
    std::size_t sensors = 0;           ///< numbered from 1
    std::vector<int> history_nodes;    ///< node ids
    std::vector<Index> history_node_rows;

    // mesh
    std::vector<int> node_id;                       ///< N
    Points coordinates;                             ///< N × 3, initial
    std::vector<int> shell_id, shell_part;          ///< E (part ids)
    std::vector<std::array<Index, 4>> shell_nodes;  ///< E × 4 rows
};

/// The ledger at one instant.                                                                  [J]
struct EnergyBooks {
    double kinetic = 0, strain = 0, gas = 0, contact = 0, friction = 0, damping = 0;
    double smoothing = 0;  ///< given by particles to the wall, not yet passed on to the fabric
    double ambient = 0;    ///< p_atm · (V - V at the start)
    double inflow = 0, outflow = 0, external = 0;
    double total = 0;     ///< what is there now and what was spent
    double residual = 0;  ///< total - (start + inflow + external)
};

struct AirbagSample {
    double volume = 0, pressure = 0, temperature = 0;
    double mass = 0, mass_in = 0, mass_out_vent = 0, mass_out_fabric = 0;
    double particles = 0, particles_out = 0;
    double energy = 0, translational_energy = 0;
    Vec3 owed_momentum = Vec3::Zero(), owed_angular_momentum = Vec3::Zero();
    double mass_rate_in = 0, mass_rate_out = 0, surface_area = 0;  ///< for abstat
    struct Species {
        double mass = 0, temperature = 0, energy = 0;
    };
    struct Part {
        double pressure = 0, area = 0, mass_out = 0, heat_lost = 0;
    };
    struct Chamber {
        double volume = 0, pressure = 0, temperature = 0, mass = 0, energy = 0;
    };
    std::vector<Species> species;
    std::vector<Part> parts;
    std::vector<Chamber> chambers;

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(volume, pressure, temperature, mass, mass_in, mass_out_vent, mass_out_fabric,
                particles, particles_out, energy, translational_energy, owed_momentum,
                owed_angular_momentum, mass_rate_in, mass_rate_out, surface_area, species, parts,
                chambers);
    }
};

/// One row of every history.
struct Sample {
    double time = 0;
    double dt = 0;
    std::int64_t step = 0;
    EnergyBooks energy;
    std::vector<AirbagSample> airbags;
    struct Part {
        double kinetic_energy = 0, strain_energy = 0;
        Vec3 momentum = Vec3::Zero();
    };
    std::vector<Part> parts;
    struct Rigid {
        Vec3 position = Vec3::Zero(), velocity = Vec3::Zero(), acceleration = Vec3::Zero();
        Vec3 force = Vec3::Zero();  ///< contact + gas
    };
    std::vector<Rigid> rigid_bodies;
    std::vector<Vec3> wall_impulse;  ///< that each has got so far                      [N s]
    struct WallMotion {
        Vec3 displacement = Vec3::Zero(), velocity = Vec3::Zero();
    };
    std::vector<WallMotion> moving_walls;
    struct Contact {
        Vec3 impulse = Vec3::Zero();  ///< that SURFA has got so far                    [N s]
        double energy = 0;
        double pairs = 0;        ///< nearer than the contact thickness
        double penetration = 0;  ///< greatest part of the thickness that is missing        [-]
    };
    std::vector<Contact> contacts;
    struct Joint {
        Vec3 impulse = Vec3::Zero();  ///< that the body of N1 has got so far            [N s]
        Vec3 turning = Vec3::Zero();  ///< the same about the joint's (first) place    [N m s]
    };
    std::vector<Joint> joints;
    struct Sensor {
        double particles = 0, pressure = 0, temperature = 0, density = 0;
        Vec3 velocity = Vec3::Zero(), centre = Vec3::Zero();
    };
    std::vector<Sensor> sensors;
    Points node_coordinates, node_velocity;  ///< of the history nodes

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
    double time = 0;
    Points coordinates, velocity;                    ///< N × 3
    std::vector<float> shell_pressure;               ///< E, gauge                     [Pa]
    std::vector<float> shell_contact_pressure;       ///< E; empty: no contact         [Pa]
    std::vector<std::array<float, 3>> shell_stress;  ///< E × 3, warp weft shear       [Pa]
    std::vector<std::array<float, 3>> shell_strain;  ///< E × 3                        [-]
    std::vector<std::uint8_t> shell_active;          ///< E, 1 alive
    struct Particles {
        std::vector<std::int64_t> id;
        std::vector<std::int32_t> bag;  ///< id of its airbag
        std::vector<std::int32_t> species;
        Points position, velocity;
        std::vector<double> internal_energy, mass;
        std::vector<float> temperature;  ///< at which it would hold its internal energy [K]
    };
    std::optional<Particles> particles;  ///< absent when no bag shows particles
};

}  // namespace corpuscle
