// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What contact does to a bag's holes.

#include "gas/bag_gas.hpp"

namespace corpuscle::gas {

/// Contact presses a node harder than the gas does, from outside, where its force along the node's
/// inward area is more than gauge pressure times that area.
void BagGas::set_touching(std::span<const std::uint8_t> nodes, std::span<const Vec3> force) {
    if (card_.block.by_pressure) {
        const double air = air_pressure();
        pressed_.assign(nodes.size(), 0);
        for (const Index n : enclosure_.nodes()) {
            const double gauge = load_.pressure_at_node(n) + air - card_.p_atm;
            pressed_[n] = nodes[n] != 0 && -force[n].dot(area_[n]) > gauge * area_[n].squaredNorm();
        }
    }
    openings_.block(nodes, pressed_);
}

}  // namespace corpuscle::gas
