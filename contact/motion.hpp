// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "contact/cloth.hpp"

namespace corpuscle::contact {

/// How far each patch has moved, as a bound: two nodes of patches a and b cannot have come nearer
/// to each other by more than way(a) + way(b). The motion that all of the cloth has in common is
/// left out, so a bag that flies freely spends nothing.
class Motion {
public:
    explicit Motion(const Cloth& cloth);

    /// Starts at x, expecting a first step of v·dt.
    void start(const Points& x, const Points& v, double dt);

    /// Adds the motion since the last call.
    void follow(const Points& x);

    /// Counts ways from here on.
    void restart() { std::fill(way_.begin(), way_.end(), 0.0); }

    [[nodiscard]] double way(Index patch) const { return way_[patch]; }  ///< so far            [m]
    [[nodiscard]] double step(Index patch) const {
        return step_[patch];
    }  ///< in the last step  [m]

private:
    template <class Displacement>
    void measure(Displacement&& of);

    const Cloth& cloth_;
    std::vector<Index> nodes_;  ///< of the cloth, ascending
    Points last_;
    std::vector<double> way_, step_;
};

}  // namespace corpuscle::contact
