// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/bounds.hpp"

#include <algorithm>
#include <limits>

namespace corpuscle::contact {
void Bounds::include(const Bounds& other) {
    for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], other.low[k]);
        high[k] = std::max(high[k], other.high[k]);
    }
}

EightBounds::EightBounds() {
    low.fill(all_eight(std::numeric_limits<float>::infinity()));
    high.fill(all_eight(-std::numeric_limits<float>::infinity()));
}

void EightBounds::set(int lane, const Bounds& box) {
    for (int k = 0; k < 3; ++k) {
        low[k][lane] = box.low[k];
        high[k][lane] = box.high[k];
    }
}

Bounds EightBounds::all() const {
    Bounds out = (*this)[0];
    for (int lane = 1; lane < EIGHT; ++lane) out.include((*this)[lane]);
    return out;
}

}  // namespace corpuscle::contact
