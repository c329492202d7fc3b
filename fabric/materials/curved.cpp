// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/materials/curved.hpp"

#include <utility>

#include "fabric/materials/lane_by_lane.hpp"
#include "fabric/materials/yarn_measures.hpp"

namespace corpuscle::fabric {
namespace {

/// use(measure of a strain), for each measure on its own.
template <class Use>
auto measured(YarnMeasure which, const Use& use) {
    return which == YarnMeasure::GREEN
               ? use([](const Strain<double>& e) { return GreenMeasure(e); })
               : use([](const Strain<double>& e) { return EngineeringMeasure(e); });
}

}  // namespace

Curved::Curved(YarnLoops loops, YarnMeasure measure, const PlaneModuli& liner)
    : loops_(std::move(loops)), measure_(measure), liner_(liner) {
    moduli_ =
        PlaneModuli{loops_.warp.steepest(), 0.0, loops_.weft.steepest(), loops_.shear.steepest()} +
        liner_;
}

template <class Real, class Answer>
Stress<Real> Curved::by(const Answer& answer, const Strain<Real>& strains) const {
    const auto by_measure = [&](const auto& measure_of) {
        return stress_by_lane(strains, [&](int lane, const Strain<double>& e) {
            const auto measure = measure_of(e);
            const Strain<double> strain = measure.strain();
            const double sign = strain.shear < 0.0 ? -1.0 : 1.0;
            const auto [warp, warp_energy] = answer(lane, loops_.warp, 0, strain.warp);
            const auto [weft, weft_energy] = answer(lane, loops_.weft, 1, strain.weft);
            const auto [shear, shear_energy] = answer(lane, loops_.shear, 2, sign * strain.shear);
            Stress<double> s = measure.stress(warp, weft, sign * shear);
            const Stress<double> l = liner_.times(e);
            s.energy = warp_energy + weft_energy + shear_energy +
                       0.5 * (l.warp * e.warp + l.weft * e.weft + l.shear * e.shear);
            return Stress<double>{s.warp + l.warp, s.weft + l.weft, s.shear + l.shear, s.energy};
        });
    };
    return measured(measure_, by_measure);
}

template <class Real>
Stress<Real> Curved::stress(const Strain<Real>& e) const {
    const auto on_curve = [](int, const LoadingLoop& loop, int, double strain) {
        const StressCurve::Point on = loop.load().at(strain);
        return std::pair(on.stress, on.energy);
    };
    return by(on_curve, e);
}

template <class Real>
Real Curved::stiffening(const Strain<Real>& e) const {
    return measured(measure_, [&](const auto& measure_of) {
        return number_by_lane(
            e, [&](const Strain<double>& one) { return measure_of(one).stiffening(moduli_); });
    });
}

template <class Real>
Stress<Real> Looped::move(const Strain<Real>& e, Memory& memory, Real& lost) const {
    Real loss{};
    const auto moved = [&](int lane, const LoadingLoop& loop, int which, double strain) {
        const LoadingLoop::Answer a = loop.move(
            strain, memory.lanes[static_cast<std::size_t>(lane)][static_cast<std::size_t>(which)]);
        set_lane(loss, lane, get_lane(loss, lane) + a.lost);
        return std::pair(a.stress, a.stored);
    };
    const Stress<Real> s = by(moved, e);
    lost += loss;
    return s;
}

template Stress<double> Curved::stress(const Strain<double>&) const;
template Stress<Lanes> Curved::stress(const Strain<Lanes>&) const;
template double Curved::stiffening(const Strain<double>&) const;
template Lanes Curved::stiffening(const Strain<Lanes>&) const;
template Stress<Lanes> Looped::move(const Strain<Lanes>&, Memory&, Lanes&) const;

}  // namespace corpuscle::fabric
