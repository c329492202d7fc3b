// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/collide.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "gas/collisions/relax.hpp"
#include "solver/base/parallel.hpp"

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

std::vector<RoomGroups> Collider::groups_of_rooms(std::size_t rooms, std::size_t kinds,
                                                  const Particles& particles) const {
    const Lists lists = groups_.lists();
    const auto room_of = [&](std::span<const Index> rows) {
        return particles.room_of(static_cast<std::size_t>(rows[0]));
    };
    constexpr std::size_t GROUPS_A_CHUNK = 16;
    // Of each chunk and room: groups, their thermal energy and mean motion, particles of each kind
    constexpr std::size_t FIXED = 3;
    const std::size_t of_room = FIXED + kinds, width = rooms * of_room;
    const std::size_t chunks = parallel::chunk_count(lists.size(), GROUPS_A_CHUNK);
    std::vector<double> sums(chunks * width, 0.0);
    parallel::for_chunks(
        lists.size(),
        [&](std::size_t begin, std::size_t end, std::size_t c) {
            for (std::size_t g = begin; g < end; ++g) {
                const GroupEnergies energies = energies_of(lists[g], mixture_, particles);
                double* const own = sums.data() + c * width + room_of(lists[g]) * of_room;
                own[0] += 1.0;
                own[1] += energies.thermal;
                own[2] += energies.mean_motion;
                for (const Index row : lists[g]) own[FIXED + particles.species[row]] += 1.0;
            }
        },
        GROUPS_A_CHUNK);
    std::vector<RoomGroups> out(rooms);
    for (RoomGroups& room : out) room.count.assign(kinds, 0.0);
    for (std::size_t c = 0; c < chunks; ++c)
        for (std::size_t r = 0; r < rooms; ++r) {
            const double* const own = sums.data() + c * width + r * of_room;
            out[r].groups += own[0];
            out[r].energies += GroupEnergies{own[1], own[2]};
            for (std::size_t k = 0; k < kinds; ++k) out[r].count[k] += own[FIXED + k];
        }
    return out;
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

CollisionReport Collider::collide(std::uint64_t step, double dt, double factor,
                                  Particles& particles) const {
    return collide(
        {groups_.lists(), mixture_, {factor}, dt, cell_volume_, cross_section(), seed_, step},
        particles);
}

CollisionReport Collider::collide(std::uint64_t step, double dt, std::span<const Heat> heat_of_room,
                                  Particles& particles) const {
    return collide({groups_.lists(),
                    mixture_,
                    {},
                    dt,
                    cell_volume_,
                    cross_section(),
                    seed_,
                    step,
                    heat_of_room},
                   particles);
}

CollisionReport Collider::collide(const CollisionStep& step, Particles& particles) const {
    switch (model_) {
        case CollisionModel::PAIRS:
            return collide_pairs(step, particles);
        case CollisionModel::LIN:
            return collide_lin(step, particles);
        case CollisionModel::NTC:
            return collide_ntc(step, particles);
        case CollisionModel::SPHERES:
            return collide_spheres(step, particles);
    }
    return {};
}

}  // namespace corpuscle::gas
