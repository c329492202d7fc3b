// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "solver/base/simd.hpp"

namespace corpuscle::contact {

/// One box, in single precision.                                                            [m]
struct Bounds {
    std::array<float, 3> low, high;

    [[nodiscard]] bool overlaps(const Bounds& other) const {
        bool is = true;
        for (int k = 0; k < 3; ++k) is &= low[k] <= other.high[k] && other.low[k] <= high[k];
        return is;
    }
    void include(const Bounds& other);
};

/// Eight boxes.                                                                             [m]
struct EightBounds {
    EightPoints low, high;

    EightBounds();  ///< overlap with nothing
    void set(int lane, const Bounds& box);
    [[nodiscard]] Bounds operator[](int lane) const {
        return {{low[0][lane], low[1][lane], low[2][lane]},
                {high[0][lane], high[1][lane], high[2][lane]}};
    }
    [[nodiscard]] Bounds all() const;

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
