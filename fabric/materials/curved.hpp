// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <utility>

#include "fabric/lanes.hpp"
#include "fabric/materials/loading_loop.hpp"
#include "fabric/materials/plane_stress.hpp"
#include "fabric/materials/yarn_measures.hpp"

namespace corpuscle::fabric {

/// Curves of a woven sheet: warp, weft and the angle between them each on its own.
struct YarnLoops {
    LoadingLoop warp, weft, shear;
};

/// Woven sheet whose yarns follow curves (FORM 4 with GreenMeasure, FORM 14 with
/// EngineeringMeasure), and a liner if there is one:
///
///     w(E) = w_a(ε_a) + w_b(ε_b) + w_ab(ε_ab) + liner,   S = dw/dE
///
/// Yarns do not feel each other's stretch (no PRBA). Each lane is worked out on its own: curves are
/// searched, not computed.
///
/// `moduli()` is the steepest slope of each curve, met or not: step, damping and hourglass control
/// hold for all of it.
template <class Measure>
class Curved {
public:
    Curved(YarnLoops loops, const PlaneModuli& liner) : loops_(std::move(loops)), liner_(liner) {
        moduli_ = PlaneModuli{loops_.warp.steepest(), 0.0, loops_.weft.steepest(),
                              loops_.shear.steepest()} +
                  liner_;
    }

    [[nodiscard]] const PlaneModuli& moduli() const { return moduli_; }

    template <class Real>
    Stress<Real> stress(const Strain<Real>& e) const {
        Stress<Real> out{};
        for (int l = 0; l < WIDTH<Real>; ++l)
            put(out, l, one(lane_of(e, l), [](const LoadingLoop& loop, int, double strain) {
                    const StressCurve::Point on = loop.load().at(strain);
                    return std::pair(on.stress, on.energy);
                }));
        return out;
    }

    /// How much stiffer than `moduli()` the sheet may be in space at this strain.
    template <class Real>
    Real stiffening(const Strain<Real>& e) const {
        Real out{};
        for (int l = 0; l < WIDTH<Real>; ++l)
            set_lane(out, l, Measure(lane_of(e, l)).stiffening(moduli_));
        return out;
    }

protected:
    /// @param answer  (loop, which, strain) -> stress and energy
    template <class Answer>
    Stress<double> one(const Strain<double>& e, const Answer& answer) const {
        const Measure measure(e);
        const Strain<double> strain = measure.strain();
        const double sign = strain.shear < 0.0 ? -1.0 : 1.0;
        const auto [warp, warp_energy] = answer(loops_.warp, 0, strain.warp);
        const auto [weft, weft_energy] = answer(loops_.weft, 1, strain.weft);
        const auto [shear, shear_energy] = answer(loops_.shear, 2, sign * strain.shear);
        Stress<double> s = measure.stress(warp, weft, sign * shear);
        const Stress<double> l = liner_.times(e);
        s.energy = warp_energy + weft_energy + shear_energy +
                   0.5 * (l.warp * e.warp + l.weft * e.weft + l.shear * e.shear);
        return {s.warp + l.warp, s.weft + l.weft, s.shear + l.shear, s.energy};
    }

    template <class Real>
    static Strain<double> lane_of(const Strain<Real>& e, int l) {
        return {get_lane(e.warp, l), get_lane(e.weft, l), get_lane(e.shear, l)};
    }
    template <class Real>
    static void put(Stress<Real>& to, int l, const Stress<double>& s) {
        set_lane(to.warp, l, s.warp);
        set_lane(to.weft, l, s.weft);
        set_lane(to.shear, l, s.shear);
        set_lane(to.energy, l, s.energy);
    }

private:
    YarnLoops loops_;
    PlaneModuli liner_;  ///< times LRATIO
    PlaneModuli moduli_;
};

/// The same with curves of unloading: stress depends on what each element's points have been
/// through. Energy is what is stored; what loops lose is told apart.
template <class Measure>
class Looped : public Curved<Measure> {
public:
    using Curved<Measure>::Curved;

    /// Of one point of LANES elements.
    struct Memory {
        std::array<std::array<LoopMemory, 3>, LANES> lanes;
    };

    /// @param lost  what this move loses is added                              [J/m^3]
    template <class Real>
    Stress<Real> move(const Strain<Real>& e, Memory& memory, Real& lost) const {
        Stress<Real> out{};
        for (int l = 0; l < WIDTH<Real>; ++l) {
            double loss = 0.0;
            auto& loops = memory.lanes[static_cast<std::size_t>(l)];
            this->put(out, l,
                      this->one(this->lane_of(e, l),
                                [&](const LoadingLoop& loop, int which, double strain) {
                                    const LoadingLoop::Answer a =
                                        loop.move(strain, loops[static_cast<std::size_t>(which)]);
                                    loss += a.lost;
                                    return std::pair(a.stress, a.stored);
                                }));
            set_lane(lost, l, get_lane(lost, l) + loss);
        }
        return out;
    }
};

/// Laws that remember: they have a Memory and are moved.
template <class Law>
concept Remembering = requires {
    typename Law::Memory;
};

}  // namespace corpuscle::fabric
