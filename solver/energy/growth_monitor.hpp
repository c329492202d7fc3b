// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// Notices that the step is too long for the fabric, in two ways.
///
/// *Zigzag.* Beyond its limit a mode turns round in every step and grows by eˣ, cosh x = (ω dt)²/2
/// - 1: by a tenth at 0.1 % above the limit, by a third at 1 %. A stable mode at 0.9 of its limit
/// grows for two steps in a row at most. So a node where the change of the fabric's own kick turns
/// round and grows TURNS times in a row, to GROWN times what it was, and swings by SWING of its
/// shells' size, is part of an unstable mode. Contacts that come and go from step to step shake
/// fabric in the same way, by far less.
///
/// *Energy.* Fabric that goes slack and taut within a step grows by no law; but it then holds
/// energy that nothing has given to it. With v_0 the velocity before the kick, k what the fabric's
/// own forces f make of it in the kick, and W the strain energy, all of it at t,
///
///     E° = Σ m v_0·(v_0 + k)/2 + W,    k = f span/m
///     E° - E°(0) = G,                  G: work of all other forces, up to the kick before
///
/// exactly, for linear elements in steps of one length, stable or not, whatever the others do:
/// gas, contact, supports and loads enter E° with the next v_0, with all the work that they did.
/// What E° has gained beyond G has come from nowhere. Of a mode at θ = ω dt/2 of its limit
///
///     E° = Σ m |v_0 + k/2|²/2 + (1 - θ²) W,    S = Σ m k²/8 = θ² W <= θ²/(1 - θ²) (E°(0) + G)
///
/// so its swing S is at most 4.3 times what it was given at θ = 0.9, and has no bound at θ = 1.
/// Nodes that others lead have given W half of their work in this kick: - span Σ f·v_0 / 2 of them.
/// Only the fabric's kick k counts in S: a hit of the gas on cloth at rest gives v_0, not k.
///
/// The fabric is unstable when it has gained MOST times as much as it was ever given (E°(0) and the
/// greatest G so far), or with the swing MOST_WITH_SWING times, and that is no trifle. The caller
/// says what is: an element that goes from slack to taut in a step of θ <= 0.9 may end with five
/// times its energy, before another loses as much; and rounding moves places by 1e-16 of them,
/// which is all that fabric at rest has.
class GrowthMonitor {
public:
    /// Turns in a row that are no chance.                                                   [-]
    static constexpr int TURNS = 24;
    /// Growth since the first of these turns that is no chance.                             [-]
    static constexpr double GROWN = 10.0;
    /// Swing that is no trifle, of the shortest edge at the node.                           [-]
    static constexpr double SWING = 1e-3;
    /// Energy from nowhere that makes fabric unstable, of scale().                          [-]
    static constexpr double MOST = 1.0;
    /// The same with the swing S.                                                           [-]
    static constexpr double MOST_WITH_SWING = 5.0;

    GrowthMonitor() = default;
    /// @param nodes  of the fabric, that are free to move
    /// @param size   of all nodes: the shortest edge of the shells there                [m]
    GrowthMonitor(std::vector<Index> nodes, std::vector<double> size)
        : nodes_(std::move(nodes)),
          size_(std::move(size)),
          kick_(size_.size(), Vec3::Zero()),
          change_(kick_),
          trace_(size_.size()) {}

    /// Takes the fabric's forces in this step.
    /// @param f     of the fabric alone, N × 3                                         [N]
    /// @param span  time for which they act                                            [s]
    /// @returns  row of a node that zigzags, -1 when none does
    [[nodiscard]] Index zigzag(const Points& f, const std::vector<double>& mass, double span);

    /// Energies of the fabric in the step at t.
    struct Instant {
        double strain;       ///< at t, with what loops have lost                        [J]
        double inner_work;   ///< of the fabric's forces in this kick, on all nodes      [J]
        double inner_early;  ///< the same if nothing had been kicked: span Σ f·v_0     [J]
    };
    /// Takes the energies of this step; k is that of the last zigzag().
    /// @returns  has the fabric gained too much from nowhere, if spurious() is no trifle?
    [[nodiscard]] bool gains(const Instant& now, const std::vector<double>& mass, const Points& v_0,
                             const Points& v_1);
    /// Energy that came otherwise: a reference shape that begins to count.               [J]
    void give(double energy) { given_ += energy; }

    /// What the fabric's forces gave a node in the last step.                          [m/s]
    [[nodiscard]] const Vec3& kick(Index node) const { return kick_[node]; }
    /// The node whose last kick holds most energy.
    [[nodiscard]] Index most_kicked(const std::vector<double>& mass) const;
    [[nodiscard]] double gained() const { return gained_; }      ///< E° - E°(0) - G       [J]
    [[nodiscard]] double spurious() const { return spurious_; }  ///< what gains() has found [J]
    [[nodiscard]] double scale() const { return scale_; }        ///< most it was given      [J]

    /// All of it, for a checkpoint.
    template <class Archive>
    void visit_state(Archive& archive) {
        for (Points* const all : {&kick_, &change_})
            for (Vec3& v : *all)
                for (int i = 0; i < 3; ++i) archive(v[i]);
        for (Trace& trace : trace_) {
            archive(trace.first);
            archive(trace.turns);
        }
        for (double* number : {&start_, &open_, &given_, &scale_, &gained_, &kinetic_})
            archive(*number);
        archive(is_open_);
    }

private:
    struct Trace {
        double first = 0.0;      ///< |change|² when it began to turn and grow  [m²/s²]
        std::int32_t turns = 0;  ///< since then
    };

    std::vector<Index> nodes_;
    std::vector<double> size_;  ///< of the shells at each node                  N [m]
    Points kick_, change_;      ///< by the fabric, and from that before         N × 3 [m/s]
    std::vector<Trace> trace_;  ///< N
    double start_ = 0.0;        ///< E° at the start, with half the others' work in its kick
    double open_ = 0.0;         ///< K + W at the start
    double given_ = 0.0, scale_ = 0.0, gained_ = 0.0, spurious_ = 0.0;  ///< [J]
    double kinetic_ = 0.0;  ///< after the last kick                                   [J]
    bool is_open_ = false;
};

}  // namespace corpuscle
