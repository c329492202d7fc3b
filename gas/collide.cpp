// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collide.hpp"

#include <cmath>
#include <utility>

#include "gas/relax.hpp"

namespace corpuscle::gas {

Collider::Collider(std::vector<Species> species, double moles_each, std::uint64_t seed,
                   CollisionModel model)
    : mixture_{std::move(species), moles_each}, seed_(seed), model_(model) {}

void Collider::find_groups(const Grid& grid, const FabricInCells& fabric,
                           Particles& particles) {
    cells_.sort(grid, particles);
    groups_.find(cells_.cells(), fabric, particles, std::sqrt(3.0) * grid.edge);
}

double Collider::thermal_energy(const Particles& particles) const {
    return gas::thermal_energy(groups_.lists(), mixture_, particles);
}

CollisionReport Collider::collide(std::uint64_t step, double heat, Particles& particles) const {
    const CollisionStep all{groups_.lists(), mixture_, heat, seed_, step};
    switch (model_) {
        case CollisionModel::PAIRS:
            return collide_pairs(all, particles);
        case CollisionModel::LIN:
            return collide_lin(all, particles);
    }
    return {};
}

}  // namespace corpuscle::gas
