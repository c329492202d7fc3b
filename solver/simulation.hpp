// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "contact/rigid_walls/rigid_wall.hpp"
#include "contact/surface/movers.hpp"
#include "contact/surface_contact.hpp"
#include "fabric/membranes.hpp"
#include "fabric/nodes.hpp"
#include "gas/bag_gas.hpp"
#include "gas/exchange.hpp"
#include "gas/uniform_bag.hpp"
#include "solver/base/archive.hpp"
#include "solver/base/stopwatch.hpp"
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
#include "solver/records.hpp"
#include "solver/stable_step.hpp"

namespace corpuscle {

struct StepReport {
    double t, dt;  ///< of the step that was made: from t, by dt                [s]
    StepLimit limit;
};

/// A force on every node, kept apart from the others so that its work can be booked.
struct ForceShare {
    Points f;  ///< N × 3, or empty: this scene has none                        [N]

    [[nodiscard]] double work(const Points& v_mid, double span) const;
};

/// A scene in motion: owns the state, built from a model. What the scene does not need is not
/// built: no contact keyword, no contact; all nodes of a part held, no strains. Absence is
/// emptiness, not a flag.
class Simulation {
public:
    /// Errors: InputError for what only the whole scene shows (a bag that is not closed, a shell
    /// without area, ...), every fault at once.
    explicit Simulation(Model model, std::uint64_t seed = 1);

    /// Called in every step when positions, forces and books are those of t.
    using Observer = std::function<void(Simulation&)>;

    /// Advances everything from t to t + dt (step.cpp: the page to read first).
    StepReport step(const Observer& observe);

    /// Brings forces and books to the end time, for the last observation.
    void close(const Observer& observe);

    [[nodiscard]] bool is_over() const { return clock_.t >= model_.end_time; }
    [[nodiscard]] double time() const { return clock_.t; }
    [[nodiscard]] std::int64_t steps() const { return clock_.step; }
    [[nodiscard]] std::size_t particles() const;
    [[nodiscard]] const Model& model() const { return model_; }
    [[nodiscard]] const fabric::Nodes& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<gas::BagGas>& bags() const { return bags_; }
    [[nodiscard]] const std::vector<gas::UniformBag>& uniform_bags() const { return uniform_bags_; }
    [[nodiscard]] const std::vector<contact::SurfaceContact>& contacts() const { return contacts_; }
    [[nodiscard]] const std::vector<contact::RigidWall>& walls() const { return walls_; }
    [[nodiscard]] const std::vector<RigidBody>& bodies() const { return bodies_; }
    [[nodiscard]] const Timings& timings() const { return timings_; }
    /// Pairs of shells that cross, or are nearer than contact lets them be, since contact began:
    /// ids. Found in the first step, or by look_at_contacts().
    struct BadStarts {
        std::vector<std::pair<int, int>> crossing, close;
    };
    [[nodiscard]] BadStarts bad_starts() const;
    void look_at_contacts();  ///< as the first step will, at the start
    [[nodiscard]] std::size_t active_shells() const { return active_shells_; }
    [[nodiscard]] double added_mass() const { return added_mass_; }

    /// The next step and who limits it.
    /// @param without_start  as if there were no DTINIT
    [[nodiscard]] StepLimit stable_step(bool without_start = false) const;
    [[nodiscard]] StepLimit shells_step() const;  ///< what the shells alone allow

    [[nodiscard]] EnergyBooks books() const;  ///< at t, inside an observer
    [[nodiscard]] RecordLayout layout() const;
    /// Of contact and gas on a body, in the kick at t.                               [N]
    [[nodiscard]] Vec3 force_on(const RigidBody& body) const;
    [[nodiscard]] Sample sample();  ///< at t, inside an observer
    [[nodiscard]] Frame frame();    ///< at t, inside an observer

    /// What a checkpoint holds of it (solver/base/archive.hpp): a scene built from the same model
    /// and seed goes on from there in the same bits.
    void visit_state(StateWriter& archive);
    void visit_state(StateReader& archive);
    /// Tells models and seeds apart.
    [[nodiscard]] std::uint64_t fingerprint() const;

private:
    template <class Archive>
    void visit_all(Archive& archive);
    void build_fabric();
    [[nodiscard]] fabric::Membranes membranes_at(double t) const;
    void bear_references();
    [[nodiscard]] std::vector<Index> fabric_nodes() const;
    [[nodiscard]] std::vector<double> fabric_sizes() const;  // by node
    void build_bags(std::uint64_t seed);
    void build_bodies();
    void check_ties();
    void part_coinciding_cloth();
    void build_contacts();
    void build_walls();
    [[nodiscard]] std::vector<std::uint8_t> held_nodes() const;
    [[nodiscard]] const std::vector<double>& met_mass() const {
        return ties_.empty() ? nodes_.mass : met_mass_;
    }

