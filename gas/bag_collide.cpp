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
constexpr double PARTICLES_PER_CELL = 20.0;

/// Share of a cell that a particle of thermal speed crosses between collisions. More: blurred
/// waves.
constexpr double COLLISION_SHARE = 0.25;

/// Share of a cell that fabric may move before the lists of facets by cell are made anew.
constexpr double SIDE_MARGIN = 0.15;

/// Least share of the particles' thermal energy that the smoothing account leaves them in one step.
constexpr double LEFT_BY_ACCOUNT = 0.7;

/// Collision steps after which particles are put in the order of cells again. Until then most have
/// crossed one cell: more would scatter what is read together, fewer move 64 bytes more often.
constexpr std::uint64_t MOVE_ROWS_EVERY = 4;

/// Collision steps after which the thermal speed is measured again: one pass over the particles.
constexpr std::uint64_t MEASURE_EVERY = 4;

/// Share of the particles that may come or go between two counts of their thermal energy.
constexpr double MOST_CHANGE = 0.01;

std::size_t occupied(const Lists& cells) {
    std::size_t count = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) count += !cells[c].empty();
    return count;
}

}  // namespace

void BagGas::collide(double dt, const Points& x) {
    since_collision_ += dt;
    if (uniform_ || particles_.size() == 0 || since_collision_ * speed_ < COLLISION_SHARE * cell_)
        return;

    find_groups(x);
    expect_thermal();
    const Heat wanted = thermal_ > 0.0 ? wanted_heat() : Heat{};
    const double factor = thermal_ > 0.0 ? 1.0 + wanted.all() / thermal_ : 1.0;
    const CollisionReport report =
        collider_.collide(collisions_, since_collision_, factor, particles_);
    if (thermal_ > 0.0) settle(wanted, report.thermal / thermal_);
    thermal_ = factor * report.thermal;
    unrelaxed_ += report.unrelaxed;
    if (collisions_ % MEASURE_EVERY == 0) measure_speed();
    ++collisions_;
    since_collision_ = 0.0;
    fit_cells(occupied(collider_.cells()));
}

/// Thermal energy before these collisions: that after the last ones, as long as few have entered or
/// left; else it is added up, one more pass over the particles.
void BagGas::expect_thermal() {
    const auto now = static_cast<double>(particles_.size()), then = static_cast<double>(counted_);
    if (std::abs(now - then) > MOST_CHANGE * then)
        thermal_ = collider_.thermal_energy(particles_);
    else
        thermal_ *= now / then;
    counted_ = particles_.size();
}

/// In cells of about the wanted size, made anew when fabric has moved too far.
void BagGas::find_groups(const Points& x) {
    const double edge = side_lists_.grid().edge;
    const bool fits = wanted_cell_ < 1.2 * edge && edge < 1.2 * wanted_cell_;
    if (!fits || !side_lists_.hold_for(x))
        build(side_lists_, wanted_cell_, SIDE_MARGIN * wanted_cell_, 0.0, x, x);
    cell_ = side_lists_.grid().edge;
    collider_.find_groups(side_lists_.grid(), {&side_lists_, x}, particles_,
                          collisions_ % MOVE_ROWS_EVERY == 0);
}

/// Heat that the particles are to get, were their thermal energy as expected.
BagGas::Heat BagGas::wanted_heat() const {
    Heat heat{heat_from_air(thermal_), heat_from_smoothing(thermal_), 0.0};
    const double spare = std::max(0.0, heat.all() + (1.0 - LEFT_BY_ACCOUNT) * thermal_);
    heat.to_outflow = std::min(owed_to_outflow_, spare);
    return heat;
}

/// Takes from the accounts what the particles did get: `ratio` times what was wanted.
void BagGas::settle(const Heat& wanted, double ratio) {
    if (air_) air_->add(-ratio * wanted.from_air);
    taken_ -= ratio * wanted.from_smoothing;
    owed_to_outflow_ -= ratio * wanted.to_outflow;
    lost_energy_ += ratio * wanted.to_outflow;
}

/// What brings the initial air to the particles' mean temperature; the air loses it. [J]
///
///     E_air(T) + E_particles(T) = E_air + E_thermal
///
/// A group's mean motion is no heat, so N particles in G groups hold 3/2 (N - G) R T of
/// translation.
double BagGas::heat_from_air(double thermal) const {
    if (!air_) return 0.0;
    const double moles = inflators_.moles_each();
    const auto free = static_cast<double>(particles_.size() - collider_.groups().lists().size());
    EnergyPolynomial content = air_->content();
    content.a += 1.5 * card_.gas_constant * moles * free;
    for (std::size_t s = 0; s < mass_.size(); ++s)
        content +=
            static_cast<double>(std::count(particles_.species.begin(), particles_.species.end(),
                                           static_cast<std::int32_t>(s))) *
            moles * inflators_.species()[s].molar_internal();
    const double T = content.temperature(air_->energy() + thermal, air_->temperature());
    return air_->energy() - air_->content()(T);
}

/// Pays back what hits took from the particles and release has not given to the fabric (or the
/// other way round), as fast as impulse is released. [J]
double BagGas::heat_from_smoothing(double thermal) const {
    const double account = taken_ - given_;
    const double share = -std::expm1(-since_collision_ / store_.time());
    return std::max(account * share, -(1.0 - LEFT_BY_ACCOUNT) * thermal);
}

/// Adapts the cells that the next facet lists will have to how many particles the occupied ones
/// hold.
void BagGas::fit_cells(std::size_t occupied_cells) {
    const double mean =
        static_cast<double>(particles_.size()) / static_cast<double>(occupied_cells);
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

}  // namespace corpuscle::gas
