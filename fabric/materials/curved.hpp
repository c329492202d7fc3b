// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "fabric/lanes.hpp"
#include "fabric/materials/loading_loop.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// What a curve's axes are (yarn_measures.hpp).
enum class YarnMeasure { GREEN, ENGINEERING };

/// Curves of a woven sheet: warp, weft and the angle between them each on its own.
struct YarnLoops {
    LoadingLoop warp, weft, shear;
};

/// Woven sheet whose yarns follow curves (FORM 4 in GREEN, FORM 14 in ENGINEERING), and a liner if
/// there is one:
///
///     w(E) = w_a(ε_a) + w_b(ε_b) + w_ab(ε_ab) + liner,   S = dw/dE
///
/// Yarns do not feel each other's stretch (no PRBA).
///
/// `moduli()` is the steepest slope of each curve, met or not: step, damping and hourglass control
/// hold for all of it.
class Curved {
public:
    Curved(YarnLoops loops, YarnMeasure measure, const PlaneModuli& liner);

    [[nodiscard]] const PlaneModuli& moduli() const { return moduli_; }
    [[nodiscard]] YarnMeasure measure() const { return measure_; }

    /// One lane after the other: curves are searched, not computed.
    template <class Real>
    Stress<Real> stress(const Strain<Real>& e) const;

    /// How much stiffer than `moduli()` the sheet may be in space at this strain.
    template <class Real>
    Real stiffening(const Strain<Real>& e) const;

protected:
    /// @param answer  (lane, loop, which, strain) -> stress and energy
    template <class Real, class Answer>
    Stress<Real> by(const Answer& answer, const Strain<Real>& e) const;

private:
    YarnLoops loops_;
    YarnMeasure measure_;
    PlaneModuli liner_;  ///< times LRATIO
    PlaneModuli moduli_;
};

/// The same with curves of unloading: stress depends on what each element's points have been
/// through. Energy is what is stored; what loops lose is told apart.
class Looped : public Curved {
public:
    using Curved::Curved;

    using LaneMemory = std::array<LoopMemory, 3>;
    /// Of one point of LANES elements.
    struct Memory {
        std::array<LaneMemory, LANES> lanes;
    };

    /// @param lost  what this move loses is added                              [J/m^3]
    template <class Real>
    Stress<Real> move(const Strain<Real>& e, Memory& memory, Real& lost) const;
};

/// Laws that remember: they have a Memory and are moved.
template <class Law>
concept Remembering = requires {
    typename Law::Memory;
};

}  // namespace corpuscle::fabric
