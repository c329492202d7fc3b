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
#include "solver/bodies/joint_springs.hpp"
#include "solver/bodies/riding_cloth.hpp"
#include "solver/bodies/rigid_body.hpp"
#include "solver/bodies/rigid_joints.hpp"
#include "solver/bodies/tied_nodes.hpp"
#include "solver/clock.hpp"
#include "solver/energy/growth_monitor.hpp"
#include "solver/energy/impulse_book.hpp"
#include "solver/energy/ledger.hpp"
#include "solver/energy/strained_start.hpp"
#include "solver/loads.hpp"
#include "solver/model.hpp"
#include "solver/stable_step.hpp"

namespace corpuscle {

/// A force on every node, kept apart from the others so that its work can be booked.
struct ForceShare {
    Points f;  ///< N × 3, or empty: this scene has none                        [N]

    /// span Σ f·v_mid, the exact work of a kick with v_mid the mean of before and after it.   [J]
    [[nodiscard]] double work(const Points& v_mid, double span) const;
    /// With two velocities.                                                              [J]
    [[nodiscard]] std::pair<double, double> works(const Points& v_mid, const Points& v_before,
                                                  double span) const;
};

/// Fabric: which shells are strained, their reference shape, their membranes.
struct SceneCloth {
    std::vector<std::uint8_t> active;            ///< E: strains are computed
    std::size_t active_shells = 0;               ///< how many of them
    double added_mass = 0.0;                     ///< by DT2MS, all told              [kg]
    std::vector<double> shell_mass;              ///< E, rho h A0                     [kg]
    std::vector<std::array<Vec3, 4>> reference;  ///< E × 4, stress-free corners         [m]
    std::vector<double> births;  ///< E: when it counts; empty: from the start           [s]
    double next_birth = INF;     ///< the first of `births` that does not count yet; INF: none [s]
    std::optional<fabric::Membranes> membranes;  ///< none: no shell is strained
    GrowthMonitor growth;                        ///< where there are membranes
    StrainedStart strained_start;                ///< likewise
};

/// Bags of the scene, by card.
struct SceneAirbags {
    std::vector<gas::BagGas> particle;     ///< *AIRBAG_PARTICLE, in the deck's order
    std::vector<gas::UniformBag> uniform;  ///< uniform from the start, in the deck's order
    std::vector<gas::Exchange> exchanges;  ///< between two uniform ones
};

/// Rigid bodies, and what joins them.
struct SceneBodies {
    std::vector<RigidBody> all;                ///< one for each rigid part that leads
    std::vector<Index> of_node;                ///< N: row in `all` or -1; empty without bodies
    std::vector<contact::RigidProxy> proxies;  ///< the same as contact sees them
    std::optional<RigidJoints> joints;         ///< none: no body is joined
    std::optional<JointSprings> springs;       ///< none: no *CONSTRAINED_JOINT_STIFFNESS
    std::vector<RidingNode> riding;            ///< cloth that they carry
    std::vector<std::vector<double>> damped;   ///< by body, by *DAMPING_PART_MASS: share of its
                                               ///< rigid parts' mass that is damped      [-]

    /// Positions are those that the last step led to.
    void arrive() {
        for (RigidBody& body : all) body.arrive();
    }
};

/// What stops nodes and bodies.
struct SceneObstacles {
    std::optional<contact::SurfaceContact> contact;  ///< one for all cards
    std::vector<Index> contact_shell;                ///< of its triangles: rows of their shells
    std::vector<contact::RigidWall> walls;           ///< *RIGIDWALL, in the deck's order
};

/// Velocities of nodes during a kick.                                             N × 3 [m/s]
struct KickVelocities {
    Points before;  ///< v(t - dt/2)
    Points free;    ///< before obstacles, if nodes are tied
    Points kicked;  ///< before obstacles, if any stopped something
    Points mid;     ///< mean of v before and after the kick
};

/// Forces on nodes at t, by cause. Gas and contact keep their own.
struct SceneForces {
    ForceShare fabric,                             ///< internal force of membranes
        loads,                                     ///< prescribed loads
        damping;                                   ///< *DAMPING_GLOBAL, *DAMPING_PART_MASS
    std::vector<std::vector<double>> damped_mass;  ///< by *DAMPING_PART_MASS: N, of cloth    [kg]
};

/// Impulses since the start, for results.
struct SceneImpulses {
    ImpulseBook walls,   ///< by wall, on it                                   [N s]
        contacts;        ///< by card, as SurfaceContact::force()            [N s]
    ImpulseBook joints,  ///< by joint, on the body of its first node          [N s]
        turnings;        ///< their moments about the joint's first place    [N m s]
};

/// Pairs of shells that cross, or are nearer than contact lets them be, since contact began: ids.
struct BadStarts {
    std::vector<std::pair<int, int>> crossing,  ///< lower id first, ascending
        close;                                  ///< likewise
};

/// A scene in motion, and how forces and obstacles move it.
///
/// What the scene does not need is not built: no contact keyword, no contact; all nodes of a part
/// held, no strains. Absence is emptiness, not a flag.
struct SceneState {
    /// @throws InputError  for what only the whole scene shows (a bag that is not closed, a shell
    ///                     without area, ...), every fault at once
    /// @param of    the scene as a deck or a test says it
    /// @param draw  seed of all random numbers
    SceneState(Model of, std::uint64_t draw);

