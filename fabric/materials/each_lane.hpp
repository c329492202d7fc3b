// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "fabric/lanes.hpp"
#include "fabric/materials/own_law.hpp"

namespace corpuscle::fabric {

/// An OwnLaw as blocks of elements ask for it: one lane after the other.
class EachLane {
public:
    explicit EachLane(std::shared_ptr<const OwnLaw> law)
        : law_(std::move(law)), moduli_(law_->moduli()) {}

    [[nodiscard]] const PlaneModuli& moduli() const { return moduli_; }

    template <class Real>
    Stress<Real> stress(const Strain<Real>& e) const {
        Stress<Real> out;
        for (int l = 0; l < WIDTH<Real>; ++l) {
            const Stress<double> s = law_->stress(one(e, l));
            set_lane(out.warp, l, s.warp);
            set_lane(out.weft, l, s.weft);
            set_lane(out.shear, l, s.shear);
            set_lane(out.energy, l, s.energy);
        }
        return out;
    }

    template <class Real>
    Real stiffening(const Strain<Real>& e) const {
        Real out{};
        for (int l = 0; l < WIDTH<Real>; ++l) set_lane(out, l, law_->stiffening(one(e, l)));
        return out;
    }

private:
    template <class Real>
    static Strain<double> one(const Strain<Real>& e, int l) {
        return {get_lane(e.warp, l), get_lane(e.weft, l), get_lane(e.shear, l)};
    }

    std::shared_ptr<const OwnLaw> law_;
    PlaneModuli moduli_;
};

}  // namespace corpuscle::fabric
