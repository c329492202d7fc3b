// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What membranes have been through: strains of the start that come back, loops, liners.

#include <algorithm>
#include <cassert>

#include "fabric/membrane_block.hpp"
#include "fabric/membranes.hpp"

namespace corpuscle::fabric {

void Membranes::add_restoring(std::size_t block, const StrainRestoration& how,
                              std::span<const Curve> curves) {
    Restoring r;
    r.block = block;
    r.how = how;
    const Index row = std::max(how.share_curve, how.course_curve);
    if (row >= 0) r.curve = curves[static_cast<std::size_t>(row)];
    restoring_.push_back(std::move(r));
    blocks_[block]->strain_left = 1.0;
}

/// r falls by the share TSRFAC of what is left in every step after the first, or is 1 - the curve.
void Membranes::restore_strains(double t) {
    for (Restoring& r : restoring_) {
        if (r.how.course_curve >= 0)
            r.left = 1.0 - r.curve(t);
        else if (r.steps > 0)
            r.left *= 1.0 - (r.how.share_curve >= 0 ? r.curve(t) : r.how.share);
        if (r.steps++ == 0) r.before = r.left;
        blocks_[r.block]->strain_left = r.left;
    }
}

/// dW/dr = -ΣV·S:E_0: mean of both ends of the step.
void Membranes::book_restored() {
    for (Restoring& r : restoring_) {
        double pull = 0.0;
        for (std::size_t i = 0; i < tasks_.size(); ++i)
            if (tasks_[i].block == r.block) pull += found_[i].pull;
        restored_energy_ += 0.5 * (r.pull + pull) * (r.before - r.left);
        r.pull = pull;
        r.before = r.left;
    }
}

void Membranes::inherit(const Membranes& from, const std::vector<std::uint8_t>& is_new) {
    assert(from.blocks_.size() == blocks_.size());
    for (std::size_t b = 0; b < blocks_.size(); ++b) blocks_[b]->inherit(*from.blocks_[b], is_new);
    lost_energy_ = from.lost_energy_;
    restored_energy_ = from.restored_energy_;
}

void Membranes::visit_past(const std::function<void(std::span<std::byte>)>& visit) {
    for (const Restoring& r : restoring_) blocks_[r.block]->strain_left = r.left;
    for (const auto& block : blocks_) block->visit_past(visit);
}

}  // namespace corpuscle::fabric
