// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/collision_cells.hpp"

#include <algorithm>
#include <cmath>

#include "gas/flight/bag_lists.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Particles in a cell of the full bag that the first cells are meant for.
constexpr double FIRST_PARTICLES_PER_CELL = 30.0;

/// Particles wanted in an occupied cell. Fewer: noisy temperatures; more: blurred waves.
constexpr double PARTICLES_PER_CELL = 30.0;

/// Share of a cell that a particle of thermal speed crosses between collisions. More: blurred
/// waves.
constexpr double COLLISION_SHARE = 1.0 / 8.0;

/// Share of a cell that fabric may move before the lists of facets by cell are made anew.
constexpr double SIDE_MARGIN = 0.15;

/// Collision steps after which particles are put in the order of cells again. Until then most have
/// crossed one cell: more would scatter what is read together, fewer move 64 bytes more often.
constexpr std::uint64_t MOVE_ROWS_EVERY = 4;

/// Collision steps after which the thermal speed is measured again: one pass over the particles.
constexpr std::uint64_t MEASURE_EVERY = 4;

std::size_t occupied(const Lists& cells) {
    constexpr std::size_t A_CHUNK = 512;
    return parallel::sum(
        cells.size(), std::size_t{0},
        [&](std::size_t c) { return static_cast<std::size_t>(!cells[c].empty()); }, A_CHUNK);
}

}  // namespace

CollisionCells::CollisionCells(const std::vector<Triangle>& triangles, std::size_t closing,
                               const Points& x, double volume, std::size_t particles, double speed)
    : lists_(triangles, x, FacetLists::Of::FACETS),
      closing_(closing),
      edge_(cell_edge(volume, particles, FIRST_PARTICLES_PER_CELL)),
      wanted_edge_(edge_),
      speed_(speed) {}

bool CollisionCells::is_due(double dt) {
    since_ += dt;
    return !((since_ + 0.5 * dt) * speed_ < COLLISION_SHARE * edge_);
}

/// Internal facets that let through whoever comes hide nothing.
void CollisionCells::find_open_facets(const Transmission* transmission) {
    is_open_.clear();
    if (transmission == nullptr) return;
    const auto lets_all_through = [](const Transmission::Chances& chances) {
        return chances.is_internal && !chances.has_sides() &&
               std::all_of(chances.chance.begin(), chances.chance.end(),
                           [](double chance) { return chance >= 1.0; });
    };
    if (std::none_of(transmission->all.begin(), transmission->all.end(), lets_all_through)) return;
    is_open_.assign(lists_.triangles().size(), 0);
    for (std::size_t f = closing_; f < is_open_.size(); ++f)
        is_open_[f] = transmission->of_facet[f] >= 0 && transmission->open[f] >= 1.0 &&
                      lets_all_through(transmission->all[transmission->of_facet[f]]);
}

void CollisionCells::find_groups(const Points& x, const Transmission* transmission,
                                 Collider& collider, Particles& particles) {
    const double edge = lists_.grid().edge;
    const bool fits = wanted_edge_ < 1.2 * edge && edge < 1.2 * wanted_edge_;
    if (!fits || !lists_.hold_for(x))
        build_fitted_to_bag(lists_, wanted_edge_, SIDE_MARGIN * wanted_edge_, x);
    edge_ = lists_.grid().edge;
    find_open_facets(transmission);
    collider.find_groups(lists_.grid(), {&lists_, x, is_open_}, particles,
                         steps_ % MOVE_ROWS_EVERY == 0);
}

void CollisionCells::finish(const Lists& cells, std::span<const double> mass,
                            const Particles& particles) {
    if (steps_ % MEASURE_EVERY == 0) measure_speed(mass, particles);
    ++steps_;
    since_ = empty_ = 0.0;
    const double mean = static_cast<double>(particles.size()) /
                        static_cast<double>(std::max<std::size_t>(1, occupied(cells)));
    wanted_edge_ = edge_ * std::clamp(std::cbrt(PARTICLES_PER_CELL / mean), 0.7, 1.4);
}

/// sqrt(R T / M) of the gas as a whole, bulk motion included: sqrt(2/3 of the kinetic energy /
/// mass).
void CollisionCells::measure_speed(std::span<const double> mass, const Particles& particles) {
    struct Sum {
        double mass = 0, twice_kinetic = 0;
        Sum& operator+=(const Sum& o) {
            mass += o.mass;
            twice_kinetic += o.twice_kinetic;
            return *this;
        }
    };
    const Sum all = parallel::sum(particles.size(), Sum{}, [&](std::size_t i) {
        const double m = mass[particles.species[i]];
        return Sum{m, m * particles.v[i].squaredNorm()};
    });
    speed_ = std::sqrt(all.twice_kinetic / (3.0 * all.mass));
}

double CollisionCells::stable_step() const {
    return COLLISION_SHARE * edge_ / speed_;
}

}  // namespace corpuscle::gas
