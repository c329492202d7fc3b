// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "fabric/materials/lane_by_lane.hpp"
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
        return stress_by_lane(
            e, [&](int, const Strain<double>& of_one) { return law_->stress(of_one); });
    }

    template <class Real>
    Real stiffening(const Strain<Real>& e) const {
        return number_by_lane(
            e, [&](const Strain<double>& of_one) { return law_->stiffening(of_one); });
    }

private:
    std::shared_ptr<const OwnLaw> law_;
    PlaneModuli moduli_;
};

}  // namespace corpuscle::fabric
