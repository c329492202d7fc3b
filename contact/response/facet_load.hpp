// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "contact/surface/cloth.hpp"
#include "contact/surface/contact_list.hpp"

namespace corpuscle::contact {

/// Normal forces of contact on the facets, mean over a time: all that a contact's impulse came to,
/// its pressure and what stopped it alike. An impulse acts in one step, so a single step says little.
///
/// A contact presses each of its nodes with J = |weight| · impulse along its normal n. Kept by node
/// is T = sum of J n nᵀ; its trace, the node's whole load, goes to the triangles there in
/// proportion to area · N·T N, N their normal: facets that a contact does not face get nothing of
/// it. What presses from both sides adds up, so the loads of all triangles sum to twice the normal
/// forces of all contacts. Friction, and impact zones, are not in it.
class FacetLoad {
public:
    explicit FacetLoad(const Cloth& cloth);

    void add(const Contact& contact);          ///< once it has its impulse of the step
    void pass(double span) { time_ += span; }  ///< for which the step's impulses stand     [s]
    [[nodiscard]] std::vector<double> forces(const Points& x) const;  ///< by triangle           [N]
    void clear();

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(taken_, time_);
    }

private:
    using Tensor = std::array<double, 6>;  ///< xx yy zz xy yz zx

    const Cloth& cloth_;
    std::vector<Tensor> taken_;  ///< T by node row                                            [N s]
    double time_ = 0.0;          ///< [s]
};

}  // namespace corpuscle::contact
