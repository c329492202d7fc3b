// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Collisions in a bag, and the heat that comes to its particles with them.

#include <algorithm>
#include <cmath>

#include "gas/bag_gas.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Particles wanted in an occupied cell. Fewer: noisy temperatures; more: blurred waves.
constexpr double PARTICLES_PER_CELL = 40.0;

/// Share of a cell that a particle of thermal speed crosses between collisions. More: blurred
/// waves.
constexpr double COLLISION_SHARE = 0.2;

/// Share of a cell that fabric may move before the lists of facets by cell are made anew.
constexpr double SIDE_MARGIN = 0.15;

/// Share of the particles' thermal energy that they trade with the initial air in one collision
/// step at most; the rest follows in the next ones.
constexpr double MOST_EXCHANGED = 0.3;

/// Collision steps after which particles are put in the order of cells again. Until then most have
/// crossed one cell: more would scatter what is read together, fewer move 64 bytes more often.
constexpr std::uint64_t MOVE_ROWS_EVERY = 4;

/// Collision steps after which the thermal speed is measured again: one pass over the particles.
constexpr std::uint64_t MEASURE_EVERY = 4;

std::size_t occupied(const Lists& cells) {
    std::size_t count = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) count += !cells[c].empty();
    return count;
}

}  // namespace

void BagGas::collide(double dt, const Points& x) {
    since_collision_ += dt;
    // In the step that comes nearest to the share.
    const double crossed = (since_collision_ + 0.5 * dt) * speed_;
    if (uniform_ || particles_.size() == 0 || crossed < COLLISION_SHARE * cell_) return;

    find_groups(x);
    std::vector<Heat> heat;
    if (!air_.empty()) exchange_heat_with_air(heat);
    const CollisionReport report =
        collider_.collide(collisions_, since_collision_, heat, particles_);
    check_collided(report.thermal);
    unrelaxed_ += report.unrelaxed;
    if (collisions_ % MEASURE_EVERY == 0) measure_speed();
    ++collisions_;
    since_collision_ = 0.0;
    fit_cells(occupied(collider_.cells()));
}

/// Internal facets that let through whoever comes hide nothing.
void BagGas::find_open_facets() {
    is_open_.clear();
    const Gates* const gates = openings_.gates();
    if (gates == nullptr) return;
    const auto lets_all_through = [](const Gates::Gate& gate) {
        return gate.is_internal && std::all_of(gate.chance.begin(), gate.chance.end(),
                                               [](double chance) { return chance >= 1.0; });
    };
    if (std::none_of(gates->all.begin(), gates->all.end(), lets_all_through)) return;
    is_open_.assign(walls_.triangles.size(), 0);
    for (std::size_t f = walls_.closing; f < is_open_.size(); ++f)
        is_open_[f] = gates->of_facet[f] >= 0 && gates->open[f] >= 1.0 &&
                      lets_all_through(gates->all[gates->of_facet[f]]);
}

/// In cells of about the wanted size, made anew when fabric has moved too far.
void BagGas::find_groups(const Points& x) {
    const double edge = side_lists_.grid().edge;
    const bool fits = wanted_cell_ < 1.2 * edge && edge < 1.2 * wanted_cell_;
    if (!fits || !side_lists_.hold_for(x))
        build(side_lists_, wanted_cell_, SIDE_MARGIN * wanted_cell_, 0.0, x, x);
    cell_ = side_lists_.grid().edge;
    find_open_facets();
    collider_.find_groups(side_lists_.grid(), {&side_lists_, x, is_open_}, particles_,
                          collisions_ % MOVE_ROWS_EVERY == 0);
}

/// Brings the initial air of each room to the mean temperature of its particles: finds the heat of
/// the room's groups, and takes it from the air.
///
///     E_air(T) + E_particles(T) = E_air + E_thermal
///
/// A group's mean motion is no heat, so N particles in G groups hold 3/2 (N - G) R T of
/// translation.
void BagGas::exchange_heat_with_air(std::vector<Heat>& heat) {
    const std::size_t rooms = air_.size(), kinds = mass_.size();
    std::vector<double> thermal(rooms, 0.0), groups(rooms, 0.0);
    collider_.thermal_energy(particles_, thermal, groups);
    const std::vector<Holding> holds = holdings();
    heat.assign(rooms, {});
    const double moles = inflators_.moles_each();
    for (std::size_t r = 0; r < rooms; ++r) {
        if (!(thermal[r] > 0.0)) continue;
        EnergyPolynomial content = air_[r].content();
        double count = 0.0, mass = 0.0;
        for (std::size_t s = 0; s < kinds; ++s) {
            content +=
                holds[r * kinds + s].count * moles * inflators_.species()[s].molar_internal();
            count += holds[r * kinds + s].count;
            mass += holds[r * kinds + s].count * mass_[s];
        }
        content.a += 1.5 * card_.gas_constant * moles * (count - groups[r]);
        const double T = content.temperature(air_[r].energy() + thermal[r], air_[r].temperature());
        const double wanted = air_[r].energy() - air_[r].content()(T);
        const double given =
            std::clamp(wanted, -MOST_EXCHANGED * thermal[r], MOST_EXCHANGED * thermal[r]);
        heat[r] = given > 0.0 ? Heat{1.0, given / mass} : Heat{1.0 + given / thermal[r], 0.0};
        air_[r].add(-given);
    }
}

/// Adapts the cells that the next facet lists will have to how many particles the occupied ones
/// hold.
void BagGas::fit_cells(std::size_t occupied_cells) {
    const double mean = static_cast<double>(particles_.size()) /
                        static_cast<double>(std::max<std::size_t>(1, occupied_cells));
    wanted_cell_ = cell_ * std::clamp(std::cbrt(PARTICLES_PER_CELL / mean), 0.7, 1.4);
}

/// sqrt(R T / M) of the gas as a whole, bulk motion included: sqrt(2/3 of the kinetic energy /
/// mass).
void BagGas::measure_speed() {
    struct Sum {
        double mass = 0, twice_kinetic = 0;
        Sum& operator+=(const Sum& o) {
            mass += o.mass;
            twice_kinetic += o.twice_kinetic;
            return *this;
        }
    };
    const Sum all = parallel::sum(particles_.size(), Sum{}, [&](std::size_t i) {
        const double m = mass_[particles_.species[i]];
        return Sum{m, m * particles_.v[i].squaredNorm()};
    });
    speed_ = std::sqrt(all.twice_kinetic / (3.0 * all.mass));
}

/// The step in which a particle of thermal speed crosses the share of a cell that it may between
/// collisions.
double BagGas::stable_step() const {
    return uniform_ ? INF : COLLISION_SHARE * cell_ / speed_;
}

}  // namespace corpuscle::gas
