// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "fabric/membrane_setup.hpp"

namespace corpuscle::fabric {

/// Bending of coated cloth (ECOAT, TCOAT of *MAT_FABRIC), which lies flat without stress.
///
///     W = ½ ∫ B (|x,11|² + |x,22|² + 2 |x,12|²) dA
///     B = (2/3)·E_c·((h/2 + t)³ - (h/2)³)               two coats of thickness t      [N·m]
///     W = ½ Σ_r c_r |y_r|²,   y_r = Σ_m w_rm (x_m - x_n),   f_m = -Σ_r c_r w_rm y_r
///
/// x,ij: second derivatives of the places over the flat cloth, at its nodes (CoatPatch), three rows
/// r a node. Of a sheet that hardly stretches they are its curvatures times the normal, and W is
/// Kirchhoff's energy of a plate with ν = 0, for no Poisson's ratio of the coat is given. W is a
/// square of the places and its force linear: no fold, inversion or loss of area can break it. It
/// pushes nowhere in all, turns nothing, and an even stretch stores nothing.
///
/// A node bends where the cloth runs on all around it: every edge there has two shells of the part
/// whose reference shapes meet and lie in one plane (within SEAM). Rims and seams do not bend; the
/// cloth beside them is reckoned to the nodes next to it, as curved as there.
class CoatBending {
public:
    static constexpr double SEAM = 0.02;  ///< bend of the reference shape that is a seam     [rad]

    CoatBending() = default;
    /// @param mass  N [kg]
    CoatBending(const MembraneSetup& setup, const std::vector<double>& mass);

    /// Whether nothing bends: no coat, or no node that the cloth surrounds.
    [[nodiscard]] bool empty() const { return rows_.empty(); }

    /// f -= dW/dx
    void add_force(const Points& x, Points& f);
    /// Adds the energy at the last add_force.                                             P [J]
    void add_energy(std::vector<double>& part_energy) const;

    /// Bound of the highest frequency squared: of row sums of M^(-½) Q M^(-½) [Gershgorin]. [1/s^2]
    [[nodiscard]] double rate() const { return rate_; }
    /// A step that is stable with this bending besides, if `dt` is without it. From 1 - a - b > 0
    /// with a ∝ dt of damping and b ∝ dt² of stiffness:  dt / (1 + ω² dt²/4)                [s]
    [[nodiscard]] double shortened(double dt) const { return dt / (1.0 + 0.25 * rate_ * dt * dt); }
    /// The step that shortened() takes to `dt`, infinite if none does.                      [s]
    [[nodiscard]] double lengthened(double dt) const;

    /// Nodes that shells of a part surround, and those of them where a seam keeps the coat from
    /// bending.
    struct Coated {
        Index part;             ///< row
        std::size_t inner = 0,  ///< nodes that its shells surround
            sewn = 0;           ///< of these, nodes that a seam keeps from bending
    };
    /// Of each part with a coat.
    [[nodiscard]] const std::vector<Coated>& parts() const { return parts_; }

private:
    struct Row {
        Index node;
        std::uint32_t begin, end;  ///< its entries
        double factor;             ///< c_r                                           [N·m^3]
    };
    struct Entry {
        Index node;
        double weight;  ///< w_rm                                                     [1/m^2]
    };
    struct Pull {  ///< what row `row` does to a node
        std::uint32_t row;
        double weight;  ///< c_r w_rm, or -c_r Σ w_rm on the row's own node            [N·m]
    };

    void add_part(const MembraneSetup& setup, Index part, double stiffness);
    void gather(std::size_t node_count);
    void find_rate(const std::vector<double>& mass);

    std::vector<Row> rows_;  ///< part by part, nodes ascending, 11, 22, 12
    std::vector<Entry> entries_;
    std::vector<std::pair<Index, std::size_t>> part_end_;  ///< part row, end of its rows
    std::vector<Coated> parts_;
    std::vector<Index> nodes_;  ///< that are pulled
    std::vector<std::uint32_t> starts_;
    std::vector<Pull> pulls_;
    Points bend_;  ///< y of every row at the last add_force                      [1/m]
    double rate_ = 0.0;
};

}  // namespace corpuscle::fabric
