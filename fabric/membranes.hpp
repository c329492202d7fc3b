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

/// All shells that can be strained: internal force, energy, stable step.
///
/// Elements of one part, shape and law form a block; a block's loop knows no options. Corner forces
/// are written once by their element and gathered by node in a fixed order: same bits on any number
/// of threads.
class Membranes {
public:
    /// @throws InputError  naming every shell whose reference shape, and every material whose
    ///                     numbers are impossible
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
    /// Largest stable step of any element alone, which bounds that of the mesh: from the reference
    /// shape, law, liner and damping, shortened by the stretch that add_force has met, and held as
    /// HeldStep says. No TSSFAC.
    [[nodiscard]] Step stable_step() const { return {step_.dt(), step_.shell()}; }

    /// f += internal force of positions x at t and, where damped, of velocities v at t - dt/2.
    /// @returns  row of the first shell whose strain or force is not finite, -1 when all are
    [[nodiscard]] Index add_force(const Points& x, const Points& v, Points& f);

    /// Energy stored at the last add_force, hourglass control and bent coats included.          [J]
    [[nodiscard]] double strain_energy() const;
    /// By part row.                                                                         [J]
    [[nodiscard]] std::span<const double> part_strain_energy() const { return part_energy_; }

    /// The part of the last add_force that came from DAMP: N × 3, empty when no part is damped. [N]
    [[nodiscard]] std::span<const Vec3> damping_force() const { return damping_force_; }

    /// What damping takes out of the motion while the last forces kick v_0 to v_1 over dt:
    /// -Σ f·(v_0 + v_1)/2·dt, exactly the loss of kinetic energy that it causes.                [J]
    [[nodiscard]] double damping_energy(const Points& v_0, const Points& v_1, double dt) const;

    /// What loops of loading and unloading (LCUA, LCUB, LCUAB) have lost up to the last
    /// add_force.                                                                           [J]
    [[nodiscard]] double lost_energy() const { return lost_energy_; }

    /// TSRFAC: one step's share of the start's strains comes back, before add_force at t.
    void restore_strains(double t);
    /// Energy that has come with them up to the last add_force.                             [J]
    [[nodiscard]] double restored_energy() const { return restored_energy_; }

    /// Takes over what yarns and liners have been through from membranes of the same shells; those
    /// of `is_new` (E) begin anew.
    void inherit(const Membranes& from, const std::vector<std::uint8_t>& is_new);

    /// Everything that is not a function of the setup, for a checkpoint: archive(number) for one,
    /// archive(std::span<std::byte>) for many, in the same order for writing and reading.
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

    /// What mass scaling adds.
    struct AddedMass {
        std::vector<double> node;  ///< N, to be added to the lumped mass                     [kg]
        double total = 0.0;        ///< may be negative when the step was forced on all       [kg]
    };
    /// Which elements take mass.
    enum class Scaling {
        WHERE_NEEDED,  ///< DT2MS < 0: those whose own step is shorter
        EVERYWHERE     ///< DT2MS > 0: all; mass is taken from those whose step is longer
    };
    /// Gives elements the mass for which the step `wish` is stable at their reference shape;
    /// stable_step() knows of it from then on.
    /// @param wish  greater than 0                                                              [s]
    /// @throws InputError  where bending of a coat alone allows no such step, of whatever mass
    AddedMass scale_mass(double wish, Scaling where);

    /// For pictures, warp, weft and shear of every shell's mean strain, zeros for inactive ones (E
    /// × 3): Green strain E11, E22, 2·E12, and the true stress of cloth of unchanged volume on its
    /// yarns, S11·|g1|², S22·|g2|², S12·|g1||g2|. [-], [Pa]
    void stress_strain(const Points& x, std::span<std::array<float, 3>> stress,
                       std::span<std::array<float, 3>> strain) const;

    /// Bending of coats; empty: none.
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
