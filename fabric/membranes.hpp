// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "fabric/coat_bending.hpp"
#include "fabric/held_step.hpp"
#include "fabric/membrane_setup.hpp"

namespace corpuscle::fabric {

class MembraneBlock;

/// All shells with strains: internal force, energy, stable step.
///
/// Elements of one part, shape and law form a block; the loop over a block has no options. Elements
/// write corner forces, nodes gather them in a fixed order: results are bitwise the same on any
/// number of threads.
class Membranes {
public:
    /// @throws InputError  naming every shell with an impossible reference shape, and every
    ///                     material with impossible numbers
    explicit Membranes(const MembraneSetup& setup);
    ~Membranes();
    /// What was moved from may only be assigned to or destroyed.
    Membranes(Membranes&&) noexcept;
    /// Likewise.
    Membranes& operator=(Membranes&&) noexcept;

    /// A stable step.
    struct Step {
        double dt;    ///< [s], infinite when nothing is active
        Index shell;  ///< row of the shell that sets it, -1 when nothing does
    };
    /// Least of the elements' stable steps, a lower bound of the mesh's: from reference shape, law,
    /// liner and damping, shortened by the stretch of the last add_force, and held by HeldStep.
    /// Without TSSFAC.
    [[nodiscard]] Step stable_step() const { return {step_.dt(), step_.shell()}; }

    /// f += internal force of positions x at t and, where damped, of velocities v at t - dt/2.
    /// @returns  row of the first shell whose strain or force is not finite, -1 when all are
    [[nodiscard]] Index add_force(const Points& x, const Points& v, Points& f);

    /// Energy stored at the last add_force, with hourglass control and coatings.                [J]
    [[nodiscard]] double strain_energy() const;
    /// By part row.                                                                         [J]
    [[nodiscard]] std::span<const double> part_strain_energy() const { return part_energy_; }

    /// Damping force (DAMP) of the last add_force: N × 3, empty when no part is damped.         [N]
    [[nodiscard]] std::span<const Vec3> damping_force() const { return damping_force_; }

    /// Energy dissipated by damping while the last forces kick v_0 to v_1 over dt:
    /// -Σ f·(v_0 + v_1)/2·dt, exactly its loss of kinetic energy.                               [J]
    [[nodiscard]] double damping_energy(const Points& v_0, const Points& v_1, double dt) const;

    /// Energy dissipated by hysteresis (LCUA, LCUB, LCUAB) up to the last add_force.
    ///                                                                                      [J]
    [[nodiscard]] double lost_energy() const { return lost_energy_; }

    /// TSRFAC: restores one step's share of the initial strain, before add_force at t.
    void restore_strains(double t);
    /// Energy added by TSRFAC up to the last add_force.                                     [J]
    [[nodiscard]] double restored_energy() const { return restored_energy_; }

    /// Copies the history of yarns and liners from membranes of the same shells; shells of `is_new`
    /// (E) start without history.
    void inherit(const Membranes& from, const std::vector<std::uint8_t>& is_new);

    /// What a checkpoint holds of it (solver/base/archive.hpp): numbers, and each block's history
    /// of yarns and liners as a std::span<std::byte>. Read by membranes of the same setup.
    template <class Archive>
    void visit_state(Archive& archive) {
        step_.visit_state(archive);
        archive(lost_energy_);
        archive(restored_energy_);
        for (double& energy : part_energy_) archive(energy);
        for (Restoring& r : restoring_) {
            archive(r.left);
            archive(r.before);
            archive(r.pull);
            archive(r.steps);
        }
        visit_past([&](std::span<std::byte> bytes) { archive(bytes); });
    }

    /// Mass added by mass scaling.
    struct AddedMass {
        std::vector<double> node;  ///< N, to be added to the lumped mass                     [kg]
        double total = 0.0;        ///< may be negative when the step was forced on all       [kg]
    };
    /// Elements that get mass.
    enum class Scaling {
        WHERE_NEEDED,  ///< DT2MS < 0: those with a shorter step
        EVERYWHERE     ///< DT2MS > 0: all; those with a longer step lose mass
    };
    /// Gives elements the mass for which the step `wish` is stable at their reference shape;
    /// stable_step() includes it from then on.
    /// @param wish  greater than 0                                                              [s]
    /// @throws InputError  where a coating's bending allows no such step with any mass
    AddedMass scale_mass(double wish, Scaling where);

    /// For output, E × 3, each shell's mean, zeros for inactive ones: Green strain E11, E22, 2·E12,
    /// and the true stress along the yarns at constant volume, S11·|g1|², S22·|g2|², S12·|g1||g2|.
    /// [-], [Pa]
    void stress_strain(const Points& x, std::span<std::array<float, 3>> stress,
                       std::span<std::array<float, 3>> strain) const;

    /// Bending of coatings; empty: none.
    [[nodiscard]] const CoatBending& coat() const { return coat_; }
    /// Elements that have strains.
    [[nodiscard]] std::size_t element_count() const { return element_count_; }

private:
    struct Task {  ///< consecutive packs of one block
        std::size_t block, begin, end;
    };
    struct TaskResult {  ///< by one task in one add_force
        double energy;
        double rate;  ///< (2/dt)² of the element that limits it [1/s^2]
        Index shell;
        double lost, pull;  ///< [J]
    };
    struct Restoring {  ///< a block with TSRFAC
        std::size_t block;
        StrainRestoration how;
        Curve curve;
        double left = 1.0;    ///< r                                              [-]
        double before = 1.0;  ///< r at the last add_force                        [-]
        double pull = 0.0;    ///< ΣV·S:E_0 at the last add_force                 [J]
        std::int64_t steps = 0;
    };
    /// For every node that has active corners: where their forces lie. Node row i's are
    /// places[starts[i]] .. places[starts[i + 1]].
    struct Gather {
        std::vector<Index> nodes;
        std::vector<std::uint32_t> starts, places;
    };

    [[nodiscard]] Gather gather_of(std::size_t node_count, bool damped) const;
    [[nodiscard]] static std::size_t chunks_of(const Gather& gather);
    void find_rest_rates(const std::vector<double>& mass);
    void find_rest_step();
    void gather_forces(std::size_t chunk, Points& f);
    void gather_damping(std::size_t chunk, Points& f);
    void add_restoring(std::size_t block, const StrainRestoration& how,
                       std::span<const Curve> curves);
    void book_restored();
    void visit_past(const std::function<void(std::span<std::byte>)>& visit);
    void reduce();
    [[nodiscard]] bool all_finite() const;
    [[nodiscard]] Index first_broken(const Points& x) const;

    std::vector<std::unique_ptr<MembraneBlock>> blocks_;
    std::vector<std::size_t> block_start_;  ///< of its corner forces
    std::vector<std::size_t> damped_start_;
    std::vector<Task> tasks_;
    std::vector<TaskResult> found_;
    std::vector<double> corner_force_, corner_damping_;
    Gather gather_, damping_gather_;
    std::vector<double> gather_check_,
        damping_check_;  ///< sums that are finite when all forces are
    std::vector<double> part_energy_;
    Points damping_force_;
    std::vector<Restoring> restoring_;
    double lost_energy_ = 0.0, restored_energy_ = 0.0;
    std::size_t element_count_ = 0, node_count_ = 0;
    struct {
        double rate = 0.0;  ///< (2/dt)² of the reference shapes                        [1/s^2]
        Index shell = -1;   ///< whose it is
    } rest_;
    HeldStep step_;
    CoatBending coat_;
};

}  // namespace corpuscle::fabric