    // A step (motion.cpp); forces at t are in nodes.f
    void activate_references();  ///< whose time has come
    void find_damping();         ///< f = -d m v
    /// Finds what cloth and bodies may touch until t + dt.
    void find_contacts(double dt);
    /// v(t - dt/2) -> v(t + dt/2) by f over `span` [s]; bodies move as one, held nodes as told.
    void kick(double dt, double span);
    /// Walls and touching surfaces take the velocity that would carry a node through them in dt.
    void stop_at_obstacles(double dt);
    [[nodiscard]] double mass_damping() const;  ///< d of *DAMPING_GLOBAL at t          [1/s]
    /// d of each *DAMPING_PART_MASS at t.                                              [1/s]
    [[nodiscard]] std::vector<double> part_dampings() const;
    /// Shares the shells' mass of each damped part of cloth out among their corners.
    void find_damped_mass();

    /// Length of the next step, and its limiter.
    /// @param without_start  as if there were no DTINIT, and no strain to let go
    [[nodiscard]] StepLimit stable_step(bool without_start = false) const;
    /// What the shells alone allow.
    [[nodiscard]] StepLimit shells_step() const;

    /// Of nodes, rigid bodies and walls of mass, at the half step that velocities live at. [J]
    [[nodiscard]] double kinetic_energy() const;
    /// All that gas and atmosphere do to a node at t.                                       [N]
    [[nodiscard]] Vec3 gas_force(Index node) const;
    /// Of a node at t, interpolated between the half steps.                               [m/s]
    [[nodiscard]] Vec3 velocity(Index node) const;
    /// 1 for nodes that supports, motions, rigid bodies or other nodes carry in every direction.
    [[nodiscard]] std::vector<std::uint8_t> held_nodes() const;
    /// N: row of the rigid body that carries a node, by itself or by an edge that it is tied to,
    /// where that body can turn; -1: none. Empty: no body can.
    [[nodiscard]] std::vector<Index> turning_bodies() const;
    /// Mass of nodes that obstacles meet.                                             N [kg]
    [[nodiscard]] const std::vector<double>& mass_met() const {
        return ties.empty() ? nodes.mass : met_mass;
    }
    /// Inside all bags.
    [[nodiscard]] std::size_t particles() const;
    /// Those of contact, as far as it has found them.
    [[nodiscard]] BadStarts bad_starts() const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(clock, nodes.x, nodes.v, ledger);
        const double next_birth = cloth.next_birth;
        archive(cloth.next_birth);
        if (cloth.next_birth != next_birth && cloth.membranes)  // read: references that count
            cloth.membranes = membranes_now();
        archive(cloth.membranes, cloth.growth, cloth.strained_start, supports, bodies.all,
                bodies.springs, airbags.particle, airbags.uniform, obstacles.contact,
                obstacles.walls, impulses.walls, impulses.contacts, impulses.joints,
                impulses.turnings);
    }

    Model model;                   ///< what the scene was built from
    std::uint64_t seed;            ///< of all random numbers
    Clock clock;                   ///< t and steps
    fabric::Nodes nodes;           ///< x, v, f, m of all nodes
    SceneCloth cloth;              ///< membranes
    SceneAirbags airbags;          ///< bags and their gas
    SceneBodies bodies;            ///< rigid bodies
    SceneObstacles obstacles;      ///< contact and walls
    Constraints supports;          ///< of nodes
    TiedNodes ties;                ///< nodes that ride on edges
    std::vector<double> met_mass;  ///< N: that obstacles meet, if nodes are tied          [kg]
    Loads loads;                   ///< that the deck prescribes
    KickVelocities v;              ///< of the kick in hand
    SceneForces forces;            ///< at t
    SceneImpulses impulses;        ///< since the start
    Ledger ledger;                 ///< energy moved up to the half steps around t

private:
    void build_cloth();
    void build_bodies();
    void join_bodies();
    void share_part_damping();
    void check_ties();
    void build_bags();
    void part_coinciding_cloth();
    void build_contacts();
    void build_walls();
    void move_bodies(double dt, double span);
    void book_stops();
    /// Adds the kinetic energy of rigid bodies and walls of mass to that of nodes.          [J]
    [[nodiscard]] double with_obstacles(double all) const;
    [[nodiscard]] fabric::Membranes membranes_now() const;
    [[nodiscard]] std::vector<Index> fabric_nodes() const;
    [[nodiscard]] std::vector<double> fabric_sizes() const;  // by node
};

}  // namespace corpuscle
