// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "fabric/materials/stress_curve.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// What one yarn, or the angle between two, remembers.
struct LoopMemory {
    double most = 0.0;       ///< greatest strain so far                         [-]
    double back = 0.0;       ///< least strain since then                        [-]
    double strain = 0.0;     ///< now                                            [-]
    double stored = 0.0;     ///< work that has been done and not yet lost       [J/m^3]
    bool unloading = false;  ///< has left the curve of loading
};

/// Stress of a yarn that unloads lower than it was loaded. Loading follows the curve L. From the
/// greatest strain e_m on, unloading keeps that share of L that the curve U has,
///
///     s(e) = L(e) ρ(e/e_m),   ρ(ξ) = U(ξ e_U)/L(ξ e_U),   ρ(1) = 1
///
/// with e_U where U meets L, or its end (U is then raised to meet L): from e_U the way back is U
/// itself, from elsewhere it is U stretched along L (of a straight or a power-law L: scaled both
/// ways). Reloading from e_r goes back the same way (RL = 0), along the chord to (e_m, L(e_m))
/// where that is higher (RL = 1), or in between. Energy is lost when unloading begins: by then it
/// is known how much of the work comes back.
///
/// Departs from a plain scaling of U both ways, which gives energy where L stiffens faster than U.
class LoadingLoop {
public:
    explicit LoadingLoop(StressCurve load) : load_(std::move(load)) {}
    /// @param reload  RL, 0 to 1
    LoadingLoop(StressCurve load, const Curve& unload, double reload);

    struct Answer {
        double stress;  ///< [Pa]
        double stored;  ///< [J/m^3]
        double lost;    ///< by this move                                      [J/m^3]
    };
    /// Moves to a strain; the same strain again changes nothing, one that is not finite neither.
    Answer move(double strain, LoopMemory& memory) const;

    [[nodiscard]] const StressCurve& load() const { return load_; }
    [[nodiscard]] bool remembers() const { return share_.has_value(); }
    /// Greatest slope of any path, k (ρ + ξ ρ') with k the steepest of L.      [Pa]
    [[nodiscard]] double steepest() const;

    /// What is wrong with U, as "... expected" has it: where a loop would give energy. Checked on a
    /// grid of turning points.
    [[nodiscard]] std::string fault() const;

private:
    [[nodiscard]] double crossing(const Curve& unload) const;
    [[nodiscard]] double path(double strain, const LoopMemory& at) const;
    [[nodiscard]] double work(double from, double to, const LoopMemory& at) const;
    [[nodiscard]] bool loops_lose(double most) const;

    StressCurve load_;
    std::optional<StressCurve> share_;  ///< ρ - ρ(0) on 0 to 1, and straight on either side
    double share_at_0_ = 0.0;           ///< ρ(0)
    double meets_ = NaN;                ///< e_U
    double reload_ = 0.0;
    bool is_above_ = false;  ///< U exceeds L somewhere below e_U
};

}  // namespace corpuscle::fabric
