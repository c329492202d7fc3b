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

/// One step: start, length, limiter.
struct StepReport {
    double t,         ///< where the step began  [s]
        dt;           ///< how long it was, to t + dt  [s]
    StepLimit limit;  ///< of dt, and its cause
};

/// A scene in motion, step by step, with its energy balance and its records.
///
///     Simulation simulation(read_deck(path));
///     while (!simulation.is_over()) simulation.step(look);
///     simulation.close(look);
class Simulation {
public:
    /// @param seed  of all random numbers: same model and seed, same bits on any number of threads
    /// @throws InputError  with all faults of the scene as a whole (a bag that is not closed, a
    ///                     shell without area, ...)
    explicit Simulation(Model model, std::uint64_t seed = 1) : scene_(std::move(model), seed) {}

    /// Called once a step, when positions, forces and energy balance are at t; never empty.
    using Observer = std::function<void(Simulation&)>;

    /// Advances the scene from t to t + dt (step.cpp).
    /// @throws PhysicsError  with the time, where the result is not physical (solver/stops.cpp)
    StepReport step(const Observer& observe);

    /// Brings forces and energy balance to the end time, for the last observation.
    /// @throws PhysicsError  likewise
    void close(const Observer& observe);

    /// Whether t has reached the end time.
    [[nodiscard]] bool is_over() const { return scene_.clock.t >= scene_.model.end_time; }
    [[nodiscard]] double time() const { return scene_.clock.t; }            ///< t            [s]
    [[nodiscard]] std::int64_t steps() const { return scene_.clock.step; }  ///< made so far
    [[nodiscard]] std::size_t particles() const { return scene_.particles(); }  ///< of all bags
    /// All moving parts, and their state.
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
    /// Empty: the deck has no contact.
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
    /// Pairs that are too near or cross at the start; after look_at_contacts() or the first step.
    [[nodiscard]] BadStarts bad_starts() const { return scene_.bad_starts(); }
    /// Finds the contacts at the start, without a step.
    void look_at_contacts() { scene_.find_contacts(stable_step().dt); }
    /// Shells that have strains.
    [[nodiscard]] std::size_t active_shells() const { return scene_.cloth.active_shells; }
    /// Mass added by DT2MS.                                                                  [kg]
    [[nodiscard]] double added_mass() const { return scene_.cloth.added_mass; }

    /// Length of the next step, and its limiter.
    /// @param without_start  ignores DTINIT and initial strain
    [[nodiscard]] StepLimit stable_step(bool without_start = false) const {
        return scene_.stable_step(without_start);
    }
    /// Stable step of the shells alone.
    [[nodiscard]] StepLimit shells_step() const { return scene_.shells_step(); }

    /// Energy balance at t; inside an observer.
    [[nodiscard]] EnergyBooks books() const { return EnergyAudit::books(scene_); }
    /// Ids and names of the entries of samples and frames.
    [[nodiscard]] RecordLayout layout() const { return Recorder::layout(scene_); }
    /// Force of contact and gas on a body, in the kick at t.                         [N]
    [[nodiscard]] Vec3 force_on(const RigidBody& body) const {
        return Recorder::force_on(scene_, body);
    }
    /// One row of every history at t, inside an observer; means are since the last one.
    [[nodiscard]] Sample sample() { return recorder_.sample(scene_); }
    /// The same between two samples, of which the next one knows nothing.
    [[nodiscard]] Sample glance() const { return recorder_.glance(scene_); }
    [[nodiscard]] Frame frame() { return recorder_.frame(scene_); }  ///< at t, inside an observer

    /// State for a checkpoint (solver/base/archive.hpp). A scene of the same model and seed
    /// continues from it bitwise identically.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(scene_, audit_, recorder_);
    }
    /// Whether all numbers of the state are finite, as a checkpoint requires.
    [[nodiscard]] bool is_finite() const;
    /// Differs between decks and seeds; for models without a deck, between meshes, parts, curves,
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
