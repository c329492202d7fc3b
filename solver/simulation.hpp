// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "solver/base/archive.hpp"
#include "solver/base/stopwatch.hpp"
#include "solver/energy/energy_audit.hpp"
#include "solver/recorder.hpp"
#include "solver/records.hpp"
#include "solver/scene/scene_state.hpp"
#include "solver/scene/touching_nodes.hpp"

namespace corpuscle {

/// What a step was.
struct StepReport {
    double t,         ///< where the step began  [s]
        dt;           ///< how long it was, to t + dt  [s]
    StepLimit limit;  ///< who set dt
};

/// A scene in motion, step by step, with its energy balance and its records.
///
///     Simulation simulation(read_deck(path));
///     while (!simulation.is_over()) simulation.step(look);
///     simulation.close(look);
class Simulation {
public:
    /// @param seed  of all random numbers: same model and seed, same bits on any number of threads
    /// @throws InputError  for what only the whole scene shows (a bag that is not closed, a shell
    ///                     without area, ...), every fault at once
    explicit Simulation(Model model, std::uint64_t seed = 1) : scene_(std::move(model), seed) {}

    /// Called in every step, once, when positions, forces and books are those of t; never empty.
    using Observer = std::function<void(Simulation&)>;

    /// Advances everything from t to t + dt (step.cpp: the page to read first).
    /// @throws PhysicsError  with the time, where what comes out is not physics (solver/stops.cpp)
    StepReport step(const Observer& observe);

    /// Brings forces and books to the end time, for the last observation.
    /// @throws PhysicsError  likewise
    void close(const Observer& observe);

    /// Has t come to the end time?
    [[nodiscard]] bool is_over() const { return scene_.clock.t >= scene_.model.end_time; }
    [[nodiscard]] double time() const { return scene_.clock.t; }            ///< t            [s]
    [[nodiscard]] std::int64_t steps() const { return scene_.clock.step; }  ///< made so far
    [[nodiscard]] std::size_t particles() const { return scene_.particles(); }  ///< of all bags
    /// Everything that moves, and how.
    [[nodiscard]] const SceneState& scene() const { return scene_; }
    /// What the scene was built from.
    [[nodiscard]] const Model& model() const { return scene_.model; }
    /// x at t, v at the last half step, f and m.
    [[nodiscard]] const fabric::Nodes& nodes() const { return scene_.nodes; }
    /// Bags of particles (*AIRBAG_PARTICLE), in the order of the deck.
    [[nodiscard]] const std::vector<gas::BagGas>& bags() const { return scene_.airbags.particle; }
    /// Those of uniform pressure from the start, in the order of the deck.
    [[nodiscard]] const std::vector<gas::UniformBag>& uniform_bags() const {
        return scene_.airbags.uniform;
    }
    /// None: no card asks for it.
    [[nodiscard]] const std::optional<contact::SurfaceContact>& contact() const {
        return scene_.obstacles.contact;
    }
    /// *RIGIDWALL, in the order of the deck.
    [[nodiscard]] const std::vector<contact::RigidWall>& walls() const {
        return scene_.obstacles.walls;
    }
    /// One for each rigid part that leads.
    [[nodiscard]] const std::vector<RigidBody>& bodies() const { return scene_.bodies.all; }
    /// Wall time by phase.                                                                  [s]
    [[nodiscard]] const Timings& timings() const { return timings_; }
    /// Found in the first step, or by look_at_contacts().
    [[nodiscard]] BadStarts bad_starts() const { return scene_.bad_starts(); }
    /// As the first step will, at the start.
    void look_at_contacts() { scene_.find_contacts(stable_step().dt); }
    /// Shells that have strains.
    [[nodiscard]] std::size_t active_shells() const { return scene_.cloth.active_shells; }
    /// By DT2MS.                                                                           [kg]
    [[nodiscard]] double added_mass() const { return scene_.cloth.added_mass; }

    /// The next step and who limits it.
    /// @param without_start  as if there were no DTINIT, and no strain to let go
    [[nodiscard]] StepLimit stable_step(bool without_start = false) const {
        return scene_.stable_step(without_start);
    }
    /// What the shells alone allow.
    [[nodiscard]] StepLimit shells_step() const { return scene_.shells_step(); }

    /// At t, inside an observer.
    [[nodiscard]] EnergyBooks books() const { return EnergyAudit::books(scene_); }
    /// Who the entries of samples and frames are.
    [[nodiscard]] RecordLayout layout() const { return Recorder::layout(scene_); }
    /// Of contact and gas on a body, in the kick at t.                               [N]
    [[nodiscard]] Vec3 force_on(const RigidBody& body) const {
        return Recorder::force_on(scene_, body);
    }
    [[nodiscard]] Sample sample() {
        return recorder_.sample(scene_);
    }                                                                ///< at t, inside an observer
    [[nodiscard]] Frame frame() { return recorder_.frame(scene_); }  ///< at t, inside an observer

    /// What a checkpoint holds of it (solver/base/archive.hpp): a scene built from the same model
    /// and seed goes on from there in the same bits.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(scene_, audit_, recorder_);
    }
    /// Whether the numbers that it goes on from are finite; a checkpoint of others is of no use.
    [[nodiscard]] bool is_finite() const;
    /// Tells decks and seeds apart; of models that no deck made, those of other meshes, parts, curves,
    /// ties or bags.
    [[nodiscard]] std::uint64_t fingerprint() const;

private:
    void load_and_kick(double dt, double span, Stopwatch& lap);
    void find_forces(double span, Stopwatch& lap);

    SceneState scene_;
    EnergyAudit audit_;
    Recorder recorder_;
    TouchingNodes touching_;
    Timings timings_;
};

}  // namespace corpuscle
