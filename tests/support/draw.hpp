// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <random>

namespace corpuscle::support {

/// Random numbers of a seed, the same on every platform.
class Draw {
public:
    explicit Draw(unsigned seed) : random_(seed) {}

    double in(double low, double high) {  ///< uniform
        return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
    }
    double log_in(double low, double high) {  ///< uniform in the logarithm
        return low * std::pow(high / low, in(0.0, 1.0));
    }
    int below(int n) { return static_cast<int>(in(0.0, n)); }  ///< 0 to n - 1
    bool chance(double share) { return in(0.0, 1.0) < share; }

private:
    std::mt19937 random_;
};

}  // namespace corpuscle::support
