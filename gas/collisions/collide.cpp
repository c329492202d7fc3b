// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/collide.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "gas/collisions/relax.hpp"

namespace corpuscle::gas {

Collider::Collider(std::vector<Species> species, double moles_each, std::uint64_t seed,
                   CollisionModel model, double mean_free_path)
    : mixture_{std::move(species), moles_each},
      seed_(seed),
      model_(model),
      mean_free_path_(mean_free_path) {}

void Collider::find_groups(const Grid& grid, const FabricInCells& fabric, Particles& particles,
                           bool moves_rows) {
    cells_.sort(grid, particles, moves_rows);
    cell_volume_ = grid.edge * grid.edge * grid.edge;
    groups_.find(cells_, fabric, particles, std::sqrt(3.0) * grid.edge);
}

double Collider::thermal_energy(const Particles& particles) const {
    return gas::thermal_energy(groups_.lists(), mixture_, particles);
}

/// Of spheres whose mean free path at density n is lambda: sigma = 1 / (sqrt(2) n lambda)
/// [Maxwell]. n: mean of the cells that hold particles.
double Collider::cross_section() const {
    if (!has_mean_free_path(model_)) return 0.0;
    const Lists cells = cells_.cells();
    std::size_t occupied = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) occupied += !cells[c].empty();
    const double density =
        static_cast<double>(cells.order.size()) / (static_cast<double>(occupied) * cell_volume_);
    const double path = std::isnan(mean_free_path_) ? default_free_path(model_) / std::cbrt(density)
                                                    : mean_free_path_;
    return 1.0 / (std::numbers::sqrt2 * density * path);
}

CollisionReport Collider::collide(std::uint64_t step, double dt, double heat,
                                  Particles& particles) const {
    const CollisionStep all{groups_.lists(), mixture_,        heat,  dt,
                            cell_volume_,    cross_section(), seed_, step};
    switch (model_) {
        case CollisionModel::PAIRS:
            return collide_pairs(all, particles);
        case CollisionModel::LIN:
            return collide_lin(all, particles);
        case CollisionModel::NTC:
            return collide_ntc(all, particles);
        case CollisionModel::SPHERES:
            return collide_spheres(all, particles);
    }
    return {};
}

}  // namespace corpuscle::gas
