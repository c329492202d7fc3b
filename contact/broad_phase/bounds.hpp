// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "solver/base/simd.hpp"

namespace corpuscle::contact {

/// One box, in single precision.                                                            [m]
struct Bounds {
    std::array<float, 3> low, high;

    void include(const Bounds& other) {
        for (int k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], other.low[k]);
            high[k] = std::max(high[k], other.high[k]);
        }
    }
};

/// Eight boxes.                                                                             [m]
struct EightBounds {
    EightPoints low, high;

    EightBounds() {  ///< overlap with nothing
        low.fill(all_eight(std::numeric_limits<float>::infinity()));
        high.fill(all_eight(-std::numeric_limits<float>::infinity()));
    }
    void set(int lane, const Bounds& box) {
        for (int k = 0; k < 3; ++k) {
            low[k][lane] = box.low[k];
            high[k][lane] = box.high[k];
        }
    }
    [[nodiscard]] Bounds operator[](int lane) const {
        return {{low[0][lane], low[1][lane], low[2][lane]},
                {high[0][lane], high[1][lane], high[2][lane]}};
    }
    [[nodiscard]] Bounds all() const {
        Bounds out = (*this)[0];
        for (int lane = 1; lane < EIGHT; ++lane) out.include((*this)[lane]);
        return out;
    }

    /// Bit l: box l overlaps with the other.
    [[nodiscard]] unsigned overlapping(const Bounds& other) const {
        EightBits is = low[0] <= other.high[0];
        for (int k = 0; k < 3; ++k) {
            if (k > 0) is &= low[k] <= other.high[k];
            is &= high[k] >= other.low[k];
        }
        return bits_of(is);
    }
};

}  // namespace corpuscle::contact
