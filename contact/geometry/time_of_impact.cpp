// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/geometry/time_of_impact.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {
namespace {

constexpr double SPARED = 0.1;  ///< part of the distance that must remain
constexpr int MOST_ADVANCES =
    64;  ///< a pair that needs more glances past another so closely that it counts as hit

}  // namespace

double time_of_impact(const Pair& pair, const Corners& x, Corners displacement, double thickness) {
    const double motion = greatest_approach(pair, displacement);
    const Vec3 mean =
        0.25 * (displacement[0] + displacement[1] + displacement[2] + displacement[3]);
    for (Vec3& d : displacement) d -= mean;

    double distance = nearest(pair, x).apart.norm();
    const double spared = SPARED * std::min(distance, thickness);
    if (motion < distance - spared || distance == 0.0) return NO_IMPACT;

    Corners moved;
    double time = 0.0;
    for (int n = 0; n < MOST_ADVANCES; ++n) {
        time += (1.0 - SPARED) * (distance - 0.5 * spared) / motion;
        if (time >= 1.0) return NO_IMPACT;
        for (int i = 0; i < 4; ++i) moved[i] = x[i] + time * displacement[i];
        distance = nearest(pair, moved).apart.norm();
        if (distance < spared) return time;
    }
    return time;
}

}  // namespace corpuscle::contact