    void find_forces(double dt, double span, Stopwatch& lap);
    [[nodiscard]] double mass_damping() const;
    [[nodiscard]] double kinetic_energy() const;
    void add_mass_damping();
    void move_bodies(double dt, double span);
    void kick(double dt, double span);
    void drift(double dt);
    void stop_at_obstacles(double dt);
    void book_forces(double span);
    void book_impulses(double span);
    void watch_growth(double span);
    [[nodiscard]] double negligible_energy(double span) const;
    void find_touching(double span);
    void find_contact_pressure(std::vector<float>& pressure);
    void find_contact_push(double span);
    void check_finite() const;
    void check_books() const;
    [[noreturn]] void stop_for(Index broken_shell) const;
    [[nodiscard]] std::string growing_shell(Index node) const;
    [[nodiscard]] Vec3 gas_force(Index node) const;
    [[nodiscard]] Vec3 velocity(Index node) const;  ///< at t                        [m/s]

    Model model_;
    std::uint64_t seed_;
    Clock clock_;
    fabric::Nodes nodes_;
    std::vector<std::uint8_t> active_;  ///< E: strains are computed
    std::size_t active_shells_ = 0;
    double added_mass_ = 0.0;         ///< by DT2MS                                   [kg]
    std::vector<double> shell_mass_;  ///< E                                          [kg]
    std::vector<std::array<Vec3, 4>> reference_;  ///< E × 4, stress-free corners           [m]
    std::vector<double> births_;  ///< E: when it counts; empty: from the start           [s]
    double next_birth_ = INF;     ///< [s]
    std::vector<fabric::Membranes> fabric_;  ///< one, or none
    double restored_ = 0.0;  ///< by TSRFAC, as booked                                   [J]
    GrowthMonitor growth_;   ///< of the fabric, where there is any
    std::vector<gas::BagGas> bags_;
    std::vector<gas::UniformBag> uniform_bags_;
    std::vector<gas::Exchange> exchanges_;           ///< between two of them
    std::vector<contact::SurfaceContact> contacts_;  ///< one for all cards, or none
    std::vector<Index> contact_shell_;               ///< of its triangles: rows of their shells
    std::vector<contact::RigidWall> walls_;
    std::vector<RigidBody> bodies_;
    std::vector<Index> body_of_node_;          ///< N: row in bodies_ or -1; empty without bodies
    std::vector<contact::RigidMover> movers_;  ///< the same as contact sees them
    std::vector<RigidJoints> joints_;          ///< one for all joints, or none
    Constraints supports_;
    TiedNodes ties_;
    std::vector<double> met_mass_;  ///< N: that obstacles meet, if nodes are tied          [kg]
    Loads loads_;

    Points v_before_;  ///< v(t - dt/2)                                [m/s]
    Points v_free_;    ///< before obstacles, if nodes are tied                       [m/s]
    Points v_kicked_;  ///< before obstacles, if any stopped something [m/s]
    Points v_mid_;     ///< mean of v before and after this step's kick   [m/s]
    std::vector<std::uint8_t> held_;  ///< N: as held_nodes() says, if contact_push_ is asked for
    Points contact_push_;             ///< N × 3: contact and obstacles, if a bag asks    [N]
    std::vector<std::uint8_t> touching_;  ///< N: nodes in contact, if a bag asks for it
    ForceShare load_force_, damping_force_, fabric_force_;
    Ledger ledger_;
    ImpulseBook wall_impulses_, contact_impulses_;  ///< by wall; by card
    ImpulseBook joint_impulses_, joint_turnings_;   ///< by joint                      [N s, N m s]
    double rubbed_ = 0.0;  ///< by friction in contact, so far                           [J]
    Timings timings_;
    double last_sample_ = 0.0, last_frame_ = 0.0;  ///< when they were last taken           [s]
};

}  // namespace corpuscle
