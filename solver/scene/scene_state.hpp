// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "contact/rigid_walls/rigid_wall.hpp"
#include "contact/surface/rigid_proxies.hpp"
#include "contact/surface_contact.hpp"
#include "fabric/membranes.hpp"
#include "fabric/nodes.hpp"
#include "gas/bag_gas.hpp"
#include "gas/exchange.hpp"
#include "gas/uniform_bag.hpp"
#include "solver/bodies/constraints.hpp"
#include "solver/bodies/rigid_body.hpp"
#include "solver/bodies/rigid_joints.hpp"
#include "solver/bodies/tied_nodes.hpp"
#include "solver/clock.hpp"
#include "solver/energy/growth_monitor.hpp"
#include "solver/energy/impulse_book.hpp"
#include "solver/energy/ledger.hpp"
#include "solver/loads.hpp"
#include "solver/model.hpp"
#include "solver/stable_step.hpp"

namespace corpuscle {

/// A force on every node, kept apart from the others so that its work can be booked.
struct ForceShare {
    Points f;  ///< N × 3, or empty: this scene has none                        [N]

    [[nodiscard]] double work(const Points& v_mid, double span) const;
    /// With two velocities.                                                              [J]
    [[nodiscard]] std::pair<double, double> works(const Points& v_mid, const Points& v_before,
                                                  double span) const;
};

/// Fabric: which shells are strained, their reference shape, their membranes.
struct SceneCloth {
    std::vector<std::uint8_t> active;  ///< E: strains are computed
    std::size_t active_shells = 0;
    double added_mass = 0.0;                     ///< by DT2MS                          [kg]
    std::vector<double> shell_mass;              ///< E                                 [kg]
    std::vector<std::array<Vec3, 4>> reference;  ///< E × 4, stress-free corners         [m]
    std::vector<double> births;  ///< E: when it counts; empty: from the start           [s]
    double next_birth = INF;     ///< [s]
    std::optional<fabric::Membranes> membranes;
    GrowthMonitor growth;  ///< where there are membranes
};

struct SceneAirbags {
    std::vector<gas::BagGas> particle;
    std::vector<gas::UniformBag> uniform;
    std::vector<gas::Exchange> exchanges;  ///< between two uniform ones
};

struct SceneBodies {
    std::vector<RigidBody> all;
    std::vector<Index> of_node;                ///< N: row in `all` or -1; empty without bodies
    std::vector<contact::RigidProxy> proxies;  ///< the same as contact sees them
    std::optional<RigidJoints> joints;

    /// Positions are those that the last step led to.
    void arrive() {
        for (RigidBody& body : all) body.arrive();
    }
};

struct SceneObstacles {
    std::optional<contact::SurfaceContact> contact;  ///< one for all cards
    std::vector<Index> contact_shell;                ///< of its triangles: rows of their shells
    std::vector<contact::RigidWall> walls;
};

/// Velocities of nodes during a kick.                                             N × 3 [m/s]
struct KickVelocities {
    Points before;  ///< v(t - dt/2)
    Points free;    ///< before obstacles, if nodes are tied
    Points kicked;  ///< before obstacles, if any stopped something
    Points mid;     ///< mean of v before and after the kick
};

struct SceneForces {
    ForceShare fabric, loads, damping;
    std::vector<std::vector<double>> damped_mass;  ///< by *DAMPING_PART_MASS: N              [kg]
};

struct SceneImpulses {
    ImpulseBook walls, contacts;   ///< by wall; by card                              [N s]
    ImpulseBook joints, turnings;  ///< by joint                             [N s], [N m s]
};

/// Pairs of shells that cross, or are nearer than contact lets them be, since contact began: ids.
struct BadStarts {
    std::vector<std::pair<int, int>> crossing, close;
};

/// A scene in motion, and how forces and obstacles move it.
///
/// What the scene does not need is not built: no contact keyword, no contact; all nodes of a part
/// held, no strains. Absence is emptiness, not a flag.
struct SceneState {
    /// Errors: InputError for what only the whole scene shows (a bag that is not closed, a shell
    /// without area, ...), every fault at once.
    SceneState(Model of, std::uint64_t draw);

    // A step (motion.cpp); forces at t are in nodes.f
    void activate_references();  ///< whose time has come
    void find_damping();         ///< f = -d m v
    void find_contacts(double dt);
    void kick(double dt, double span);
    void stop_at_obstacles(double dt);
    [[nodiscard]] double mass_damping() const;  ///< d of *DAMPING_GLOBAL at t          [1/s]
    /// d of the k-th *DAMPING_PART_MASS at t.                                          [1/s]
    [[nodiscard]] double part_damping(std::size_t k) const;
    void find_damped_mass();

    /// The next step and who limits it.
    /// @param without_start  as if there were no DTINIT
    [[nodiscard]] StepLimit stable_step(bool without_start = false) const;
    [[nodiscard]] StepLimit shells_step() const;  ///< what the shells alone allow

    /// Of nodes, rigid bodies and walls of mass, at the half step that velocities live at. [J]
    [[nodiscard]] double kinetic_energy() const;
    [[nodiscard]] Vec3 gas_force(Index node) const;  ///< [N]
    [[nodiscard]] Vec3 velocity(Index node) const;   ///< at t                         [m/s]
    /// 1 for nodes that supports, motions, rigid bodies or other nodes carry in every direction.
    [[nodiscard]] std::vector<std::uint8_t> held_nodes() const;
    /// Mass of nodes that obstacles meet.                                             N [kg]
    [[nodiscard]] const std::vector<double>& mass_met() const {
        return ties.empty() ? nodes.mass : met_mass;
    }
    [[nodiscard]] std::size_t particles() const;
    [[nodiscard]] BadStarts bad_starts() const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(clock, nodes.x, nodes.v, ledger);
        const double next_birth = cloth.next_birth;
        archive(cloth.next_birth);
        if (cloth.next_birth != next_birth && cloth.membranes)  // read: references that count now
            cloth.membranes = membranes_at(clock.t);
        archive(cloth.membranes, cloth.growth, supports, bodies.all, airbags.particle,
                airbags.uniform, obstacles.contact, obstacles.walls, impulses.walls,
                impulses.contacts, impulses.joints, impulses.turnings);
    }

    Model model;
    std::uint64_t seed;
    Clock clock;
    fabric::Nodes nodes;
    SceneCloth cloth;
    SceneAirbags airbags;
    SceneBodies bodies;
    SceneObstacles obstacles;
    Constraints supports;
    TiedNodes ties;
    std::vector<double> met_mass;  ///< N: that obstacles meet, if nodes are tied          [kg]
    Loads loads;
    KickVelocities v;
    SceneForces forces;
    SceneImpulses impulses;
    Ledger ledger;

private:
    void build_cloth();
    void build_bodies();
    void join_bodies();
    void check_ties();
    void build_bags();
    void part_coinciding_cloth();
    void build_contacts();
    void build_walls();
    void move_bodies(double dt, double span);
    void book_stops();
    /// Adds the kinetic energy of rigid bodies and walls of mass to that of nodes.          [J]
    [[nodiscard]] double with_obstacles(double all) const;
    [[nodiscard]] fabric::Membranes membranes_at(double t) const;
    [[nodiscard]] std::vector<Index> fabric_nodes() const;
    [[nodiscard]] std::vector<double> fabric_sizes() const;  // by node
};

}  // namespace corpuscle
