// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"

namespace corpuscle::fabric {

/// Laws that are searched, or not the library's: worked out for one lane after the other.

template <class Real>
Strain<double> lane_of(const Strain<Real>& e, int lane) {
    return {get_lane(e.warp, lane), get_lane(e.weft, lane), get_lane(e.shear, lane)};
}

/// @param law  (lane, strain) -> stress
template <class Real, class Law>
Stress<Real> stress_by_lane(const Strain<Real>& e, const Law& law) {
    Stress<Real> out{};
    for (int l = 0; l < WIDTH<Real>; ++l) {
        const Stress<double> s = law(l, lane_of(e, l));
        set_lane(out.warp, l, s.warp);
        set_lane(out.weft, l, s.weft);
        set_lane(out.shear, l, s.shear);
        set_lane(out.energy, l, s.energy);
    }
    return out;
}

/// @param number  strain -> number
template <class Real, class Number>
Real number_by_lane(const Strain<Real>& e, const Number& number) {
    Real out{};
    for (int l = 0; l < WIDTH<Real>; ++l) set_lane(out, l, number(lane_of(e, l)));
    return out;
}

}  // namespace corpuscle::fabric
